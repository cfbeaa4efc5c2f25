#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/foundations/exact/fields.h"
#include "core/theory/ttgraph/tt_system.h"

namespace geargraph::inline ttgraph {

/// The equations over rational functions, without what is redundant or vanishes. Used by ttSymbolicSolution()
/// and substitutionSteps(). Refers to the graph and the plan it was made from.
struct SymbolicSystem {
  std::unique_ptr<const RationalFunctionField> field;
  std::vector<std::vector<char>> vanishing;  ///< by input, then by column: the rate is 0 whatever the ratios
  TtSystem<RationalFunctionField> system;
  /// The coupled equations went over what anybody reads and are left out.
  bool withoutCoupled = false;
};

/// 1. Which equations are redundant at the ratios' own values: they are left out; the ratios of such
/// meshes are bound to others.
/// 2. Which rates vanish identically, found at random ratios modulo a prime: they are not computed.
/// 3. The elimination of the coupled rest, which stops where a function grows beyond reading.
///
/// None where `stop` was requested.
[[nodiscard]] std::optional<SymbolicSystem> symbolicSystem(const RatioRingPtr& ring, const TtGraph& graph,
                                                           const SubstitutionPlan& plan,
                                                           const std::stop_token& stop);

}  // namespace geargraph::inline ttgraph
