#include "core/presentation/print_kit/kit_shell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

GridPoint gridPoint(const Vector2d& p) {
  return {std::llround(p.x() / KitShell::kGrid), std::llround(p.y() / KitShell::kGrid)};
}

/// Twice the area of a triangle, exactly.
std::int64_t turnOf(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int signOf(std::int64_t value) {
  return value < 0 ? -1 : (value > 0 ? 1 : 0);
}

/// Do two segments have a point in common, other than a common end?
bool cross(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  if (a == c || a == d || b == c || b == d) return false;
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
    return false;
  return signOf(turnOf(a, b, c)) * signOf(turnOf(a, b, d)) <= 0 &&
         signOf(turnOf(c, d, a)) * signOf(turnOf(c, d, b)) <= 0;
}

/// A polygon in which holes are tied to the outside by bridges, and its ears cut one after the other.
class EarCutter {
 public:
  explicit EarCutter(std::span<const KitOutline> outlines) {
    for (const KitOutline& outline : outlines) {
      std::vector<std::uint32_t> loop;
      for (const Vector2d& p : outline) {
        loop.push_back(static_cast<std::uint32_t>(m_points.size()));
        m_points.push_back(gridPoint(p));
      }
      m_loops.push_back(std::move(loop));
    }
  }

  std::vector<Triangle> cut() {
    std::vector<Triangle> all;
    for (std::vector<std::uint32_t> polygon : polygons()) {
      if (!cutOne(polygon, all)) return {};
    }
    return all;
  }

 private:
  [[nodiscard]] std::int64_t areaOf(const std::vector<std::uint32_t>& loop) const {
    std::int64_t area = 0;
    const GridPoint& o = m_points[loop.front()];
    for (std::size_t i = 0; i + 1 < loop.size(); ++i)
      area += turnOf(o, m_points[loop[i]], m_points[loop[i + 1]]);
    return area;
  }

  [[nodiscard]] bool encloses(const std::vector<std::uint32_t>& loop, const GridPoint& p) const {
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const GridPoint& a = m_points[loop[i]];
      const GridPoint& b = m_points[loop[(i + 1) % loop.size()]];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      const int side = signOf(turnOf(a, b, p));
      if ((b.y > a.y) == (side > 0)) inside = !inside;
    }
    return inside;
  }

  /// Each outer loop with its holes; an island in a hole is an outer loop of its own.
  std::vector<std::vector<std::uint32_t>> polygons() {
    std::vector<std::size_t> outer, holes;
    for (std::size_t l = 0; l < m_loops.size(); ++l) (areaOf(m_loops[l]) > 0 ? outer : holes).push_back(l);
    std::map<std::size_t, std::vector<std::size_t>> holesOf;
    for (const std::size_t h : holes) {
      std::size_t found = m_loops.size();
      for (const std::size_t o : outer) {
        if (!encloses(m_loops[o], m_points[m_loops[h].front()])) continue;
        if (found == m_loops.size() || areaOf(m_loops[o]) < areaOf(m_loops[found])) found = o;
      }
      if (found < m_loops.size()) holesOf[found].push_back(h);
    }
    std::vector<std::vector<std::uint32_t>> all;
    for (const std::size_t o : outer) all.push_back(bridged(o, holesOf[o]));
    return all;
  }

  /// Holes from the right to the left, each tied by the shortest bridge that crosses nothing.
  std::vector<std::uint32_t> bridged(std::size_t outer, std::vector<std::size_t> holes) {
    const auto rightmost = [&](std::size_t h) {
      return *std::max_element(m_loops[h].begin(), m_loops[h].end(), [&](std::uint32_t a, std::uint32_t b) {
        return m_points[a].x < m_points[b].x;
      });
    };
    std::sort(holes.begin(), holes.end(), [&](std::size_t a, std::size_t b) {
      return m_points[rightmost(a)].x > m_points[rightmost(b)].x;
    });
    std::vector<std::uint32_t> polygon = m_loops[outer];
    for (std::size_t k = 0; k < holes.size(); ++k) {
      const std::vector<std::uint32_t>& hole = m_loops[holes[k]];
      const std::uint32_t from = rightmost(holes[k]);
      std::vector<std::size_t> order(polygon.size());
      for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
      const auto away = [&](std::size_t i) {
        const std::int64_t dx = m_points[polygon[i]].x - m_points[from].x;
        const std::int64_t dy = m_points[polygon[i]].y - m_points[from].y;
        return dx * dx + dy * dy;
      };
      std::sort(order.begin(), order.end(),
                [&](std::size_t a, std::size_t b) { return std::pair(away(a), a) < std::pair(away(b), b); });
      const std::span<const std::size_t> left(holes.begin() + static_cast<std::ptrdiff_t>(k), holes.end());
      const auto place = std::find_if(order.begin(), order.end(),
                                      [&](std::size_t i) { return isFree(polygon, i, from, left); });
      if (place == order.end()) return {};
      std::vector<std::uint32_t> tied(polygon.begin(),
                                      polygon.begin() + static_cast<std::ptrdiff_t>(*place) + 1);
      const auto start = static_cast<std::size_t>(std::find(hole.begin(), hole.end(), from) - hole.begin());
      for (std::size_t i = 0; i <= hole.size(); ++i) tied.push_back(hole[(start + i) % hole.size()]);
      tied.insert(tied.end(), polygon.begin() + static_cast<std::ptrdiff_t>(*place), polygon.end());
      polygon = std::move(tied);
    }
    return polygon;
  }

  /// Is the bridge from the polygon's point `at` to a point of a hole inside, clear of all edges?
  [[nodiscard]] bool isFree(const std::vector<std::uint32_t>& polygon, std::size_t at, std::uint32_t to,
                            std::span<const std::size_t> holes) const {
    const std::size_t n = polygon.size();
    const GridPoint& p = m_points[polygon[at]];
    const GridPoint& before = m_points[polygon[(at + n - 1) % n]];
    const GridPoint& after = m_points[polygon[(at + 1) % n]];
    const GridPoint& q = m_points[to];
    const bool isConvex = turnOf(before, p, after) > 0;
    const bool isLeft = turnOf(p, after, q) > 0, isRight = turnOf(before, p, q) > 0;
    if (isConvex ? !(isLeft && isRight) : !(isLeft || isRight)) return false;
    for (std::size_t i = 0; i < n; ++i) {
      if (cross(p, q, m_points[polygon[i]], m_points[polygon[(i + 1) % n]])) return false;
    }
    for (const std::size_t h : holes) {
      const std::vector<std::uint32_t>& hole = m_loops[h];
      for (std::size_t i = 0; i < hole.size(); ++i) {
        if (cross(p, q, m_points[hole[i]], m_points[hole[(i + 1) % hole.size()]])) return false;
      }
    }
    return true;
  }

  /// Cuts ears from a ring of positions until a triangle is left.
  bool cutOne(const std::vector<std::uint32_t>& polygon, std::vector<Triangle>& all) {
    std::size_t left = polygon.size();
    if (left < 3) return false;
    std::vector<std::size_t> next(left), last(left);
    for (std::size_t i = 0; i < left; ++i) {
      next[i] = (i + 1) % left;
      last[i] = (i + left - 1) % left;
    }
    const auto pointAt = [&](std::size_t i) -> const GridPoint& { return m_points[polygon[i]]; };
    const auto isEar = [&](std::size_t i, bool isStrict) {
      const GridPoint &a = pointAt(last[i]), &b = pointAt(i), &c = pointAt(next[i]);
      const std::int64_t turn = turnOf(a, b, c);
      if (isStrict ? turn <= 0 : turn < 0) return false;
      if (turn == 0) return true;
      const std::int64_t lowX = std::min({a.x, b.x, c.x}), highX = std::max({a.x, b.x, c.x});
      const std::int64_t lowY = std::min({a.y, b.y, c.y}), highY = std::max({a.y, b.y, c.y});
      for (std::size_t k = next[next[i]]; k != last[i]; k = next[k]) {
        const GridPoint& p = pointAt(k);
        if (p.x < lowX || p.x > highX || p.y < lowY || p.y > highY) continue;
        if (p == a || p == b || p == c) continue;
        if (turnOf(a, b, p) >= 0 && turnOf(b, c, p) >= 0 && turnOf(c, a, p) >= 0) return false;
      }
      return true;
    };
    std::size_t at = 0, misses = 0;
    bool isStrict = true;
    while (left > 3) {
      if (isEar(at, isStrict)) {
        all.push_back({polygon[last[at]], polygon[at], polygon[next[at]]});
        next[last[at]] = next[at];
        last[next[at]] = last[at];
        --left;
        at = next[next[at]];  // skipping one keeps triangles fat
        misses = 0;
        isStrict = true;
        continue;
      }
      at = next[at];
      if (++misses <= left) continue;
      if (!isStrict) return false;
      isStrict = false;
      misses = 0;
    }
    if (turnOf(pointAt(last[at]), pointAt(at), pointAt(next[at])) < 0) return false;
    all.push_back({polygon[last[at]], polygon[at], polygon[next[at]]});
    return true;
  }

  std::vector<GridPoint> m_points;
  std::vector<std::vector<std::uint32_t>> m_loops;
};

