#include "tests/soak/gesture_soak.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QSettings>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"
#include "tests/soak/held_memory.h"
#include "tests/soak/live_objects.h"
#include "tests/soak/resident_code.h"
#include "ui/mainwindow/window_files.h"
#include "ui/theme/application_theme.h"

namespace geargraph::soak {
namespace {

constexpr int kRoundsOfEach = 3;        // of every document at least, so that the first may fill caches
constexpr long kGesturesOfRound = 200;  // where no number is given
constexpr int kMaxFindings = 20;        // after that the rest would only repeat them
constexpr int kSettling = 60;           // events with no window open until memory is counted
constexpr int kMaxOpeningSteps = 200;   // for a window that is never painted
constexpr int kStepsAfterPaint = 3;     // other parts of it are painted in the next event
constexpr long kSpareObjects = 20;      // that come and go with timers and threads
constexpr double kSpareMemory = 24;     // MB: allocators do not give back all
constexpr std::chrono::seconds kHang{100};
constexpr qint64 kStuck = 100'000;        // ms without a new gesture, or until all windows are closed
constexpr double kStallLimit = 50;        // ms
constexpr double kLargeStallLimit = 100;  // ms, beyond kLargeTrain links
constexpr int kLargeTrain = 1000;
constexpr int kLargestTrain = 10'000;  // that a limit is stated for: beyond, it grows with the links

QStringList warnings;

/// Whatever Qt warns of. The platform "offscreen" has no window manager and reports that itself.
void onMessage(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
  if (type == QtDebugMsg || type == QtInfoMsg) return;
  if (message.startsWith(QLatin1String("This plugin does not support"))) return;
  warnings << message;
}

/// "80 ms (CPU 75, waiting 5, wall 120)"
QString textOf(const test::StallWatchdog::Stall& stall) {
  return QStringLiteral("%1 ms (CPU %2, waiting %3, wall %4)")
      .arg(stall.length(), 0, 'f', 0)
      .arg(stall.cpu, 0, 'f', 0)
      .arg(stall.waiting, 0, 'f', 0)
      .arg(stall.wall, 0, 'f', 0);
}

/// "robot", "random:1000"
Mechanism documentOf(const std::string& name) {
  const std::string prefix = "random:";
  if (name.rfind(prefix, 0) != 0) return test::example(name);
  const int links = std::max(1, std::atoi(name.c_str() + prefix.size()));
  return test::randomTrain(7, links, links * 2 / 5);
}

}  // namespace

GestureSoak::GestureSoak(const SoakOptions& options) : m_options(options), m_random(options.seed) {
  qInstallMessageHandler(onMessage);
  QDir::setCurrent(m_folder.path());  // for what a file dialog writes
  QCoreApplication::setOrganizationName(QStringLiteral("GearGraphTest"));
  QCoreApplication::setApplicationName(QStringLiteral("GearGraphTest"));
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
  QApplication::setQuitOnLastWindowClosed(false);
  applyTheme(*qApp, Theme::light);
  qApp->installEventFilter(this);
  m_windows = std::make_unique<WindowSet>(m_folder.filePath(QStringLiteral("recovery")));
  m_watchdog = std::make_unique<test::StallWatchdog>(
      kOpening, options.stacks ? test::StallWatchdog::Stacks::sampled : test::StallWatchdog::Stacks::none);
  m_watchdog->onHang(kHang, [](const QString& activity) {
    std::fprintf(stderr, "the event loop has not come back from: %s\n", qPrintable(activity));
    std::abort();  // what a debugger or a core shows is the place
  });
}

GestureSoak::~GestureSoak() {
  m_windows.reset();
  qInstallMessageHandler(nullptr);
}

int GestureSoak::run() {
  touchMemory();
  m_time.start();
  beginRound();
  next();
  QApplication::exec();
  checkLeaks();
  printStalls();
  test::StallWatchdog::Stall longest;
  for (const auto& [what, stall] : m_longest) {
    if (stall.length() > longest.length()) longest = stall;
  }
  std::printf("soak_gestures: seed %llu, %ld gestures, %d rounds, %.0f s, longest stall %s, %d findings\n",
              static_cast<unsigned long long>(m_options.seed), m_gestures, m_round, m_time.elapsed() / 1e3,
              qPrintable(textOf(longest)), m_findings);
  return m_findings;
}

void GestureSoak::finding(const QString& what) {
  ++m_findings;
  std::fprintf(stderr, "seed %llu, gesture %ld, %s, %s: %s\n",
               static_cast<unsigned long long>(m_options.seed), m_gestures, qPrintable(m_document),
               qPrintable(m_watchdog->activity()), qPrintable(what));
}

// --- rounds -----------------------------------------------------------------------------------------------

QString GestureSoak::documentFile(const std::string& name) {
  const QString path =
      m_folder.filePath(QString::fromStdString(name).replace(u':', u'-') + QStringLiteral(".geargraph"));
  const Mechanism document = documentOf(name);
  if (writeFile(QFile::encodeName(path).toStdString(), writeMechanism(document)))
    finding(QStringLiteral("The document could not be written."));
  return path;
}

void GestureSoak::beginRound() {
  const std::string& name =
      m_options.documents[static_cast<std::size_t>(m_round) % m_options.documents.size()];
  m_document = QString::fromStdString(name);
  const QString path = documentFile(name);
  m_watchdog->renameActivity(kOpening);
  m_watchdog->reset();
  m_ending = false;
  m_sinceGesture.start();
  m_gesturesBefore = m_gestures;
  m_favourite = nullptr;
  if (m_round < 2) keepCodeResident();  // the first round loads libraries
  m_windows->openNew().files().openByUser(path);
}

/// The next event of a gesture, after all that this one brings about. Called before the event, because it may
/// run an event loop of its own.
void GestureSoak::next() {
  QTimer::singleShot(1, this, &GestureSoak::step);
}

/// The gestures of a round. All rounds have as many, so that stalls and leaks can be compared.
long GestureSoak::gesturesOfRound() const {
  if (!m_options.count) return kGesturesOfRound;
  return std::max(1L, *m_options.count / (kRoundsOfEach * static_cast<long>(m_options.documents.size())));
}

/// Is this the last round? With a number of gestures there are kRoundsOfEach of every document, else they go
/// on until the minutes are over.
bool GestureSoak::isLastRound() const {
  const int rounds = kRoundsOfEach * static_cast<int>(m_options.documents.size());
  return m_findings >= kMaxFindings || isTimeOver() || (m_options.count && m_round + 1 >= rounds);
}

bool GestureSoak::isTimeOver() const {
  return m_options.minutes && m_time.elapsed() / 6e4 >= *m_options.minutes;
}

void GestureSoak::step() {
  for (; !warnings.isEmpty(); warnings.removeFirst()) finding(warnings.front());
  const bool isOver =
      m_gestures - m_gesturesBefore >= gesturesOfRound() || isTimeOver() || m_findings >= kMaxFindings;
  if (m_sinceGesture.elapsed() > kStuck) return giveUp();
  if (isOver || m_ending) return endRound();
  next();
  if (isOpening()) return;
  act();
  checkStalls();
}

/// Those of the largest document; gestures change them.
void GestureSoak::countLinks() {
  for (MainWindow* each : m_windows->windows())
    m_links = std::max(m_links, each->document().mechanism()->n());
}

/// A stall is measured against the links that there are about then: what a gesture asked for may still arrive
/// during the next one.
void GestureSoak::checkStalls() {
  countLinks();
  for (auto& [activity, stall] : m_watchdog->take()) {
    test::StallWatchdog::Stall& longest = m_longest[m_document + QStringLiteral(", ") + activity];
    if (stall.length() > longest.length()) longest = stall;
    if (activity == kOpening || activity == kClosing || stall.length() <= limitOfStall()) continue;
    TooLong& worst = m_tooLong[activity];
    if (stall.length() > worst.stall.length()) worst = {std::move(stall), linksOfLate(), limitOfStall()};
  }
}

void GestureSoak::reportStalls() {
  for (const auto& [activity, worst] : std::exchange(m_tooLong, {})) {
    m_watchdog->setActivity(activity);
    finding(QStringLiteral("the event loop was stalled for %1 of %2; %3 links")
                .arg(textOf(worst.stall))
                .arg(worst.limit, 0, 'f', 0)
                .arg(worst.links));
  }
}

/// A gesture that makes a window (opens an example, begins a practice, changes the language) is an opening
/// until that is painted, and one that deletes a window a closing. Known as soon as it begins: the event that
/// a gesture sends handles posted ones before it returns.
bool GestureSoak::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Polish && qobject_cast<MainWindow*>(watched) != nullptr) {
    m_watchdog->renameActivity(kOpening);
    m_opening = static_cast<QWidget*>(watched);
    m_openingSteps = kMaxOpeningSteps;
    connect(watched, &QObject::destroyed, this, [this] { m_watchdog->renameActivity(kClosing); });
  }
  if (event->type() == QEvent::Paint && m_opening && watched->isWidgetType() &&
      static_cast<QWidget*>(watched)->window() == m_opening)
    m_openingSteps = std::min(m_openingSteps, kStepsAfterPaint);
  return QObject::eventFilter(watched, event);
}

