#include <algorithm>

#include "core/design/fixes/fix_makers.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/edits.h"

namespace geargraph {
namespace {

/// The inputs as they are where they stay, the others at 1 rad/s, in the order of the wanted ones:
/// `exchanged` take the places of those that go.
std::vector<Input> validInputs(const Mechanism& mechanism, const InputChoice& choice) {
  const auto idOf = [&](JointOrdinal joint) { return mechanism.turningJoints[joint].id; };
  std::vector<Input> inputs;
  std::vector<int> added = choice.added;
  for (const Input& input : *mechanism.inputs) {
    const auto isThis = [&](JointOrdinal joint) { return idOf(joint) == input.joint; };
    if (std::any_of(choice.joints.begin(), choice.joints.end(), isThis)) {
      inputs.push_back(input);
    } else if (!added.empty()) {
      inputs.push_back({idOf(added.front()), input.speed, {}});
      added.erase(added.begin());
    }
  }
  for (const JointOrdinal joint : added) inputs.push_back({idOf(joint), Number(1), {}});
  return inputs;
}

std::string labels(const Mechanism& mechanism, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const JointOrdinal joint : joints) names.push_back(std::to_string(mechanism.jointLabel(joint)));
  return listed(names, kAllNames);
}

std::string textFor(const Mechanism& mechanism, const InputChoice& choice) {
  const std::string out = labels(mechanism, choice.rejected);
  const std::string in = labels(mechanism, choice.added);
  if (choice.added.empty()) return translated("Stop driving %1", {out});
  if (choice.rejected.empty()) return translated("Drive %1 too", {in});
  return translated("Exchange input %1 for %2", {out, in});
}

}  // namespace

std::vector<Fix> inputFixes(const AnalysisSnapshot& snapshot) {
  const MatroidAnalysis* matroid = snapshot.matroid();
  if (matroid == nullptr || !snapshot.mechanism->inputs) return {};
  const Mechanism& mechanism = *snapshot.mechanism;
  std::vector<Input> inputs = validInputs(mechanism, matroid->choice);
  std::vector<Fix> fixes;
  if (!inputs.empty()) {
    fixes.push_back({textFor(mechanism, matroid->choice),
                     [inputs](const Mechanism& before) { return withInputs(before, inputs); }});
  }
  fixes.push_back({translated("Choose the inputs for me"),
                   [](const Mechanism& before) { return withInputs(before, std::nullopt); }});
  return fixes;
}

}  // namespace geargraph