float onGridOf(double value) {
  return static_cast<float>(std::round(value / KitShell::kGrid) * KitShell::kGrid) + 0.0F;
}

Float3 floatsOf(const Vector3d& p) {
  return {onGridOf(p.x()), onGridOf(p.y()), onGridOf(p.z())};
}

}  // namespace

Vector2d KitShell::onGrid(const Vector2d& p) {
  return {std::round(p.x() / kGrid) * kGrid, std::round(p.y() / kGrid) * kGrid};
}

void KitShell::addTriangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  m_triangles.push_back({a, b, c});
}

void KitShell::addWall(std::span<const Rim> rims) {
  for (std::size_t r = 0; r + 1 < rims.size(); ++r) {
    const Rim &low = rims[r], &high = rims[r + 1];
    const std::size_t n = low.outline.size();
    GEARGRAPH_REQUIRE(n == high.outline.size());
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = (i + 1) % n;
      const Vector3d a(low.outline[i].x(), low.outline[i].y(), low.height);
      const Vector3d b(low.outline[k].x(), low.outline[k].y(), low.height);
      const Vector3d c(high.outline[k].x(), high.outline[k].y(), high.height);
      const Vector3d d(high.outline[i].x(), high.outline[i].y(), high.height);
      addTriangle(a, b, c);
      addTriangle(a, c, d);
    }
  }
}

