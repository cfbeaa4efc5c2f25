#pragma once

#include <optional>
#include <vector>

#include "core/placement/placement.h"

namespace geargraph {

/// The line of an axis in the reference pose.
struct ReferenceLine {
  Vector3 point{};
  Vector3 direction{0, 0, 1};  ///< of length 1
  bool automatic = false;      ///< placed by the program
};

/// Where the T-T graph method looks when it needs the drawn pose: to tell which joints are coaxial and which
/// way two meshing gears turn. A place is none where nothing says it.
struct ReferenceLines {
  std::vector<std::optional<ReferenceLine>> axes;   ///< by position in Mechanism::axes
  std::vector<std::optional<Vector3>> pitchPoints;  ///< by position in Mechanism::gearMeshes
};

/// The completed geometry of the document. Of a placement this method takes where things are, and no more: it
/// finds levels, carriers and signs by itself.
[[nodiscard]] ReferenceLines referenceLines(const Placement& placement);

/// The same direction or the opposite one, as far as decimals tell.
[[nodiscard]] bool areParallel(const ReferenceLine& a, const ReferenceLine& b);
/// The same line in space, whichever way it points, as far as decimals tell.
[[nodiscard]] bool areCollinear(const ReferenceLine& a, const ReferenceLine& b);

}  // namespace geargraph
