#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "ui/mainwindow/file_watch.h"
#include "ui/recovery/autosave.h"
#include "ui/recovery/open_documents.h"
#include "ui/recovery/side_file.h"

class QMimeData;
class QWidget;

namespace geargraph {
class Selection;
}  // namespace geargraph
namespace geargraph {
class Workbench;
}  // namespace geargraph

namespace geargraph {

struct CommandState;
class NoticeBar;
class RecentFiles;

/// The file operations of a window: opens, saves and reverts its document, watches for changes of the file by
/// other programs, keeps unsaved changes in a side file, and offers to restore those that an earlier run left
/// behind.
class WindowFiles : public QObject {
  Q_OBJECT

 public:
  /// The interface to all windows of the program.
  class Windows {
   public:
    Windows() = default;
    Windows(const Windows&) = delete;
    Windows& operator=(const Windows&) = delete;
    virtual ~Windows() = default;

    /// Opens a new window with an empty document and returns its files.
    virtual WindowFiles& addWindow() = 0;
    /// Opens a file or example: in its own window if it is open already, in that of `from` if
    /// from.isUnused(), else in a new one.
    virtual void openFrom(const QString& path, WindowFiles& from) = 0;
    /// The files of all windows in which this file is open, except `besides`. Different spellings of a path
    /// count as the same file.
    [[nodiscard]] virtual std::vector<WindowFiles*> filesWith(const QString& path,
                                                              const WindowFiles* besides) const = 0;
    /// The documents that all running instances of the program have open.
    [[nodiscard]] virtual OpenDocuments& documents() = 0;
    [[nodiscard]] virtual bool restoresSession() const = 0;
    virtual void setRestoresSession(bool restores) = 0;
    /// Closes all windows unless the user cancels.
    virtual void quit() = 0;
  };

  /// @param window the parent of all dialogs; closed and raised by this object
  /// @param saved gives the document as it is to be written
  WindowFiles(Workbench& workbench, QWidget* window, NoticeBar* notices, RecentFiles* recent,
              std::function<Mechanism()> saved);

  /// Opens a file or an example in this window. False if reading failed (unreadable() gives the diagnostics)
  /// or was cancelled; then the open document stays.
  bool open(const QString& path);
  /// Shows a document that was read from `path`. One that was imported from a table gets no file: it is an
  /// edit of an empty document.
  void show(Mechanism mechanism, const QString& path);
  /// Shows a document that the program has made in a new window: an edit of an empty document without a file.
  void showMade(const MechanismPtr& mechanism);
  /// Reports why a file was not opened.
  void reportUnreadable(const QString& path, const Diagnostics& why);
  /// False if the file was not written; then a notice, ahead of all others, gives the reason, and the
  /// document stays modified. A file that another program has changed meanwhile is not overwritten; the
  /// notice asks what to do.
  bool save(const QString& path);
  void startAnew();
  /// Returns to the contents of the file, as an edit that can be undone.
  void revert();

  /// The local files in dragged data.
  [[nodiscard]] static QStringList filesIn(const QMimeData& dragged);
  void describe(CommandState& state) const;

  // User commands: in this window if isUnused(), else in another one.
  void newByUser();
  void newWindow();
  void openByUser(const QString& path);
  void chooseAndOpen();
  bool saveOrChoose();
  bool chooseAndSave();
  /// Asks about unsaved changes. True if the document may be discarded: it is saved, or the user agrees.
  bool mayDiscard();
  /// To be called when the document is discarded: removes its side file and releases the document for other
  /// windows and programs.
  void discard();
  void setRestoresSession(bool restores);
  void quit();

  /// Adds the window to the program's windows; from now on unsaved changes are kept in side files.
  void join(Windows* windows, const QString& recoveryFolder);
  /// Takes over the file, side file and file watch of the window that this one replaces.
  void takeOver(WindowFiles& former);
  /// Marks the document as that of a lesson: it has this title, no file and no side file, is discarded
  /// without a question, and nothing is opened in its place.
  void makeTransient(const QString& title);
  /// Raises the window, and activates it as far as the desktop permits.
  void raiseWindow();
  /// Offers to restore a document that an earlier run has left in a side file.
  void offer(std::unique_ptr<SideFile> side);
  /// Was nothing drawn or opened here, or only an example viewed?
  [[nodiscard]] bool isUnused() const;
  /// The path of the file or example that is open; empty if there is none.
  [[nodiscard]] QString source() const;
  /// The title of the window: "robot.geargraph", "Untitled".
  [[nodiscard]] QString title() const;
  /// Is the file open in another window or program, so that this window does not write to it?
  [[nodiscard]] bool isReadOnly() const { return m_isReadOnly; }
  [[nodiscard]] bool isTransient() const { return !m_lessonTitle.isEmpty(); }
  [[nodiscard]] Autosave* autosave() const { return m_autosave.get(); }

 signals:
  void titleChanged();
  void sourceChanged();
  /// Other commands are possible: after join(), takeOver() and makeTransient().
  void joined();
  /// Messages for the status bar: why a command was rejected, and what was done.
  void rejected(const QString& why);
  void noted(const QString& note);
  /// A file could not be opened, with the diagnostics.
  void unreadable(const QString& name, const geargraph::Diagnostics& why);
  /// A file was opened: the diagnostics of unreadable() are obsolete.
  void read();

 private:
  struct Offered;
  void import(Mechanism mechanism, const QString& table);
  void restore(const std::shared_ptr<Offered>& offered);
  void offerRecovery();
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
  bool rejectIfOpenElsewhere(const QString& path);
  void showElsewhere(const QString& path);
  void leaveToOther(const QString& path);
  void offerInterrupted(const QString& path);
  void reload();
  void finishTyping() const;
  bool saveAnyway(const QString& path);
  bool mayReplace(const QString& path);
  void took(const QString& path);

  QWidget* m_window;
  Document* m_document;
  Selection* m_selection;
  std::function<Mechanism()> m_saved;
  NoticeBar* m_notices;
  RecentFiles* m_recent;
  Windows* m_windows = nullptr;
  QString m_recoveryFolder;
  QString m_proposed;     ///< file name proposed for a document imported from a table
  QString m_example;      ///< path of the open example, which is not a file of the user's
  MechanismPtr m_onDisk;  ///< contents of the file when last read or written here
  FileWatch m_watch;
  QString m_lessonTitle;  ///< of a document that is not kept; else empty
  bool m_isReadOnly = false;
  std::unique_ptr<Autosave> m_autosave;
};

}  // namespace geargraph
