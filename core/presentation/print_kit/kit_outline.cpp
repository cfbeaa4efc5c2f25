#include "core/presentation/print_kit/kit_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

Vector2d unitAt(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// Chords of an arc, each within the tolerance.
int chordsOf(double radius, double angle) {
  const double step = 2 * std::acos(1 - std::min(kOutlineTolerance / std::max(radius, 1e-6), 0.3));
  return std::max(1, static_cast<int>(std::ceil(std::abs(angle) / step)));
}

double crossOf(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double distanceToEdge(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
  const Vector2d way = b - a;
  const double length = way.squaredNorm();
  const double part = length > 0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0;
  return (p - a - part * way).norm();
}

/// Segments of a digit: top, upper right, lower right, bottom, lower left, upper left, middle.
constexpr std::array<unsigned, 10> kSegments = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07, 0x7F, 0x6F};

/// A stroke with pointed ends from a to b.
KitOutline stroke(const Vector2d& a, const Vector2d& b, double width) {
  const Vector2d along = (b - a).normalized() * width / 2;
  const Vector2d across(-along.y(), along.x());
  return {a, a + along - across, b - along - across, b, b - along + across, a + along + across};
}

constexpr double kDigitWidth = 0.55;    // as a share of the height
constexpr double kDigitStroke = 0.17;   // as a share of the height
constexpr double kDigitAdvance = 0.80;  // as a share of the height
constexpr double kDotAdvance = 0.35;

}  // namespace

KitOutline circleOutline(const Vector2d& centre, double radius, int points) {
  const int count = points > 0 ? points : std::max(16, chordsOf(radius, 2 * pi));
  KitOutline outline;
  for (int i = 0; i < count; ++i) outline.push_back(centre + radius * unitAt(2 * pi * i / count));
  return outline;
}

KitOutline hullOfPoints(std::vector<Vector2d> points) {
  GEARGRAPH_REQUIRE(points.size() > 2);
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  constexpr double kFlat = 1e-6;  // mm²: corners that turn by less are left out
  std::vector<Vector2d> hull;
  const auto add = [&](const Vector2d& p, std::size_t least) {
    while (hull.size() >= least && crossOf(hull.back() - hull[hull.size() - 2], p - hull.back()) <= kFlat)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const Vector2d& p : points) add(p, 2);
  const std::size_t least = hull.size() + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], least);
  hull.pop_back();
  return hull;
}

KitOutline hullOutline(std::span<const KitDisc> discs) {
  GEARGRAPH_REQUIRE(!discs.empty());
  double largest = 0;
  for (const KitDisc& disc : discs) largest = std::max(largest, disc.radius);
  const int count = std::max(24, chordsOf(largest, 2 * pi));
  std::vector<Vector2d> points;
  for (const KitDisc& disc : discs) {
    for (int i = 0; i < count; ++i) points.push_back(disc.centre + disc.radius * unitAt(2 * pi * i / count));
  }
  return hullOfPoints(std::move(points));
}

KitOutline flattedOutline(double radius, double flat, double towards) {
  GEARGRAPH_REQUIRE(0 < flat && flat < radius);
  const double half = std::acos(flat / radius);
  const int count = std::max(12, chordsOf(radius, 2 * (pi - half)));
  KitOutline outline;
  for (int i = 0; i <= count; ++i)
    outline.push_back(radius * unitAt(towards + half + 2 * (pi - half) * i / count));
  return outline;
}

KitOutline boxOutline(const Vector2d& centre, const Vector2d& along, double length, double width) {
  const Vector2d a = along * length / 2;
  const Vector2d b(-along.y() * width / 2, along.x() * width / 2);
  return {centre - a - b, centre + a - b, centre + a + b, centre - a + b};
}

KitOutline reversed(KitOutline outline) {
  std::reverse(outline.begin(), outline.end());
  return outline;
}

KitOutline shifted(KitOutline outline, const Vector2d& by) {
  for (Vector2d& p : outline) p += by;
  return outline;
}

KitOutline inset(const KitOutline& outline, double by) {
  KitOutline moved = outline;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d before = (outline[i] - outline[(i + n - 1) % n]).normalized();
    const Vector2d after = (outline[(i + 1) % n] - outline[i]).normalized();
    const Vector2d left = Vector2d(-before.y() - after.y(), before.x() + after.x());
    const double half = left.norm() / 2;  // cosine of half of the turn
    moved[i] += left.normalized() * by / std::max(half, 0.3);
  }
  return moved;
}

