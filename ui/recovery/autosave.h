#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>

#include "core/foundations/base/ending_thread.h"
#include "core/mechanism/model/mechanism.h"
#include "ui/document/document.h"
#include "ui/recovery/side_file.h"
#include "ui/service/background_work.h"

class QTimer;

namespace geargraph::inline recovery {

/// Keeps the unsaved changes of a document in a side file, never in the document's own: kDelay after an edit
/// the newest state is handed to a thread, which writes it whole or not at all. The side file goes as soon as
/// there is nothing unsaved any more. So a program that is killed loses what was done in the last kDelay, and
/// the time that one writing takes.
class Autosave : public QObject, public BackgroundWork {
  Q_OBJECT

 public:
  static constexpr int kDelay = 1000;  ///< ms

  /// `folder`: for documents that have no file, or no folder that can be written to.
  Autosave(Document* document, QString folder, QObject* parent = nullptr);
  /// Ends what is being written. The side file of a document that still has unsaved changes stays.
  ~Autosave() override;

  /// What the side file calls the document.
  void setTitle(const QString& title) { m_title = title; }
  /// Goes on in a side file that was left behind, whose document has been restored as unsaved changes.
  void adopt(std::unique_ptr<SideFile> side, const SideNote& note);
  /// What is not written yet is written first.
  void tellToEnd() override;
  [[nodiscard]] bool hasEnded() const override { return m_thread.hasEnded(); }
  /// The unsaved changes have been given up.
  void discard();
  /// Has the newest state been written, or is there nothing unsaved?
  [[nodiscard]] bool isUpToDate() const { return m_written == m_wanted; }
  [[nodiscard]] QString sidePath() const { return m_side ? m_side->path() : QString(); }

 signals:
  /// Once, until it works again.
  void failed(const QString& why);
  void upToDate();

 private:
  struct Job {
    std::shared_ptr<SideFile> side;
    MechanismPtr mechanism;  ///< null: the side file goes
    SideNote note;
    quint64 number = 0;
  };

  void onChanged();
  void save();
  void drop();
  void enqueue(Job job);
  void run(const std::stop_token& quit);
  void finished(quint64 number, const QString& error);
  [[nodiscard]] int edits() const;

  Document* m_document;
  QString m_folder;
  QString m_title;
  QTimer* m_timer;
  std::shared_ptr<SideFile> m_side;  ///< null while nothing is unsaved
  int m_editsBefore = 0;             ///< of an adopted side file
  quint64 m_wanted = 0;
  quint64 m_written = 0;
  bool m_failing = false;
  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::deque<Job> m_jobs;  ///< guarded by m_mutex
  EndingThread m_thread;   ///< last: it starts when all else is there
};

}  // namespace geargraph::inline recovery
