#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/mechanism/mechanism.h"

namespace geargraph {

using Triple = std::array<double, 3>;  ///< x y z in the base frame

/// The line of an axis in the reference pose; the direction has length 1.
struct AxisLine {
  Triple point{};
  Triple direction{};
};

/// Where the T-T graph method looks when it needs the drawn pose: to tell which joints are coaxial and which
/// way two meshing gears turn. A place is none where the document leaves it out and nothing placed it.
struct ReferenceLines {
  std::vector<std::optional<AxisLine>> axes;       ///< by position in Mechanism::axes
  std::vector<std::optional<Triple>> pitchPoints;  ///< by position in Mechanism::gearMeshes
};

/// What the document itself says.
[[nodiscard]] ReferenceLines drawnLines(const Mechanism& mechanism);

[[nodiscard]] Triple difference(const Triple& a, const Triple& b);
[[nodiscard]] double dot(const Triple& a, const Triple& b);
[[nodiscard]] Triple cross(const Triple& a, const Triple& b);
[[nodiscard]] double length(const Triple& a);

/// The same direction or the opposite one, to 1e-9.
[[nodiscard]] bool areParallel(const AxisLine& a, const AxisLine& b);
/// The same line in space, whichever way it points, to 1e-9 of `size`, the size of the mechanism.
[[nodiscard]] bool areCollinear(const AxisLine& a, const AxisLine& b, double size);

}  // namespace geargraph
