#include "tests/support/stall_watchdog.h"

#include <pthread.h>

#include <QCoreApplication>
#include <QEvent>
#include <algorithm>
#include <chrono>

namespace geargraph::test {
namespace {

constexpr std::chrono::milliseconds kPause{2};  // between two events

QEvent::Type pingType() {
  static const auto type = static_cast<QEvent::Type>(QEvent::registerEventType());
  return type;
}

double milliseconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

}  // namespace

StallWatchdog::StallWatchdog(const QString& activity, QObject* parent)
    : QObject(parent), m_activity(activity), m_postedActivity(activity) {
  pthread_getcpuclockid(pthread_self(), &m_cpuClock);
  pingType();
  m_thread = std::jthread([this](const std::stop_token& quit) { watch(quit); });
}

StallWatchdog::~StallWatchdog() {
  m_thread.request_stop();
  m_thread.join();
}

StallWatchdog::Stall StallWatchdog::now() const {
  return {milliseconds(m_cpuClock), milliseconds(CLOCK_MONOTONIC)};
}

void StallWatchdog::watch(const std::stop_token& quit) {
  std::unique_lock lock(m_mutex);
  while (!quit.stop_requested()) {
    m_wake.wait_for(lock, quit, kPause, [] { return false; });
    if (m_isPosted || quit.stop_requested()) continue;
    m_isPosted = true;
    m_posted = now();
    m_postedActivity = m_activity;
    lock.unlock();
    QCoreApplication::postEvent(this, new QEvent(pingType()));
    lock.lock();
  }
}

bool StallWatchdog::event(QEvent* event) {
  if (event->type() != pingType()) return QObject::event(event);
  const std::lock_guard lock(m_mutex);
  const Stall clocks = now();
  const Stall stall{clocks.cpu - m_posted.cpu, clocks.wall - m_posted.wall};
  Stall& longest = m_longest[m_postedActivity];
  if (stall.cpu > longest.cpu) longest = stall;
  m_isPosted = false;
  return true;
}

void StallWatchdog::setActivity(const QString& activity) {
  const std::lock_guard lock(m_mutex);
  m_activity = activity;
}

void StallWatchdog::renameActivity(const QString& activity) {
  const std::lock_guard lock(m_mutex);
  m_activity = activity;
  m_postedActivity = activity;
}

QString StallWatchdog::activity() const {
  const std::lock_guard lock(m_mutex);
  return m_activity;
}

std::map<QString, StallWatchdog::Stall> StallWatchdog::longestByActivity() const {
  const std::lock_guard lock(m_mutex);
  return m_longest;
}

double StallWatchdog::longestCpu() const {
  double longest = 0;
  for (const auto& [activity, stall] : longestByActivity()) longest = std::max(longest, stall.cpu);
  return longest;
}

void StallWatchdog::reset() {
  const std::lock_guard lock(m_mutex);
  m_longest.clear();
}

}  // namespace geargraph::test
