#include "core/presentation/drawing/obstacle_grid.h"

namespace geargraph {
namespace {

constexpr double kSmallestCell = 48;
constexpr double kMaxCells = 1 << 19;
constexpr double kMaxAlong = 1 << 16;  // cells of a side

}  // namespace

ObstacleGrid::ObstacleGrid(const Extent& area) : m_origin{area.left(), area.top()} {
  // As many cells as memory bears: a drawing of thousands of links is long, and must not crowd into a few.
  const double sides = 4 * (area.halfWidth + kSmallestCell) * (area.halfHeight + kSmallestCell);
  const double longest = 2 * std::max(area.halfWidth, area.halfHeight);
  m_cell = std::max({kSmallestCell, std::sqrt(sides / kMaxCells), longest / kMaxAlong});
  m_columns = 1 + static_cast<int>(2 * area.halfWidth / m_cell);
  m_rows = 1 + static_cast<int>(2 * area.halfHeight / m_cell);
  m_first.assign(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows), -1);
}

int ObstacleGrid::column(double x) const {
  return static_cast<int>(std::clamp((x - m_origin.x) / m_cell, 0.0, m_columns - 1.0));
}

int ObstacleGrid::row(double y) const {
  return static_cast<int>(std::clamp((y - m_origin.y) / m_cell, 0.0, m_rows - 1.0));
}

void ObstacleGrid::enter(int obstacle, const Extent& extent) {
  for (int r = row(extent.top()); r <= row(extent.bottom()); ++r) {
    for (int c = column(extent.left()); c <= column(extent.right()); ++c) {
      int& first = m_first[static_cast<std::size_t>(r * m_columns + c)];
      m_entries.push_back({obstacle, first});
      first = static_cast<int>(m_entries.size()) - 1;
    }
  }
}

void ObstacleGrid::addCircle(CanvasPoint center, double radius, int owner) {
  m_obstacles.push_back({Kind::circle, owner, center, {radius, 0}});
  enter(static_cast<int>(m_obstacles.size()) - 1, {center, radius, radius});
}

void ObstacleGrid::addBox(const Extent& box) {
  m_obstacles.push_back({Kind::box, -1, box.center, {box.halfWidth, box.halfHeight}});
  enter(static_cast<int>(m_obstacles.size()) - 1, box);
}

void ObstacleGrid::addCurve(const Curve& curve) {
  forEachChord(curve, [this](CanvasPoint from, CanvasPoint to) { addSegment(from, to); });
}

void ObstacleGrid::addSegment(CanvasPoint from, CanvasPoint to) {
  if (from.x > to.x) std::swap(from, to);
  const int index = static_cast<int>(m_obstacles.size());
  m_obstacles.push_back({Kind::segment, -1, from, to});
  const double slope = to.x > from.x ? (to.y - from.y) / (to.x - from.x) : 0;
  const int last = column(to.x);
  for (int c = column(from.x); c <= last; ++c) {
    // The piece of the segment in this column of cells.
    const double left = std::max(from.x, m_origin.x + c * m_cell);
    const double right = c == last ? to.x : std::min(to.x, m_origin.x + (c + 1) * m_cell);
    const CanvasPoint start{left, from.y + slope * (left - from.x)};
    const CanvasPoint end = c == last ? to : CanvasPoint{right, from.y + slope * (right - from.x)};
    const int top = row(std::min(start.y, end.y));
    const int bottom = row(std::max(start.y, end.y));
    for (int r = top; r <= bottom; ++r) {
      int& first = m_first[static_cast<std::size_t>(r * m_columns + c)];
      m_entries.push_back({index, first});
      first = static_cast<int>(m_entries.size()) - 1;
    }
  }
}

template <class Visit>
bool ObstacleGrid::anyNear(const Extent& extent, Visit visit) const {
  const int right = column(extent.right());
  const int bottom = row(extent.bottom());
  for (int r = row(extent.top()); r <= bottom; ++r) {
    for (int c = column(extent.left()); c <= right; ++c) {
      int entry = m_first[static_cast<std::size_t>(r * m_columns + c)];
      for (; entry >= 0; entry = m_entries[static_cast<std::size_t>(entry)].next) {
        const int obstacle = m_entries[static_cast<std::size_t>(entry)].obstacle;
        if (visit(m_obstacles[static_cast<std::size_t>(obstacle)])) return true;
      }
    }
  }
  return false;
}

bool ObstacleGrid::touches(const Extent& box, double gap, int except) const {
  const Extent wide = box.grown(gap);
  return anyNear(wide, [&](const Obstacle& obstacle) {
    switch (obstacle.kind) {
      case Kind::circle:
        return obstacle.owner != except && wide.meetsCircle(obstacle.a, obstacle.b.x);
      case Kind::segment:
        return wide.meetsSegment(obstacle.a, obstacle.b);
      case Kind::box:
        return wide.meets({obstacle.a, obstacle.b.x, obstacle.b.y});
    }
    return false;
  });
}

int ObstacleGrid::circlesHit(const Curve& curve, double gap, int tail, int head, int enough) const {
  std::vector<int> hit;
  CanvasPoint from;
  CanvasPoint to;
  const auto visit = [&](const Obstacle& circle) {
    const bool counts = circle.kind == Kind::circle && circle.owner != tail && circle.owner != head;
    if (!counts || distanceToSegment(circle.a, from, to) >= circle.b.x + gap) return false;
    if (std::find(hit.begin(), hit.end(), circle.owner) == hit.end()) hit.push_back(circle.owner);
    return static_cast<int>(hit.size()) >= enough;
  };
  bool done = false;
  forEachChord(curve, [&](CanvasPoint start, CanvasPoint end) {
    // In pieces of two cells, so that a long slanting line does not look at the whole rectangle it spans.
    const int pieces = 1 + static_cast<int>(distance(start, end) / (2 * m_cell));
    from = start;
    for (int i = 1; i <= pieces && !done; ++i) {
      to = between(start, end, static_cast<double>(i) / pieces);
      done = anyNear(Extent::spanning(from, to).grown(gap), visit);
      from = to;
    }
  });
  return static_cast<int>(hit.size());
}

}  // namespace geargraph
