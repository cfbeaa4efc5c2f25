#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/foundations/exact/expansion.h"
#include "core/foundations/exact/fields.h"
#include "core/foundations/exact/pi_number.h"
#include "core/theory/ttgraph/substitution.h"

namespace geargraph {

/// Joint rates as a matrix over the input rates [AU, Eqs. (43), (45)]: outputs x inputs.
///
/// Entry (o, k) is the rate of joint outputs[o] where input k turns at 1 and the others stand still.
template <class Value>
struct RateMatrix {
  std::vector<int> outputs;  ///< joints by ordinal, ascending
  std::vector<int> inputs;   ///< joints by ordinal, in the order of the document's inputs
  std::vector<std::vector<Value>> entries;
  /// True if no rate is left open and the equations that were not needed hold for every input. False for
  /// invalid inputs: then the matrix is no solution.
  bool determined = true;
};

/// Whether the inputs determine the motion, and the equations that add nothing.
struct TtDetermination {
  std::vector<int> openJoints;  ///< no equation gives them: too few inputs, or dependent ones
  bool contradictory = false;   ///< the equations force a relation among the inputs
  /// Not needed for the solution: meshes, and from c() on engaged couplings.
  std::vector<int> surplusEquations;
  [[nodiscard]] bool valid() const { return openJoints.empty() && !contradictory; }
};

/// Decided modulo a random prime of 61 bits: where it says valid, it is.
/// Cost: the circuit terms, and the elimination of the coupled rest. std::nullopt if `stop` was requested.
[[nodiscard]] std::optional<TtDetermination> ttDetermination(const TtGraph& graph,
                                                             const SubstitutionPlan& plan,
                                                             const std::stop_token& stop = {});

/// The rates of all joints, by joint, for these rates of the plan's inputs. Exact; std::nullopt if `stop` was
/// requested.
/// @pre the inputs are valid, and no terminal equation has a power of pi
[[nodiscard]] std::optional<std::vector<Rational>> ttRates(const TtGraph& graph, const SubstitutionPlan& plan,
                                                           std::span<const Rational> inputRates,
                                                           const std::stop_token& stop = {});
/// The same in doubles with their residues modulo a prime, so that zeros are exact; fast enough for dragging.
[[nodiscard]] std::optional<std::vector<ModularDouble>> ttRates(const ModularDoubleField& field,
                                                                const TtGraph& graph,
                                                                const SubstitutionPlan& plan,
                                                                std::span<const ModularDouble> inputRates,
                                                                const std::stop_token& stop = {});

/// The whole matrix, exact; `determined` is false if the inputs are not valid. std::nullopt if `stop` was
/// requested. Cost: that of ttRates() for each input.
/// @pre no terminal equation has a power of pi
[[nodiscard]] std::optional<RateMatrix<Rational>> ttSolution(const TtGraph& graph,
                                                             const SubstitutionPlan& plan,
                                                             const std::stop_token& stop = {});
/// The same with powers of pi, which are found along the circuits.
[[nodiscard]] std::optional<RateMatrix<PiNumber>> ttPiSolution(const TtGraph& graph,
                                                               const SubstitutionPlan& plan,
                                                               const std::stop_token& stop = {});

/// The whole matrix as functions of the gear ratios; an entry is none if it, or the coupled equations that
/// give it, exceeded the budget; all are none if the plan is by levels. std::nullopt if `stop` was requested.
///
/// `ring` has a variable for each mesh, N_tail / N_head, in the order of the meshes: ttRatioRing() makes one.
/// Redundant (surplus) meshes are left out: their ratios depend on the others.
/// @pre the inputs are valid
[[nodiscard]] std::optional<RateMatrix<std::optional<RationalFunction>>> ttSymbolicSolution(
    const RatioRingPtr& ring, const TtGraph& graph, const SubstitutionPlan& plan,
    const std::stop_token& stop = {}, ExpansionBudget budget = {});

enum class RatioNaming { matroid, ttGraph };  ///< i15, or n41 [AU, Eq. (44)]

/// The ring of the graph's ratios under these names, with their values.
[[nodiscard]] RatioRingPtr ttRatioRing(const TtGraph& graph, RatioNaming naming);

}  // namespace geargraph
