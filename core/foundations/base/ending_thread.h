#pragma once

#include <atomic>
#include <stop_token>
#include <thread>
#include <utility>

namespace geargraph::inline base {

/// A thread whose end can be requested and queried without waiting. The destructor requests the end and waits
/// for it.
class EndingThread {
 public:
  /// Starts the thread with `run(quit)`, which must return soon after a stop of `quit` is requested.
  template <class Run>
  explicit EndingThread(Run run)
      : m_thread([this, run = std::move(run)](const std::stop_token& quit) mutable {
          run(quit);
          m_hasEnded = true;
        }) {}

  /// Requests the end; does not wait. Thread-safe.
  void tellToEnd() { m_thread.request_stop(); }
  /// Has `run` returned? Its captures may not be destroyed yet. Thread-safe.
  [[nodiscard]] bool hasEnded() const { return m_hasEnded; }

 private:
  std::atomic<bool> m_hasEnded = false;
  std::jthread m_thread;  ///< last: started after and joined before the other members
};

}  // namespace geargraph::inline base
