#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/machine/train/train.h"
#include "core/theory/pose/forward_kinematics.h"

namespace geargraph {

/// The triangles of a part in a bounding volume hierarchy of FCL.
class CollisionShape;

/// A piece of a link that can collide with others: a wheel as the solid of revolution swept by its tips, or
/// one part of a body (a shaft, an arm, a bearing). In the base frame, in the reference pose.
struct CollisionPart {
  LinkOrdinal link = 0;
  double module = 1;  ///< the unit of resolutions
  /// The line about which it is a solid of revolution; none: it is not one.
  std::optional<TurningLine> revolvedAbout;
  std::shared_ptr<const CollisionShape> shape;
  Eigen::Vector3d centre{0, 0, 0};  ///< of the bounding sphere
  double radius = 0;
};

/// Chordal error of the parts' surfaces, modules.
constexpr double kCollisionTolerance = 0.05;

/// The parts of all links of a train. Windows of wheels are filled, because a part that passes through one
/// collides as the wheel turns. Incomplete if `stop` was requested. Cost: O(triangles), about 0.1 ms per
/// wheel.
[[nodiscard]] std::vector<CollisionPart> collisionParts(const GearTrain& train,
                                                        const std::stop_token& stop = {});

/// A part from a solid in the base frame. @pre it has triangles
[[nodiscard]] CollisionPart collisionPart(LinkOrdinal link, const Solid& solid, double module,
                                          const std::optional<TurningLine>& revolvedAbout = {});

/// The extent of a solid about a line: distances from it, and coordinates along it from the line's point.
struct AxialExtent {
  double inner = 0;  ///< of the surface; 0 if the line passes through it
  double outer = 0;
  double low = 0;
  double high = 0;
};
/// The extent of a part about a line. Cost: O(triangles).
[[nodiscard]] AxialExtent axialExtent(const CollisionPart& part, const TurningLine& line);

/// The greatest distance of the part's points from a point. Cost: O(vertices).
[[nodiscard]] double reachFrom(const CollisionPart& part, const Eigen::Vector3d& point);

}  // namespace geargraph
