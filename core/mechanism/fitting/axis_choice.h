#pragma once

#include <cstdint>

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph::inline fitting {

/// How an axis is to lie: along an axis of the base frame, or as another axis says.
struct AxisChoice {
  enum class Way : std::uint8_t {
    alongX,
    alongY,
    alongZ,
    squareTo,       ///< at right angles to `other`; it keeps as much of its own direction as that allows
    parallelTo,     ///< in the direction of `other`
    throughMeeting  ///< through the point where `other` meets the axis of its first bevel pair; where it
                    ///< meets none, through its point
  };
  Way way = Way::alongZ;
  AxisId other = {};  ///< of the last three
};

/// The axis lies as chosen and is stated so; where its meshes lay it like that already, it stays open. The
/// first axis is stated with it where none was, so that the others stay. What was guessed of the meshes
/// between it and its neighbours gives way: pairs whose axes are parallel no more become bevels with
/// withKindFitted(), bevels whose axes are parallel now become external. Refuses unknown-id, and what the
/// geometry does not allow.
[[nodiscard]] Expected<PlacedMechanism> withAxisChosen(const PlacedMechanism& before, AxisId axis,
                                                       const AxisChoice& choice);

}  // namespace geargraph::inline fitting
