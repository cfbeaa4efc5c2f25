#include "ui/mainwindow/dock_drag.h"

#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLayout>
#include <algorithm>
#include <utility>

namespace geargraph {
namespace {

/// Keys of the drag itself, as Ctrl, with which the dock stays free. Esc is Qt's.
bool isOfDrag(int key) {
  return key == Qt::Key_Control || key == Qt::Key_Shift || key == Qt::Key_Alt || key == Qt::Key_Meta ||
         key == Qt::Key_Escape;
}

bool isWithin(const QMainWindow& window, const QObject* part) {
  while (part != nullptr && part != &window) part = part->parent();
  return part != nullptr;
}

/// Can docks be dragged by it? By their titles and by their tabs.
bool isHandle(const QObject* part) {
  return qobject_cast<const QDockWidget*>(part) != nullptr || part->inherits("QMainWindowTabBar");
}

bool isInLayout(const QMainWindow& window, const QWidget& part) {
  const QLayout& layout = *window.layout();
  for (int i = 0; i < layout.count(); ++i) {
    if (layout.itemAt(i)->widget() == &part) return true;
  }
  return false;
}

/// A group that has lost its docks hides itself and leaves the layout; one that is still seen is held by
/// another one's layout, and one that stays in the window's cannot be saved.
bool isLost(const QMainWindow& window, const QWidget& group) {
  const auto docks = group.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly);
  return (group.isVisible() || isInLayout(window, group)) &&
         std::all_of(docks.begin(), docks.end(), [](const QDockWidget* dock) { return dock->isWindow(); });
}

}  // namespace

DockDrag::DockDrag(QMainWindow* window) : QObject(window), m_window(window) {
  qApp->installEventFilter(this);
}

// A dock that floats is a window of its own.
QDockWidget* DockDrag::draggedOf(const QMainWindow& window) {
  auto* dock = qobject_cast<QDockWidget*>(QWidget::mouseGrabber());
  return isWithin(window, dock) ? dock : nullptr;
}

/// As if the button were released here.
void DockDrag::end() const {
  QDockWidget* dock = draggedOf(*m_window);
  if (dock == nullptr) return;
  const QPointF at = QCursor::pos();
  QMouseEvent release(QEvent::MouseButtonRelease, dock->mapFromGlobal(at), at, Qt::LeftButton, Qt::NoButton,
                      Qt::NoModifier);
  QCoreApplication::sendEvent(dock, &release);
}

void DockDrag::takeBackIfLost() {
  const QByteArray before = std::exchange(m_before, {});
  if (before.isEmpty()) return;
  const auto children = m_window->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
  const bool anyLost = std::any_of(children.begin(), children.end(), [this](const QWidget* child) {
    return child->inherits("QDockWidgetGroupWindow") && isLost(*m_window, *child);
  });
  if (anyLost) m_window->restoreState(before);
}

bool DockDrag::eventFilter(QObject* watched, QEvent* event) {
  const bool isEnd = event->type() == QEvent::Close || event->type() == QEvent::Hide;
  if (isEnd && watched == m_window) end();
  if (event->type() == QEvent::MouseButtonPress && isHandle(watched) && isWithin(*m_window, watched))
    m_before = m_window->saveState();
  if (event->type() == QEvent::MouseButtonRelease && !m_before.isEmpty())
    QMetaObject::invokeMethod(this, &DockDrag::takeBackIfLost, Qt::QueuedConnection);
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  const bool isDragged = isKey && qobject_cast<QDockWidget*>(QWidget::mouseGrabber()) != nullptr &&
                         QGuiApplication::mouseButtons().testFlag(Qt::LeftButton);
  if (!isDragged || isOfDrag(static_cast<QKeyEvent*>(event)->key()))
    return QObject::eventFilter(watched, event);
  event->accept();  // it is no shortcut either
  return true;
}

}  // namespace geargraph

#include "moc_dock_drag.cpp"
