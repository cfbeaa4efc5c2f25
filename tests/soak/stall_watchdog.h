#pragma once

#include <sys/types.h>

#include <QObject>
#include <QString>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tests/soak/stack_sampler.h"

namespace geargraph::test {

/// For how long the thread that it lives on does not come back to its event loop. A thread posts an event
/// every few ms and measures how long it takes until the event is delivered. Other programs that load the
/// machine change neither time of a stall that counts, `cpu` and `waiting`:
///
///     wall = cpu + waiting + (ready to run, and other threads had the processors)
///
/// Of `waiting`, what the threads that it may wait for were themselves kept from the processors by other
/// programs is taken off.
class StallWatchdog : public QObject {
  Q_OBJECT

 public:
  struct Stall {
    double cpu = 0;                 ///< ms of the thread's CPU clock
    double waiting = 0;             ///< ms that it slept: for a lock, another thread, a file
    double wall = 0;                ///< ms
    std::vector<std::string> path;  ///< what it was at, StackSampler::commonPath(); empty for short ones

    [[nodiscard]] double length() const { return cpu + waiting; }
  };

  enum class Stacks { none, sampled };

  /// `activity` is what is going on to begin with. Stalls have a `path` only where stacks are sampled: see
  /// StackSampler for what that may cost.
  explicit StallWatchdog(const QString& activity = {}, Stacks stacks = Stacks::none,
                         QObject* parent = nullptr);
  ~StallWatchdog() override;

  /// What is going on from now on: stalls are kept by it.
  void setActivity(const QString& activity);
  /// Another name for what is going on now: it has turned out to be something else.
  void renameActivity(const QString& activity);
  [[nodiscard]] QString activity() const;

  /// Once, on a thread of its own, when an event has not been delivered for so long: `then(activity)`. Before
  /// the event loop runs.
  void onHang(std::chrono::milliseconds after, std::function<void(const QString& activity)> then);

  /// The longest stall of each activity, by length().
  [[nodiscard]] std::map<QString, Stall> longestByActivity() const;
  /// The longest of all.
  [[nodiscard]] double longest() const;
  void reset();
  /// longestByActivity() of the time since the last call, which is forgotten.
  [[nodiscard]] std::map<QString, Stall> take();

 protected:
  bool event(QEvent* event) override;

 private:
  /// Readings of clocks, in ms.
  struct Clocks {
    double cpu = 0;   ///< of the watched thread
    double kept = 0;  ///< that it was ready to run and did not
    double wall = 0;
    double program = 0;  ///< CPU time of all threads
  };
  using KeptByThread = std::map<pid_t, double>;

  [[nodiscard]] Clocks now() const;
  [[nodiscard]] KeptByThread keptOfOthers() const;
  [[nodiscard]] double excusedSince(const Clocks& clocks) const;
  void watch(const std::stop_token& quit);

  std::optional<StackSampler> m_sampler;
  pid_t m_thread = 0;
  clockid_t m_cpuClock{};
  mutable std::mutex m_mutex;
  std::condition_variable_any m_wake;
  bool m_isPosted = false;  ///< an event is on its way; guarded, as all below
  Clocks m_posted;          ///< when it was posted
  KeptByThread m_others;    ///< when the event was late; empty before
  QString m_activity;
  QString m_postedActivity;  ///< that went on when the event was posted
  std::map<QString, Stall> m_longest;
  std::chrono::milliseconds m_hang{};
  std::function<void(const QString&)> m_onHang;  ///< empty: not asked for, or told already
  std::jthread m_watcher;                        ///< last: it starts when all else is there
};

}  // namespace geargraph::test
