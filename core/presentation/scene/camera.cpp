#include "core/presentation/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;
constexpr double kHalfOpening = 13.0 * std::numbers::pi / 180;  // vertical
constexpr double kRadiansPerPixel = 0.008;
constexpr double kNearest = 1e-3;
constexpr double kMaxDistance = 1e7;

/// The lowest eye position along the line of sight that sees all points between two mirrored planes of slope
/// `slope`, and where across it stands: x_i - x <= slope (z_i - z) and the same mirrored.
struct Slab {
  double highest = -std::numeric_limits<double>::infinity();
  double mirrored = -std::numeric_limits<double>::infinity();

  void add(double across, double along, double slope) {
    highest = std::max(highest, across - slope * along);
    mirrored = std::max(mirrored, -across - slope * along);
  }
  [[nodiscard]] double along(double slope) const { return -(highest + mirrored) / (2 * slope); }
  [[nodiscard]] double across() const { return (highest - mirrored) / 2; }
};

}  // namespace

Camera Camera::from(double yaw, double pitch) {
  Camera camera;
  camera.m_yaw = std::remainder(yaw, 2 * std::numbers::pi);
  camera.m_pitch = std::clamp(pitch, -kQuarter, kQuarter);
  return camera;
}

Camera Camera::looking(StandardView view) {
  return Camera().turnedTo(view);
}

Camera Camera::turnedTo(StandardView view) const {
  const auto placed = [this](double yaw, double pitch) {
    return from(yaw, pitch).placedAt(m_target, m_distance);
  };
  switch (view) {
    case StandardView::front:
      return placed(-kQuarter, 0);
    case StandardView::back:
      return placed(kQuarter, 0);
    case StandardView::left:
      return placed(2 * kQuarter, 0);
    case StandardView::right:
      return placed(0, 0);
    case StandardView::top:
      return placed(-kQuarter, kQuarter);
    case StandardView::bottom:
      return placed(-kQuarter, -kQuarter);
    case StandardView::isometric:
      return placed(-kQuarter / 2, std::atan(std::sqrt(0.5)));
  }
  return *this;
}

Camera Camera::turnedAlong(const Eigen::Vector3d& direction) const {
  const Eigen::Vector3d along = direction.normalized();
  const bool isUpright = along.head<2>().norm() < 1e-9;
  return from(isUpright ? -kQuarter : std::atan2(-along.y(), -along.x()),
              std::asin(std::clamp(-along.z(), -1.0, 1.0)))
      .placedAt(m_target, m_distance);
}

Camera Camera::placedAt(const Eigen::Vector3d& target, double distance) const {
  GEARGRAPH_REQUIRE(distance > 0);
  Camera camera = *this;
  camera.m_target = target;
  camera.m_distance = std::clamp(distance, kNearest, kMaxDistance);
  return camera;
}

Eigen::Vector3d Camera::forward() const {
  return -Eigen::Vector3d(std::cos(m_pitch) * std::cos(m_yaw), std::cos(m_pitch) * std::sin(m_yaw),
                          std::sin(m_pitch));
}

// Independent of the pitch, so that it holds at the poles too.
Eigen::Vector3d Camera::right() const {
  return {-std::sin(m_yaw), std::cos(m_yaw), 0};
}

Camera Camera::orbited(double pixelsRight, double pixelsDown) const {
  Camera next = *this;
  next.m_yaw = std::remainder(m_yaw - kRadiansPerPixel * pixelsRight, 2 * std::numbers::pi);
  next.m_pitch = std::clamp(m_pitch + kRadiansPerPixel * pixelsDown, -kQuarter, kQuarter);
  return next;
}

double Camera::millimetresPerPixel(const Viewport& viewport) const {
  return 2 * m_distance * std::tan(kHalfOpening) / viewport.height;
}

Camera Camera::panned(double pixelsRight, double pixelsDown, const Viewport& viewport) const {
  Camera next = *this;
  next.m_target += millimetresPerPixel(viewport) * (pixelsDown * up() - pixelsRight * right());
  return next;
}

// The eye and the target shrink towards the fixed point alike, so every ray through it stays where it was.
Camera Camera::zoomed(double factor, const Eigen::Vector3d& fixed) const {
  GEARGRAPH_REQUIRE(factor > 0);
  Camera next = *this;
  next.m_distance = std::clamp(m_distance / factor, kNearest, kMaxDistance);
  const double shrink = next.m_distance / m_distance;
  next.m_target = fixed + shrink * (m_target - fixed);
  return next;
}

Camera Camera::fitted(std::span<const Eigen::Vector3d> points, const Viewport& viewport,
                      double margin) const {
  if (points.empty()) return *this;
  const double slopeUp = std::tan(kHalfOpening) * (1 - 2 * margin);
  const double slopeRight = slopeUp * viewport.aspect();
  Slab rightward, upward;
  double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
  const Eigen::Vector3d ahead = forward(), aside = right(), above = up();
  for (const Eigen::Vector3d& point : points) {
    const double along = point.dot(ahead);
    rightward.add(point.dot(aside), along, slopeRight);
    upward.add(point.dot(above), along, slopeUp);
    nearest = std::min(nearest, along);
    farthest = std::max(farthest, along);
  }
  const double eyeAlong = std::min(rightward.along(slopeRight), upward.along(slopeUp));
  const double middle = (nearest + farthest) / 2;
  Camera next = *this;
  next.m_distance = std::clamp(middle - eyeAlong, kNearest, kMaxDistance);
  next.m_target = rightward.across() * aside + upward.across() * above + middle * ahead;
  return next;
}

Eigen::Isometry3d Camera::view() const {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear().row(0) = right();
  result.linear().row(1) = up();
  result.linear().row(2) = -forward();
  result.translation() = -(result.linear() * eye());
  return result;
}

Eigen::Matrix4d Camera::projection(const Viewport& viewport, const Eigen::Vector3d& centre,
                                   double radius) const {
  const double middle = (centre - eye()).dot(forward());
  const double farPlane = std::max(middle + radius, 2 * kNearest);
  const double nearPlane = std::max(middle - radius, farPlane * 1e-3);  // keeps the depth buffer's precision
  const double focal = 1 / std::tan(kHalfOpening);
  Eigen::Matrix4d result = Eigen::Matrix4d::Zero();
  result(0, 0) = focal / viewport.aspect();
  result(1, 1) = focal;
  result(2, 2) = (farPlane + nearPlane) / (nearPlane - farPlane);
  result(2, 3) = 2 * farPlane * nearPlane / (nearPlane - farPlane);
  result(3, 2) = -1;
  return result;
}

ScreenPoint Camera::project(const Eigen::Vector3d& point, const Viewport& viewport) const {
  const Eigen::Vector3d seen = view() * point;
  const double scale = 0.5 * viewport.height / (std::tan(kHalfOpening) * -seen.z());
  return {0.5 * viewport.width + scale * seen.x(), 0.5 * viewport.height - scale * seen.y(), -seen.z()};
}

Ray Camera::rayThrough(double x, double y, const Viewport& viewport) const {
  const double perPixel = 2 * std::tan(kHalfOpening) / viewport.height;
  const Eigen::Vector3d direction = forward() + perPixel * (x - 0.5 * viewport.width) * right() -
                                    perPixel * (y - 0.5 * viewport.height) * up();
  return {eye(), direction.normalized()};
}

Eigen::Vector3d Camera::atTargetDepth(double x, double y, const Viewport& viewport) const {
  const Ray ray = rayThrough(x, y, viewport);
  return ray.origin + ray.direction * (m_distance / ray.direction.dot(forward()));
}

}  // namespace geargraph
