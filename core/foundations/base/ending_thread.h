#pragma once

#include <atomic>
#include <stop_token>
#include <thread>
#include <utility>

namespace geargraph::inline base {

/// A thread that can be told to end long before somebody has to wait for it, and asked whether it has.
/// The destructor tells it to end, too, and waits.
class EndingThread {
 public:
  /// `run(quit)`: returns soon once `quit` is requested.
  template <class Run>
  explicit EndingThread(Run run)
      : m_thread([this, run = std::move(run)](const std::stop_token& quit) mutable {
          run(quit);
          m_hasEnded = true;
        }) {}

  /// Does not wait.
  void tellToEnd() { m_thread.request_stop(); }
  /// Is there nothing left to wait for? What `run` captured may still be going.
  [[nodiscard]] bool hasEnded() const { return m_hasEnded; }

 private:
  std::atomic<bool> m_hasEnded = false;
  std::jthread m_thread;  ///< last: it starts when all else is there, and is waited for first
};

}  // namespace geargraph::inline base
