#pragma once

#include <QColor>
#include <QFont>
#include <QPixmap>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/presentation/scene3d/motion_curves.h"

namespace geargraph {

/// Axis ticks at round numbers: 1, 2 or 5 times a power of ten apart, at most `most` of them over the range.
/// @pre low < high, most > 1
[[nodiscard]] std::vector<double> niceTicks(double low, double high, int most);

/// A subset of the points of a line from left to right that stays within `tolerance` vertically of all of
/// them. Contains the first and the last point. Cost: O(points).
[[nodiscard]] std::vector<QPointF> simplified(const std::vector<QPointF>& points, double tolerance);

/// Curves over time, with axes, units and a legend.
///
///     wheel         zoom along the time, at the pointer      drag            move along the time
///     Ctrl+wheel    zoom along the values                    click           go to that time
///     double click  show all                                 pointer         values there
class MotionPlot : public QWidget {
  Q_OBJECT

 public:
  explicit MotionPlot(QWidget* parent = nullptr);

  /// Sets the curves. The displayed range is kept if the times are the same; else it is the whole period, or
  /// the beginning of a long one.
  void setSheet(const CurveSheet& sheet);
  [[nodiscard]] const CurveSheet& sheet() const { return m_sheet; }
  /// Marks the time of the 3D view by a line. In seconds.
  void setTime(double seconds);
  void showAll();

  struct Range {
    double low = 0;
    double high = 1;
    [[nodiscard]] double size() const { return high - low; }
    friend bool operator==(const Range&, const Range&) = default;
  };
  [[nodiscard]] const Range& times() const { return m_times; }
  [[nodiscard]] const Range& values() const { return m_values; }
  /// The key of the cached picture of axes and curves; it changes whenever they are painted again.
  [[nodiscard]] qint64 pictureKey() const { return m_painted.picture.cacheKey(); }
  [[nodiscard]] double timeAt(double x) const;
  [[nodiscard]] QRectF area() const;  ///< of the curves

 signals:
  void timeWanted(double seconds);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  [[nodiscard]] QPointF placeOf(double time, double value) const;
  /// The same with a known area(), which is more expensive than the rest.
  [[nodiscard]] QPointF placeOf(double time, double value, const QRectF& inside) const;
  [[nodiscard]] QColor inkOf(const MotionCurve& curve) const;
  [[nodiscard]] double valueAt(const MotionCurve& curve, double time) const;
  [[nodiscard]] double legendWidth() const;
  void fitValues();
  void moveTimes(double low, double size);
  void paintAxes(QPainter& painter) const;
  void paintCurves(QPainter& painter) const;
  void paintLegend(QPainter& painter) const;
  void paintMoments(QPainter& painter) const;

  /// The cached picture of axes and curves, and all that it depends on.
  struct Painted {
    QPixmap picture;
    quint64 sheet = 0;
    Range times, values;
    QSize size;
    qreal ratio = 1;
    QColor ground;
    QFont font;
    [[nodiscard]] bool looksLike(const Painted& other) const {
      return sheet == other.sheet && times == other.times && values == other.values && size == other.size &&
             ratio == other.ratio && ground == other.ground && font == other.font;
    }
  };
  void updatePainted();

  CurveSheet m_sheet;
  quint64 m_sheetNumber = 0;  ///< incremented with every sheet
  Painted m_painted;
  int m_longestName = 0;  ///< px, of the legend
  Range m_times;
  Range m_values;
  double m_time = 0;
  std::optional<double> m_pointed;  ///< the time under the pointer
  std::optional<QPointF> m_pressed;
  double m_lowAtPress = 0;
  bool m_dragged = false;
};

}  // namespace geargraph
