#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/foundations/exact/rational_function.h"
#include "core/theory/matroid/coefficient_matrix.h"
#include "core/theory/ttgraph/substitution.h"
#include "core/theory/ttgraph/tt_graph.h"

namespace geargraph::inline comparison {

/// The arithmetic of a calculation by hand. Products (and quotients) with 0, 1 and -1 and sums with 0 cost
/// nothing and are not counted.
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

// Both methods as one would carry them out on paper, counted while they are carried out. Each gives the
// solution matrix, outputs x inputs, from equations that are there. The values are fractions, or functions of
// the gear ratios (then nothing where an entry grows beyond kMostHandTerms terms).

constexpr long long kMostHandTerms = 100;

template <class Value>
struct HandSolution {
  std::vector<std::vector<Value>> matrix;  ///< by output, by input
  Operations operations;
  std::vector<int> together;  ///< equations of the T-T graph that were eliminated together
};

/// The equations over the joints in their order, one a mesh or an engaged coupling: the rows of P divided by
/// the radius of the head's gear.
template <class Value>
using HandRows = std::vector<std::vector<Value>>;

/// As Eq. (23) of [AU] says: the inverse of P_r by elimination (Gauss, Jordan), then its product with P_E.
/// In each column the row with the fewest unknowns is the pivot.
/// Cost: O(r^3). @pre the rows are independent and the inputs valid
[[nodiscard]] HandSolution<Rational> solvedByInverse(const HandRows<Rational>& rows,
                                                     std::span<const int> inputs,
                                                     std::span<const int> outputs);
[[nodiscard]] std::optional<HandSolution<RationalFunction>> solvedByInverse(
    const HandRows<RationalFunction>& rows, std::span<const int> inputs, std::span<const int> outputs,
    const RatioRingPtr& ring);

/// As Eqs. (39)-(42) say: mesh by mesh in the plan's order, the known chord of a mesh as the sum of its
/// circuit, times the ratio, gives the other chord, and this the unknown. What is coupled is then eliminated
/// together. By output and input, in the plan's order of them.
/// @pre the plan is the graph's, not by levels, its inputs valid; surplus equations are not used
[[nodiscard]] HandSolution<Rational> solvedBySubstitution(const TtGraph& graph, const SubstitutionPlan& plan);
/// The same in symbols. `together`: as in the solution in fractions, because equations may be dependent for
/// these teeth only.
[[nodiscard]] std::optional<HandSolution<RationalFunction>> solvedBySubstitution(
    const TtGraph& graph, const SubstitutionPlan& plan, std::span<const int> together,
    const RatioRingPtr& ring);

/// From the coordinates to the rows of P, Eqs. (10)-(20): for each joint of a cycle the vector from the pitch
/// point to its axis, the part of its moment along the normal of the mesh, and for each mesh one quotient,
/// its ratio.
[[nodiscard]] Operations geometryOperations(const Mechanism& mechanism, const KinematicModel& model,
                                            const Placement& placement);

}  // namespace geargraph::inline comparison
