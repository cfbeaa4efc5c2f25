#pragma once

#include <atomic>
#include <stop_token>
#include <thread>
#include <utility>

namespace geargraph {

/// A thread whose stop can be requested and queried without waiting. The destructor requests it and waits
/// for the end.
class StoppableThread {
 public:
  /// Starts the thread with `run(quit)`, which must return soon after a stop of `quit` is requested.
  template <class Run>
  explicit StoppableThread(Run run)
      : m_thread([this, run = std::move(run)](const std::stop_token& quit) mutable {
          run(quit);
          m_hasStopped = true;
        }) {}

  /// Requests a stop; does not wait. Thread-safe.
  void requestStop() { m_thread.request_stop(); }
  /// Has `run` returned? Its captures may not be destroyed yet. Thread-safe.
  [[nodiscard]] bool hasStopped() const { return m_hasStopped; }

 private:
  std::atomic<bool> m_hasStopped = false;
  std::jthread m_thread;  ///< last: started after and joined before the other members
};

}  // namespace geargraph
