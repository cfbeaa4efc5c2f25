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

/// A point of the half-tooth profile in one section of the teeth. The other half is mirrored before both are
/// turned.
struct WallPoint {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;                           ///< of the wall, before it is turned
  double turn = 0;                                  ///< rad, about the axis
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();  ///< the gradient of `turn`
};

/// The body below the teeth: its profile from the top face to the bottom face (poles where there is no bore).
struct BodyBelow {
  std::vector<ProfileVertex> body;
  /// Openings in the body's two strips between the circles (rim, half) and (hub, half), and (hub, -half) and
  /// (rim, -half).
  std::optional<WebWindows> windows;
  double tolerance = 0;  ///< chordal error of the body's circles, a length
};

/// The input of meshed(): half a tooth from the middle of the space to the middle of the tip, and the body.
struct GearBlank {
  int teeth = 0;
  bool inward = false;  ///< a ring: teeth point towards the axis, the body is outside
  std::vector<OutlinePoint> half;
  /// Sections of the teeth from the bottom face to the top face, whose `half` is a cylinder then; empty:
  /// straight walls.
  std::vector<TwistLayer> layers = {};
  /// Of teeth that no turned cylinder is, instead: all sections, from the bottom face to the top face, the
  /// first and the last with the positions of `half` (but for their turn).
  std::vector<std::vector<WallPoint>> sections = {};
  BodyBelow below;
};

/// One closed, oriented, 2-manifold mesh. Tooth k is tooth 0 turned by 2 pi k / z with its own sine and
/// cosine (no error accumulates), and the last tooth ends on the vertices of the first: watertight by
/// construction. The end faces of a tooth are triangle strips between mirrored points, which never intersect,
/// even with undercut. Cost: O(vertices).
[[nodiscard]] Solid meshed(const GearBlank& blank);

/// Where a face of the teeth ends at the body: its polygon, and the normal there (radial, axial).
struct FaceLoop {
  Loop loop;
  Eigen::Vector2d normal;
};

/// The vertices of each circle of a body, and the body itself, sewn to teeth whose loops begin at the angle
/// `start`.
[[nodiscard]] int circleCountOf(const BodyBelow& below);
void sewBodyBelow(ShellBuilder& builder, const BodyBelow& below, int count, double start, const FaceLoop& top,
                  const FaceLoop& bottom);

}  // namespace geargraph
