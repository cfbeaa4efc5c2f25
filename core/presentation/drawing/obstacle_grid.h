#pragma once

#include <vector>

#include "core/presentation/drawing/planar.h"

namespace geargraph {

/// The obstacles on a sheet, sorted into square cells, so that testing a place costs the same with ten
/// obstacles as with thousands.
class ObstacleGrid {
 public:
  /// `area` is where obstacles are expected; obstacles beyond it are put into the outermost cells.
  explicit ObstacleGrid(const Extent& area);

  void addCircle(CanvasPoint center, double radius, int owner);  ///< a node; `owner` its ordinal
  void addCurve(const Curve& curve);
  void addBox(const Extent& box);

  /// Is any obstacle nearer to the box than `gap`? The circle of the owner `except` is ignored.
  [[nodiscard]] bool touches(const Extent& box, double gap, int except = -1) const;
  /// The number of circles nearer to the curve than `gap`, except those of its two ends; counts up to
  /// `enough` only.
  [[nodiscard]] int circlesHit(const Curve& curve, double gap, int tail, int head, int enough) const;

 private:
  enum class Kind { circle, segment, box };
  struct Obstacle {
    Kind kind;
    int owner;
    CanvasPoint a;  ///< centre, or one end
    CanvasPoint b;  ///< (radius, 0), the other end, or half the sides
  };
  struct Entry {
    int obstacle;
    int next;
  };

  [[nodiscard]] int column(double x) const;
  [[nodiscard]] int row(double y) const;
  void enter(int obstacle, const Extent& extent);
  void addSegment(CanvasPoint from, CanvasPoint to);
  template <class Visit>
  bool anyNear(const Extent& extent, Visit visit) const;

  CanvasPoint m_origin;
  double m_cell = 1;
  int m_columns = 1;
  int m_rows = 1;
  std::vector<Obstacle> m_obstacles;
  std::vector<Entry> m_entries;
  std::vector<int> m_first;  ///< by cell: the head of its list of entries, or -1
};

}  // namespace geargraph
