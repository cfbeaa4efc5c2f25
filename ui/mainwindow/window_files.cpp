#include "ui/mainwindow/window_files.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMimeData>
#include <QUrl>

#include "core/mechanism/model/difference.h"
#include "ui/mainwindow/commands.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/file_texts.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/recent_files.h"
#include "ui/mainwindow/thumbnails.h"
#include "ui/models/term_tips.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
namespace {

QString timeText(const QDateTime& time) {
  const QLocale locale;
  const bool today = time.date() == QDate::currentDate();
  return today ? locale.toString(time.time(), QLocale::ShortFormat)
               : locale.toString(time, QLocale::ShortFormat);
}

}  // namespace

/// A side file that waits for an answer. It is held meanwhile, so that nobody else offers it.
struct WindowFiles::Offered {
  std::unique_ptr<SideFile> side;
  SideDocument document;
};

WindowFiles::WindowFiles(Workbench& workbench, QWidget* window, NoticeBar* notices, RecentFiles* recent,
                         std::function<Mechanism()> saved)
    : m_window(window),
      m_document(&workbench.document()),
      m_selection(&workbench.selection()),
      m_saved(std::move(saved)),
      m_notices(notices),
      m_recent(recent) {
  connect(&m_watch, &FileWatch::changed, this, &WindowFiles::onForeignChange);
  connect(&m_watch, &FileWatch::removed, this, &WindowFiles::onRemoved);
}

// --- opening ----------------------------------------------------------------------------------------------

bool WindowFiles::open(const QString& path) {
  std::optional<Expected<Mechanism>> opened = readDocument(path, m_window);
  if (!opened) return false;
  if (!*opened) {
    reportUnreadable(path, opened->error());
    return false;
  }
  show(std::move(*opened).value(), path);
  return true;
}

void WindowFiles::reportUnreadable(const QString& path, const Diagnostics& why) {
  const QString name = QFileInfo(path).fileName();
  emit unreadable(name, why);
  emit rejected(tr("%1 could not be opened: %2").arg(name, shownText(why.front().message)));
  offerInterrupted(path);
}

void WindowFiles::show(Mechanism mechanism, const QString& path) {
  if (isTable(path)) return import(std::move(mechanism), path);
  const bool isExample = path.startsWith(QLatin1String(":/"));
  emit read();
  m_selection->clear();
  m_example = isExample ? path : QString();
  m_document->replace(std::move(mechanism), isExample ? QString() : path);
  took(isExample ? QString() : path);
  if (isExample) return;
  offerInterrupted(path);
  offerRecovery();
}

/// A table has no place for all of a document, so that nothing is saved to it.
void WindowFiles::import(Mechanism mechanism, const QString& table) {
  emit read();
  startAnew();
  const QString name = QFileInfo(table).fileName();
  m_document->apply(
      takingOver(tr("Import of %1").arg(name), std::make_shared<const Mechanism>(std::move(mechanism))));
  m_proposed =
      QFileInfo(table).dir().filePath(QFileInfo(table).completeBaseName() + QStringLiteral(".geargraph"));
  emit noted(tr("%1 was imported. Save writes a document of its own.").arg(name));
}

void WindowFiles::showMade(const MechanismPtr& mechanism) {
  if (m_windows == nullptr) return emit rejected(tr("This window is not connected to others."));
  WindowFiles& files = m_windows->addWindow();
  files.startAnew();
  files.m_document->apply(takingOver(tr("New document"), mechanism));
  emit files.noted(tr("This is a document of its own. Save keeps it."));
}

void WindowFiles::startAnew() {
  m_selection->clear();
  m_example.clear();
  m_document->replace(emptyMechanism(), {});
  took({});
}

/// The document as it is now is what stands in this file.
void WindowFiles::took(const QString& path) {
  m_onDisk = m_document->mechanism();
  m_proposed.clear();
  m_watch.watch(path);
  withdrawSaving();
  claim(path);
  if (m_autosave) m_autosave->setTitle(title());
  if (!path.isEmpty() && m_windows != nullptr) {
    m_recent->add(path);
    Thumbnails::keep(path, m_onDisk);
  }
  emit titleChanged();
  emit sourceChanged();
}

QString WindowFiles::source() const {
  return m_document->filePath().isEmpty() ? m_example : m_document->filePath();
}

void WindowFiles::makeTransient(const QString& title) {
  m_lessonTitle = title;
  if (m_autosave) m_autosave->discard();
  m_autosave.reset();
  emit joined();
}

QString WindowFiles::title() const {
  if (isTransient()) return m_lessonTitle;
  const QString name = QFileInfo(source()).fileName();
  return name.isEmpty() ? tr("Untitled") : name;
}

bool WindowFiles::isUnused() const {
  return m_document->filePath().isEmpty() && !m_document->isModified() && !isTransient();
}

void WindowFiles::newByUser() {
  const bool isEmpty =
      m_document->filePath().isEmpty() && isSameButForView(*m_document->mechanism(), emptyMechanism());
  if (isEmpty && !isTransient()) return startAnew();  // all that was drawn has been deleted: nothing to save
  if (isUnused() || m_windows == nullptr) {
    if (mayDiscard()) startAnew();
  } else {
    m_windows->addWindow();
  }
}

void WindowFiles::newWindow() {
  if (m_windows != nullptr) m_windows->addWindow();
}

void WindowFiles::openByUser(const QString& path) {
  finishTyping();
  if (m_windows != nullptr) return m_windows->openFrom(path, *this);
  if (mayDiscard() && !open(path)) m_recent->forget(path);
}

void WindowFiles::chooseAndOpen() {
  const QString folder = QFileInfo(m_document->filePath()).path();
  const QString path = QFileDialog::getOpenFileName(m_window, tr("Open"), folder, readableFilter());
  if (!path.isEmpty()) openByUser(path);
}

