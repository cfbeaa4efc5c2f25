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

DockDrag::DockDrag(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool DockDrag::eventFilter(QObject* watched, QEvent* event) {
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  const bool isDragged = isKey && qobject_cast<QDockWidget*>(QWidget::mouseGrabber()) != nullptr &&
                         QGuiApplication::mouseButtons().testFlag(Qt::LeftButton);
  if (!isDragged || isOfDrag(static_cast<QKeyEvent*>(event)->key()))
    return QObject::eventFilter(watched, event);
  event->accept();  // it is no shortcut either
  return true;
}

}  // namespace geargraph::inline mainwindow
