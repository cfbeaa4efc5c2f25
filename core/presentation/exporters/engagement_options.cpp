#include "core/presentation/exporters/engagement_options.h"

#include <algorithm>
#include <utility>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/theory/states/state_edits.h"

namespace geargraph {
namespace {

std::variant<Mechanism, UsageError> inState(Mechanism mechanism, const std::string& name) {
  const auto found = std::find_if(mechanism.states.begin(), mechanism.states.end(),
                                  [&](const ShiftState& state) { return state.name == name; });
  if (found == mechanism.states.end()) {
    std::vector<std::string> names;
    for (const ShiftState& state : mechanism.states) names.push_back(state.name);
    return UsageError{
        names.empty()
            ? translated("There is no state \"%1\". The document has no states.", {name})
            : translated("There is no state \"%1\". States: %2.", {name, listed(names, kAllNames)})};
  }
  std::vector<ShiftElementId> engaged = found->engaged;
  Expected<Mechanism> next = withStateEngaged(mechanism, static_cast<int>(found - mechanism.states.begin()));
  if (next) return *std::move(next);
  mechanism.engaged = std::move(engaged);  // a coupling closes a linkage: the analysis tells which
  return mechanism;
}

std::variant<Mechanism, UsageError> withList(Mechanism mechanism, std::string_view list) {
  std::vector<ShiftElementId> engaged;
  while (list != "none" && !list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const ShiftElementId id{std::string(list.substr(0, comma))};
    if (mechanism.find(id) == nullptr) {
      std::vector<std::string> names;
      for (const ShiftElement& coupling : mechanism.couplings) names.push_back(coupling.id.text());
      return UsageError{
          names.empty()
              ? translated("There is no coupling \"%1\". The document has no couplings.", {id.text()})
              : translated("There is no coupling \"%1\". Couplings: %2.",
                           {id.text(), listed(names, kAllNames)})};
    }
    engaged.push_back(id);
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  Expected<Mechanism> bare = withEngagement(mechanism, engaged);
  if (!bare) return UsageError{bare.error().front().message};
  Expected<Mechanism> next = withCouplingsEngaged(std::move(mechanism), engaged);
  return *std::move(next ? next : bare);  // without: a coupling closes a linkage
}

}  // namespace

std::variant<Mechanism, UsageError> withEngagementOptions(Mechanism mechanism, const OptionValues& given) {
  const auto state = given.value("--state");
  const auto list = given.value("--engage");
  if (state && list) return UsageError{translated("Give --state NAME or --engage A,B.")};
  if (state) return inState(std::move(mechanism), *state);
  if (list) return withList(std::move(mechanism), *list);
  return mechanism;
}

}  // namespace geargraph
