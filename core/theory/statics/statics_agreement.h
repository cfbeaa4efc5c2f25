#pragma once

#include <optional>
#include <stop_token>

#include "core/theory/statics/statics_solution.h"
#include "core/theory/ttgraph/tt_statics.h"

namespace geargraph {

/// Both methods' torques side by side, mesh by mesh and held part by held part, as fractions.
struct StaticsAgreement {
  bool equal = true;
  Real largestDifference;
  int compared = 0;         ///< torques
  std::vector<int> meshes;  ///< whose port torques differ, ascending
  std::vector<int> held;    ///< held parts that differ, ascending
};

/// Compares the determined torques of both solutions; both have to hold the same loads and determine the same
/// torques.
/// @pre the solution is one without losses
[[nodiscard]] StaticsAgreement staticsAgreement(const KinematicModel& model, const StaticsSolution& matroid,
                                                const TtTorques& ttGraph);

/// The held parts as further chords of the T-T graph, one each, in order.
[[nodiscard]] std::vector<TtChord> chordsOf(std::span<const HeldPart> held);

}  // namespace geargraph
