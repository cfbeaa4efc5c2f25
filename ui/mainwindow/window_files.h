#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "core/mechanism/model/mechanism.h"
#include "ui/mainwindow/file_watch.h"
#include "ui/recovery/autosave.h"
#include "ui/recovery/side_file.h"

class QMimeData;

namespace geargraph::inline mainwindow {

struct WindowActions;
class MainWindow;
class NoticeBar;
class RecentFiles;
class WindowSet;

/// What a window does with files: opens, saves and reverts its document, minds other programs that write the
/// same file, keeps unsaved changes in a side file, and offers those that an earlier run left behind.
class WindowFiles : public QObject {
  Q_OBJECT

 public:
  WindowFiles(MainWindow* window, NoticeBar* notices, RecentFiles* recent);

  /// Opens a file or an example in this window. A broken one is listed in the problems with its places, and
  /// the document that was open stays.
  bool open(const QString& path);
  /// Takes a document that was read from there.
  void show(Mechanism mechanism, const QString& path);
  /// Says why a file was not opened.
  void sayBroken(const QString& path, const Diagnostics& why);
  /// False if it was not written; a notice says why before all others, and the document stays modified. A
  /// file that another program has changed meanwhile is not overwritten: the notice asks.
  bool save(const QString& path);
  void startAnew();
  /// Back to what is in the file, as an edit that can be undone.
  void revert();

  /// The files that somebody drags over the window.
  [[nodiscard]] static QStringList filesIn(const QMimeData& dragged);
  void renewActions(const WindowActions& actions) const;

  // What a person asks for: in this window where it holds nothing yet, else in another one.
  void newForPerson();
  void newWindow();
  void openForPerson(const QString& path);
  void chooseAndOpen();
  bool saveOrChoose();
  bool chooseAndSave();
  /// True where the document may be given up: it is saved, or the person does not mind.
  bool mayDiscard();
  /// The document has been given up for good.
  void discard();
  void setRestoresSession(bool restores);
  void quit();

  /// From now on the window is one of several, and unsaved changes are kept in side files.
  void join(WindowSet* windows, const QString& recoveryFolder);
  /// Offers a document that an earlier run has left in a side file.
  void offer(std::unique_ptr<SideFile> side);
  /// Nothing was drawn or opened here, or only an example looked at.
  [[nodiscard]] bool isUnused() const;
  /// The file or example that is open; empty where there is none.
  [[nodiscard]] QString source() const;
  /// "robot.geargraph", "Untitled"
  [[nodiscard]] QString title() const;
  /// Is the file open in another window or program, so that this window does not write to it?
  [[nodiscard]] bool isReadOnly() const { return m_isReadOnly; }
  [[nodiscard]] const Autosave* autosave() const { return m_autosave.get(); }

 signals:
  void titleChanged();
  void sourceChanged();

 private:
  struct Offered;
  void restore(const std::shared_ptr<Offered>& offered);
  void offerLeftBehind();
  void onForeignChange();
  void onRemoved();
  void postForeignChange(const Expected<Mechanism>& now, bool isSaving);
  void postNotSaved(const QString& path, const QString& why);
  void withdrawSaving();
  struct Elsewhere;
  [[nodiscard]] std::optional<Elsewhere> openElsewhere(const QString& path) const;
  [[nodiscard]] bool isOwnFile(const QString& path) const;
  void claim(const QString& path);
  void postReadOnly(const QString& problem);
  bool refusesOpenElsewhere(const QString& path);
  void showElsewhere(const QString& path);
  void leaveToOther(const QString& path);
  void offerInterrupted(const QString& path);
  void reload();
  bool saveAnyway(const QString& path);
  bool mayReplace(const QString& path);
  void took(const QString& path);

  MainWindow* m_window;
  Document* m_document;
  NoticeBar* m_notices;
  RecentFiles* m_recent;
  WindowSet* m_windows = nullptr;
  QString m_recoveryFolder;
  QString m_example;      ///< the example that is open, which is no file yet
  MechanismPtr m_onDisk;  ///< what the file held when it was read or written here
  FileWatch m_watch;
  bool m_isReadOnly = false;
  std::unique_ptr<Autosave> m_autosave;
};

}  // namespace geargraph::inline mainwindow
