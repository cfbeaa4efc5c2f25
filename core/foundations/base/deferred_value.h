#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <utility>

namespace geargraph {

/// A value that is computed once, on first use, and then shared by all threads. Thread-safe.
///
/// The first request computes the value; concurrent ones wait for it, or for their own stop. A computation
/// that is cancelled leaves nothing behind: one of the waiting requests, else the next one, starts again.
template <class Value>
class DeferredValue {
 public:
  /// The result is discarded if a stop was requested meanwhile.
  using Make = std::function<Value(const std::stop_token& stop)>;

  explicit DeferredValue(Make make) : m_make(std::move(make)) {}

  /// Null if `stop` was requested before there was a value; never without a stop.
  [[nodiscard]] std::shared_ptr<const Value> get(const std::stop_token& stop = {}) const {
    std::unique_lock lock(m_mutex);
    while (true) {
      m_changed.wait(lock, stop, [this] { return m_value || !m_isMaking; });
      if (m_value) return m_value;
      if (stop.stop_requested()) return nullptr;
      m_isMaking = true;
      lock.unlock();
      std::shared_ptr<const Value> made = attempt(stop);
      lock.lock();
      m_isMaking = false;
      if (made) {
        m_value = std::move(made);
        m_make = nullptr;  // with what it holds
      }
      m_changed.notify_all();
    }
  }

 private:
  /// Null if cancelled.
  std::shared_ptr<const Value> attempt(const std::stop_token& stop) const {
    auto made = std::make_shared<const Value>(m_make(stop));
    return stop.stop_requested() ? nullptr : made;
  }

  mutable std::mutex m_mutex;
  mutable std::condition_variable_any m_changed;
  mutable Make m_make;                           ///< used by the one thread that computes; then empty
  mutable std::shared_ptr<const Value> m_value;  ///< guarded by m_mutex
  mutable bool m_isMaking = false;               ///< guarded by m_mutex
};

}  // namespace geargraph
