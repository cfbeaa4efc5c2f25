#include "ui/mainwindow/window_set.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QThread>
#include <QTimer>
#include <algorithm>

#include "core/foundations/files/file_identity.h"
#include "ui/mainwindow/crash_offer.h"
#include "ui/mainwindow/dock_drag.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/recent_files.h"
#include "ui/mainwindow/status_line.h"
#include "ui/settings/languages.h"
#include "ui/settings/settings.h"

namespace geargraph {
namespace {

const QString kSession = QStringLiteral("session/windows");
const QString kRestores = QStringLiteral("session/restore");
constexpr int kLaidOut = 1000;  ///< ms after which a new window stands as it will
constexpr int kLeavePoll = 5;   ///< ms between checks whether a closed window can go
constexpr int kCascade = 32;    ///< px between a window and the one opened from it

}  // namespace

WindowSet::WindowSet(const QString& folder, QObject* parent)
    : QObject(parent),
      m_folder(folder),
      m_recordSoon(new QTimer(this)),
      m_lock(QDir(folder).filePath(QStringLiteral("session.lock"))),
      m_documents(folder),
      m_leaveSoon(new QTimer(this)) {
  m_leaveSoon->setInterval(kLeavePoll);
  connect(m_leaveSoon, &QTimer::timeout, this, &WindowSet::deleteLeft);
  QDir().mkpath(folder);
  m_lock.setStaleLockTime(0);
  m_ownsSession = m_lock.tryLock(0);
  m_recordSoon->setSingleShot(true);
  m_recordSoon->setInterval(kLaidOut);
  connect(m_recordSoon, &QTimer::timeout, this, &WindowSet::recordLayouts);
  m_documents.setShower([this](const QString& path) {
    const auto open = filesWith(path, nullptr);
    if (!open.empty()) open.front()->raiseWindow();
    return !open.empty();
  });
}

WindowSet::~WindowSet() = default;

QString WindowSet::defaultFolder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
      .filePath(QStringLiteral("recovery"));
}

std::vector<MainWindow*> WindowSet::windows() const {
  std::vector<MainWindow*> all;
  for (const auto& window : m_windows) all.push_back(window.get());
  return all;
}

std::vector<WindowFiles*> WindowSet::filesWith(const QString& path, const WindowFiles* besides) const {
  std::vector<WindowFiles*> found;
  if (path.isEmpty() || path.startsWith(QLatin1String(":/"))) return found;
  for (const auto& window : m_windows) {
    const QString open = window->document().filePath();
    if (&window->files() != besides &&
        isSameFile(QFile::encodeName(open).toStdString(), QFile::encodeName(path).toStdString())) {
      found.push_back(&window->files());
    }
  }
  return found;
}

MainWindow& WindowSet::add() {
  const MainWindow* active = qobject_cast<MainWindow*>(QApplication::activeWindow());
  m_windows.push_back(std::make_unique<MainWindow>());
  MainWindow& window = *m_windows.back();
  window.restoreLayout();
  if (active != nullptr) window.move(active->pos() + QPoint(kCascade, kCascade));
  window.files().join(this, m_folder);
  connectTo(window);
  m_recordSoon->start();
  return window;
}

void WindowSet::connectTo(MainWindow& window) {
  connect(&window, &MainWindow::closed, this, [this, &window] { onClosed(&window); });
  connect(&window.files(), &WindowFiles::sourceChanged, this, &WindowSet::remember);
  connect(&window, &MainWindow::lessonWanted, this, &WindowSet::openLesson);
  connect(&window, &MainWindow::languageWanted, this, &WindowSet::chooseLanguage);
}

