#include "core/presentation/brep/brep_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Vector3d kUp = Vector3d::UnitZ();
constexpr double kWholeTurn = 2 * std::numbers::pi * (1 - 1e-12);

Vector3d raised(const Vector2d& point, double height) {
  return {point.x(), point.y(), height};
}

}  // namespace

std::vector<LoopEdge> against(std::span<const LoopEdge> loop) {
  std::vector<LoopEdge> other;
  for (auto edge = loop.rbegin(); edge != loop.rend(); ++edge) other.push_back(against(*edge));
  return other;
}

int BrepBuilder::addPoint(const Vector3d& point) {
  m_solid.points.push_back(point);
  return static_cast<int>(m_solid.points.size()) - 1;
}

LoopEdge BrepBuilder::addLine(int from, int to) {
  m_solid.edges.push_back({from, to, LineCurve{}});
  return {static_cast<int>(m_solid.edges.size()) - 1, true};
}

LoopEdge BrepBuilder::addArc(int from, int to, const Vector3d& centre) {
  m_solid.edges.push_back({from, to, ArcCurve{centre, kUp}});
  return {static_cast<int>(m_solid.edges.size()) - 1, true};
}

LoopEdge BrepBuilder::addCircle(const Vector2d& centre, double radius, double height) {
  const int start = addPoint(raised(centre + radius * Vector2d::UnitX(), height));
  return addArc(start, start, raised(centre, height));
}

LoopEdge BrepBuilder::addSpline(int from, int to, SplineCurve curve) {
  m_solid.edges.push_back({from, to, std::move(curve)});
  return {static_cast<int>(m_solid.edges.size()) - 1, true};
}

void BrepBuilder::addFace(std::variant<PlaneSurface, RoundSurface, SplineSurface> surface,
                          std::vector<std::vector<LoopEdge>> loops, bool isReversed) {
  m_solid.faces.push_back({std::move(surface), isReversed, std::move(loops)});
}

void BrepBuilder::addPlane(double height, bool isTop, std::vector<std::vector<LoopEdge>> loops) {
  addFace(PlaneSurface{height * kUp, isTop ? kUp : Vector3d(-kUp)}, std::move(loops));
}

std::vector<BrepBuilder::Circle> BrepBuilder::addCircles(std::span<const ProfileVertex> profile) {
  std::vector<Circle> circles;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (i > 0 && profile[i] == profile[i - 1]) {
      circles.push_back(circles.back());
    } else if (profile[i].radius > 0) {
      circles.push_back({addCircle({0, 0}, profile[i].radius, profile[i].height)});
    } else {
      circles.emplace_back();
    }
  }
  return circles;
}

BrepBuilder::Circle BrepBuilder::addSplitCircle(const ProfileVertex& circle, double first, double second) {
  const auto at = [&](double angle) {
    return addPoint(circle.radius * Vector3d(std::cos(angle), std::sin(angle), 0) + circle.height * kUp);
  };
  const int a = at(first), b = at(second);
  return {addArc(a, b, circle.height * kUp), addArc(b, a, circle.height * kUp)};
}

void BrepBuilder::addRevolved(std::span<const ProfileVertex> profile, std::span<const Circle> circles,
                              bool inward, std::span<const std::vector<std::vector<LoopEdge>>> holes) {
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const ProfileVertex &a = profile[i], &b = profile[i + 1];
    if (a == b || (a.radius == 0 && b.radius == 0)) continue;
    // Out of the material is to the right of the way from a to b: (dh, -dr).
    const double sense = inward ? -1 : 1;
    const double dr = b.radius - a.radius, dh = b.height - a.height;
    if (dh == 0) {
      const bool isTop = -sense * dr > 0;
      const bool aIsOuter = a.radius > b.radius;
      const Circle &outer = circles[aIsOuter ? i : i + 1], &inner = circles[aIsOuter ? i + 1 : i];
      std::vector<std::vector<LoopEdge>> loops{isTop ? outer : against(outer)};
      if (!inner.empty()) loops.push_back(isTop ? against(inner) : inner);
      if (i < holes.size()) loops.insert(loops.end(), holes[i].begin(), holes[i].end());
      addPlane(a.height, isTop, std::move(loops));
      continue;
    }
    GEARGRAPH_REQUIRE(a.radius > 0 && b.radius > 0);
    const bool isOutward = sense * dh > 0;
    const Circle &low = circles[dh > 0 ? i : i + 1], &high = circles[dh > 0 ? i + 1 : i];
    addBand(RoundSurface{a.height * kUp, kUp, a.radius, dr == 0 ? 0 : dr / dh}, low, high, isOutward);
  }
}

