#pragma once

#include <QObject>
#include <QString>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace geargraph::test {

/// For how long the thread that it lives on does not come back to its event loop. A thread posts an event
/// every few ms and measures how long it takes until the event is delivered: in time of the watched thread's
/// own CPU clock, which other programs hardly change, and in time of the wall.
class StallWatchdog : public QObject {
  Q_OBJECT

 public:
  struct Stall {
    double cpu = 0;   ///< ms of the thread's CPU clock
    double wall = 0;  ///< ms
  };

  /// `activity` is what is going on to begin with.
  explicit StallWatchdog(const QString& activity = {}, QObject* parent = nullptr);
  ~StallWatchdog() override;

  /// What is going on from now on: stalls are kept by it.
  void setActivity(const QString& activity);
  /// Another name for what is going on now: it has turned out to be something else.
  void renameActivity(const QString& activity);
  [[nodiscard]] QString activity() const;

  /// The longest stall of each activity, by CPU time.
  [[nodiscard]] std::map<QString, Stall> longestByActivity() const;
  /// The longest of all, by CPU time.
  [[nodiscard]] double longestCpu() const;
  void reset();

 protected:
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] Stall now() const;
  void watch(const std::stop_token& quit);

  clockid_t m_cpuClock{};
  mutable std::mutex m_mutex;
  std::condition_variable_any m_wake;
  bool m_isPosted = false;  ///< an event is on its way; guarded, as all below
  Stall m_posted;           ///< the clocks when it was posted
  QString m_activity;
  QString m_postedActivity;  ///< that went on when the event was posted
  std::map<QString, Stall> m_longest;
  std::jthread m_thread;  ///< last: it starts when all else is there
};

}  // namespace geargraph::test
