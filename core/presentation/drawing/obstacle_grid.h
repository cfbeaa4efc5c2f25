#pragma once

#include <vector>

#include "core/presentation/drawing/planar.h"

namespace geargraph::inline drawing {

/// What stands on a sheet already, sorted into square cells, so that asking whether a place is free costs no
/// more on a sheet of thousands than on one of ten.
class ObstacleGrid {
 public:
  /// `area` is where obstacles are expected; beyond it the outermost cells fill up.
  explicit ObstacleGrid(const Extent& area);

  void addCircle(SheetPoint center, double radius, int owner);  ///< a node; `owner` its ordinal
  void addCurve(const Curve& curve);
  void addBox(const Extent& box);

  /// Does anything come nearer to the box than `gap`? The circle of `except` does not count.
  [[nodiscard]] bool touches(const Extent& box, double gap, int except = -1) const;
  /// How many circles the curve comes nearer to than `gap`, apart from those of its two ends. Counts no
  /// further than to `enough`.
  [[nodiscard]] int circlesHit(const Curve& curve, double gap, int tail, int head, int enough) const;

 private:
  enum class Kind { circle, segment, box };
  struct Obstacle {
    Kind kind;
    int owner;
    SheetPoint a;  ///< centre, or one end
    SheetPoint b;  ///< (radius, 0), the other end, or half the sides
  };
  struct Entry {
    int obstacle;
    int next;
  };

  [[nodiscard]] int column(double x) const;
  [[nodiscard]] int row(double y) const;
  void enter(int obstacle, const Extent& extent);
  void addSegment(SheetPoint from, SheetPoint to);
  template <class Visit>
  bool anyNear(const Extent& extent, Visit visit) const;

  SheetPoint m_origin;
  double m_cell = 1;
  int m_columns = 1;
  int m_rows = 1;
  std::vector<Obstacle> m_obstacles;
  std::vector<Entry> m_entries;
  std::vector<int> m_first;  ///< by cell: the head of its list of entries, or -1
};

}  // namespace geargraph::inline drawing
