#include "core/machine/solids/part_solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/foundations/base/contract.h"
#include "core/machine/teeth/sampling.h"

namespace geargraph {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

struct OutlineNode {
  Vector2d position;
  Vector2d normal;
};

/// Half of an arm: a boss with the part of the outline about it, up to the line where the halves meet.
class ArmHalf {
 public:
  ArmHalf(ShellBuilder& builder, const Boss& boss, double from, double to, double tolerance)
      : m_builder(builder), m_boss(boss), m_from(from), m_to(to), m_tolerance(tolerance) {}

  /// `outline` counter-clockwise about the boss, ascending in angle from the first.
  void add(const std::vector<OutlineNode>& outline) {
    const double start = angleOf(outline.front().position);
    const Loop top = face(outline, m_to, 1);
    const Loop bottom = face(outline, m_from, -1);
    m_builder.sew(top, bossLoop(start, m_to, 1));
    m_builder.sew(bossLoop(start, m_from, -1), bottom);
    if (m_boss.hole > 0) m_builder.sew(bossLoop(start, m_to, 0), bossLoop(start, m_from, 0));
  }

 private:
  [[nodiscard]] double angleOf(const Vector2d& p) const {
    return std::atan2(p.y() - m_boss.centre.y(), p.x() - m_boss.centre.x());
  }

  Loop face(const std::vector<OutlineNode>& outline, double z, double up) {
    Loop loop;
    for (const OutlineNode& node : outline) {
      double angle = angleOf(node.position);
      while (!loop.angles.empty() && angle < loop.angles.back()) angle += 2 * pi;
      loop.angles.push_back(angle);
      loop.vertices.push_back(m_builder.addVertex({node.position.x(), node.position.y(), z}, {0, 0, up}));
    }
    return loop;
  }

  /// The hole's rim, or the boss's centre where there is none. `up` 0: for the wall of the hole.
  Loop bossLoop(double start, double z, double up) {
    const int count = m_boss.hole > 0 ? circleCount(m_boss.hole, m_tolerance) : 1;
    Loop loop;
    for (int i = 0; i < count; ++i) {
      const double angle = start + 2 * pi * i / count;
      const Vector2d out(std::cos(angle), std::sin(angle));
      const Vector2d p = m_boss.centre + m_boss.hole * out;
      const Vector3d normal = up == 0 ? Vector3d(-out.x(), -out.y(), 0) : Vector3d(0, 0, up);
      loop.vertices.push_back(m_builder.addVertex({p.x(), p.y(), z}, normal));
      loop.angles.push_back(angle);
    }
    return loop;
  }

