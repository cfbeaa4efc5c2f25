#include "app/python/bindings/interruptible.h"

#include <flint/flint.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "app/python/bindings/bindings.h"

namespace geargraph::python {
namespace {

constexpr auto kBetweenSignals = std::chrono::milliseconds(30);

/// One piece of work on its thread.
class Run {
 public:
  explicit Run(const std::function<void(const std::stop_token&)>& work)
      : m_thread([this, &work](const std::stop_token& stop) {
          try {
            work(stop);
          } catch (...) {
            m_failure = std::current_exception();
          }
          flint_cleanup();  // FLINT keeps memory by thread, and this one ends
          const std::lock_guard lock(m_mutex);
          m_isDone = true;
          m_done.notify_one();
        }) {}

  void requestStop() { m_thread.request_stop(); }
  /// Has it ended within the time? Called without the interpreter's lock.
  [[nodiscard]] bool waitShortly() {
    std::unique_lock lock(m_mutex);
    return m_done.wait_for(lock, kBetweenSignals, [this] { return m_isDone; });
  }
  void join() { m_thread.join(); }
  [[nodiscard]] const std::exception_ptr& failure() const { return m_failure; }

 private:
  std::mutex m_mutex;
  std::condition_variable m_done;
  bool m_isDone = false;
  std::exception_ptr m_failure;
  std::jthread m_thread;  ///< last: it uses the others
};

}  // namespace

void runInterruptible(const std::function<void(const std::stop_token&)>& work) {
  Run run(work);
  bool isInterrupted = false;
  for (bool isDone = false; !isDone && !isInterrupted;) {
    {
      const py::gil_scoped_release unlocked;
      isDone = run.waitShortly();
    }
    if (!isDone) isInterrupted = PyErr_CheckSignals() != 0;
  }
  if (isInterrupted) run.requestStop();
  {
    const py::gil_scoped_release unlocked;
    run.join();
  }
  if (isInterrupted) throw py::error_already_set();
  if (run.failure()) std::rethrow_exception(run.failure());
}

}  // namespace geargraph::python