/// Between two whole circles, or in two halves between those of split ones.
void BrepBuilder::addBand(const RoundSurface& surface, const Circle& low, const Circle& high,
                          bool isOutward) {
  if (low.size() == 1 && high.size() == 1) {
    addFace(surface, {isOutward ? low : against(low), isOutward ? against(high) : high}, !isOutward);
    return;
  }
  GEARGRAPH_REQUIRE(low.size() == 2 && high.size() == 2);
  const LoopEdge first = addLine(startOf(low[0]), startOf(high[0]));
  const LoopEdge second = addLine(startOf(low[1]), startOf(high[1]));
  for (const bool isFirst : {true, false}) {
    const std::size_t i = isFirst ? 0 : 1;
    const LoopEdge from = isFirst ? first : second, to = isFirst ? second : first;
    const std::vector<LoopEdge> loop{low[i], to, against(high[i]), against(from)};
    addFace(surface, {isOutward ? loop : against(loop)}, !isOutward);
  }
}

BrepBuilder::WallLoops BrepBuilder::addWall(std::span<const PlanarArc> outline, double from, double to,
                                            bool isHole) {
  if (outline.size() == 1 && std::abs(outline.front().to - outline.front().from) >= kWholeTurn)
    return addRoundWall(outline.front().centre, outline.front().radius, from, to, isHole);
  double size = 0;
  for (const PlanarArc& arc : outline) size = std::max(size, arc.centre.norm() + arc.radius);
  const auto isSame = [&](const Vector2d& a, const Vector2d& b) { return (a - b).norm() <= 1e-9 * size; };
  // Corners: both ends of every arc, one for two that meet; and what is between them, null: a straight line.
  struct Stretch {
    const PlanarArc* arc = nullptr;
    std::size_t from = 0, to = 0;
  };
  std::vector<Vector2d> corners{outline.front().at(outline.front().from)};
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanarArc& arc = outline[i];
    const bool isLast = i + 1 == outline.size();
    const Vector2d end = arc.at(arc.to);
    const Vector2d next = isLast ? corners.front() : outline[i + 1].at(outline[i + 1].from);
    const std::size_t start = corners.size() - 1;
    const bool closes = isLast && isSame(end, next);
    if (!closes) corners.push_back(end);
    const std::size_t stop = closes ? 0 : corners.size() - 1;
    stretches.push_back({&arc, start, stop});
    if (closes || isSame(end, next)) continue;
    if (!isLast) corners.push_back(next);
    stretches.push_back({nullptr, stop, isLast ? 0 : corners.size() - 1});
  }
  std::vector<int> low, high;
  std::vector<LoopEdge> posts;
  for (const Vector2d& corner : corners) {
    low.push_back(addPoint(raised(corner, from)));
    high.push_back(addPoint(raised(corner, to)));
    posts.push_back(addLine(low.back(), high.back()));
  }
  std::vector<LoopEdge> bottom, top;  // along the outline
  for (const Stretch& stretch : stretches) {
    const std::size_t at = stretch.from, next = stretch.to;
    const auto edgeAt = [&](const std::vector<int>& points, double height) {
      const int a = points[at], b = points[next];
      if (stretch.arc == nullptr) return addLine(a, b);
      const Vector3d centre = raised(stretch.arc->centre, height);
      return stretch.arc->to > stretch.arc->from ? addArc(a, b, centre) : against(addArc(b, a, centre));
    };
    bottom.push_back(edgeAt(low, from));
    top.push_back(edgeAt(high, to));
    std::vector<LoopEdge> loop{bottom.back(), posts[next], against(top.back()), against(posts[at])};
    if (isHole) loop = against(loop);
    if (stretch.arc != nullptr) {
      const bool isOutward = (stretch.arc->to > stretch.arc->from) != isHole;
      addFace(RoundSurface{raised(stretch.arc->centre, from), kUp, stretch.arc->radius, 0}, {loop},
              !isOutward);
    } else {
      const Vector2d way = (corners[next] - corners[at]).normalized();
      const Vector3d right(way.y(), -way.x(), 0);
      addFace(PlaneSurface{point(low[at]), isHole ? Vector3d(-right) : right}, {loop});
    }
  }
  if (isHole) return {against(top), bottom};
  return {top, against(bottom)};
}

