#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/design/gearboxes/hub_search.h"

namespace geargraph {

/// The wheels that have the same teeth in all candidates that can be assembled.
[[nodiscard]] std::vector<std::pair<std::string, int>> sharedWheels(const HubSearch& search);
/// Candidates, by position, that have the same exact ratios in all gears: no turning tells them apart. Groups
/// of two or more.
[[nodiscard]] std::vector<std::vector<std::size_t>> inseparable(const HubSearch& search);
/// By answer: the candidates, by position, that it leaves.
[[nodiscard]] std::map<std::string, std::vector<std::size_t>> leftBy(const HubQuestion& question);

/// The format "geargraph-hardware" (resources/schema/README.md): the first `limit` candidates, all if it is
/// negative; what they share and what decides between them is of all.
[[nodiscard]] std::string hardwareJson(const HubWish& wish, const HubSearch& search, std::int64_t limit);

}  // namespace geargraph