double doubledArea(const KitOutline& outline) {
  double area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    area += crossOf(outline[i], outline[(i + 1) % outline.size()]);
  return area;
}

bool isInside(std::span<const KitOutline> outlines, const Vector2d& p) {
  bool inside = false;
  for (const KitOutline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vector2d& a = outline[i];
      const Vector2d& b = outline[(i + 1) % outline.size()];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
  }
  return inside;
}

double distanceTo(std::span<const KitOutline> outlines, const Vector2d& p) {
  double least = 1e300;
  for (const KitOutline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i)
      least = std::min(least, distanceToEdge(outline[i], outline[(i + 1) % outline.size()], p));
  }
  return least;
}

std::vector<KitOutline> digitOutlines(std::string_view text, double height) {
  std::vector<KitOutline> outlines;
  const double width = kDigitWidth * height, thick = kDigitStroke * height, half = height / 2;
  const double gap = 0.06 * height;  // between the points of two strokes
  double x = -digitsWidth(text, height) / 2;
  for (const char c : text) {
    if (c == '.') {
      outlines.push_back(circleOutline({x + kDotAdvance * height / 2, -half + thick / 2}, 0.6 * thick));
      x += kDotAdvance * height;
      continue;
    }
    if (c >= '0' && c <= '9') {
      const double l = x + thick / 2, r = x + width - thick / 2, t = half - thick / 2, b = -t;
      const std::array<std::pair<Vector2d, Vector2d>, 7> ends = {{{{l + gap, t}, {r - gap, t}},
                                                                  {{r, gap}, {r, t - gap}},
                                                                  {{r, b + gap}, {r, -gap}},
                                                                  {{l + gap, b}, {r - gap, b}},
                                                                  {{l, b + gap}, {l, -gap}},
                                                                  {{l, gap}, {l, t - gap}},
                                                                  {{l + gap, 0}, {r - gap, 0}}}};
      for (std::size_t s = 0; s < ends.size(); ++s) {
        if ((kSegments[static_cast<std::size_t>(c - '0')] >> s & 1U) == 0) continue;
        outlines.push_back(stroke(ends[s].first, ends[s].second, thick));
      }
    }
    x += kDigitAdvance * height;
  }
  return outlines;
}

double digitsWidth(std::string_view text, double height) {
  double width = 0;
  for (const char c : text) width += (c == '.' ? kDotAdvance : kDigitAdvance) * height;
  return width - (kDigitAdvance - kDigitWidth) * height;
}

bool roomFor(std::span<const KitOutline> outlines, const Vector2d& size, double margin, Vector2d& centre) {
  Vector2d low(1e300, 1e300), high(-1e300, -1e300);
  for (const KitOutline& outline : outlines) {
    for (const Vector2d& p : outline) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  constexpr int kPlaces = 28;
  double best = margin;
  bool isFound = false;
  for (int i = 0; i <= kPlaces; ++i) {
    for (int k = 0; k <= kPlaces; ++k) {
      const Vector2d at(low.x() + (high.x() - low.x()) * i / kPlaces,
                        low.y() + (high.y() - low.y()) * k / kPlaces);
      if (!isInside(outlines, at)) continue;
      double room = distanceTo(outlines, at) - size.x() / 2;
      if (room + size.x() / 2 <= best) continue;
      room = 1e300;
      for (int s = 0; s < 20 && room > best; ++s) {  // points on the box's edge
        const double u = (s % 5 - 2) / 2.0;
        const double v = (s / 5) % 2 == 0 ? -1 : 1;
        const Vector2d p = at + (s < 10 ? Vector2d(u * size.x() / 2, v * size.y() / 2)
                                        : Vector2d(v * size.x() / 2, u * size.y() / 2));
        room = isInside(outlines, p) ? std::min(room, distanceTo(outlines, p)) : -1;
      }
      if (room <= best + 1e-9) continue;
      best = room;
      centre = at;
      isFound = true;
    }
  }
  return isFound;
}

}  // namespace geargraph
