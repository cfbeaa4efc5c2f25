#pragma once

#include <vector>

#include "core/presentation/drawing/planar.h"

namespace geargraph::inline power_drawing {

/// The lines of one link on a sheet, as ways for its power. Lines are joined where one ends on another; parts
/// that do not touch (both halves of a hollow shaft) are bridged where they come nearest.
class BandNetwork {
 public:
  void addLine(SheetPoint from, SheetPoint to) { m_lines.push_back({from, to}); }
  [[nodiscard]] bool isEmpty() const { return m_lines.empty(); }
  /// The place on the lines that is nearest. @pre it is not empty
  [[nodiscard]] SheetPoint nearest(SheetPoint place) const;
  /// The end of the nearest line that is nearest, if it is not farther from that place than `most`, else the
  /// place itself.
  [[nodiscard]] SheetPoint nearestEnd(SheetPoint place, double most) const;

  /// Power that enters at a place of the lines (below 0: leaves).
  struct Entry {
    SheetPoint at;
    double power = 0;
    double circulating = 0;
  };
  /// A stretch with the same power all along, in its direction.
  struct Run {
    std::vector<SheetPoint> course;
    double power = 0;        ///< above 0
    double circulating = 0;  ///< signed
  };
  /// How the power goes from where it enters to where it leaves, on the shortest tree of lines that holds all
  /// of them. Cost: O(lines^2). @pre the entries add up to 0, but for rounding
  [[nodiscard]] std::vector<Run> runs(const std::vector<Entry>& entries) const;

 private:
  struct Line {
    SheetPoint from;
    SheetPoint to;
  };
  std::vector<Line> m_lines;
};

}  // namespace geargraph::inline power_drawing