/// Is a window being opened, which gestures cannot be made in yet?
bool GestureSoak::isOpening() {
  if (!m_opening || m_openingSteps <= 0) return false;
  --m_openingSteps;
  return true;
}

void GestureSoak::act() {
  if (QWidget* popup = QApplication::activePopupWidget()) return answerPopup(popup);
  if (QWidget* dialog = QApplication::activeModalWidget()) return answerPopup(dialog);
  if (m_windows->windows().empty()) return beginRound();
  if (m_steps.empty()) return chooseGesture();
  const std::function<void()> now = std::move(m_steps.back());
  m_steps.pop_back();
  now();
}

/// The program answers, but something on the screen does not go away.
void GestureSoak::giveUp() {
  QStringList shown;
  for (const QWidget* each : QApplication::topLevelWidgets()) {
    if (!each->isVisible()) continue;
    shown << QStringLiteral("%1 \"%2\" %3")
                 .arg(QLatin1String(each->metaObject()->className()), each->windowTitle(),
                      each->objectName());
  }
  finding(QStringLiteral("nothing ends it; on the screen: ") + shown.join(QStringLiteral(", ")));
  std::fflush(stdout);
  std::_Exit(1);  // event loops of dialogs may be stacked below
}

/// Closes windows and what they ask, event by event, then waits and counts.
void GestureSoak::endRound() {
  if (!m_ending) {
    m_ending = true;
    m_sinceGesture.start();
    m_steps.clear();
    m_waited = 0;
    m_watchdog->setActivity(kClosing);
  }
  if (m_waited < kSettling) next();
  if (!m_windows->windows().empty() || QApplication::activeModalWidget() != nullptr) return closeAll();
  if (++m_waited <= kSettling) return;
  const AtRest rest = atRest();
  const bool isWhole = m_gestures - m_gesturesBefore >= gesturesOfRound();
  if (isWhole) m_rests.push_back(rest);
  checkStalls();
  reportStalls();
  std::printf("  round %d, %s: %ld gestures, %ld objects and %.1f MB at rest, %.0f s\n", m_round,
              qPrintable(m_document), m_gestures - m_gesturesBefore, rest.objects, rest.memory,
              m_time.elapsed() / 1e3);
  std::fflush(stdout);
  if (isLastRound()) {
    ++m_round;
    return QApplication::quit();
  }
  ++m_round;
  beginRound();
  next();
}

