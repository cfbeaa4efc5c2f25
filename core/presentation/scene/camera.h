#pragma once

#include <Eigen/Geometry>
#include <span>

namespace geargraph {

/// The standard directions of drawings: front looks along +y with x to the right, right looks along -x, top
/// looks down; isometric looks from (1, -1, 1), with x, y and z equally foreshortened.
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

/// A point in the picture: pixels to the right and down from the upper left corner, and the depth in mm along
/// the line of sight (negative behind the eye).
struct ScreenPoint {
  double x = 0;
  double y = 0;
  double depth = 0;
};

/// The camera: an immutable value. It orbits a target with z upright, so the horizon stays level; perspective
/// with a small field of view, as of a long lens.
///
/// Units: mm, rad. Yaw is the azimuth of the eye about +z from +x, pitch its elevation, within ±90°.
class Camera {
 public:
  Camera() = default;
  [[nodiscard]] static Camera looking(StandardView view);
  /// The initial view: a little from the right and above, where most of a train is visible.
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

  /// Orbited about the target, as if the scene were dragged by this many pixels. Identity: target and
  /// distance stay; orbiting back restores the view, unless a pole was reached.
  [[nodiscard]] Camera orbited(double pixelsRight, double pixelsDown) const;
  /// Panned so that points at the target's depth follow the pointer.
  [[nodiscard]] Camera panned(double pixelsRight, double pixelsDown, const Viewport& viewport) const;
  /// Zoomed by `factor`, > 1 comes nearer. Identity: `fixed`, a point in space, keeps its place in the
  /// picture.
  [[nodiscard]] Camera zoomed(double factor, const Eigen::Vector3d& fixed) const;
  /// The same direction, as near as possible with all points in the picture and a margin (a fraction of each
  /// side).
  [[nodiscard]] Camera fitted(std::span<const Eigen::Vector3d> points, const Viewport& viewport,
                              double margin = 0.08) const;
  /// The same target and distance from a standard direction.
  [[nodiscard]] Camera turnedTo(StandardView view) const;
  /// The same target and distance, looking along a direction (not 0); x to the right if the direction is
  /// straight up or down.
  [[nodiscard]] Camera turnedAlong(const Eigen::Vector3d& direction) const;
  /// The same direction with another target and distance. @pre distance > 0
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

}  // namespace geargraph
