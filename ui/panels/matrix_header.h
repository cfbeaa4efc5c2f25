#pragma once

#include <QHeaderView>
#include <functional>

namespace geargraph {

constexpr int kMatrixBracket = 12;  ///< pixels for a bracket beside the first and last column

/// The labels above or beside a matrix; those beside it also draw its left bracket.
class MatrixHeader : public QHeaderView {
  Q_OBJECT

 public:
  /// @param isHighlighted whether the row or column is highlighted
  MatrixHeader(Qt::Orientation orientation, std::function<bool(int section)> isHighlighted, QWidget* parent);

 signals:
  void sectionHovered(int section);  ///< -1: none any more

 protected:
  void paintEvent(QPaintEvent* event) override;
  void paintSection(QPainter* painter, const QRect& rect, int section) const override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  [[nodiscard]] QSize sizeHint() const override;

 private:
  std::function<bool(int)> m_isHighlighted;
  int m_hovered = -1;
};

/// Paints the left or right bracket around the rows from `top` to `bottom` at `x`; its ends extend by `hook`
/// pixels, to the left if negative.
void paintBracket(QPainter& painter, int x, int top, int bottom, int hook);

}  // namespace geargraph
