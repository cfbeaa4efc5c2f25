#include "ui/mainwindow/screen_fit.h"

#include <QApplication>
#include <QEvent>
#include <QPointer>
#include <QScreen>
#include <QWidget>

namespace geargraph {
namespace {

constexpr QMargins kUsualFrame(0, 32, 0, 0);  ///< while the window manager has not told the frame yet

bool isOrdinary(const QWidget& window) {
  const bool isKind = window.windowType() == Qt::Window || window.windowType() == Qt::Dialog;
  const Qt::WindowStates filling = Qt::WindowMaximized | Qt::WindowFullScreen | Qt::WindowMinimized;
  return window.isWindow() && isKind && (window.windowState() & filling) == Qt::WindowNoState;
}

QRect roomFor(const QWidget& window) {
  const QRect inner = window.geometry();
  const QRect outer = window.frameGeometry();
  const QMargins frame = inner == outer
                             ? kUsualFrame
                             : QMargins(inner.left() - outer.left(), inner.top() - outer.top(),
                                        outer.right() - inner.right(), outer.bottom() - inner.bottom());
  return window.screen()->availableGeometry().marginsRemoved(frame);
}

void fit(QWidget& window) {
  if (!window.isVisible() || !isOrdinary(window)) return;
  const QRect room = roomFor(window);
  const QSize least = window.minimumSize();
  // A minimum of its own goes before that of the layout.
  if (least.width() > room.width() || least.height() > room.height())
    window.setMinimumSize(least.boundedTo(room.size()));
  const QRect fitted = fittedInto(room, window.geometry());
  if (fitted != window.geometry()) window.setGeometry(fitted);
}

}  // namespace

QRect fittedInto(const QRect& room, const QRect& wanted) {
  QRect fitted(wanted.topLeft(), wanted.size().boundedTo(room.size()));
  fitted.moveLeft(qBound(room.left(), fitted.left(), room.right() - fitted.width() + 1));
  fitted.moveTop(qBound(room.top(), fitted.top(), room.bottom() - fitted.height() + 1));
  return fitted;
}

ScreenFit::ScreenFit(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool ScreenFit::eventFilter(QObject* watched, QEvent* event) {
  const bool isShown = event->type() == QEvent::Show;
  if ((!isShown && event->type() != QEvent::Resize) || !watched->isWidgetType())
    return QObject::eventFilter(watched, event);
  auto* window = static_cast<QWidget*>(watched);
  if (!isOrdinary(*window)) return QObject::eventFilter(watched, event);
  // A larger size is the user's own, over several screens, unless the contents have forced it.
  const QSize room = roomFor(*window).size();
  const bool isForced = window->minimumWidth() > room.width() || window->minimumHeight() > room.height();
  // Afterwards: windows lay out their docks when they are shown first.
  if (isShown || isForced)
    QMetaObject::invokeMethod(
        window, [window] { fit(*window); }, Qt::QueuedConnection);
  return QObject::eventFilter(watched, event);
}

}  // namespace geargraph

#include "moc_screen_fit.cpp"
