#pragma once

#include <optional>
#include <vector>

#include "core/presentation/drawing/planar.h"

namespace geargraph::inline schematic {

/// A line on the sheet and the link it belongs to.
struct LinkLine {
  SheetPoint from;
  SheetPoint to;
  int link = 0;
  /// What it costs to fasten an arm of the link here; below 0: no arm begins here.
  double hold = 0;
};

/// The lanes on which arms run, ascending. Nodes are where they cross, row by row.
struct ArmGrid {
  std::vector<double> xs;  ///< of the upright lanes
  std::vector<double> ys;  ///< of the level ones

  [[nodiscard]] std::size_t columns() const { return xs.size(); }
  [[nodiscard]] std::size_t rows() const { return ys.size(); }
  [[nodiscard]] std::size_t nodes() const { return xs.size() * ys.size(); }
  [[nodiscard]] SheetPoint place(std::size_t node) const {
    return {xs[node % xs.size()], ys[node / xs.size()]};
  }
  [[nodiscard]] std::optional<std::size_t> nodeAt(SheetPoint p) const;
  /// All nodes on a line, row by row.
  [[nodiscard]] std::vector<std::size_t> nodesOn(const LinkLine& line) const;
};

/// The first of ascending values that is not less than v; their number if there is none.
[[nodiscard]] std::size_t firstFrom(const std::vector<double>& values, double v);

/// Lanes that lines ask for: through their ends, where arms may begin, and some beside them.
class ArmLanes {
 public:
  /// Takes in the lines that have come since the last time. Cost: O(m log m), m the new ones, and O(all).
  void follow(const std::vector<LinkLine>& lines);
  /// `ends`: places that courses will have to begin or end at, beside the lines' own ends. Cost: O(lines).
  [[nodiscard]] ArmGrid gridWith(const std::vector<SheetPoint>& ends) const;

 private:
  /// All ascending.
  struct Asked {
    std::vector<double> exact;   ///< lanes stay where these are
    std::vector<double> wished;  ///< others give way to them
  };
  std::size_t m_known = 0;  ///< lines
  Asked m_x;
  Asked m_y;
};

/// What it costs an arm of a link beside its length to run along the edges of a grid: for crossing lines of
/// others, and for running beside them.
struct ArmTolls {
  std::vector<double> level;    ///< by node: the edge to the right
  std::vector<double> upright;  ///< by node: the edge down

  /// What comes to an edge is added up in the order of the lines. Cost: O(lines + (line, edge near it)).
  void charge(const ArmGrid& grid, const std::vector<LinkLine>& lines, int link);
};

}  // namespace geargraph::inline schematic
