#pragma once

#include <vector>

#include "core/presentation/drawing/planar.h"

namespace geargraph {

/// The lines of one link on a sheet as a network for its power flow. Lines are connected where one ends on
/// another; parts that do not touch (the two halves of a hollow shaft) are bridged at their nearest points.
class BandNetwork {
 public:
  void addLine(CanvasPoint from, CanvasPoint to) { m_lines.push_back({from, to}); }
  [[nodiscard]] bool isEmpty() const { return m_lines.empty(); }
  /// The nearest point on the lines. @pre it is not empty
  [[nodiscard]] CanvasPoint nearest(CanvasPoint place) const;
  /// The nearer end of the line nearest to `place`, if it is at most `most` from that nearest point, else the
  /// nearest point.
  [[nodiscard]] CanvasPoint nearestEnd(CanvasPoint place, double most) const;

  /// Power that enters the lines at a point (below 0: leaves).
  struct Entry {
    CanvasPoint at;
    double power = 0;
    double circulating = 0;
  };
  /// A path of constant power, in the direction of the flow.
  struct Run {
    std::vector<CanvasPoint> course;
    double power = 0;        ///< above 0
    double circulating = 0;  ///< signed
  };
  /// The power flow from where it enters to where it leaves, on a shortest tree of lines through all entries.
  /// Cost: O(lines^2). @pre the entries sum to 0 within rounding
  [[nodiscard]] std::vector<Run> runs(const std::vector<Entry>& entries) const;

 private:
  struct Line {
    CanvasPoint from;
    CanvasPoint to;
  };
  std::vector<Line> m_lines;
};

}  // namespace geargraph
