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

namespace geargraph::inline selection {
class Selection;
}  // namespace geargraph::inline selection
namespace geargraph::inline workbench {
class Workbench;
}  // namespace geargraph::inline workbench

namespace geargraph::inline mainwindow {

struct WindowActions;
class NoticeBar;
class RecentFiles;

/// What a window does with files: opens, saves and reverts its document, minds other programs that write the
/// same file, keeps unsaved changes in a side file, and offers those that an earlier run left behind.
class WindowFiles : public QObject {
  Q_OBJECT

 public:
  /// What it asks of the program's windows together.
  class Windows {
   public:
    Windows() = default;
    Windows(const Windows&) = delete;
    Windows& operator=(const Windows&) = delete;
    virtual ~Windows() = default;

    /// The files of a new window with an empty document.
    virtual WindowFiles& addWindow() = 0;
    /// Opens a file or example: in its own window if it is open already, in that of `from` if that holds
    /// nothing yet, else in a new one.
    virtual void openFrom(const QString& path, WindowFiles& from) = 0;
    /// Those of the windows with this file, whatever the spelling of its path, but for one.
    [[nodiscard]] virtual std::vector<WindowFiles*> filesWith(const QString& path,
                                                              const WindowFiles* besides) const = 0;
    /// What all running programs have open.
    [[nodiscard]] virtual OpenDocuments& documents() = 0;
    [[nodiscard]] virtual bool restoresSession() const = 0;
    virtual void setRestoresSession(bool restores) = 0;
    /// Closes all windows, unless the user minds.
    virtual void quit() = 0;
  };

  /// `window`: the parent of its dialogs, which it closes and brings to the front. `saved`: the document as
  /// it is to be written.
  WindowFiles(Workbench& workbench, QWidget* window, NoticeBar* notices, RecentFiles* recent,
              std::function<Mechanism()> saved);

  /// Opens a file or an example in this window. A broken one is listed in the problems with its places, and
  /// the document that was open stays.
  bool open(const QString& path);
  /// Takes a document that was read from there. That of a table gets no file: it is an edit of an empty
  /// document.
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
  void join(Windows* windows, const QString& recoveryFolder);
  /// Goes on where the files of a window left off that this one is built in place of: its file, side file and
  /// watch.
  void takeOver(WindowFiles& former);
  /// The document is a lesson's: it has this title, no file and no side file, is given up without a question,
  /// and nothing is opened in its place.
  void keepNothing(const QString& title);
  /// The window to the front, and active as far as the desktop lets a program do that.
  void bringForward();
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
  [[nodiscard]] bool keepsNothing() const { return !m_lessonTitle.isEmpty(); }
  [[nodiscard]] Autosave* autosave() const { return m_autosave.get(); }

 signals:
  void titleChanged();
  void sourceChanged();
  /// renewActions() has something to do.
  void joined();
  /// Why something was not done, and what was: for the status bar.
  void refused(const QString& why);
  void noted(const QString& note);
  /// A file could not be opened, by its findings.
  void broken(const QString& name, const geargraph::Diagnostics& why);
  /// Another one was: those findings are of no interest any more.
  void read();

 private:
  struct Offered;
  void import(Mechanism mechanism, const QString& table);
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

  QWidget* m_window;
  Document* m_document;
  Selection* m_selection;
  std::function<Mechanism()> m_saved;
  NoticeBar* m_notices;
  RecentFiles* m_recent;
  Windows* m_windows = nullptr;
  QString m_recoveryFolder;
  QString m_proposed;     ///< the file's name that is proposed for a document of an imported table
  QString m_example;      ///< the example that is open, which is no file yet
  MechanismPtr m_onDisk;  ///< what the file held when it was read or written here
  FileWatch m_watch;
  QString m_lessonTitle;  ///< of a document that is not kept; else empty
  bool m_isReadOnly = false;
  std::unique_ptr<Autosave> m_autosave;
};

}  // namespace geargraph::inline mainwindow
