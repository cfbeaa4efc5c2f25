#include "core/presentation/gl_renderer/mark_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace geargraph {
namespace {

constexpr double kNearestW = 1e-4;
constexpr double kDash = 7, kGap = 5;  // logical pixels

/// A point of the picture: pixels from the upper left corner, and OpenGL's depth.
using Place = Eigen::Vector3d;

/// The part of a segment before the eye; nothing where it is all behind.
std::optional<std::pair<Place, Place>> placed(Eigen::Vector4d a, Eigen::Vector4d b,
                                              const Viewport& viewport) {
  if (a.w() < kNearestW && b.w() < kNearestW) return std::nullopt;
  const auto cut = [](const Eigen::Vector4d& behind, const Eigen::Vector4d& before) -> Eigen::Vector4d {
    return behind + (kNearestW - behind.w()) / (before.w() - behind.w()) * (before - behind);
  };
  if (a.w() < kNearestW) a = cut(a, b);
  if (b.w() < kNearestW) b = cut(b, a);
  const auto onScreen = [&](const Eigen::Vector4d& p) {
    const Eigen::Vector3d ndc = p.hnormalized();
    return Place(0.5 * (1 + ndc.x()) * viewport.width, 0.5 * (1 - ndc.y()) * viewport.height, ndc.z());
  };
  return std::pair(onScreen(a), onScreen(b));
}

void addStroke(std::vector<OverlayVertex>& to, const Place& a, const Place& b, double width,
               const Rgb& colour) {
  const Eigen::Vector2d way = (b - a).head<2>();
  if (way.norm() < 1e-6) return;
  const Eigen::Vector2d along = 0.25 * width * way.normalized();
  const Eigen::Vector2d across = 2 * Eigen::Vector2d(-along.y(), along.x());
  const auto vertex = [&](const Eigen::Vector2d& p, double depth) {
    return OverlayVertex{
        static_cast<float>(p.x()), static_cast<float>(p.y()), colour.red, colour.green, colour.blue,
        static_cast<float>(depth)};
  };
  const OverlayVertex corners[] = {
      vertex(a.head<2>() - along - across, a.z()), vertex(b.head<2>() + along - across, b.z()),
      vertex(b.head<2>() + along + across, b.z()), vertex(a.head<2>() - along + across, a.z())};
  to.insert(to.end(), {corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]});
}

/// Dashes of a whole polyline; `walked` is how far along it the segment begins.
void addDashes(std::vector<OverlayVertex>& to, const Place& a, const Place& b, double walked,
               double pixelRatio, double width, const Rgb& colour) {
  const double length = (b - a).head<2>().norm(), round = (kDash + kGap) * pixelRatio;
  if (!(length > 0) || length > 1e5) return;  // a line that runs far out of the picture
  const auto at = [&](double s) -> Place { return a + s / length * (b - a); };
  for (double from = -std::fmod(walked, round); from < length; from += round) {
    const double first = std::max(0.0, from), last = std::min(length, from + kDash * pixelRatio);
    if (last > first) addStroke(to, at(first), at(last), width, colour);
  }
}

}  // namespace

std::vector<OverlayVertex> markTriangles(std::span<const MarkLine> lines, const Eigen::Matrix4d& clip,
                                         const Viewport& viewport, double pixelRatio) {
  std::vector<OverlayVertex> triangles;
  for (const MarkLine& line : lines) {
    double walked = 0;
    const double width = line.width * pixelRatio;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const auto segment =
          placed(clip * line.points[i - 1].homogeneous(), clip * line.points[i].homogeneous(), viewport);
      if (!segment) continue;
      const auto& [a, b] = *segment;
      line.dashed ? addDashes(triangles, a, b, walked, pixelRatio, width, line.colour)
                  : addStroke(triangles, a, b, width, line.colour);
      walked += (b - a).head<2>().norm();
    }
  }
  return triangles;
}

}  // namespace geargraph
