#pragma once

#include <Eigen/Geometry>
#include <span>

namespace geargraph::inline painting {

/// Directions that everybody who reads drawings knows: front looks along +y with x to the right, right looks
/// along -x, top looks down; isometric sees x, y and z equally short from (1, -1, 1).
enum class StandardView { front, back, left, right, top, bottom, isometric };

/// The size of the picture in device pixels.
struct Viewport {
  int width = 1;
  int height = 1;
  [[nodiscard]] double aspect() const { return static_cast<double>(width) / height; }
};

struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  ///< length 1
};

/// A place in the picture: pixels to the right and down from the upper left corner, and the depth in mm along
/// the line of sight (negative behind the eye).
struct ScreenPoint {
  double x = 0;
  double y = 0;
  double depth = 0;
};

/// Where the viewer stands: a value, like everything that can be undone, stored or compared. It circles a
/// target with z upright, so the horizon stays level; perspective with a small opening angle, as of a long
/// lens.
///
/// Units: mm, rad. Yaw is the azimuth of the eye about +z from +x, pitch its elevation, within ±90°.
class Camera {
 public:
  Camera() = default;
  [[nodiscard]] static Camera looking(StandardView view);
  /// How a train opens: a little from the right and above, where most of it can be seen.
  [[nodiscard]] static Camera home() { return from(-0.45, 0.35); }
  /// Eye at this azimuth and elevation.
  [[nodiscard]] static Camera from(double yaw, double pitch);

  [[nodiscard]] const Eigen::Vector3d& target() const { return m_target; }
  [[nodiscard]] double yaw() const { return m_yaw; }
  [[nodiscard]] double pitch() const { return m_pitch; }
  [[nodiscard]] double distance() const { return m_distance; }  ///< eye to target
  [[nodiscard]] Eigen::Vector3d eye() const { return m_target - m_distance * forward(); }
  [[nodiscard]] Eigen::Vector3d forward() const;
  [[nodiscard]] Eigen::Vector3d right() const;
  [[nodiscard]] Eigen::Vector3d up() const { return right().cross(forward()); }

  /// Turned about the target, as if the scene were taken by a hand that moves by this many pixels.
  /// Identity: target and distance stay; turning there and back is no turn, unless the pole was in the way.
  [[nodiscard]] Camera orbited(double pixelsRight, double pixelsDown) const;
  /// Moved so that what is at the target's depth follows the pointer.
  [[nodiscard]] Camera panned(double pixelsRight, double pixelsDown, const Viewport& viewport) const;
  /// `factor` > 1 comes nearer. Identity: `fixed`, a point in space, keeps its place in the picture.
  [[nodiscard]] Camera zoomed(double factor, const Eigen::Vector3d& fixed) const;
  /// The same direction, as near as all points stay in the picture with a margin (a part of each side).
  [[nodiscard]] Camera fitted(std::span<const Eigen::Vector3d> points, const Viewport& viewport,
                              double margin = 0.08) const;
  /// The same target and distance from a standard direction.
  [[nodiscard]] Camera turnedTo(StandardView view) const;
  /// The same target and distance, looking along a direction (not 0); x to the right where that is straight
  /// up or down.
  [[nodiscard]] Camera turnedAlong(const Eigen::Vector3d& direction) const;
  /// The same direction from another place. @pre distance > 0
  [[nodiscard]] Camera placedAt(const Eigen::Vector3d& target, double distance) const;

  [[nodiscard]] Eigen::Isometry3d view() const;  ///< world to eye; the eye looks along -z with y up
  /// Perspective for OpenGL's clip space, with everything within `radius` of `centre` between near and far.
  [[nodiscard]] Eigen::Matrix4d projection(const Viewport& viewport, const Eigen::Vector3d& centre,
                                           double radius) const;
  [[nodiscard]] ScreenPoint project(const Eigen::Vector3d& point, const Viewport& viewport) const;
  [[nodiscard]] Ray rayThrough(double x, double y, const Viewport& viewport) const;
  /// The point under the pixel in the plane of the target that faces the viewer.
  [[nodiscard]] Eigen::Vector3d atTargetDepth(double x, double y, const Viewport& viewport) const;
  [[nodiscard]] double millimetresPerPixel(const Viewport& viewport) const;  ///< at the target's depth

  friend bool operator==(const Camera&, const Camera&) = default;

 private:
  Eigen::Vector3d m_target = Eigen::Vector3d::Zero();
  double m_yaw = -0.6;
  double m_pitch = 0.4;
  double m_distance = 500;
};

}  // namespace geargraph::inline painting
