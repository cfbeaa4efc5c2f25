#include "tests/soak/stall_watchdog.h"

#include <pthread.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QEvent>
#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <utility>

namespace geargraph::test {
namespace {

constexpr std::chrono::milliseconds kPause{2};  // between two events
constexpr double kLate = 15;                    // ms, from which on a stall is looked into
constexpr double kWorthAPath = 30;              // ms

std::atomic<pid_t> watcher{0};  // nothing waits for it, so that what it is kept from excuses nothing

QEvent::Type pingType() {
  static const auto type = static_cast<QEvent::Type>(QEvent::registerEventType());
  return type;
}

double milliseconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

/// How long a thread of this program was ready to run and did not, in ms; 0 where the system does not count
/// it.
double keptOf(pid_t thread) {
  std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/schedstat");
  double ran = 0;
  double kept = 0;  // ns
  file >> ran >> kept;
  return kept / 1e6;
}

}  // namespace

StallWatchdog::StallWatchdog(const QString& activity, Stacks stacks, QObject* parent)
    : QObject(parent), m_thread(gettid()), m_activity(activity), m_postedActivity(activity) {
  if (stacks == Stacks::sampled) m_sampler.emplace();
  pthread_getcpuclockid(pthread_self(), &m_cpuClock);
  pingType();
  m_watcher = std::jthread([this](const std::stop_token& quit) { watch(quit); });
}

StallWatchdog::~StallWatchdog() {
  m_watcher.request_stop();
  m_watcher.join();
}

StallWatchdog::Clocks StallWatchdog::now() const {
  return {milliseconds(m_cpuClock), keptOf(m_thread), milliseconds(CLOCK_MONOTONIC),
          milliseconds(CLOCK_PROCESS_CPUTIME_ID)};
}

StallWatchdog::KeptByThread StallWatchdog::keptOfOthers() const {
  KeptByThread kept;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
    const std::string name = entry.path().filename();
    pid_t thread = 0;
    std::from_chars(name.data(), name.data() + name.size(), thread);
    if (thread != m_thread && thread != watcher) kept[thread] = keptOf(thread);
  }
  return kept;
}

/// By how much other programs may have prolonged the wait for one of our threads: what it was kept from
/// running, but no more than the time of processors that we did not use ourselves.
double StallWatchdog::excusedSince(const Clocks& clocks) const {
  double most = 0;
  for (const auto& [thread, kept] : keptOfOthers()) {
    const auto before = m_others.find(thread);
    most = std::max(most, kept - (before == m_others.end() ? 0 : before->second));
  }
  const Clocks at = now();
  const double processors = std::max(1U, std::thread::hardware_concurrency());
  return std::min(most, processors * (at.wall - clocks.wall) - (at.program - clocks.program));
}

void StallWatchdog::watch(const std::stop_token& quit) {
  watcher = gettid();
  std::unique_lock lock(m_mutex);
  while (!quit.stop_requested()) {
    m_wake.wait_for(lock, quit, kPause, [] { return false; });
    if (quit.stop_requested()) continue;
    if (m_isPosted) {
      const double late = milliseconds(CLOCK_MONOTONIC) - m_posted.wall;
      const bool isLate = late > kLate;
      const bool isFirst = m_others.empty();
      std::function<void(const QString&)> told;
      if (late > static_cast<double>(m_hang.count())) told = std::exchange(m_onHang, {});
      const QString during = m_postedActivity;
      // The watched thread never waits while files are read here.
      lock.unlock();
      KeptByThread others;
      if (isLate && isFirst) others = keptOfOthers();
      if (isLate && m_sampler) m_sampler->sample();
      if (told) told(during);
      lock.lock();
      if (m_isPosted && isLate && isFirst) m_others = std::move(others);
      continue;
    }
    lock.unlock();
    const Clocks clocks = now();
    lock.lock();
    m_isPosted = true;
    m_others.clear();
    m_posted = clocks;
    m_postedActivity = m_activity;
    lock.unlock();
    QCoreApplication::postEvent(this, new QEvent(pingType()));
    lock.lock();
  }
}

bool StallWatchdog::event(QEvent* event) {
  if (event->type() != pingType()) return QObject::event(event);
  const Clocks clocks = now();
  const std::lock_guard lock(m_mutex);
  Stall stall;
  stall.cpu = clocks.cpu - m_posted.cpu;
  stall.wall = clocks.wall - m_posted.wall;
  stall.waiting = std::max(0.0, stall.wall - stall.cpu - (clocks.kept - m_posted.kept));
  if (stall.waiting > kLate) stall.waiting = std::max(0.0, stall.waiting - excusedSince(m_posted));
  Stall& longest = m_longest[m_postedActivity];
  if (stall.length() > longest.length()) {
    if (stall.length() > kWorthAPath && m_sampler && m_sampler->count() > 0)
      stall.path = m_sampler->commonPath();
    longest = std::move(stall);
  }
  if (m_sampler) m_sampler->clear();
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

void StallWatchdog::onHang(std::chrono::milliseconds after,
                           std::function<void(const QString& activity)> then) {
  const std::lock_guard lock(m_mutex);
  m_hang = after;
  m_onHang = std::move(then);
}

QString StallWatchdog::activity() const {
  const std::lock_guard lock(m_mutex);
  return m_activity;
}

std::map<QString, StallWatchdog::Stall> StallWatchdog::longestByActivity() const {
  const std::lock_guard lock(m_mutex);
  return m_longest;
}

double StallWatchdog::longest() const {
  double longest = 0;
  for (const auto& [activity, stall] : longestByActivity()) longest = std::max(longest, stall.length());
  return longest;
}

void StallWatchdog::reset() {
  const std::lock_guard lock(m_mutex);
  m_longest.clear();
}

std::map<QString, StallWatchdog::Stall> StallWatchdog::take() {
  const std::lock_guard lock(m_mutex);
  return std::exchange(m_longest, {});
}

}  // namespace geargraph::test