bool KitShell::addFace(std::span<const KitOutline> outlines, double height, bool isUp) {
  std::vector<Vector3d> points;
  for (const KitOutline& outline : outlines) {
    for (const Vector2d& p : outline) points.emplace_back(p.x(), p.y(), height);
  }
  const std::vector<Triangle> triangles = triangulated(outlines);
  for (const Triangle& t : triangles) {
    if (isUp) {
      addTriangle(points[t[0]], points[t[1]], points[t[2]]);
    } else {
      addTriangle(points[t[0]], points[t[2]], points[t[1]]);
    }
  }
  return !triangles.empty();
}

Solid KitShell::solid() const {
  Solid made;
  for (const std::array<Vector3d, 3>& t : m_triangles) {
    const std::array<Float3, 3> corners = {floatsOf(t[0]), floatsOf(t[1]), floatsOf(t[2])};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    const auto first = static_cast<std::uint32_t>(made.positions.size());
    for (const Float3& corner : corners) {
      made.positions.push_back(corner);
      made.normals.push_back(
          {static_cast<float>(normal.x()), static_cast<float>(normal.y()), static_cast<float>(normal.z())});
    }
    made.triangles.push_back({first, first + 1, first + 2});
  }
  return made;
}

std::vector<Triangle> triangulated(std::span<const KitOutline> outlines) {
  return EarCutter(outlines).cut();
}

bool isClosed(const Solid& solid) {
  std::map<std::pair<Float3, Float3>, int> edges;
  for (const Triangle& t : solid.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Float3& a = solid.positions[t[k]];
      const Float3& b = solid.positions[t[(k + 1) % 3]];
      ++edges[{a, b}];
    }
  }
  return !solid.empty() && std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    const auto back = edges.find({edge.first.second, edge.first.first});
    return edge.second == 1 && back != edges.end() && back->second == 1;
  });
}

std::vector<Rim> chamferedWall(const KitOutline& outline, double low, double high, double chamfer) {
  if (chamfer <= 0) return {{low, outline}, {high, outline}};
  const double height = std::min(chamfer, 0.5 * (high - low));
  return {{low, inset(outline, chamfer)}, {low + height, outline}, {high, outline}};
}

Solid plateSolid(const PlateShape& shape) {
  KitShell shell;
  shell.addWall(shape.outer);
  std::vector<KitOutline> bottom{shape.outer.front().outline}, top{shape.outer.back().outline};
  for (const std::vector<Rim>& hole : shape.holes) {
    shell.addWall(hole);
    bottom.push_back(hole.front().outline);
    top.push_back(hole.back().outline);
  }
  const double low = shape.outer.front().height, high = shape.outer.back().height;
  bool isMade = true;
  for (const std::vector<Rim>& well : shape.wells) {
    shell.addWall(well);
    top.push_back(well.back().outline);
    const KitOutline& floor = well.front().outline;
    isMade = shell.addFace(std::vector<KitOutline>{reversed(floor)}, well.front().height, true) && isMade;
  }
  for (const KitOutline& pocket : shape.topPockets) {
    const KitOutline hole = reversed(pocket);
    top.push_back(hole);
    shell.addWall(std::vector<Rim>{{high - shape.pocketDepth, hole}, {high, hole}});
    isMade = shell.addFace(std::vector<KitOutline>{pocket}, high - shape.pocketDepth, true) && isMade;
  }
  for (const KitOutline& pocket : shape.bottomPockets) {
    const KitOutline hole = reversed(pocket);
    bottom.push_back(hole);
    shell.addWall(std::vector<Rim>{{low, hole}, {low + shape.pocketDepth, hole}});
    isMade = shell.addFace(std::vector<KitOutline>{pocket}, low + shape.pocketDepth, false) && isMade;
  }
  isMade = shell.addFace(bottom, low, false) && isMade;
  isMade = shell.addFace(top, high, true) && isMade;
  return isMade ? shell.solid() : Solid{};
}

}  // namespace geargraph