  ShellBuilder& m_builder;
  const Boss& m_boss;
  double m_from, m_to, m_tolerance;
};

void addArc(std::vector<OutlineNode>& outline, const Boss& boss, double base, double from, double to,
            double tolerance) {
  const int n = chordsOfArc(to - from, boss.radius, tolerance);
  for (int i = 0; i <= n; ++i) {
    const double angle = base + from + (to - from) * i / n;
    const Vector2d out(std::cos(angle), std::sin(angle));
    outline.push_back({boss.centre + boss.radius * out, out});
  }
}

/// A strip of wall from the first node to the last.
void addWall(ShellBuilder& builder, std::span<const OutlineNode> strip, double from, double to) {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  for (std::size_t i = 0; i < strip.size(); ++i) {
    const Vector3d normal(strip[i].normal.x(), strip[i].normal.y(), 0);
    const auto add = [&](double z) {
      return builder.addVertex({strip[i].position.x(), strip[i].position.y(), z}, normal);
    };
    const std::uint32_t nextLow = add(from);
    const std::uint32_t nextHigh = add(to);
    if (i > 0) {
      builder.addTriangle(low, nextLow, nextHigh);
      builder.addTriangle(low, nextHigh, high);
    }
    low = nextLow;
    high = nextHigh;
  }
}

/// A bar of a spider: where its sides leave the hub and run into the boss.
struct Bar {
  Boss boss;
  double angle = 0;  ///< about the hub
  double half = 0;   ///< of its width
  Vector2d rootLow = Vector2d::Zero();
  Vector2d rootHigh = Vector2d::Zero();
};

Vector2d onCircle(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// The bars in the order of their angles; none where they would run into each other at the hub.
std::vector<Bar> barsOf(const Boss& hub, std::span<const Boss> ends) {
  std::vector<Bar> bars;
  for (const Boss& end : ends) {
    const Vector2d line = end.centre - hub.centre;
    Bar bar;
    bar.boss = end;
    bar.angle = std::atan2(line.y(), line.x());
    bars.push_back(bar);
  }
  std::sort(bars.begin(), bars.end(), [](const Bar& a, const Bar& b) { return a.angle < b.angle; });
  double spacing = pi;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double next = i + 1 < bars.size() ? bars[i + 1].angle : bars.front().angle + 2 * pi;
    spacing = std::min(spacing, next - bars[i].angle);
  }
  const double keep = hub.hole + 0.15 * (hub.radius - hub.hole);  // what the bars' roots leave round the hole
  const double most = std::min(std::sqrt(hub.radius * hub.radius - keep * keep),
                               hub.radius * std::sin(std::min(0.45 * spacing, pi / 2)));
  for (Bar& bar : bars) {
    bar.half = std::min(0.95 * most, bar.boss.radius);
    const double reach = (bar.boss.centre - hub.centre).norm() -
                         std::sqrt(bar.boss.radius * bar.boss.radius - bar.half * bar.half) -
                         std::sqrt(hub.radius * hub.radius - bar.half * bar.half);
    if (bar.half < 0.3 * bar.boss.radius || reach < 0.1 * hub.radius) return {};
    const double root = std::asin(bar.half / hub.radius);
    bar.rootLow = hub.centre + hub.radius * onCircle(bar.angle - root);
    bar.rootHigh = hub.centre + hub.radius * onCircle(bar.angle + root);
  }
  return bars;
}

/// Each piece of a spider has a smaller hub than the one before, by this factor, so that no two share a
/// vertex.
constexpr double kPart = 0.985;

Boss partOf(const Boss& hub, double part) {
  return {hub.centre, part * hub.radius, part * hub.hole};
}

/// Those that neither lie in the hub nor around it.
std::vector<Boss> reachingEnds(const Boss& hub, std::span<const Boss> all) {
  const double least = std::pow(kPart, static_cast<double>(all.size()));
  std::vector<Boss> ends;
  for (const Boss& end : all) {
    const double distance = (end.centre - hub.centre).norm();
    const double most = std::max(hub.radius - end.radius, end.radius - least * hub.radius);
    if (distance > (1 + 1e-6) * most) ends.push_back(end);
  }
  return ends;
}

/// An arc of nodes about a boss, its ends where the neighbours have theirs.
std::vector<OutlineNode> arcBetween(const Boss& boss, double from, double to, const Vector2d& first,
                                    const Vector2d& last, double tolerance) {
  std::vector<OutlineNode> arc;
  addArc(arc, boss, 0, from, to, tolerance);
  arc.front().position = first;
  arc.back().position = last;
  return arc;
}

class SpiderMaker {
 public:
  SpiderMaker(const Boss& hub, std::vector<Bar> bars, double from, double to, double tolerance)
      : m_hub(hub), m_bars(std::move(bars)), m_from(from), m_to(to), m_tolerance(tolerance) {}

  Solid make() {
    std::vector<OutlineNode> round;
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
      const Bar& bar = m_bars[i];
      const Bar& next = m_bars[(i + 1) % m_bars.size()];
      const double turn = i + 1 < m_bars.size() ? 0 : 2 * pi;
      const auto arc = arcBetween(m_hub, bar.angle + std::asin(bar.half / m_hub.radius),
                                  next.angle + turn - std::asin(next.half / m_hub.radius), bar.rootHigh,
                                  next.rootLow, m_tolerance);
      addWall(m_builder, arc, m_from, m_to);
      round.insert(round.end(), arc.begin(), arc.end());
      addBar(bar);
    }
    ArmHalf(m_builder, m_hub, m_from, m_to, m_tolerance).add(round);
    return std::move(m_solid);
  }

 private:
  void addBar(const Bar& bar) {
    const double open = std::asin(std::min(bar.half / bar.boss.radius, 1.0));
    const double back = bar.angle + pi;
    const Vector2d low = bar.boss.centre + bar.boss.radius * onCircle(back + open);
    const Vector2d high = bar.boss.centre + bar.boss.radius * onCircle(back - open);
    const auto arc =
        arcBetween(bar.boss, bar.angle - pi + open, bar.angle + pi - open, low, high, m_tolerance);
    addWall(m_builder, arc, m_from, m_to);
    const Vector2d across = onCircle(bar.angle + pi / 2);
    addWall(m_builder, std::vector<OutlineNode>{{bar.rootLow, -across}, {low, -across}}, m_from, m_to);
    addWall(m_builder, std::vector<OutlineNode>{{high, across}, {bar.rootHigh, across}}, m_from, m_to);
    std::vector<OutlineNode> outline{{bar.rootLow, -across}};
    outline.insert(outline.end(), arc.begin(), arc.end());
    outline.push_back({bar.rootHigh, across});
    ArmHalf(m_builder, bar.boss, m_from, m_to, m_tolerance).add(outline);
  }