/// Texts are set where widgets are made, so each window is built anew in its place.
void WindowSet::chooseLanguage(const QString& code) {
  for (const auto& window : m_windows) {
    if (window->exportJobs().isBusy())
      return window->statusLine().showRejection(
          tr("The language can be changed when the export is finished."));
    if (isReading(*window))
      return window->statusLine().showRejection(
          tr("The language can be changed when the file has been read."));
  }
  saveLanguage(code);
  const QString wanted = code.isEmpty() ? systemLanguage() : code;
  if (wanted == currentLanguage()) return;
  useLanguage(wanted);
  for (std::size_t i = 0; i < m_windows.size(); ++i) {
    const bool wasActive = m_windows[i]->isActiveWindow();
    const bool wasVisible = m_windows[i]->isVisible();
    const auto place = m_windows.begin() + static_cast<std::ptrdiff_t>(i);
    std::unique_ptr<MainWindow> left = std::move(*place);  // it is the one that asks
    MainWindow* const former = left.get();
    m_windows.erase(place);  // first, so that its file is not held twice
    auto renewed = MainWindow::inPlaceOf(*former);
    leave(std::move(left));
    MainWindow& window = *renewed;
    m_windows.insert(m_windows.begin() + static_cast<std::ptrdiff_t>(i), std::move(renewed));
    m_layouts[&window] = m_layouts[former];
    m_layouts.erase(former);
    connectTo(window);
    window.setVisible(wasVisible);
    if (wasActive) window.activateWindow();
  }
  m_recordSoon->start();
}

MainWindow& WindowSet::openNew() {
  MainWindow& window = add();
  window.show();
  remember();
  return window;
}

/// All lessons share one window, so that they never take the place of the learner's own document.
void WindowSet::openLesson(const std::shared_ptr<const Lesson>& lesson, const QString& place,
                           const QString& file) {
  const auto open = std::find_if(m_windows.begin(), m_windows.end(),
                                 [](const auto& window) { return window->lesson() != nullptr; });
  MainWindow& window = open != m_windows.end() ? **open : openNew();
  window.playLesson(lesson, place, file);
  window.files().raiseWindow();
}

WindowFiles& WindowSet::addWindow() {
  return openNew().files();
}

void WindowSet::openFrom(const QString& path, WindowFiles& from) {
  const bool isExample = path.startsWith(QLatin1String(":/"));
  const QString wanted = isExample ? path : QFileInfo(path).absoluteFilePath();
  if (const auto open = filesWith(wanted, nullptr); !open.empty()) {
    open.front()->raiseWindow();
    return emit open.front()->noted(tr("%1 is open in this window already.").arg(open.front()->title()));
  }
  MainWindow* const asking = std::find_if(m_windows.begin(), m_windows.end(), [&](const auto& window) {
                               return &window->files() == &from;
                             })->get();
  std::optional<Expected<Mechanism>> opened = readDocument(wanted, asking);
  if (!opened) return;
  if (!*opened) {
    RecentFiles::forget(wanted);
    return from.reportUnreadable(wanted, opened->error());
  }
  MainWindow& window = from.isUnused() ? *asking : add();
  window.files().show(std::move(*opened).value(), wanted);
  window.show();
}

// --- the session ------------------------------------------------------------------------------------------

void WindowSet::start(const QStringList& documents) {
  if (!documents.isEmpty()) {
    for (const QString& path : documents) {
      if (!filesWith(path, nullptr).empty()) continue;  // named twice
      MainWindow& window = add();
      window.show();
      window.files().open(path.startsWith(QLatin1String(":/")) ? path : QFileInfo(path).absoluteFilePath());
      if (m_windows.empty()) return;  // the program was quit while it read
    }
  } else if (!reopenSession()) {
    openNew().showStartPage();
  }
  offerRecovery();
}

