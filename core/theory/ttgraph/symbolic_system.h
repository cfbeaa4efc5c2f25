#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/foundations/exact/fields.h"
#include "core/theory/ttgraph/tt_system.h"

namespace geargraph {

/// The equations over rational functions, without what is redundant or vanishes. Used by ttSymbolicSolution()
/// and substitutionSteps(). The graph and the plan that it was made from outlive it.
struct SymbolicSystem {
  std::unique_ptr<const RationalFunctionField> field;
  std::vector<std::vector<char>> vanishing;  ///< by input, then by column: the rate is 0 whatever the ratios
  TtSystem<RationalFunctionField> system;
  /// The coupled equations exceeded the budget and are left out.
  bool withoutCoupled = false;
};

/// 1. Equations that are redundant at the ratios' own values are left out; the ratios of such meshes depend
/// on others.
/// 2. Rates that vanish identically, found at random ratios modulo a prime, are not computed.
/// 3. The elimination of the coupled rest, which stops when a function exceeds the budget.
///
/// std::nullopt if `stop` was requested.
[[nodiscard]] std::optional<SymbolicSystem> symbolicSystem(const RatioRingPtr& ring, const TtGraph& graph,
                                                           const SubstitutionPlan& plan,
                                                           const std::stop_token& stop);

}  // namespace geargraph
