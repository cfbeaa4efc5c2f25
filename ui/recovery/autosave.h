#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>

#include "core/foundations/base/stoppable_thread.h"
#include "core/mechanism/model/mechanism.h"
#include "ui/document/document.h"
#include "ui/recovery/side_file.h"
#include "ui/service/background_work.h"

class QTimer;

namespace geargraph {

/// Keeps the unsaved changes of a document in a side file, never in the document's own file: kDelay after an
/// edit the newest state is passed to a background thread, which writes it atomically. The side file is
/// removed as soon as nothing is unsaved. A crash therefore loses at most the edits of the last kDelay and of
/// the duration of one write.
class Autosave : public QObject, public BackgroundWork {
  Q_OBJECT

 public:
  static constexpr int kDelay = 1000;  ///< ms

  /// @param folder for documents that have no file, or whose folder is not writable
  Autosave(Document* document, QString folder, QObject* parent = nullptr);
  /// Completes a pending write. The side file of a document with unsaved changes stays.
  ~Autosave() override;

  /// Sets the title of the document in the side file.
  void setTitle(const QString& title) { m_title = title; }
  /// Continues with a side file that was left behind, whose document has been restored as unsaved changes.
  void adopt(std::unique_ptr<SideFile> side, const SideNote& note);
  /// Requests the end of the thread, which first completes pending writes. Does not wait.
  void requestStop() override;
  [[nodiscard]] bool hasStopped() const override { return m_thread.hasStopped(); }
  /// Discards the unsaved changes: removes the side file.
  void discard();
  /// Has the newest state been written, or is there nothing unsaved?
  [[nodiscard]] bool isUpToDate() const { return m_written == m_wanted; }
  /// The path of the current side file; empty before its first write.
  [[nodiscard]] const QString& sidePath() const { return m_sidePath; }

 signals:
  /// Writing failed. Emitted once until it succeeds again.
  void failed(const QString& why);
  void upToDate();

 private:
  /// Where the side file of a document belongs. The file is locked, which waits for the disk, by the thread
  /// that writes it first.
  struct Place {
    QString filePath;                ///< of the document
    std::unique_ptr<SideFile> side;  ///< null before the first write; not for the GUI thread
  };
  struct Job {
    std::shared_ptr<Place> place;
    MechanismPtr mechanism;  ///< null: remove the side file
    SideNote note;
    quint64 number = 0;
  };

  void onChanged();
  void save();
  void removeSideFile();
  void enqueue(Job job);
  void run(const std::stop_token& quit);
  [[nodiscard]] QString write(const Job& job) const;
  void finished(const Job& job, const QString& path, const QString& error);
  [[nodiscard]] int edits() const;

  Document* m_document;
  const QString m_folder;
  QString m_title;
  QTimer* m_timer;
  std::shared_ptr<Place> m_place;  ///< null while nothing is unsaved
  QString m_sidePath;
  int m_editsBefore = 0;  ///< of an adopted side file
  quint64 m_wanted = 0;
  quint64 m_written = 0;
  bool m_failing = false;
  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::deque<Job> m_jobs;    ///< guarded by m_mutex
  StoppableThread m_thread;  ///< last: started after the members it uses
};

}  // namespace geargraph
