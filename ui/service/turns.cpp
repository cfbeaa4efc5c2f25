#include "ui/service/turns.h"

#include <QCoreApplication>
#include <QEvent>
#include <utility>

namespace geargraph {
namespace {

QEvent::Type turnType() {
  static const auto type = static_cast<QEvent::Type>(QEvent::registerEventType());
  return type;
}

}  // namespace

GuiTaskQueue& GuiTaskQueue::instance() {
  static QPointer<GuiTaskQueue> turns;
  if (turns == nullptr) turns = new GuiTaskQueue(QCoreApplication::instance());
  return *turns;
}

GuiTaskQueue::GuiTaskQueue(QObject* application) : QObject(application) {
  m_turn.setInterval(0);
  m_turn.setSingleShot(true);
  // The loop may run timers twice before it delivers what has been posted; an event of low priority comes
  // after all of that.
  connect(&m_turn, &QTimer::timeout, this,
          [this] { QCoreApplication::postEvent(this, new QEvent(turnType()), Qt::LowEventPriority); });
}

void GuiTaskQueue::later(QObject* context, std::function<void()> piece) {
  m_waiting.push_back({context, std::move(piece)});
  begin();
}

void CoalescedTask::request() {
  if (std::exchange(m_isDue, true)) return;
  GuiTaskQueue::instance().later(m_context, [this] {
    m_isDue = false;
    m_piece();
  });
}

void GuiTaskQueue::begin() {
  if (!std::exchange(m_isUnderWay, true)) m_turn.start();
}

bool GuiTaskQueue::event(QEvent* event) {
  if (event->type() != turnType()) return QObject::event(event);
  m_isUnderWay = false;
  runNext();
  return true;
}

void GuiTaskQueue::runNext() {
  while (!m_waiting.empty()) {
    const Waiting next = std::move(m_waiting.front());
    m_waiting.pop_front();
    if (next.context == nullptr) continue;
    if (!m_waiting.empty()) begin();  // before the piece, which may run an event loop of its own
    return next.piece();
  }
}

}  // namespace geargraph

#include "moc_turns.cpp"
