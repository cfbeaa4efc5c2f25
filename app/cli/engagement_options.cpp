#include "app/cli/engagement_options.h"

#include <utility>
#include <vector>

#include "app/cli/load.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/theory/states/state_edits.h"

namespace geargraph::cli {

std::variant<Mechanism, int> loadEngaged(const Command& command, const Arguments& arguments) {
  auto document = loadOrSay(arguments.files.front(), command);
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
  for (const ShiftElementId id : mechanism.engaged) names.push_back(id.text());
  if (names.empty()) return {};
  const int state = engagedState(mechanism);
  const std::string all = listed(names, kAllNames);
  return state < 0
             ? all
             : translated("%1 (state %2)", {all, mechanism.states[static_cast<std::size_t>(state)].name});
}

}  // namespace geargraph::cli
