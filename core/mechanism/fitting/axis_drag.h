#pragma once

#include <optional>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph::inline fitting {

// What an axis that is dragged takes along. Either the module follows, or tooth counts are offered that bring
// the axis near the place with the module as it is.

/// The axis goes to a place, and the module of the wheels that hold it follows, with all that they mesh.
/// Refuses unknown-id, pitch-point-on-axis, and teeth-geometry where something pinned is in the way.
[[nodiscard]] Expected<PlacedMechanism> withAxisMoved(const PlacedMechanism& before, AxisId axis,
                                                      const NumberTriple& point);

/// Where an axis stands among the parallel ones that it meshes with.
struct AxisReach {
  AxisId from;          ///< the one nearest the ground
  double distance = 0;  ///< between both
  double module = 1;    ///< of their wheels
  Vector3 outward{};    ///< unit vector from that axis to this one, square to both
};
/// Nothing where the axis has no mesh of parallel axes.
[[nodiscard]] std::optional<AxisReach> axisReach(const PlacedMechanism& placed, AxisId axis);

/// The axis goes to `factor` times that distance on its ray, as withAxisMoved(). @pre axisReach(), factor > 0
[[nodiscard]] Expected<PlacedMechanism> withAxisReach(const PlacedMechanism& before, AxisId axis,
                                                      const Rational& factor);

/// The module of an axis that is dragged goes in steps of this where it snaps.
constexpr double kModuleStep = 0.05;

/// The axis is dragged by this way in the base frame. With meshes of parallel axes it keeps its ray from the
/// axis that it meshes with nearest the ground, and the module follows its distance there; one without goes
/// along, square to itself. `snapped`: the module to kModuleStep, a place to whole length units. Refuses
/// unknown-id and what withAxisMoved() refuses.
[[nodiscard]] Expected<PlacedMechanism> withAxisDragged(const PlacedMechanism& before, AxisId axis,
                                                        const Vector3& way, bool snapped);

/// Tooth counts that bring an axis near a place with the module as it is.
struct TeethOffer {
  MeshId mesh;
  int tailTeeth = 1;
  int headTeeth = 1;
  double distance = 0;  ///< the centre distance they make
};

/// The nearest counts for a new distance from the axis that it meshes with, the wheel on the moved axis
/// changed, the nearest first, `most` at most; each of them fits all else. Empty without axisReach().
[[nodiscard]] std::vector<TeethOffer> teethNear(const PlacedMechanism& placed, AxisId axis, double distance,
                                                std::size_t most = 4);

}  // namespace geargraph::inline fitting
