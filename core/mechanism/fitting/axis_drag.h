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
};
/// Nothing where the axis has no mesh of parallel axes.
[[nodiscard]] std::optional<AxisReach> axisReach(const PlacedMechanism& placed, AxisId axis);

/// The axis goes to `factor` times that distance on its ray, as withAxisMoved(). @pre axisReach(), factor > 0
[[nodiscard]] Expected<PlacedMechanism> withAxisReach(const PlacedMechanism& before, AxisId axis,
                                                      const Rational& factor);

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
