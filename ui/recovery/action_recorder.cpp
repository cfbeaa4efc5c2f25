#include "ui/recovery/action_recorder.h"

#include <QAction>
#include <QActionEvent>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QKeySequence>
#include <QMouseEvent>

#include "ui/recovery/action_log.h"

namespace geargraph {
namespace {

void note(const QByteArray& name) {
  actionLog().note({name.constData(), static_cast<std::size_t>(name.size())});
}

/// "digraph", "QPushButton in noticeBar": names that the program gives, none of the user.
QByteArray nameOf(const QWidget* widget) {
  const QWidget* named = widget;
  while (named != nullptr && (named->objectName().isEmpty() || named->objectName().startsWith("qt_"))) {
    named = named->parentWidget();
  }
  if (named == widget && named != nullptr) return named->objectName().toUtf8();
  const QByteArray kind = widget->metaObject()->className();
  return named == nullptr ? kind : kind + " in " + named->objectName().toUtf8();
}

QByteArray buttonName(Qt::MouseButton button) {
  if (button == Qt::LeftButton) return "left";
  if (button == Qt::RightButton) return "right";
  return button == Qt::MiddleButton ? "middle" : "other";
}

/// Keys that write text are not told apart.
QByteArray keyName(const QKeyEvent& event) {
  const bool isCommand = event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
  const bool isText = !event.text().isEmpty() && event.text().at(0).isPrint();
  if (isText && !isCommand) return "key (text)";
  return "key " + QKeySequence(event.keyCombination()).toString(QKeySequence::PortableText).toUtf8();
}

}  // namespace

ActionRecorder::ActionRecorder(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool ActionRecorder::eventFilter(QObject* watched, QEvent* event) {
  if (!watched->isWidgetType()) return false;
  const auto* widget = static_cast<QWidget*>(watched);
  if (event->isInputEvent()) {
    const quint64 time = static_cast<QInputEvent*>(event)->timestamp();
    if (event->type() != QEvent::MouseMove && time != 0 && std::exchange(m_lastInput, time) == time)
      return false;
  }
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      note("press " + buttonName(static_cast<QMouseEvent*>(event)->button()) + " on " + nameOf(widget));
      break;
    case QEvent::MouseMove:
      if (static_cast<QMouseEvent*>(event)->buttons() != Qt::NoButton) note("drag on " + nameOf(widget));
      break;
    case QEvent::MouseButtonRelease:
      note("release on " + nameOf(widget));
      break;
    case QEvent::Wheel:
      note("wheel on " + nameOf(widget));
      break;
    case QEvent::KeyPress:
      note(keyName(*static_cast<QKeyEvent*>(event)));
      break;
    case QEvent::Show:
      if (widget->isWindow() && !widget->inherits("QTipLabel")) note("show " + nameOf(widget));
      break;
    case QEvent::Close:
      note("close " + nameOf(widget));
      break;
    case QEvent::ActionAdded:
      connect(static_cast<QActionEvent*>(event)->action(), &QAction::triggered, this,
              &ActionRecorder::onTriggered, Qt::UniqueConnection);
      break;
    default:
      break;
  }
  return false;
}

void ActionRecorder::onTriggered() {
  const QString name = sender()->objectName();
  note(name.isEmpty() ? QByteArray("menu item") : "command " + name.toUtf8());
}

}  // namespace geargraph

#include "moc_action_recorder.cpp"
