#pragma once

#include <optional>
#include <vector>

#include "core/theory/statics/power_flow.h"

namespace geargraph {

/// Power that circulates in a loop of the train, in addition to the power from the input to the output.
struct Circulation {
  Real power;               ///< W, the least power on the loop; above 0
  std::vector<int> links;   ///< of the shafts on the loop, ascending
  std::vector<int> meshes;  ///< of the gear sets on the loop, ascending
};

/// At most this many loops are reported, those of the greatest power.
constexpr int kMaxCirculations = 64;

/// The loops of a flow in the ground's frame, the greatest first. Meshes that share a planet are one gear
/// set, links joined by engaged clutches one shaft; from a set to a shaft there is an edge where the set
/// delivers power to the shaft, from the shaft to the set where it takes power. A directed cycle circulates:
/// the widest one (whose least edge is greatest) is reported and subtracted, until none is left.
///
/// A planet is a link with one joint that meshes on its own moving carrier only, without loads, balances and
/// couplings. std::nullopt if a link other than a planet does not turn on the ground, or if the powers of the
/// sets are not determined: then the loops are no property of the train.
///
/// Cost: O((n + c) log (n + c)) per loop.
/// @pre the flow is that of this problem and solution, seen from the ground
[[nodiscard]] std::optional<std::vector<Circulation>> circulationsOf(
    const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
    const StaticsProblem& problem, const StaticsSolution& lossless, const PowerFlow& flow);

}  // namespace geargraph
