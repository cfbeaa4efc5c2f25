#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/presentation/drawing/palette.h"

namespace geargraph {

/// A line plot with axes and a legend; a line has gaps where it has no value. The pointer, or the left and
/// right arrow keys, move a crosshair that reads the values.
class EfficiencyPlot : public QWidget {
  Q_OBJECT

 public:
  struct Line {
    QString name;
    ColorRole colour = ColorRole::accent;
    Qt::PenStyle style = Qt::SolidLine;
    std::vector<std::optional<double>> values;  ///< one per place
  };
  struct Sheet {
    QString across;  ///< title of the horizontal axis
    QString up;      ///< title of the vertical axis, with its unit
    std::vector<double> places;
    std::vector<Line> lines;
    std::optional<double> now;  ///< the present value of the train
  };

  explicit EfficiencyPlot(QWidget* parent = nullptr);

  void setSheet(Sheet sheet);
  [[nodiscard]] const Sheet& sheet() const { return m_sheet; }
  /// The values at the crosshair as text; empty without one.
  [[nodiscard]] QString reading() const;
  [[nodiscard]] QPointF placeOf(double place, double value) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  [[nodiscard]] QRectF area() const;
  void readAt(std::optional<std::size_t> index);
  void paintAxes(QPainter& painter) const;
  void paintLine(QPainter& painter, const Line& line) const;
  void paintLegend(QPainter& painter) const;

  Sheet m_sheet;
  double m_low = 0;  ///< lower limit of the vertical axis
  double m_high = 1;
  std::optional<std::size_t> m_read;  ///< index of the place at the crosshair
};

}  // namespace geargraph
