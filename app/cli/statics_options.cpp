#include "app/cli/statics_options.h"

#include <algorithm>

#include "app/cli/number_options.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/length.h"
#include "core/mechanism/model/quantity.h"
#include "core/presentation/exporters/element_words.h"

namespace geargraph::cli {
namespace {

/// A joint, or a link with an axis: "joint:14", "link:3", "link:3@e".
using Place = std::variant<JointId, HoldingTorque::OnLink>;

UsageError noPlace(std::string_view option, std::string_view word) {
  return UsageError{
      translated("%1 is on joint:LABEL, link:LABEL or link:LABEL@AXIS, not \"%2\".", {option, word})};
}

std::variant<Place, UsageError> placeFrom(const Mechanism& mechanism, std::string_view option,
                                          std::string_view word) {
  constexpr std::string_view kJoint = "joint:";
  constexpr std::string_view kLink = "link:";
  if (word.starts_with(kJoint)) {
    const auto position = jointNamed(mechanism, word.substr(kJoint.size()));
    if (!position)
      return UsageError{translated("There is no turning joint \"%1\".", {word.substr(kJoint.size())})};
    return Place(mechanism.turningJoints[*position].id);
  }
  if (!word.starts_with(kLink)) return noPlace(option, word);
  word.remove_prefix(kLink.size());
  const std::size_t at = std::min(word.find('@'), word.size());
  const auto position = linkNamed(mechanism, word.substr(0, at));
  if (!position) return UsageError{translated("There is no link \"%1\".", {word.substr(0, at)})};
  if (*position == 0) return UsageError{translated("The ground takes any load: name a moving link.")};
  HoldingTorque::OnLink place{mechanism.links[*position].id, {}};
  if (at < word.size()) {
    place.axis = AxisId(word.substr(at + 1));
    if (mechanism.find(*place.axis) == nullptr)
      return UsageError{translated("There is no axis \"%1\".", {word.substr(at + 1)})};
  }
  return Place(place);
}

/// "10,-20,-50N@30,-60,130" on a link: components in the unit behind the last one, a point in the document's
/// unit or with one.
std::optional<LinkForce> forceFrom(const Mechanism& mechanism, LinkId link, std::string_view text) {
  const std::size_t at = text.find('@');
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view components = text.substr(0, at);
  const auto point = tripleFrom(text.substr(at + 1),
                                [&](std::string_view each) { return lengthFromText(each, mechanism.unit); });
  for (const std::string_view unit : {"kN", "mN", "N", "lbf", "kgf"}) {
    if (!components.ends_with(unit)) continue;
    const auto force =
        tripleFrom(components.substr(0, components.size() - unit.size()), [&](std::string_view each) {
          return withUnitFromText(std::string(each) + std::string(unit), Quantity::force);
        });
    if (force && point) return LinkForce{link, *force, *point};
  }
  return std::nullopt;
}

std::variant<Load, UsageError> loadFrom(const Mechanism& mechanism, std::string_view word) {
  const std::size_t equals = std::min(word.find('='), word.size());
  const auto place = placeFrom(mechanism, "--load", word.substr(0, equals));
  if (const auto* error = std::get_if<UsageError>(&place)) return *error;
  const std::string_view size = word.substr(std::min(equals + 1, word.size()));
  const auto& where = std::get<Place>(place);
  const auto* link = std::get_if<HoldingTorque::OnLink>(&where);
  if (const auto torque = withUnitFromText(size, Quantity::torque)) {
    if (link == nullptr) return Load{{}, JointTorque{std::get<JointId>(where), *torque}};
    return Load{{}, LinkTorque{link->link, link->axis, *torque}};
  }
  if (link != nullptr && !link->axis) {
    if (const auto force = forceFrom(mechanism, link->link, size)) return Load{{}, *force};
  }
  return UsageError{translated(
      "\"%1\" is no load: 10Nm, 1/2kNm, 3lbf ft and 2kW@1500rpm are torques, and 10,-20,-50N@30,-60,130 is a "
      "force on a link at a point.",
      {size})};
}

}  // namespace

std::optional<UsageError> readLossOptions(const Arguments& arguments, StaticsOptions& options) {
  if (const auto word = arguments.value("--eta")) {
    const bool isPercent = word->ends_with('%');
    const auto number = typedNumber(isPercent ? word->substr(0, word->size() - 1) : *word);
    const Rational efficiency = number ? number->exact() / (isPercent ? 100 : 1) : Rational();
    if (efficiency.sign() <= 0 || efficiency > Rational(1))
      return UsageError{translated("--eta is an efficiency, above 0 and at most 1.")};
    options.efficiency = efficiency;
  }
  if (const auto share = arguments.value("--share")) {
    options.sharing = loadSharingFrom(*share);
    if (!options.sharing) return UsageError{translated("--share is one of none, stiffness.")};
  }
  return std::nullopt;
}

std::variant<StaticsOptions, UsageError> staticsOptions(const Mechanism& mechanism,
                                                        const Arguments& arguments) {
  StaticsOptions options;
  options.documentLoads = !arguments.has("--no-loads");
  for (const std::string& word : arguments.values("--load")) {
    auto load = loadFrom(mechanism, word);
    if (const auto* error = std::get_if<UsageError>(&load)) return *error;
    options.loads.push_back(std::get<Load>(std::move(load)));
  }
  for (const std::string& word : arguments.values("--balance")) {
    const auto place = placeFrom(mechanism, "--balance", word);
    if (const auto* error = std::get_if<UsageError>(&place)) return *error;
    HoldingTorque balance;
    std::visit([&](const auto& where) { balance.at = where; }, std::get<Place>(place));
    if (std::find(options.balances.begin(), options.balances.end(), balance) != options.balances.end())
      return UsageError{translated("--balance names \"%1\" twice.", {word})};
    options.balances.push_back(std::move(balance));
  }
  if (const auto error = readLossOptions(arguments, options)) return *error;
  options.losses = arguments.has("--efficiency") || arguments.has("--eta");
  options.symbolic = !arguments.has("--no-symbolic");
  return options;
}

std::variant<std::vector<int>, UsageError> statesAsked(const Mechanism& mechanism,
                                                       const Arguments& arguments) {
  const auto name = arguments.value("--state");
  if (name && arguments.has("--all-states"))
    return UsageError{translated("Give --state NAME or --all-states.")};
  std::vector<int> states;
  for (std::size_t i = 0; i < mechanism.states.size(); ++i) {
    const bool isAsked = arguments.has("--all-states") || (name && mechanism.states[i].name == *name);
    if (isAsked) states.push_back(static_cast<int>(i));
  }
  if (name && states.empty()) return UsageError{translated("There is no state \"%1\".", {*name})};
  if (!name && !arguments.has("--all-states")) states.push_back(-1);
  return states;
}

}  // namespace geargraph::cli
