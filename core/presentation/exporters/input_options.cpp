#include "core/presentation/exporters/input_options.h"

#include <algorithm>
#include <memory>

#include "core/foundations/base/translation.h"
#include "core/presentation/exporters/element_words.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {
namespace {

/// The position of the joint that a word names.
std::variant<int, UsageError> jointOf(const Mechanism& mechanism, std::string_view word) {
  if (const auto position = jointNamed(mechanism, word)) return int{*position};
  if (mechanism.t() == 0) return UsageError{translated("There is no turning joint \"%1\".", {word})};
  return UsageError{translated("There is no turning joint \"%1\"; they are labelled %2 to %3.",
                               {word, std::to_string(mechanism.jointLabel(0)),
                                std::to_string(mechanism.jointLabel(mechanism.t() - 1))})};
}

std::optional<Number> speedOf(const Mechanism& mechanism, JointId joint) {
  if (!mechanism.inputs) return std::nullopt;
  for (const Input& input : *mechanism.inputs) {
    if (input.joint == joint) return input.speed;
  }
  return std::nullopt;
}

std::variant<std::vector<Input>, UsageError> inputsNamed(const Mechanism& mechanism, std::string_view list) {
  std::vector<Input> inputs;
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const auto position = jointOf(mechanism, list.substr(0, comma));
    if (const auto* error = std::get_if<UsageError>(&position)) return *error;
    const JointId joint = mechanism.turningJoints[static_cast<std::size_t>(std::get<int>(position))].id;
    if (std::any_of(inputs.begin(), inputs.end(), [&](const Input& input) { return input.joint == joint; })) {
      return UsageError{translated("--inputs names joint %1 twice.", {list.substr(0, comma)})};
    }
    inputs.push_back({joint, speedOf(mechanism, joint).value_or(Number(1)), {}});
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return inputs;
}

/// The inputs that are chosen where nobody names any.
std::vector<Input> chosenInputs(const Mechanism& mechanism) {
  std::vector<Input> inputs;
  const SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(mechanism));
  const MatroidAnalysis* matroid = snapshot->matroid();
  if (matroid == nullptr) return inputs;
  for (std::size_t i = 0; i < matroid->choice.joints.size(); ++i) {
    const auto joint = static_cast<std::size_t>(matroid->choice.joints[i]);
    inputs.push_back({mechanism.turningJoints[joint].id, Number(matroid->speeds[i]), {}});
  }
  return inputs;
}

std::optional<UsageError> setSpeed(Mechanism& mechanism, std::string_view word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos)
    return UsageError{translated("--speed is like 8=1/2: a joint's label and rad/s.")};
  const auto position = jointOf(mechanism, word.substr(0, equals));
  if (const auto* error = std::get_if<UsageError>(&position)) return *error;
  const auto speed = quantityFromText(word.substr(equals + 1), Quantity::speed);
  if (!speed) {
    return UsageError{translated("\"%1\" is no speed; 1/2, 2*3 (rad/s), 1500rpm and 90deg/s are.",
                                 {word.substr(equals + 1)})};
  }
  const JointId joint = mechanism.turningJoints[static_cast<std::size_t>(std::get<int>(position))].id;
  for (Input& input : *mechanism.inputs) {
    if (input.joint != joint) continue;
    input.speed = *speed;
    return std::nullopt;
  }
  return UsageError{translated("Joint %1 is not an input; see --inputs.", {word.substr(0, equals)})};
}

}  // namespace

std::variant<Mechanism, UsageError> withInputOptions(Mechanism mechanism, const OptionValues& given) {
  if (const auto list = given.value("--inputs")) {
    auto inputs = inputsNamed(mechanism, *list);
    if (const auto* error = std::get_if<UsageError>(&inputs)) return *error;
    mechanism.inputs = std::get<std::vector<Input>>(std::move(inputs));
  }
  const std::vector<std::string> speeds = given.values("--speed");
  if (!speeds.empty() && !mechanism.inputs) mechanism.inputs = chosenInputs(mechanism);
  for (const std::string& speed : speeds) {
    if (const auto error = setSpeed(mechanism, speed)) return *error;
  }
  return mechanism;
}

}  // namespace geargraph