bool WindowSet::reopenSession() {
  if (!m_ownsSession || !restoresSession()) return false;
  struct Entry {
    QString source;
    QByteArray geometry;
    QByteArray state;
  };
  flushSettings();
  QSettings settings;
  std::vector<Entry> entries;
  const int count = settings.beginReadArray(kSession);
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    entries.push_back({settings.value(QStringLiteral("source")).toString(),
                       settings.value(QStringLiteral("geometry")).toByteArray(),
                       settings.value(QStringLiteral("state")).toByteArray()});
  }
  settings.endArray();
  QStringList missing;
  for (const Entry& entry : entries) {
    if (!filesWith(entry.source, nullptr).empty()) continue;
    Expected<Mechanism> opened = readDocument(entry.source);
    if (!opened) {
      missing << QFileInfo(entry.source).fileName();
      continue;
    }
    MainWindow& window = add();
    window.restoreLayout(entry.geometry, entry.state);
    window.files().show(std::move(opened).value(), entry.source);
    window.show();
  }
  if (m_windows.empty()) return false;
  if (!missing.isEmpty())
    m_windows.front()->statusLine().showNote(
        tr("Not opened again: %1").arg(missing.join(QStringLiteral(", "))));
  return true;
}

void WindowSet::offerRecovery() {
  SideFiles left = recoverableFiles(m_folder, RecentFiles::paths());
  for (auto& side : left) m_windows.front()->files().offer(std::move(side));
  offerCrashReports(m_folder, *m_windows.front());
}

void WindowSet::onClosed(MainWindow* window) {
  const auto found = std::find_if(m_windows.begin(), m_windows.end(),
                                  [&](const auto& each) { return each.get() == window; });
  if (found == m_windows.end()) return;
  const bool wasLast = m_windows.size() == 1;
  if (wasLast) recordLayouts();
  m_layouts.erase(window);
  leave(std::move(*found));  // it is the one that tells
  m_windows.erase(found);
  if (!wasLast && !m_quitting) remember();
}

void WindowSet::leave(std::unique_ptr<MainWindow> window) {
  window->requestStop();
  m_leaving.push_back(std::move(window));
  m_leaveSoon->start();
}

/// Not in the event loop of a dialog: a window that has been closed may be what it was opened by, and waits
/// on the stack for its answer.
void WindowSet::deleteLeft() {
  if (QThread::currentThread()->loopLevel() > 1 || !m_leaving.front()->hasStopped()) return;
  m_leaving.pop_front();
  if (m_leaving.empty()) m_leaveSoon->stop();
}

/// Records the layouts of the windows. A window that was shown just now has no layout yet, one whose docks
/// are being dragged is recorded later.
void WindowSet::recordLayouts() {
  for (const auto& window : m_windows) {
    if (DockDrag::draggedOf(*window) != nullptr)
      m_recordSoon->start();
    else if (window->isVisible())
      m_layouts[window.get()] = window->workLayout();
  }
  remember();
}

/// Written at every change: a program that is killed is remembered, too.
void WindowSet::remember() {
  if (!m_ownsSession || m_quitting) return;
  std::vector<std::pair<QString, Layout>> session;
  for (const auto& window : m_windows) {
    const QString source = window->files().source();
    if (!source.isEmpty()) session.emplace_back(source, m_layouts[window.get()]);
  }
  changeSettings(kSession, [session = std::move(session)](QSettings& settings) {
    settings.remove(kSession);
    settings.beginWriteArray(kSession);
    int index = 0;
    for (const auto& [source, layout] : session) {
      settings.setArrayIndex(index++);
      settings.setValue(QStringLiteral("source"), source);
      settings.setValue(QStringLiteral("geometry"), layout.geometry);
      settings.setValue(QStringLiteral("state"), layout.state);
    }
    settings.endArray();
  });
}

void WindowSet::quit() {
  recordLayouts();
  m_recordSoon->stop();  // it would record that there are no windows
  m_quitting = true;
  for (MainWindow* window : windows()) {
    if (!window->close()) break;
  }
  m_quitting = false;
  if (!m_windows.empty()) remember();
}

bool WindowSet::restoresSession() const {
  return savedSetting(kRestores, true).toBool();
}

void WindowSet::setRestoresSession(bool restores) {
  saveSetting(kRestores, restores);
}

}  // namespace geargraph

#include "moc_window_set.cpp"