BrepBuilder::WallLoops BrepBuilder::addRoundWall(const Vector2d& centre, double radius, double from,
                                                 double to, bool isHole) {
  const LoopEdge low = addCircle(centre, radius, from), high = addCircle(centre, radius, to);
  const RoundSurface surface{raised(centre, from), kUp, radius, 0};
  if (isHole) {
    addFace(surface, {{against(low)}, {high}}, true);
    return {{against(high)}, {low}};
  }
  addFace(surface, {{low}, {against(high)}});
  return {{high}, {against(low)}};
}

Brep revolvedBrep(std::span<const ProfileVertex> profile) {
  BrepBuilder builder;
  std::vector<ProfileVertex> closed(profile.begin(), profile.end());
  while (closed.size() > 1 && closed.back() == closed.front()) closed.pop_back();
  std::vector<BrepBuilder::Circle> circles = builder.addCircles(closed);
  closed.push_back(closed.front());
  circles.push_back(circles.front());
  builder.addRevolved(closed, circles, false);
  return builder.take();
}

Brep flatBrep(const FlatShape& shape) {
  BrepBuilder builder;
  BrepBuilder::WallLoops outer = builder.addWall(shape.outline, shape.from, shape.to, false);
  std::vector<std::vector<LoopEdge>> top{std::move(outer.top)}, bottom{std::move(outer.bottom)};
  for (const Boss& hole : shape.holes) {
    BrepBuilder::WallLoops inner = builder.addRoundWall(hole.centre, hole.hole, shape.from, shape.to, true);
    top.push_back(std::move(inner.top));
    bottom.push_back(std::move(inner.bottom));
  }
  builder.addPlane(shape.to, true, std::move(top));
  builder.addPlane(shape.from, false, std::move(bottom));
  return builder.take();
}

Brep placed(Brep solid, const Eigen::Isometry3d& pose, double scale) {
  const auto move = [&](Vector3d& point) { point = scale * (pose * point); };
  const auto turn = [&](Vector3d& direction) { direction = pose.linear() * direction; };
  for (Vector3d& point : solid.points) move(point);
  for (BrepEdge& edge : solid.edges) {
    if (auto* arc = std::get_if<ArcCurve>(&edge.curve)) {
      move(arc->centre);
      turn(arc->axis);
    } else if (auto* spline = std::get_if<SplineCurve>(&edge.curve)) {
      for (Vector3d& pole : spline->poles) move(pole);
    }
  }
  for (BrepFace& face : solid.faces) {
    if (auto* plane = std::get_if<PlaneSurface>(&face.surface)) {
      move(plane->origin);
      turn(plane->normal);
    } else if (auto* round = std::get_if<RoundSurface>(&face.surface)) {
      move(round->origin);
      turn(round->axis);
      round->radius *= scale;
    } else {
      for (Vector3d& pole : std::get<SplineSurface>(face.surface).poles) move(pole);
    }
  }
  return solid;
}

}  // namespace geargraph
