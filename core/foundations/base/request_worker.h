#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

#include "core/foundations/base/stoppable_thread.h"
#include "core/foundations/platform/system.h"

namespace geargraph {

/// The urgency of work: immediately, or in the background, when requests have paused for kRest.
enum class Urgency { prompt, background };

/// The pause in requests before background work begins: more than a frame, so that during a drag the
/// processors are free for what is displayed.
constexpr std::chrono::milliseconds kRest{30};

/// Processes requests on a background thread; the newest wins. A waiting request is replaced by a newer one,
/// the current one is asked to stop through its token.
///
/// The destructor asks the current work to stop and waits for it; no work begins afterwards. Free of Qt on
/// purpose: the distribution's Qt is not built with the thread sanitizer, this is.
template <class Request>
class RequestWorker {
 public:
  /// Called on the worker's thread, for one request at a time. The token is signalled by a newer request,
  /// cancel() or the destructor only, also after the call has returned, so that it can be used for work on
  /// other threads.
  using Work = std::function<void(Request request, const std::stop_token& stop)>;

  explicit RequestWorker(Work work, Urgency urgency = Urgency::prompt)
      : m_work(std::move(work)),
        m_rest(urgency == Urgency::background ? kRest : std::chrono::milliseconds(0)),
        m_thread([this, urgency](const std::stop_token& quit) {
          if (urgency == Urgency::background) lowerThreadPriority();
          run(quit);
        }) {}
  ~RequestWorker() { requestStop(); }
  RequestWorker(const RequestWorker&) = delete;
  RequestWorker& operator=(const RequestWorker&) = delete;

  void request(Request request) {
    {
      const std::lock_guard lock(m_mutex);
      m_underWay.request_stop();
      m_next = std::move(request);
      m_asked = Clock::now();
    }
    m_wake.notify_one();
  }

  /// Requests the end like the destructor, but does not wait for it, so that many workers can end at the same
  /// time.
  void requestStop() {
    m_thread.requestStop();
    const std::lock_guard lock(m_mutex);
    m_underWay.request_stop();
  }
  /// Was the end requested, and is no work in progress?
  [[nodiscard]] bool hasStopped() const { return m_thread.hasStopped(); }

  /// Drops the waiting request and asks the current work to stop.
  void cancel() {
    const std::lock_guard lock(m_mutex);
    m_underWay.request_stop();
    m_next.reset();
  }

 private:
  using Clock = std::chrono::steady_clock;

  void run(const std::stop_token& quit) {
    while (true) {
      std::unique_lock lock(m_mutex);
      m_wake.wait(lock, quit, [this] { return m_next.has_value(); });
      while (!quit.stop_requested() && Clock::now() < m_asked + m_rest)
        m_wake.wait_until(lock, quit, m_asked + m_rest, [] { return false; });
      if (quit.stop_requested()) return;
      if (!m_next) continue;  // cancelled during the rest
      Request request = *std::exchange(m_next, std::nullopt);
      m_underWay = std::stop_source();
      const std::stop_token stop = m_underWay.get_token();
      lock.unlock();
      m_work(std::move(request), stop);
    }
  }

  Work m_work;
  std::chrono::milliseconds m_rest;
  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::optional<Request> m_next;                  ///< guarded by m_mutex
  Clock::time_point m_asked;                      ///< guarded by m_mutex
  std::stop_source m_underWay{std::nostopstate};  ///< guarded by m_mutex
  StoppableThread m_thread;                       ///< last member: it starts when the others are initialised
};

}  // namespace geargraph