  const Boss& m_hub;
  std::vector<Bar> m_bars;
  double m_from, m_to, m_tolerance;
  Solid m_solid;
  ShellBuilder m_builder{m_solid};
};

/// The nodes on the convex hull, counter-clockwise (A. M. Andrew, Information Processing Letters 9(5), 1979,
/// 216-219).
std::vector<OutlineNode> hullOf(std::vector<OutlineNode> nodes) {
  std::sort(nodes.begin(), nodes.end(), [](const OutlineNode& a, const OutlineNode& b) {
    return a.position.x() != b.position.x() ? a.position.x() < b.position.x()
                                            : a.position.y() < b.position.y();
  });
  const auto turnsLeft = [](const OutlineNode& a, const OutlineNode& b, const OutlineNode& c) {
    const Vector2d u = b.position - a.position, v = c.position - b.position;
    return u.x() * v.y() - u.y() * v.x() > 1e-9 * (u.norm() * v.norm());
  };
  std::vector<OutlineNode> hull;
  for (const bool upper : {false, true}) {
    const std::size_t start = hull.size();
    for (const OutlineNode& node : nodes) {
      while (hull.size() >= start + 2 && !turnsLeft(hull[hull.size() - 2], hull.back(), node))
        hull.pop_back();
      hull.push_back(node);
    }
    hull.pop_back();  // the next half begins with it
    if (!upper) std::reverse(nodes.begin(), nodes.end());
  }
  return hull;
}

}  // namespace

Eigen::Isometry3d frameAlong(const Vector3d& origin, const Vector3d& axis, const Vector3d& towards) {
  Vector3d x = towards - towards.dot(axis) * axis;
  if (x.norm() < 1e-6 * towards.norm()) {
    const Vector3d other = std::abs(axis.z()) < 0.9 ? Vector3d::UnitZ() : Vector3d::UnitX();
    x = other - other.dot(axis) * axis;
  }
  x.normalize();
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear().col(0) = x;
  frame.linear().col(1) = axis.cross(x);
  frame.linear().col(2) = axis;
  frame.translation() = origin;
  return frame;
}

Solid revolved(std::span<const ProfileVertex> profile, double tolerance) {
  GEARGRAPH_REQUIRE(profile.size() >= 2);
  Solid solid;
  ShellBuilder builder(solid);
  double largest = 0;
  for (const ProfileVertex& c : profile) largest = std::max(largest, c.radius);
  std::vector<ProfileVertex> closed(profile.begin(), profile.end());
  if (!(closed.front().radius == 0 && closed.back().radius == 0)) closed.push_back(closed.front());
  const int count = circleCount(largest, tolerance);
  const std::size_t most = 2 * (closed.size() - 1) * static_cast<std::size_t>(count);
  solid.positions.reserve(most);
  solid.normals.reserve(most);
  solid.triangles.reserve(most);
  builder.addRevolved(closed, count, 0);
  return solid;
}

std::vector<ProfileVertex> tubeProfile(double outer, double inner, double from, double to) {
  const double chamfer = std::min({0.12 * (outer - inner), 0.25 * (to - from)});
  std::vector<ProfileVertex> profile;
  if (inner > 0) {
    profile = {{outer - chamfer, to}, {inner, to}, {inner, from}, {outer - chamfer, from}};
  } else {
    profile = {{outer - chamfer, to}, {0, to}, {0, from}, {outer - chamfer, from}};
  }
  profile.push_back({outer, from + chamfer});
  profile.push_back({outer, to - chamfer});
  return profile;
}

Solid tube(double outer, double inner, double from, double to, double tolerance) {
  return revolved(tubeProfile(outer, inner, from, to), tolerance);
}

