#include "ui/service/turns.h"

#include <QCoreApplication>
#include <utility>

namespace geargraph::inline ui_service {

Turns& Turns::instance() {
  static QPointer<Turns> turns;
  if (turns == nullptr) turns = new Turns(QCoreApplication::instance());
  return *turns;
}

Turns::Turns(QObject* application) : QObject(application) {
  m_turn.setInterval(0);
  connect(&m_turn, &QTimer::timeout, this, &Turns::runNext);
}

void Turns::later(QObject* context, std::function<void()> piece) {
  m_waiting.push_back({context, std::move(piece)});
  if (!m_turn.isActive()) m_turn.start();
}

void Turns::runNext() {
  while (!m_waiting.empty()) {
    const Waiting next = std::move(m_waiting.front());
    m_waiting.pop_front();
    if (next.context == nullptr) continue;
    next.piece();
    break;
  }
  if (m_waiting.empty()) m_turn.stop();
}

}  // namespace geargraph::inline ui_service
