#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/cli/arguments.h"
#include "core/foundations/base/translation.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph::cli {

/// `--load joint:14=10Nm`, `--load link:3@e=10Nm`, `--load link:3=10,-20,-50N@30,-60,130`, `--no-loads`,
/// `--balance joint:8`, `--balance link:7@a`, `--efficiency`, `--eta 0.98`, `--share none|stiffness`: joints
/// and links by label, axes by id, torques in Nm, Nmm or kNm, forces in N at a point in the document's unit.
/// All members of StaticsOptions except the state.
[[nodiscard]] std::variant<StaticsOptions, UsageError> staticsOptions(const Mechanism& mechanism,
                                                                      const Arguments& arguments);

/// Reads `--eta 0.98` and `--share none|stiffness`; what is wrong with them.
[[nodiscard]] std::optional<UsageError> readLossOptions(const Arguments& arguments, StaticsOptions& options);

inline constexpr Option kShareOption{
    "--share", "none|stiffness",
    toTranslate("loads that several meshes share: left open, or by equal stiffness")};

/// The indices of the states to solve, by `--state NAME` and `--all-states`; -1: no state.
[[nodiscard]] std::variant<std::vector<int>, UsageError> statesAsked(const Mechanism& mechanism,
                                                                     const Arguments& arguments);

}  // namespace geargraph::cli
