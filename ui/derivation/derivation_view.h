#pragma once

#include <QAbstractScrollArea>
#include <optional>
#include <set>
#include <vector>

#include "ui/derivation/derivation_service.h"
#include "ui/derivation/flow_painter.h"
#include "ui/selection/selection.h"

namespace geargraph::inline ui_derivation {

/// A derivation, set like a printed page, as wide as the view; a matrix that is wider even when it is small
/// scrolls. Equations of an element light up with it and select it; of what is selected elsewhere the nearest
/// one comes into sight. Ctrl and the wheel zoom.
class DerivationView : public QAbstractScrollArea {
  Q_OBJECT

 public:
  static constexpr double kLeastZoom = 0.6, kMostZoom = 3;

  explicit DerivationView(Selection* selection, QWidget* parent = nullptr);

  /// What is in sight stays there, as far as it is still there.
  void setReport(const SetReportPtr& report);
  [[nodiscard]] const SetReportPtr& report() const { return m_report; }

  [[nodiscard]] double zoom() const { return m_zoom; }
  void setZoom(double zoom);

  /// The blocks that are headings, from the first on.
  [[nodiscard]] const std::vector<std::size_t>& headings() const { return m_headings; }
  /// Of the heading that is above what is in sight; 0 at the beginning.
  [[nodiscard]] int currentHeading() const;
  void showHeading(int heading);

  /// Where the strip of an equation's first line is, in the viewport; empty for none of this number.
  [[nodiscard]] QRect equationPlace(int number) const;
  /// What "Copy" takes at a place of the viewport: the TeX of an equation, the text of anything else.
  [[nodiscard]] QString textAt(QPoint place) const;
  [[nodiscard]] bool isEquationAt(QPoint place) const;

  [[nodiscard]] QSize minimumSizeHint() const override { return {120, 60}; }

 signals:
  void headingChanged(int heading);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;

 private:
  /// A place in the document that a new layout goes back to.
  struct Anchor {
    int heading = 0;
    int below = 0;  ///< px
  };

  void layOut();
  void layOutAt(const Anchor& anchor);
  [[nodiscard]] Anchor anchor() const;
  [[nodiscard]] int topOfHeading(int heading) const;
  void renewScrollBars(double width, double height);
  [[nodiscard]] std::optional<std::size_t> lineAt(QPoint place) const;
  [[nodiscard]] std::optional<ElementId> elementAt(QPoint place) const;
  void paintLight(QPainter& painter, std::size_t line, QPointF origin);
  void hover(const std::optional<ElementId>& element);
  /// Scrolls to the nearest equation of what is selected where none is in sight.
  void showSelected();

  Selection* m_selection;
  SetReportPtr m_report;
  std::optional<FontMeasure> m_measure;
  std::vector<FlowLine> m_lines;
  std::vector<double> m_tops;           ///< of lines; one more: the end
  std::vector<std::size_t> m_headings;  ///< blocks
  FlowPainter m_painter;
  double m_zoom = 1;
  int m_laidOutFor = -1;  ///< width
  bool m_hovers = false;  ///< what is hovered was hovered here
  int m_heading = -1;     ///< told last
};

}  // namespace geargraph::inline ui_derivation
