#pragma once

#include <QHeaderView>

namespace geargraph::inline panels {

class MatrixView;

/// The labels above or beside a matrix; those beside it also draw its left bracket.
class MatrixHeader : public QHeaderView {
  Q_OBJECT

 public:
  MatrixHeader(Qt::Orientation orientation, MatrixView* view);

 signals:
  void sectionHovered(int section);  ///< -1: none any more

 protected:
  void paintEvent(QPaintEvent* event) override;
  void paintSection(QPainter* painter, const QRect& rect, int section) const override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  [[nodiscard]] QSize sizeHint() const override;

 private:
  MatrixView* m_view;
  int m_hovered = -1;
};

/// Half of a bracket around rows `top` to `bottom` at x, its hooks pointing by `hook` pixels.
void paintBracket(QPainter& painter, int x, int top, int bottom, int hook);

}  // namespace geargraph::inline panels
