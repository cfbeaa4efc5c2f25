#pragma once

#include <QHeaderView>
#include <functional>

namespace geargraph::inline panels {

constexpr int kMatrixBracket = 12;  ///< room for a bracket, beside the first and the last column

/// The labels above or beside a matrix; those beside it also draw its left bracket.
class MatrixHeader : public QHeaderView {
  Q_OBJECT

 public:
  /// `isLit`: is this row or column emphasised?
  MatrixHeader(Qt::Orientation orientation, std::function<bool(int section)> isLit, QWidget* parent);

 signals:
  void sectionHovered(int section);  ///< -1: none any more

 protected:
  void paintEvent(QPaintEvent* event) override;
  void paintSection(QPainter* painter, const QRect& rect, int section) const override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  [[nodiscard]] QSize sizeHint() const override;

 private:
  std::function<bool(int)> m_isLit;
  int m_hovered = -1;
};

/// Half of a bracket around rows `top` to `bottom` at x, its hooks pointing by `hook` pixels.
void paintBracket(QPainter& painter, int x, int top, int bottom, int hook);

}  // namespace geargraph::inline panels
