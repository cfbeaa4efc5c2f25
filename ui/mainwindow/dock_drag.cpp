#include "ui/mainwindow/dock_drag.h"

#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>

namespace geargraph::inline mainwindow {
namespace {

/// Keys of the drag itself, as Ctrl, with which the dock stays free. Esc is Qt's.
bool isOfDrag(int key) {
  return key == Qt::Key_Control || key == Qt::Key_Shift || key == Qt::Key_Alt || key == Qt::Key_Meta ||
         key == Qt::Key_Escape;
}

}  // namespace

DockDrag::DockDrag(QMainWindow* window) : QObject(window), m_window(window) {
  qApp->installEventFilter(this);
}

/// Null if no dock of the window is. A dock that floats is a window of its own.
QDockWidget* DockDrag::dragged() const {
  auto* dock = qobject_cast<QDockWidget*>(QWidget::mouseGrabber());
  for (const QObject* each = dock; each != nullptr; each = each->parent())
    if (each == m_window) return dock;
  return nullptr;
}

/// As if the button were released here.
void DockDrag::end() const {
  QDockWidget* dock = dragged();
  if (dock == nullptr) return;
  const QPointF at = QCursor::pos();
  QMouseEvent release(QEvent::MouseButtonRelease, dock->mapFromGlobal(at), at, Qt::LeftButton, Qt::NoButton,
                      Qt::NoModifier);
  QCoreApplication::sendEvent(dock, &release);
}

bool DockDrag::eventFilter(QObject* watched, QEvent* event) {
  const bool isEnd = event->type() == QEvent::Close || event->type() == QEvent::Hide;
  if (isEnd && watched == m_window) end();
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  const bool isDragged = isKey && qobject_cast<QDockWidget*>(QWidget::mouseGrabber()) != nullptr &&
                         QGuiApplication::mouseButtons().testFlag(Qt::LeftButton);
  if (!isDragged || isOfDrag(static_cast<QKeyEvent*>(event)->key()))
    return QObject::eventFilter(watched, event);
  event->accept();  // it is no shortcut either
  return true;
}

}  // namespace geargraph::inline mainwindow
