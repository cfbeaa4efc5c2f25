#pragma once

#include <optional>
#include <vector>

#include "core/presentation/drawing/planar.h"

namespace geargraph {

/// A line on the sheet and its link.
struct LinkLine {
  CanvasPoint from;
  CanvasPoint to;
  int link = 0;
  /// The cost of connecting an arm of the link here; below 0: no arm begins here.
  double penalty = 0;
};

/// The lanes on which arms run, ascending. Nodes are their intersections, row by row.
struct ArmGrid {
  std::vector<double> xs;  ///< of the vertical lanes
  std::vector<double> ys;  ///< of the horizontal ones

  [[nodiscard]] std::size_t columns() const { return xs.size(); }
  [[nodiscard]] std::size_t rows() const { return ys.size(); }
  [[nodiscard]] std::size_t nodes() const { return xs.size() * ys.size(); }
  [[nodiscard]] CanvasPoint place(std::size_t node) const {
    return {xs[node % xs.size()], ys[node / xs.size()]};
  }
  [[nodiscard]] std::optional<std::size_t> nodeAt(CanvasPoint p) const;
  /// All nodes on a line, row by row.
  [[nodiscard]] std::vector<std::size_t> nodesOn(const LinkLine& line) const;
};

/// The first of ascending values that is not less than v; their number if there is none.
[[nodiscard]] std::size_t firstFrom(const std::vector<double>& values, double v);

/// Collects the lanes for a set of lines: through their ends, where arms may begin, and some beside them.
class ArmLanes {
 public:
  /// Adds the lines that are new since the last call. Cost: O(m log m) for m new ones, and O(all).
  void follow(const std::vector<LinkLine>& lines);
  /// `ends`: further points where courses have to begin or end. Cost: O(lines).
  [[nodiscard]] ArmGrid gridWith(const std::vector<CanvasPoint>& ends) const;

 private:
  /// All ascending.
  struct Asked {
    std::vector<double> exact;      ///< lanes stay where these are
    std::vector<double> preferred;  ///< kept where no exact lane is too near
  };
  std::size_t m_known = 0;  ///< lines
  Asked m_x;
  Asked m_y;
};

/// The edge weights of a grid for the arms of a link, in addition to length: for crossing lines of other
/// links, and for running beside them.
struct ArmEdgeWeights {
  std::vector<double> level;    ///< by node: the edge to the right
  std::vector<double> upright;  ///< by node: the edge down

  /// Computes the weights for a link; contributions are added in the order of the lines. Cost: O(lines +
  /// pairs of a line and a near edge).
  void add(const ArmGrid& grid, const std::vector<LinkLine>& lines, int link);
};

}  // namespace geargraph
