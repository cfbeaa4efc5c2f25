#include "ui/view3d/axis_handle.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <utility>

namespace geargraph {
namespace {

constexpr int kHandleSide = 30;
constexpr double kHandleRadius = 11;

}  // namespace

AxisHandle::AxisHandle(QWidget* view) : QWidget(view) {
  setObjectName(QStringLiteral("axisHandle"));
  setFixedSize(kHandleSide, kHandleSide);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::SizeAllCursor);
  hide();
}

void AxisHandle::setName(const QString& name) {
  setAccessibleName(tr("Handle of %1").arg(name));
  setToolTip(
      tr("Drag to move %1, or use the arrow keys (with Shift: finer). Alt places freely, Esc puts back")
          .arg(name));
}

void AxisHandle::showAt(const QPointF& middle) {
  move((middle - QPointF(kHandleSide, kHandleSide) / 2).toPoint());
  if (isHidden()) show();
}

void AxisHandle::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF middle(kHandleSide / 2.0, kHandleSide / 2.0);
  const QColor accent = palette().color(QPalette::Highlight);
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(middle, kHandleRadius + 3, kHandleRadius + 3);
  }
  painter.setPen(QPen(accent, 2));
  painter.setBrush(m_isDragged ? accent : palette().color(QPalette::Base));
  painter.drawEllipse(middle, kHandleRadius, kHandleRadius);
  const QColor ink = m_isDragged ? palette().color(QPalette::HighlightedText) : accent;
  painter.setPen(QPen(ink, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  for (int quarter = 0; quarter < 4; ++quarter) {  // four arrows
    QPainterPath arrow(QPointF(0, 0));
    arrow.lineTo(0, -7);
    arrow.moveTo(-2.5, -4.5);
    arrow.lineTo(0, -7);
    arrow.lineTo(2.5, -4.5);
    painter.save();
    painter.translate(middle);
    painter.rotate(90 * quarter);
    painter.drawPath(arrow);
    painter.restore();
  }
}

void AxisHandle::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  m_isPressed = true;
  m_from = event->globalPosition();
  setFocus(Qt::MouseFocusReason);
}

void AxisHandle::mouseMoveEvent(QMouseEvent* event) {
  if (!m_isPressed) return;
  const QPointF way = event->globalPosition() - m_from;
  if (!m_isDragged) {
    if (way.manhattanLength() < QApplication::startDragDistance() / 2.0) return;
    m_isDragged = true;
    update();
    emit grabbed();
  }
  emit pulled(way, event->modifiers().testFlag(Qt::AltModifier));
}

void AxisHandle::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  m_isPressed = false;
  update();
  if (std::exchange(m_isDragged, false)) emit dropped();
}

void AxisHandle::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 1 : 10;
  switch (event->key()) {
    case Qt::Key_Left:
      return emit nudged({-step, 0});
    case Qt::Key_Right:
      return emit nudged({step, 0});
    case Qt::Key_Up:
      return emit nudged({0, -step});
    case Qt::Key_Down:
      return emit nudged({0, step});
    case Qt::Key_Escape:
      m_isPressed = false;
      update();
      if (std::exchange(m_isDragged, false)) return emit putBack();
      return parentWidget()->setFocus();
    default:
      QWidget::keyPressEvent(event);
  }
}

void AxisHandle::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void AxisHandle::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace geargraph

#include "moc_axis_handle.cpp"
