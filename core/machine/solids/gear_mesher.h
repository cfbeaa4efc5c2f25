#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/machine/solids/shell_builder.h"
#include "core/machine/solids/web_windows.h"

namespace geargraph {

/// A point of the half-tooth profile at both faces, in the frame of tooth 0 (its half with y >= 0), lengths.
struct OutlinePoint {
  Eigen::Vector3d bottom;  ///< at the face of smaller z (bevel: the small end)
  Eigen::Vector3d top;
  Eigen::Vector3d wallNormal;
  Eigen::Vector3d bottomNormal;
  Eigen::Vector3d topNormal;
  bool corner = false;  ///< has the positions of the point before it with another wall normal
};

/// A section of a twisted wheel: the profile turned by an angle. Two at one height are an edge where the
/// twist changes.
struct TwistLayer {
  double height = 0;
  double turn = 0;   ///< rad
  double slope = 0;  ///< of the walls there: d turn / d height
};

/// The input of meshed(): half a tooth from the middle of the space to the middle of the tip, and the profile
/// of the body from the top face to the bottom face (poles where there is no bore).
struct GearBlank {
  int teeth = 0;
  bool inward = false;  ///< a ring: teeth point towards the axis, the body is outside
  std::vector<OutlinePoint> half;
  /// Sections of the teeth from the bottom face to the top face, whose `half` is a cylinder then; empty:
  /// straight walls.
  std::vector<TwistLayer> layers = {};
  std::vector<ProfileVertex> body;
  /// Openings in the body's two strips between the circles (rim, half) and (hub, half), and (hub, -half) and
  /// (rim, -half).
  std::optional<WebWindows> windows;
  double tolerance = 0;  ///< chordal error of the body's circles, a length
};

/// One closed, oriented, 2-manifold mesh. Tooth k is tooth 0 turned by 2 pi k / z with its own sine and
/// cosine (no error accumulates), and the last tooth ends on the vertices of the first: watertight by
/// construction. The end faces of a tooth are triangle strips between mirrored points, which never intersect,
/// even with undercut. Cost: O(vertices).
[[nodiscard]] Solid meshed(const GearBlank& blank);

}  // namespace geargraph
