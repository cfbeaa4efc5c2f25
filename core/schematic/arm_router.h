#pragma once

#include <optional>
#include <vector>

#include "core/drawing/planar.h"

namespace geargraph {

/// A line on the sheet and the link it belongs to.
struct LinkLine {
  SheetPoint from;
  SheetPoint to;
  int link = 0;
  /// What it costs to fasten an arm of the link here; below 0: no arm begins here.
  double hold = 0;
};

/// Finds courses for arms between what is drawn already: level and upright lines only, with few bends, and
/// across lines of other links only where there is no way round.
class ArmRouter {
 public:
  /// `ends`: places that courses will have to begin or end at, beside the lines' own ends.
  ArmRouter(const std::vector<LinkLine>& lines, const std::vector<SheetPoint>& ends);

  struct Course {
    std::vector<SheetPoint> points;
    double length = 0;
    int crossings = 0;       ///< lines of other links
    std::size_t target = 0;  ///< which one it reached
  };
  /// From any of the link's lines to the cheapest of the targets; nothing if it has no lines. `prices`: what
  /// it costs beside to end at each of them, px; empty: nothing.
  /// The course counts as the link's from then on. Cost: O(m log m), m the cells of the grid.
  [[nodiscard]] std::optional<Course> route(int link, const std::vector<SheetPoint>& targets,
                                            const std::vector<double>& prices = {});

 private:
  struct Toll {
    int link = 0;
    int next = -1;  ///< of the same edge: its place in m_tolls
    double cost = 0;
  };
  /// What links ask for an edge, in the order in which their lines came.
  struct Tolls {
    int first = -1;
    int last = -1;
  };

  void addLine(const LinkLine& line);
  void charge(const LinkLine& line, bool level);
  [[nodiscard]] int node(std::size_t column, std::size_t row) const;
  [[nodiscard]] SheetPoint place(int node) const;
  [[nodiscard]] std::optional<int> nodeAt(SheetPoint p) const;
  /// Nodes on the link's lines, and what it costs to begin there.
  [[nodiscard]] std::vector<std::pair<int, double>> startsOf(int link) const;
  /// Tolls of all edges for this link.
  [[nodiscard]] std::vector<double> pricesOf(const std::vector<Tolls>& edges, int link) const;
  [[nodiscard]] Course courseTo(int state, const std::vector<int>& from, int link) const;
  void add(Tolls& tolls, int link, double cost);
  [[nodiscard]] double tollFor(const Tolls& tolls, int link) const;

  std::vector<LinkLine> m_lines;
  std::vector<double> m_xs;
  std::vector<double> m_ys;
  std::vector<Toll> m_tolls;     ///< of all edges
  std::vector<Tolls> m_level;    ///< by node: the edge to the right
  std::vector<Tolls> m_upright;  ///< by node: the edge down
};

}  // namespace geargraph