Solid tubeSector(double outer, double inner, double from, double to, double half, double tolerance) {
  GEARGRAPH_REQUIRE(inner > 0 && inner < outer && half > 0 && half < pi);
  const int n = chordsOfArc(2 * half, outer, tolerance);
  Solid solid;
  ShellBuilder builder(solid);
  const auto point = [&](double radius, int i, double z, const Vector3d& normal) {
    const Vector2d p = radius * onCircle(-half + 2 * half * i / n);
    return builder.addVertex({p.x(), p.y(), z}, normal);
  };
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    builder.addTriangle(a, b, c);
    builder.addTriangle(a, c, d);
  };
  for (int i = 0; i < n; ++i) {
    const auto out = [&](int k, double sense) {
      const Vector2d u = sense * onCircle(-half + 2 * half * k / n);
      return Vector3d(u.x(), u.y(), 0);
    };
    const Vector3d up(0, 0, 1);
    const int k = i + 1;
    quad(point(outer, i, from, out(i, 1)), point(outer, k, from, out(k, 1)), point(outer, k, to, out(k, 1)),
         point(outer, i, to, out(i, 1)));
    quad(point(inner, k, from, out(k, -1)), point(inner, i, from, out(i, -1)),
         point(inner, i, to, out(i, -1)), point(inner, k, to, out(k, -1)));
    quad(point(inner, i, to, up), point(outer, i, to, up), point(outer, k, to, up), point(inner, k, to, up));
    quad(point(inner, k, from, -up), point(outer, k, from, -up), point(outer, i, from, -up),
         point(inner, i, from, -up));
  }
  for (const int i : {0, n}) {
    const double sense = i == 0 ? -1 : 1;
    const double angle = sense * half;
    const Vector3d normal(-sense * std::sin(angle), sense * std::cos(angle), 0);
    const std::uint32_t a = point(inner, i, from, normal), b = point(outer, i, from, normal);
    const std::uint32_t c = point(outer, i, to, normal), d = point(inner, i, to, normal);
    if (i == 0) {
      quad(a, b, c, d);
    } else {
      quad(d, c, b, a);
    }
  }
  return solid;
}

Solid arm(const Boss& a, const Boss& b, double from, double to, double tolerance) {
  const Vector2d line = b.centre - a.centre;
  const double distance = line.norm();
  GEARGRAPH_REQUIRE(distance > std::abs(a.radius - b.radius));
  const double base = std::atan2(line.y(), line.x());
  const double tangent =
      std::acos((a.radius - b.radius) / distance);  // of both straight sides, from the line
  std::vector<OutlineNode> aroundA;
  addArc(aroundA, a, base, tangent, 2 * pi - tangent, tolerance);
  std::vector<OutlineNode> aroundB;
  addArc(aroundB, b, base, -tangent, tangent, tolerance);
  const auto middle = [](const OutlineNode& p, const OutlineNode& q) {
    return OutlineNode{0.5 * (p.position + q.position), p.normal};
  };
  const OutlineNode lower = middle(aroundA.back(), aroundB.front());
  const OutlineNode upper = middle(aroundB.back(), aroundA.front());

  std::vector<OutlineNode> wall = aroundA;
  wall.push_back(lower);
  wall.insert(wall.end(), aroundB.begin(), aroundB.end());
  wall.push_back(upper);
  wall.push_back(aroundA.front());
  aroundA.push_back(lower);
  aroundA.push_back(upper);
  aroundB.push_back(upper);
  aroundB.push_back(lower);

  Solid solid;
  ShellBuilder builder(solid);
  ArmHalf(builder, a, from, to, tolerance).add(aroundA);
  ArmHalf(builder, b, from, to, tolerance).add(aroundB);
  addWall(builder, wall, from, to);  // its normals are smooth: the hull has no corner
  return solid;
}

Solid spider(const Boss& hub, std::span<const Boss> allEnds, double from, double to, double tolerance) {
  const std::vector<Boss> ends = reachingEnds(hub, allEnds);
  if (ends.empty()) return tube(hub.radius, hub.hole, from, to, tolerance);
  if (ends.size() == 1) return arm(hub, ends.front(), from, to, tolerance);
  std::vector<Bar> bars = barsOf(hub, ends);
  if (!bars.empty()) return SpiderMaker(hub, std::move(bars), from, to, tolerance).make();
  Solid pieces;
  double part = 1;
  for (const Boss& end : ends) {
    append(pieces, arm(partOf(hub, part), end, part * from, part * to, tolerance));
    part *= kPart;
  }
  return pieces;
}

FlatShape sectorShape(double outer, double inner, double from, double to, double half) {
  return {{{Vector2d::Zero(), outer, -half, half}, {Vector2d::Zero(), inner, half, -half}}, {}, from, to};
}

FlatShape armShape(const Boss& a, const Boss& b, double from, double to) {
  const Vector2d line = b.centre - a.centre;
  const double base = std::atan2(line.y(), line.x());
  const double tangent = std::acos((a.radius - b.radius) / line.norm());
  FlatShape shape{{{a.centre, a.radius, base + tangent, base + 2 * pi - tangent},
                   {b.centre, b.radius, base - tangent, base + tangent}},
                  {},
                  from,
                  to};
  for (const Boss& boss : {a, b}) {
    if (boss.hole > 0) shape.holes.push_back(boss);
  }
  return shape;
}

