#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/presentation/drawing/palette.h"

namespace geargraph::inline forces {

/// A few lines over one quantity, with axes and a legend; a line has gaps where it has no value. The pointer,
/// or the left and right arrow keys, move a hair line that reads the values.
class EfficiencyPlot : public QWidget {
  Q_OBJECT

 public:
  struct Line {
    QString name;
    ColorRole colour = ColorRole::accent;
    Qt::PenStyle style = Qt::SolidLine;
    std::vector<std::optional<double>> values;  ///< one a place
  };
  struct Sheet {
    QString across;  ///< what the places are
    QString up;      ///< what the values are, with its unit
    std::vector<double> places;
    std::vector<Line> lines;
    std::optional<double> now;  ///< where the train is
  };

  explicit EfficiencyPlot(QWidget* parent = nullptr);

  void setSheet(Sheet sheet);
  [[nodiscard]] const Sheet& sheet() const { return m_sheet; }
  /// The values at the hair line, in words; empty where there is none.
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
  double m_low = 0;  ///< of the values that are shown
  double m_high = 1;
  std::optional<std::size_t> m_read;  ///< the place that the hair line is at
};

}  // namespace geargraph::inline forces