int GestureSoak::linksOfLate() const {
  return std::max(m_links, m_linksBefore);
}

double GestureSoak::limitOfStall() const {
  const int links = linksOfLate();
  const double limit = links > kLargeTrain ? kLargeStallLimit : kStallLimit;
  return m_options.slack * limit * std::max(1.0, static_cast<double>(links) / kLargestTrain);
}

AtRest GestureSoak::atRest() const {
  return {liveObjects(), heldMemory()};
}

/// The first rounds fill caches. What is held after the last round of every document beyond what was ever
/// held after an earlier one has been lost.
void GestureSoak::checkLeaks() {
  const std::size_t documents = m_options.documents.size();
  if (m_rests.size() < kRoundsOfEach * documents) return;
  AtRest earlier{};
  AtRest last{m_rests.back()};
  for (std::size_t i = 0; i < m_rests.size(); ++i) {
    AtRest& side = i + documents < m_rests.size() ? earlier : last;
    side.objects = &side == &earlier ? std::max(side.objects, m_rests[i].objects)
                                     : std::min(side.objects, m_rests[i].objects);
    side.memory = &side == &earlier ? std::max(side.memory, m_rests[i].memory)
                                    : std::min(side.memory, m_rests[i].memory);
  }
  m_watchdog->setActivity(QStringLiteral("at rest"));
  if (last.objects > earlier.objects + kSpareObjects)
    finding(QStringLiteral("%1 objects alive, %2 before").arg(last.objects).arg(earlier.objects));
  if (last.memory > earlier.memory + kSpareMemory)
    finding(QStringLiteral("%1 MB allocated, %2 before").arg(last.memory).arg(earlier.memory));
}

void GestureSoak::printStalls() {
  constexpr double kShort = 8;  // ms, not worth a line
  std::multimap<double, QString> sorted;
  for (const auto& [what, stall] : m_longest) {
    if (stall.length() < kShort) continue;
    QString lines = QStringLiteral("  stall of %1: %2\n").arg(textOf(stall), what);
    if (stall.length() > kStallLimit) {
      for (const std::string& function : stall.path)
        lines += QStringLiteral("      ") + QString::fromStdString(function) + u'\n';
    }
    sorted.emplace(-stall.length(), lines);
  }
  for (const auto& [length, lines] : sorted) std::printf("%s", qPrintable(lines));
}

}  // namespace geargraph::soak
