#pragma once

#include "core/presentation/schematic/arm_search.h"

namespace geargraph::inline schematic {

/// Finds courses for arms between what is drawn already: level and upright lines only, with few bends, and
/// across lines of other links only where there is no way round.
class ArmRouter {
 public:
  ArmRouter() = default;
  /// `ends`: places that courses will have to begin or end at, beside the lines' own ends.
  ArmRouter(std::vector<LinkLine> lines, const std::vector<SheetPoint>& ends);

  /// As if it were new, but for the memory it has.
  void begin(ArmGrid grid, const std::vector<LinkLine>& lines);

  struct Course {
    std::vector<SheetPoint> points;
    double length = 0;
    int crossings = 0;       ///< lines of other links
    std::size_t target = 0;  ///< which one it reached
  };
  /// From one of `starts`, or where it is empty from any of the link's lines, to the cheapest of the targets;
  /// std::nullopt if it has no lines, or `stop` was requested meanwhile. `prices`: what
  /// it costs beside to end at each of them, px; empty: nothing. Of courses that cost the same it is the one
  /// that Dijkstra's search finds which settles such states in the order of their numbers.
  /// The course counts as the link's from then on. Cost: O(b m), m the nodes of the grid and b the bends of
  /// the courses, 30 µs for a thousand nodes.
  [[nodiscard]] std::optional<Course> route(int link, const std::vector<LinkLine>& starts,
                                            const std::vector<SheetPoint>& targets,
                                            const std::vector<double>& prices = {},
                                            const std::stop_token& stop = {});

 private:
  [[nodiscard]] Course courseThrough(std::vector<SheetPoint> points, int link) const;

  ArmGrid m_grid;
  std::vector<LinkLine> m_lines;
  ArmTolls m_tolls;
  ArmSearch m_search;
};

}  // namespace geargraph::inline schematic
