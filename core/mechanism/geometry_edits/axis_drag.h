#pragma once

#include <optional>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph {

// What follows when an axis is dragged: either the module changes, or tooth counts are offered that bring the
// axis near the new place at the present module.

/// Moves the axis to a point; the module of its wheels, and of all wheels that mesh with them, changes
/// accordingly. Rejects unknown-id, pitch-point-on-axis, and teeth-geometry where something pinned prevents
/// it.
[[nodiscard]] Expected<PlacedMechanism> withAxisMoved(const PlacedMechanism& before, AxisId axis,
                                                      const NumberTriple& point);

/// The distance of an axis from the parallel axis that it meshes with.
struct AxisReach {
  AxisId from;          ///< the parallel axis nearest the ground
  double distance = 0;  ///< centre distance
  double module = 1;    ///< of their wheels
  Vector3 outward{};    ///< unit vector from that axis to this one, perpendicular to both
};
/// std::nullopt if the axis has no mesh of parallel axes.
[[nodiscard]] std::optional<AxisReach> axisReach(const PlacedMechanism& placed, AxisId axis);

/// Moves the axis along its ray to `factor` times that distance, as withAxisMoved(). @pre axisReach(), factor
/// > 0
[[nodiscard]] Expected<PlacedMechanism> withAxisReach(const PlacedMechanism& before, AxisId axis,
                                                      const Rational& factor);

/// The step of the module while an axis is dragged with snapping.
constexpr double kModuleStep = 0.05;

/// Drags the axis by a displacement in the base frame. An axis with meshes of parallel axes moves along its
/// ray from the axis that it meshes with nearest the ground, and the module follows the centre distance; any
/// other axis moves by the component perpendicular to itself. `snapped`: the module is rounded to
/// kModuleStep, a position to whole length units. Rejects unknown-id and what withAxisMoved() rejects.
[[nodiscard]] Expected<PlacedMechanism> withAxisDragged(const PlacedMechanism& before, AxisId axis,
                                                        const Vector3& way, bool snapped);

/// Tooth counts that bring an axis near a new place at the present module.
struct TeethOffer {
  MeshId mesh;
  int tailTeeth = 1;
  int headTeeth = 1;
  double distance = 0;  ///< the centre distance that they give
};

/// Tooth counts for a new distance from the axis that it meshes with, changing the wheel on the moved axis:
/// at most `most`, the nearest distance first, each of which fits the rest of the train. Empty without
/// axisReach().
[[nodiscard]] std::vector<TeethOffer> teethNear(const PlacedMechanism& placed, AxisId axis, double distance,
                                                std::size_t most = 4);

}  // namespace geargraph
