#pragma once

#include <optional>
#include <stop_token>

#include "core/foundations/base/expected.h"
#include "core/theory/dynamics/link_inertia.h"
#include "core/theory/dynamics/simulation.h"
#include "core/theory/matroid/matroid_analysis.h"

namespace geargraph {

/// A mechanism as dynamics sees it: the inertias of its links, and the equation of motion in its inputs.
struct MechanismDynamics {
  std::vector<LinkInertia> links;  ///< by position
  std::vector<int> inputs;         ///< joints, in the order of angles, speeds and torques
  DynamicTrain train;
};

/// The dynamics of a mechanism as engaged, with its loads and its gravity. Lengths are converted to metres
/// and measured from a point of the train, so that a train far from the origin loses no precision.
///
/// Fails with unknown-unit where the unit of length is not known. std::nullopt if `stop` was requested.
/// Cost: linkInertias().
/// @pre all arguments belong to one mechanism without errors; the analysis has a solution with its matrix
[[nodiscard]] std::optional<Expected<MechanismDynamics>> dynamicsOf(
    const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
    const MatroidAnalysis& analysis, const GearTrain& train, const std::stop_token& stop = {});

/// The loads of a document as they act on a moving train. Torques on links turn about the line of an axis as
/// it moves with the link that carries it; forces keep their direction, and their point moves with the link.
/// `metres`: in one of the document's length unit.
/// @pre the placement has a tree; loads name elements of the mechanism
[[nodiscard]] std::vector<MovingLoad> movingLoads(const Mechanism& mechanism, const Placement& placement,
                                                  std::span<const Load> loads, double metres);

}  // namespace geargraph
