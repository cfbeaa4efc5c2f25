#pragma once

#include <QWidget>

namespace geargraph {

/// The handle of an axis in the 3D view: a disc on the axis that is dragged, or moved by the arrow keys while
/// it has the focus. It works in pixels only.
class AxisHandle final : public QWidget {
  Q_OBJECT

 public:
  explicit AxisHandle(QWidget* view);

  /// Sets the name for the tooltip and screen readers: "axis c".
  void setName(const QString& name);
  void showAt(const QPointF& middle);
  [[nodiscard]] bool isDragged() const { return m_isDragged; }

 signals:
  void grabbed();
  /// `way`: the displacement of the pointer since the press, px; `isFree`: Alt is held.
  void pulled(const QPointF& way, bool isFree);
  void dropped();
  void putBack();
  /// An arrow key was pressed. `way`: the displacement, px.
  void nudged(const QPointF& way);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  QPointF m_from;
  bool m_isPressed = false;
  bool m_isDragged = false;
};

}  // namespace geargraph
