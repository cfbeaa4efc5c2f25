#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/design/teeth_search/teeth_answer.h"

namespace geargraph {

/// The conditions that were asked for, by name ("turns", "clears", "assembles", "hunting", "undercut",
/// "within"), each with the number of choices that pass it and all before it.
[[nodiscard]] std::vector<std::pair<std::string, std::int64_t>> filtersOf(const TeethProblem& problem,
                                                                          const TeethCounts& counts);

/// `geargraph-teeth` (resources/schema/README.md).
[[nodiscard]] std::string teethJson(const TeethAnswer& answer);

}  // namespace geargraph
