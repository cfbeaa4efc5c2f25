#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/foundations/exact/rational_function.h"
#include "core/theory/matroid/coefficient_matrix.h"
#include "core/theory/ttgraph/substitution.h"
#include "core/theory/ttgraph/tt_graph.h"

namespace geargraph {

/// The operation count of a calculation by hand. Products and quotients with 0, 1 and -1 and sums with 0 are
/// not counted.
struct Operations {
  long long products = 0;
  long long sums = 0;

  Operations& operator+=(const Operations& other) {
    products += other.products;
    sums += other.sums;
    return *this;
  }
  friend bool operator==(const Operations&, const Operations&) = default;
};

// Both methods as carried out on paper, with their operations counted. Each computes the solution matrix,
// outputs x inputs, from given equations. The values are fractions, or functions of the gear ratios (then
// std::nullopt if an entry exceeds kMaxHandTerms terms).

constexpr long long kMaxHandTerms = 100;

template <class Value>
struct HandSolution {
  std::vector<std::vector<Value>> matrix;  ///< by output, by input
  Operations operations;
  std::vector<int> together;  ///< equations of the T-T graph that were eliminated together, being coupled
};

/// The equations over the joints in their order, one per mesh or engaged coupling: the rows of P divided by
/// the radius of the head's gear.
template <class Value>
using HandRows = std::vector<std::vector<Value>>;

/// By Eq. (23) of [AU]: the inverse of P_r by Gauss-Jordan elimination, then its product with P_E. In each
/// column the row with the fewest unknowns is the pivot.
/// Cost: O(r^3). @pre the rows are independent and the inputs valid
[[nodiscard]] HandSolution<Rational> solvedByInverse(const HandRows<Rational>& rows,
                                                     std::span<const int> inputs,
                                                     std::span<const int> outputs);
[[nodiscard]] std::optional<HandSolution<RationalFunction>> solvedByInverse(
    const HandRows<RationalFunction>& rows, std::span<const int> inputs, std::span<const int> outputs,
    const RatioRingPtr& ring);

/// By Eqs. (39)-(42) of [AU]: mesh by mesh in the plan's order, the known chord of a mesh as the sum of its
/// circuit, times the ratio, gives the other chord, and that gives the unknown. Coupled equations are then
/// eliminated together. Outputs and inputs are in the plan's order.
/// @pre the plan is the graph's, not by levels, its inputs valid; surplus equations are not used
[[nodiscard]] HandSolution<Rational> solvedBySubstitution(const TtGraph& graph, const SubstitutionPlan& plan);
/// The same in symbols. `together`: HandSolution::together of the solution in fractions, because equations
/// may be dependent for these teeth only.
[[nodiscard]] std::optional<HandSolution<RationalFunction>> solvedBySubstitution(
    const TtGraph& graph, const SubstitutionPlan& plan, std::span<const int> together,
    const RatioRingPtr& ring);

/// The operations from the coordinates to the rows of P, Eqs. (10)-(20): for each joint of a cycle the vector
/// from the pitch point to its axis, the part of its moment along the normal of the mesh, and for each mesh
/// one quotient, its ratio.
[[nodiscard]] Operations geometryOperations(const Mechanism& mechanism, const KinematicModel& model,
                                            const Placement& placement);

}  // namespace geargraph
