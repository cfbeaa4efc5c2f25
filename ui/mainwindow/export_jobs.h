#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <deque>
#include <functional>
#include <stop_token>
#include <string>
#include <thread>

#include "ui/service/background_work.h"

namespace geargraph {

class NoticeBar;

/// Writes a file whole. Returns why it could not be written, as a sentence; empty if it was.
[[nodiscard]] QString writingError(const QString& path, const std::string& bytes);

/// Makes files that take long on a background thread, one after the other. A notice shows the progress of one
/// with several pictures, and can stop it; another tells what was written, and opens it or its folder.
class ExportJobs : public QObject, public BackgroundWork {
  Q_OBJECT

 public:
  /// Called on the job's thread.
  using Progress = std::function<void(int done, int all)>;
  struct Job {
    QString path;
    bool isLong = false;  ///< worth a notice
    /// Returns the error as a sentence; empty on success. Runs on another thread.
    std::function<QString(const Progress& progress, const std::stop_token& stop)> run;
    bool isInPercent = false;  ///< progress counts percent, not pictures
    /// What a user should know about the file, sentences; called when it is written. May be empty.
    std::function<QStringList()> notes = {};
  };

  explicit ExportJobs(NoticeBar* notices, QObject* parent = nullptr);
  ~ExportJobs() override;

  void add(Job job);
  void stop();  ///< stops the current job
  [[nodiscard]] bool isBusy() const { return m_isBusy; }
  /// Withdraws the notice of what was written last.
  void forgetWritten();
  void requestStop() override;
  [[nodiscard]] bool hasStopped() const override { return !m_isBusy; }

 signals:
  void finished(const QString& path);
  void failed(const QString& why);
  /// What a user should know about a file that was written.
  void told(const QString& notes);

 private:
  void startNext();
  void onDone(const Job& job, const QString& why, bool stopped);
  void tellWritten(const QString& path, const QStringList& notes);
  void open(const QString& path);

  NoticeBar* m_notices;
  std::deque<Job> m_waiting;
  bool m_isBusy = false;
  std::jthread m_thread;  ///< last: it ends before the members it uses are destroyed
};

}  // namespace geargraph
