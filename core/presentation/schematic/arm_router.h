#pragma once

#include "core/presentation/schematic/arm_search.h"

namespace geargraph {

/// Routes arms between the existing lines: with horizontal and vertical segments only, few bends, and
/// crossing lines of other links only where a detour is impossible.
class ArmRouter {
 public:
  ArmRouter() = default;
  /// `ends`: further points where courses have to begin or end.
  ArmRouter(std::vector<LinkLine> lines, const std::vector<CanvasPoint>& ends);

  /// Resets the router, reusing its memory.
  void begin(ArmGrid grid, const std::vector<LinkLine>& lines);

  struct Course {
    std::vector<CanvasPoint> points;
    double length = 0;
    int crossings = 0;       ///< lines of other links
    std::size_t target = 0;  ///< position of the target reached
  };
  /// Routes from one of `starts`, or if that is empty from any of the link's lines, to the cheapest of the
  /// targets; std::nullopt if the link has no lines, or `stop` was requested meanwhile. `prices`: additional
  /// cost of ending at each target, px; empty: none. Among courses of equal cost it is the one that
  /// Dijkstra's algorithm finds when it settles such states in the order of their numbers. The course is then
  /// added to the link's lines. Cost: O(b m), m the nodes of the grid and b the bends of the courses, 30 µs
  /// for a thousand nodes.
  [[nodiscard]] std::optional<Course> route(int link, const std::vector<LinkLine>& starts,
                                            const std::vector<CanvasPoint>& targets,
                                            const std::vector<double>& prices = {},
                                            const std::stop_token& stop = {});

 private:
  [[nodiscard]] Course courseThrough(std::vector<CanvasPoint> points, int link) const;

  ArmGrid m_grid;
  std::vector<LinkLine> m_lines;
  ArmEdgeWeights m_weights;
  ArmSearch m_search;
};

}  // namespace geargraph
