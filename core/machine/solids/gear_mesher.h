#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/machine/solids/shell_builder.h"
#include "core/machine/solids/web_windows.h"

namespace geargraph::inline solids {

/// A point of half a tooth at both ends of the tooth, in the frame of tooth 0 (its half with y >= 0), as
/// lengths.
struct OutlinePoint {
  Eigen::Vector3d bottom;  ///< at the end of small z (bevel: the small end)
  Eigen::Vector3d top;
  Eigen::Vector3d wallNormal;
  Eigen::Vector3d bottomNormal;
  Eigen::Vector3d topNormal;
  bool corner = false;  ///< the same positions as the point before it, another wall normal
};

/// What the mesher makes a gear of: half a tooth from the middle of the space to the middle of the tip, and
/// the meridian of the body from the top face round to the bottom face (poles where there is no bore).
struct GearBlank {
  int teeth = 0;
  bool inward = false;  ///< a ring: teeth point to the axis, the body lies outside
  std::vector<OutlinePoint> half;
  std::vector<ProfileVertex> body;
  /// Openings in the body's two strips between the circles (rim, half) and (hub, half), and (hub, -half) and
  /// (rim, -half).
  std::optional<WebWindows> windows;
  double tolerance = 0;  ///< for the circles of the body, a length
};

/// One closed, oriented, 2-manifold mesh. Tooth k is tooth 0 turned by 2 pi k / z with one sine and cosine of
/// its own (nothing accumulates), the last tooth ends on the vertices of the first: watertight by
/// construction. Faces of the teeth are ladders of rungs between mirrored points; they never cross, even when
/// undercut. Cost: O(vertices).
[[nodiscard]] Solid meshed(const GearBlank& blank);

}  // namespace geargraph::inline solids
