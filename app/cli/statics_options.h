#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/cli/arguments.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph::cli {

/// `--load joint:14=10Nm`, `--load link:3@e=10Nm`, `--load link:3=10,-20,-50N@30,-60,130`, `--no-loads`,
/// `--balance joint:8`, `--balance link:7@a`, `--efficiency`, `--eta 0.98`, `--share none|stiffness`: joints
/// and links by label, axes by id, torques in Nm, Nmm or kNm, forces in N at a point in the document's unit.
/// Everything of StaticsOptions but the state.
[[nodiscard]] std::variant<StaticsOptions, UsageError> staticsOptions(const Mechanism& mechanism,
                                                                      const Arguments& arguments);

/// `--state NAME` and `--all-states`: the positions of the states to solve, -1 for none engaged.
[[nodiscard]] std::variant<std::vector<int>, UsageError> statesAsked(const Mechanism& mechanism,
                                                                     const Arguments& arguments);

}  // namespace geargraph::cli
