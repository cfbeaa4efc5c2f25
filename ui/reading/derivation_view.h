#pragma once

#include <QAbstractScrollArea>
#include <optional>
#include <set>
#include <vector>

#include "ui/document/selection.h"
#include "ui/reading/derivation_service.h"
#include "ui/reading/flow_painter.h"
#include "ui/service/turns.h"

namespace geargraph {

/// A typeset derivation, as wide as the view; a matrix that is too wide even at its smallest size scrolls.
/// Equations of an element are highlighted with it, and a click selects it; for a selection in another view
/// the nearest equation is scrolled into view. Ctrl and the wheel zoom.
class DerivationView : public QAbstractScrollArea {
  Q_OBJECT

 public:
  static constexpr double kLeastZoom = 0.6, kMaxZoom = 3;

  explicit DerivationView(Selection* selection, QWidget* parent = nullptr);

  /// Shows a report, keeping the scroll position as far as possible.
  void setReport(const SetReportPtr& report);
  /// The same; it need not be laid out here if its layout is that of the view.
  void setDerivation(const Derivation& derivation);
  /// As the view lays out reports now.
  [[nodiscard]] DerivationLayout currentLayout() const;
  [[nodiscard]] const SetReportPtr& report() const { return m_report; }

  [[nodiscard]] double zoom() const { return m_zoom; }
  void setZoom(double zoom);

  /// The blocks that are headings, in order.
  [[nodiscard]] const std::vector<std::size_t>& headings() const { return m_headings; }
  /// The index of the last heading above the visible part; 0 at the beginning.
  [[nodiscard]] int currentHeading() const;
  void showHeading(int heading);

  /// The rectangle of an equation's first line in the viewport; empty if there is no equation with this
  /// number.
  [[nodiscard]] QRect equationPlace(int number) const;
  /// The text for "Copy" at a point of the viewport: the TeX of an equation, the text of anything else.
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
  /// A position in the document to which a new layout returns.
  struct Anchor {
    int heading = 0;
    int below = 0;  ///< px
  };

  void show(const SetReportPtr& report, const Derivation* derivation);
  void layOut();
  void layOutAt(const Anchor& anchor);
  void layOutAnew();
  void place(std::vector<FlowLine> lines);
  void returnTo(const Anchor& anchor);
  [[nodiscard]] Anchor anchor() const;
  [[nodiscard]] int topOfHeading(int heading) const;
  void updateScrollBars();
  [[nodiscard]] std::optional<std::size_t> lineAt(QPoint place) const;
  [[nodiscard]] std::optional<ElementId> elementAt(QPoint place) const;
  void paintLight(QPainter& painter, std::size_t line, QPointF origin);
  void hover(const std::optional<ElementId>& element);
  /// Scrolls to the nearest equation of the selection if none is visible.
  void showSelected();

  Selection* m_selection;
  SetReportPtr m_report;
  DerivationLayout m_layout;  ///< of the lines
  std::optional<FontMeasure> m_measure;
  std::vector<FlowLine> m_lines;
  double m_width = 0;                   ///< of the widest, without margins
  std::vector<double> m_tops;           ///< by line, and one for the end
  std::vector<std::size_t> m_headings;  ///< blocks
  FlowPainter m_painter;
  double m_zoom = 1;
  CoalescedTask m_layOutTurn{this, [this] {
                               if (currentLayout() != m_layout) layOutAt(anchor());
                             }};
  bool m_hovers = false;  ///< the hovered element was hovered in this view
  int m_heading = -1;     ///< last emitted
};

}  // namespace geargraph
