#include "core/presentation/schematic/arm_router.h"

#include <algorithm>

namespace geargraph {
namespace {

ArmGrid gridOf(const std::vector<LinkLine>& lines, const std::vector<CanvasPoint>& ends) {
  ArmLanes lanes;
  lanes.follow(lines);
  return lanes.gridWith(ends);
}

/// Without the places at which a way runs straight on.
std::vector<CanvasPoint> bendsOf(const ArmGrid& grid, const std::vector<std::size_t>& nodes) {
  std::vector<CanvasPoint> places;
  for (const std::size_t node : nodes) {
    const CanvasPoint p = grid.place(node);
    if (places.empty() || distance(places.back(), p) > 1e-6) places.push_back(p);
  }
  std::vector<CanvasPoint> bends;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool straight =
        i > 0 && i + 1 < places.size() &&
        std::abs(dot(unit(places[i] - places[i - 1]), turned(unit(places[i + 1] - places[i])))) < 1e-6;
    if (!straight) bends.push_back(places[i]);
  }
  return bends;
}

}  // namespace

ArmRouter::ArmRouter(std::vector<LinkLine> lines, const std::vector<CanvasPoint>& ends)
    : m_grid(gridOf(lines, ends)), m_lines(std::move(lines)) {}

void ArmRouter::begin(ArmGrid grid, const std::vector<LinkLine>& lines) {
  m_grid = std::move(grid);
  m_lines = lines;
}

ArmRouter::Course ArmRouter::courseThrough(std::vector<CanvasPoint> points, int link) const {
  Course course;
  course.points = std::move(points);
  for (std::size_t i = 1; i < course.points.size(); ++i) {
    const Extent way = Extent::spanning(course.points[i - 1], course.points[i]);
    course.length += 2 * (way.halfWidth + way.halfHeight);
    course.crossings +=
        static_cast<int>(std::count_if(m_lines.begin(), m_lines.end(), [&](const LinkLine& line) {
          return line.link >= 0 && line.link != link && way.meetsSegment(line.from, line.to);
        }));
  }
  return course;
}

std::optional<ArmRouter::Course> ArmRouter::route(int link, const std::vector<LinkLine>& starts,
                                                  const std::vector<CanvasPoint>& targets,
                                                  const std::vector<double>& prices,
                                                  const std::stop_token& stop) {
  m_weights.add(m_grid, m_lines, link);
  m_search.begin(m_grid, m_weights);
  const auto begin = [&](const LinkLine& line) {
    for (const std::size_t node : m_grid.nodesOn(line)) m_search.addStart(node, line.penalty);
  };
  for (const LinkLine& line : starts) begin(line);
  for (const LinkLine& line : m_lines) {
    if (starts.empty() && line.link == link && line.penalty >= 0) begin(line);
  }
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const auto node = m_grid.nodeAt(targets[t]);
    if (node) m_search.addTarget(*node, prices.empty() ? 0 : prices[t], t);
  }
  const std::optional<ArmSearch::Way> way = m_search.cheapest(stop);
  if (!way) return std::nullopt;
  Course course = courseThrough(bendsOf(m_grid, way->nodes), link);
  course.target = way->target;
  for (std::size_t i = 1; i < course.points.size(); ++i)
    m_lines.push_back({course.points[i - 1], course.points[i], link, 0});
  return course;
}

}  // namespace geargraph
