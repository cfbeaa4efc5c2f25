#include "app/cli/engagement_options.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "app/cli/load.h"
#include "core/foundations/base/wording.h"
#include "core/foundations/base/words.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/theory/states/state_edits.h"

namespace geargraph::cli {
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
  std::vector<CouplingId> engaged = found->engaged;
  Expected<Mechanism> next = withStateEngaged(mechanism, static_cast<int>(found - mechanism.states.begin()));
  if (next) return *std::move(next);
  mechanism.engaged = std::move(engaged);  // a coupling closes a linkage: the analysis tells which
  return mechanism;
}

std::variant<Mechanism, UsageError> withList(Mechanism mechanism, std::string_view list) {
  std::vector<CouplingId> engaged;
  while (list != "none" && !list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const CouplingId id{std::string(list.substr(0, comma))};
    if (mechanism.find(id) == nullptr) {
      std::vector<std::string> names;
      for (const Coupling& coupling : mechanism.couplings) names.push_back(coupling.id.text());
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

std::variant<Mechanism, UsageError> withEngagementOptions(Mechanism mechanism, const Arguments& arguments) {
  const auto state = arguments.value("--state");
  const auto list = arguments.value("--engage");
  if (state && list) return UsageError{translated("Give --state NAME or --engage A,B.")};
  if (state) return inState(std::move(mechanism), *state);
  if (list) return withList(std::move(mechanism), *list);
  return mechanism;
}

std::variant<Mechanism, int> loadEngaged(const Command& command, const Arguments& arguments) {
  auto document = loadOrSay(arguments.files.front());
  if (const int* status = std::get_if<int>(&document)) return *status;
  auto engaged = withEngagementOptions(std::get<Mechanism>(std::move(document)), arguments);
  if (const auto* error = std::get_if<UsageError>(&engaged)) return wrongUsage(command, error->message);
  return std::get<Mechanism>(std::move(engaged));
}

std::string titleOf(const Mechanism& mechanism) {
  return mechanism.name.empty() ? translated("Mechanism") : mechanism.name;
}

std::string engagementText(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const CouplingId id : mechanism.engaged) names.push_back(id.text());
  if (names.empty()) return {};
  const int state = engagedState(mechanism);
  const std::string all = listed(names, kAllNames);
  return state < 0
             ? all
             : translated("%1 (state %2)", {all, mechanism.states[static_cast<std::size_t>(state)].name});
}

}  // namespace geargraph::cli
