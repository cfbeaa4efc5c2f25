#pragma once

#include <cstdint>

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph {

/// A new direction or place for an axis: along an axis of the base frame, or relative to another axis.
struct AxisChoice {
  enum class Way : std::uint8_t {
    alongX,
    alongY,
    alongZ,
    squareTo,            ///< at right angles to `other`; its own direction is projected
    parallelTo,          ///< in the direction of `other`
    throughIntersection  ///< through the point where `other` intersects the axis of its first bevel pair; if
                         ///< it has none, through its reference point
  };
  Way way = Way::alongZ;
  AxisId other = {};  ///< for the last three
};

/// Places the axis as chosen and states the place in the document; if its meshes already give that place, the
/// axis stays open. If no axis was stated, the first one is stated too, so that the others stay. Kinds of
/// meshes on the axis that were guessed are adapted: pairs whose axes are no longer parallel become bevels by
/// withKindFitted(), bevels whose axes are now parallel become external. Rejects unknown-id, and places that
/// the geometry does not allow.
[[nodiscard]] Expected<PlacedMechanism> withAxisChosen(const PlacedMechanism& before, AxisId axis,
                                                       const AxisChoice& choice);

}  // namespace geargraph