std::vector<FlatShape> spiderShapes(const Boss& hub, std::span<const Boss> allEnds, double from, double to) {
  const std::vector<Boss> ends = reachingEnds(hub, allEnds);
  if (ends.empty()) return {};
  if (ends.size() == 1) return {armShape(hub, ends.front(), from, to)};
  const std::vector<Bar> bars = barsOf(hub, ends);
  std::vector<FlatShape> shapes;
  if (bars.empty()) {
    double part = 1;
    for (const Boss& end : ends) {
      shapes.push_back(armShape(partOf(hub, part), end, part * from, part * to));
      part *= kPart;
    }
    return shapes;
  }
  FlatShape shape{{}, {}, from, to};
  if (hub.hole > 0) shape.holes.push_back(hub);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const Bar& bar = bars[i];
    const Bar& next = bars[(i + 1) % bars.size()];
    const double turn = i + 1 < bars.size() ? 0 : 2 * pi;
    const double open = std::asin(std::min(bar.half / bar.boss.radius, 1.0));
    shape.outline.push_back({bar.boss.centre, bar.boss.radius, bar.angle - pi + open, bar.angle + pi - open});
    shape.outline.push_back({hub.centre, hub.radius, bar.angle + std::asin(bar.half / hub.radius),
                             next.angle + turn - std::asin(next.half / hub.radius)});
    if (bar.boss.hole > 0) shape.holes.push_back(bar.boss);
  }
  shapes.push_back(std::move(shape));
  return shapes;
}

/// The hull follows the disc that reaches farthest in each direction. Going round, the next one takes over
/// where its reach becomes the larger one.
FlatShape plateShape(std::span<const Boss> corners, double from, double to) {
  GEARGRAPH_REQUIRE(!corners.empty());
  const auto reach = [](const Boss& disc) { return disc.centre.x() + disc.radius; };
  const Boss* current = &*std::max_element(corners.begin(), corners.end(), [&](const Boss& a, const Boss& b) {
    return reach(a) != reach(b) ? reach(a) < reach(b) : a.centre.y() < b.centre.y();
  });
  FlatShape shape{{}, {}, from, to};
  for (double angle = 0; angle < 2 * pi;) {
    const Boss* next = nullptr;
    double change = 2 * pi;
    for (const Boss& other : corners) {
      const Vector2d line = other.centre - current->centre;
      const double excess = (current->radius - other.radius) / line.norm();
      if (!(std::abs(excess) < 1)) continue;  // one is inside the other, or the same
      double at = std::atan2(line.y(), line.x()) - std::acos(excess);
      while (at < angle + 1e-9) at += 2 * pi;
      if (at < change) {
        change = at;
        next = &other;
      }
    }
    shape.outline.push_back({current->centre, current->radius, angle, change});
    angle = change;
    if (next != nullptr) current = next;
  }
  // The disc that it began with is the last one, too.
  if (shape.outline.size() > 1 && shape.outline.back().centre == shape.outline.front().centre) {
    shape.outline.back().to += shape.outline.front().to;
    shape.outline.erase(shape.outline.begin());
  }
  return shape;
}

Solid plate(std::span<const Boss> corners, double from, double to, double tolerance) {
  GEARGRAPH_REQUIRE(!corners.empty());
  std::vector<OutlineNode> nodes;
  for (const Boss& corner : corners) {
    const int n = circleCount(corner.radius, tolerance);
    for (int i = 0; i < n; ++i) {
      const Vector2d out = onCircle(2 * pi * i / n);
      nodes.push_back({corner.centre + corner.radius * out, out});
    }
  }
  const std::vector<OutlineNode> outline = hullOf(std::move(nodes));
  Solid solid;
  ShellBuilder builder(solid);
  for (const double z : {from, to}) {
    const double up = z == to ? 1 : -1;
    std::vector<std::uint32_t> rim;
    for (const OutlineNode& node : outline)
      rim.push_back(builder.addVertex({node.position.x(), node.position.y(), z}, {0, 0, up}));
    for (std::size_t i = 1; i + 1 < rim.size(); ++i) {
      if (up > 0) {
        builder.addTriangle(rim[0], rim[i], rim[i + 1]);
      } else {
        builder.addTriangle(rim[0], rim[i + 1], rim[i]);
      }
    }
  }
  std::vector<OutlineNode> wall = outline;
  wall.push_back(outline.front());
  addWall(builder, wall, from, to);
  return solid;
}

}  // namespace geargraph
