#include "core/presentation/gl_renderer/triad.h"

#include <algorithm>
#include <array>
#include <utility>

namespace geargraph {
namespace {

using Point = Eigen::Vector2d;
using LetterStroke = std::pair<Point, Point>;

/// Letters as a plotter draws them, in a square of side 1 about the origin, y down.
const std::array<std::vector<LetterStroke>, 3>& letterStrokes() {
  static const std::array<std::vector<LetterStroke>, 3> strokes = {
      std::vector<LetterStroke>{{{-0.42, -0.5}, {0.42, 0.5}}, {{0.42, -0.5}, {-0.42, 0.5}}},
      std::vector<LetterStroke>{{{-0.42, -0.5}, {0, 0.1}}, {{0.42, -0.5}, {-0.2, 0.75}}},
      std::vector<LetterStroke>{
          {{-0.4, -0.5}, {0.4, -0.5}}, {{0.4, -0.5}, {-0.4, 0.5}}, {{-0.4, 0.5}, {0.4, 0.5}}}};
  return strokes;
}

void addLine(std::vector<OverlayVertex>& to, const Point& a, const Point& b, double width,
             const Rgb& colour) {
  const Point along = (b - a).normalized() * (0.5 * width);
  const Point across(-along.y(), along.x());
  const auto vertex = [&](const Point& p) {
    return OverlayVertex{static_cast<float>(p.x()), static_cast<float>(p.y()), colour.red, colour.green,
                         colour.blue};
  };
  const OverlayVertex corners[] = {vertex(a - along - across), vertex(b + along - across),
                                   vertex(b + along + across), vertex(a - along + across)};
  to.insert(to.end(), {corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]});
}

}  // namespace

std::vector<OverlayVertex> axisTriad(const Camera& camera, const Viewport& viewport, double pixelRatio,
                                     const RenderStyle& style) {
  constexpr double kLength = 34, kLetterAt = 45, kLetterSize = 8, kFromEdge = 58;
  const bool darkLetters = style.letters.red < 0.5F;
  const std::array<Rgb, 3> colours = {Rgb::fromHex(darkLetters ? 0xC62828 : 0xFF7B72),
                                      Rgb::fromHex(darkLetters ? 0x2E7D32 : 0x6CD39B),
                                      Rgb::fromHex(darkLetters ? 0x1F5FBF : 0x6C9BFF)};
  const Eigen::Matrix3d view = camera.view().linear();
  std::array<int, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int b) { return view(2, a) < view(2, b); });
  const Point origin(kFromEdge * pixelRatio, viewport.height - kFromEdge * pixelRatio);
  std::vector<OverlayVertex> triangles;
  for (const int axis : order) {
    const Point direction(view(0, axis), -view(1, axis));
    if (direction.norm() < 0.08) continue;  // points at the viewer
    const Rgb& colour = colours[static_cast<std::size_t>(axis)];
    addLine(triangles, origin, origin + kLength * pixelRatio * direction, 2.4 * pixelRatio, colour);
    const Point centre =
        origin + pixelRatio * (kLength * direction + (kLetterAt - kLength) * direction.normalized());
    for (const auto& [from, to] : letterStrokes()[static_cast<std::size_t>(axis)]) {
      addLine(triangles, centre + kLetterSize * pixelRatio * from, centre + kLetterSize * pixelRatio * to,
              1.4 * pixelRatio, colour);
    }
  }
  return triangles;
}

}  // namespace geargraph
