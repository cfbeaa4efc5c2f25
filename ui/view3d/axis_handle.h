#pragma once

#include <QWidget>

namespace geargraph::inline view3d {

/// What an axis is taken by in the 3D view: a disc on it, to be dragged, or moved by the arrow keys while it
/// has the focus. It knows pixels only.
class AxisHandle final : public QWidget {
  Q_OBJECT

 public:
  explicit AxisHandle(QWidget* view);

  /// "axis c", for tip and screen readers.
  void setName(const QString& name);
  void showAt(const QPointF& middle);
  [[nodiscard]] bool isDragged() const { return m_isDragged; }

 signals:
  void grabbed();
  /// The way of the pointer since it was pressed, px; `isFree`: Alt is held.
  void pulled(const QPointF& way, bool isFree);
  void dropped();
  void putBack();
  /// A key: by this many px.
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

}  // namespace geargraph::inline view3d