void WindowFiles::discard() {
  if (m_autosave) m_autosave->discard();
  if (m_windows != nullptr) m_windows->documents().release(this);
}

void WindowFiles::quit() {
  if (m_windows != nullptr) {
    m_windows->quit();
  } else {
    m_window->close();
  }
}

void WindowFiles::setRestoresSession(bool restores) {
  if (m_windows != nullptr) m_windows->setRestoresSession(restores);
}

void WindowFiles::describe(CommandState& state) const {
  state.hasSiblings = m_windows != nullptr;
  state.restoresSession = m_windows != nullptr && m_windows->restoresSession();
  state.isTransient = isTransient();
  state.hasFile = !m_document->filePath().isEmpty();
  state.isModified = m_document->isModified();
}

void WindowFiles::raiseWindow() {
  m_window->setWindowState(m_window->windowState() & ~Qt::WindowMinimized);
  m_window->show();
  m_window->raise();
  m_window->activateWindow();
  QApplication::alert(m_window);  // where the desktop does not let a program take the focus
}

QStringList WindowFiles::filesIn(const QMimeData& dragged) {
  QStringList files;
  for (const QUrl& url : dragged.urls()) {
    if (url.isLocalFile() && QFileInfo(url.toLocalFile()).isFile()) files << url.toLocalFile();
  }
  return files;
}

// --- side files -------------------------------------------------------------------------------------------

void WindowFiles::join(Windows* windows, const QString& recoveryFolder) {
  m_windows = windows;
  m_recoveryFolder = recoveryFolder;
  m_autosave = std::make_unique<Autosave>(m_document, recoveryFolder);
  connect(m_autosave.get(), &Autosave::failed, this, &WindowFiles::rejected);
  emit joined();
}

void WindowFiles::takeOver(WindowFiles& former) {
  m_windows = former.m_windows;
  m_recoveryFolder = former.m_recoveryFolder;
  m_example = former.m_example;
  m_onDisk = former.m_onDisk;
  m_lessonTitle = former.m_lessonTitle;
  m_autosave = std::move(former.m_autosave);
  if (m_autosave) connect(m_autosave.get(), &Autosave::failed, this, &WindowFiles::rejected);
  const bool isForeign = former.m_watch.isForeign();
  former.m_watch.watch({});
  m_watch.watch(m_document->filePath());
  if (m_windows != nullptr) m_windows->documents().release(&former);
  former.m_windows = nullptr;
  claim(m_document->filePath());
  if (isForeign) onForeignChange();
  emit joined();
  emit titleChanged();
}

void WindowFiles::offerRecovery() {
  if (m_windows == nullptr) return;
  for (auto& side : recoverableFilesOf(m_document->filePath(), m_recoveryFolder)) offer(std::move(side));
}

void WindowFiles::offer(std::unique_ptr<SideFile> side) {
  const QString key = side->path();
  auto document = side->read();
  if (!document) {
    const std::shared_ptr<SideFile> kept = std::move(side);
    return m_notices->post({key,
                            Severity::warning,
                            tr("Unsaved changes of an earlier run are in %1, which cannot be read.").arg(key),
                            {{tr("Delete it"), {}, [kept] { kept->remove(); }},
                             {tr("Later"), tr("It will be offered again"), {}}}});
  }
  const SideNote& note = document->note;
  Mechanism before = emptyMechanism();
  if (!note.filePath.isEmpty()) {
    if (Expected<Mechanism> saved = readDocument(note.filePath)) before = std::move(saved).value();
  }
  const QString name = note.filePath.isEmpty() ? tr("a document that was never saved (%1)").arg(note.title)
                                               : QFileInfo(note.filePath).fileName();
  const QString edits = note.edits == 1 ? tr("1 edit") : tr("%1 edits").arg(note.edits);
  const QString what =
      tr("GearGraph ended with unsaved changes of %1: %2 after it was last saved, the last at %3 (%4).")
          .arg(name, edits, timeText(note.savedAt), textOf(differenceOf(before, document->mechanism)));
  auto offered = std::make_shared<Offered>(Offered{std::move(side), std::move(*document)});
  m_notices->post({key,
                   Severity::warning,
                   what,
                   {{tr("Restore"), tr("Open them as unsaved changes, which can be undone"),
                     [this, offered] { restore(offered); }},
                    {tr("Discard"), tr("Delete them for good"), [offered] { offered->side->remove(); }},
                    {tr("Later"), tr("They stay where they are and will be offered again"), {}}}});
}

void WindowFiles::restore(const std::shared_ptr<Offered>& offered) {
  const QString path = offered->document.note.filePath;
  const bool here = isUnused() || isOwnFile(path);
  if (!here && m_windows != nullptr) {
    if (const auto open = m_windows->filesWith(path, nullptr); !open.empty()) {
      open.front()->raiseWindow();
      return open.front()->restore(offered);
    }
    return m_windows->addWindow().restore(offered);
  }
  if (!mayDiscard()) return;
  if (path.isEmpty()) {
    startAnew();
  } else if (!isOwnFile(path) || m_document->isModified()) {
    Expected<Mechanism> saved = readDocument(path);
    m_selection->clear();
    m_example.clear();
    m_document->replace(saved ? std::move(saved).value() : emptyMechanism(), path);
    took(path);
  }
  m_document->apply(takingOver(tr("Restore unsaved changes"),
                               std::make_shared<const Mechanism>(offered->document.mechanism)));
  if (m_autosave) m_autosave->adopt(std::move(offered->side), offered->document.note);
}

}  // namespace geargraph

#include "moc_window_files.cpp"
