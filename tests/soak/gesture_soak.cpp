#include "tests/soak/gesture_soak.h"

#include <malloc.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QSettings>
#include <QTimer>
#include <cstdio>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"
#include "tests/soak/live_objects.h"
#include "ui/mainwindow/window_files.h"
#include "ui/theme/application_theme.h"

namespace geargraph::soak {
namespace {

constexpr int kRoundsOfEach = 3;          // of every document, so that the first may fill caches
constexpr int kMostFindings = 20;         // after that the rest would only repeat them
constexpr int kSettling = 60;             // events with no window open until memory is counted
constexpr long kSpareObjects = 20;        // that come and go with timers and threads
constexpr double kSpareMemory = 24;       // MB: allocators do not give back all
constexpr double kStallLimit = 50;        // ms
constexpr double kLargeStallLimit = 100;  // ms, beyond kLargeTrain links
constexpr int kLargeTrain = 1000;

QStringList warnings;

/// Whatever Qt warns of. The platform "offscreen" has no window manager and reports that itself.
void onMessage(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
  if (type == QtDebugMsg || type == QtInfoMsg) return;
  if (message.startsWith(QLatin1String("This plugin does not support"))) return;
  warnings << message;
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
  m_windows = std::make_unique<WindowSet>(m_folder.filePath(QStringLiteral("recovery")));
  m_watchdog = std::make_unique<test::StallWatchdog>(kOpening);
}

GestureSoak::~GestureSoak() {
  m_windows.reset();
  qInstallMessageHandler(nullptr);
}

int GestureSoak::run() {
  m_time.start();
  beginRound();
  next();
  QApplication::exec();
  checkLeaks();
  printStalls();
  std::printf(
      "soak_gestures: seed %llu, %ld gestures, %d rounds, %.0f s, longest stall %.0f ms of CPU, %d "
      "findings\n",
      static_cast<unsigned long long>(m_options.seed), m_gestures, m_round, m_time.elapsed() / 1e3,
      [this] {
        double longest = 0;
        for (const auto& [what, stall] : m_longest) longest = std::max(longest, stall.cpu);
        return longest;
      }(),
      m_findings);
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
  m_links = document.n();
  if (writeFile(QFile::encodeName(path).toStdString(), writeMechanism(document)))
    finding(QStringLiteral("The document could not be written."));
  return path;
}

void GestureSoak::beginRound() {
  const std::string& name =
      m_options.documents[static_cast<std::size_t>(m_round) % m_options.documents.size()];
  m_document = QString::fromStdString(name);
  const QString path = documentFile(name);
  m_watchdog->setActivity(kOpening);
  m_watchdog->reset();
  m_ending = false;
  m_roundTime.start();
  m_windows->openNew().files().openForPerson(path);
}

/// The next event of a gesture, after all that this one brings about. Called before the event, because it may
/// run an event loop of its own.
void GestureSoak::next() {
  QTimer::singleShot(1, this, &GestureSoak::step);
}

void GestureSoak::step() {
  const double total = m_time.elapsed() / 1e3;
  const auto rounds = static_cast<double>(kRoundsOfEach * m_options.documents.size());
  const double seconds = m_options.minutes.value_or(1e9) * 60 / rounds;
  const double gestures = static_cast<double>(m_options.count.value_or(1'000'000'000)) / rounds;
  for (; !warnings.isEmpty(); warnings.removeFirst()) finding(warnings.front());
  const bool isOver = static_cast<double>(m_gestures) >= gestures * (m_round + 1) ||
                      total >= seconds * (m_round + 1) || m_findings >= kMostFindings;
  if (isOver || m_ending) return endRound();
  next();
  if (QWidget* popup = QApplication::activePopupWidget()) return answerPopup(popup);
  if (QWidget* dialog = QApplication::activeModalWidget()) return answerPopup(dialog);
  if (m_windows->windows().empty()) return beginRound();
  if (!m_steps.empty()) {
    const std::function<void()> now = std::move(m_steps.back());
    m_steps.pop_back();
    return now();
  }
  chooseGesture();
}

/// Closes windows and what they ask, event by event, then waits and counts.
void GestureSoak::endRound() {
  if (!m_ending) {
    m_ending = true;
    m_steps.clear();
    m_waited = 0;
    m_watchdog->setActivity(kClosing);
  }
  if (m_waited < kSettling) next();
  if (!m_windows->windows().empty() || QApplication::activeModalWidget() != nullptr) return closeAll();
  if (++m_waited <= kSettling) return;
  malloc_trim(0);
  m_rests.push_back(atRest());
  for (const auto& [activity, stall] : m_watchdog->longestByActivity()) {
    test::StallWatchdog::Stall& longest = m_longest[m_document + QStringLiteral(", ") + activity];
    if (stall.cpu > longest.cpu) longest = stall;
    if (stall.cpu > limitOfStall() && activity != kOpening && activity != kClosing) {
      m_watchdog->setActivity(activity);
      finding(QStringLiteral("the event loop was stalled for %1 ms of CPU, %2 ms of the wall")
                  .arg(stall.cpu, 0, 'f', 0)
                  .arg(stall.wall, 0, 'f', 0));
    }
  }
  std::printf("  round %d, %s: %ld gestures so far, %ld objects and %.1f MB at rest\n", m_round,
              qPrintable(m_document), m_gestures, m_rests.back().objects, m_rests.back().memory);
  std::fflush(stdout);
  ++m_round;
  const bool isLast = m_round >= kRoundsOfEach * static_cast<int>(m_options.documents.size());
  if (isLast || m_findings >= kMostFindings) return QApplication::quit();
  beginRound();
  next();
}

double GestureSoak::limitOfStall() const {
  return m_options.slack * (m_links > kLargeTrain ? kLargeStallLimit : kStallLimit);
}

AtRest GestureSoak::atRest() const {
  const struct mallinfo2 heap = mallinfo2();
  return {liveObjects(), static_cast<double>(heap.uordblks + heap.hblkhd) / 1e6};
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
  std::vector<std::pair<double, QString>> sorted;
  for (const auto& [what, stall] : m_longest) {
    sorted.emplace_back(-stall.cpu, QStringLiteral("  stall of %1 ms of CPU, %2 ms of the wall: %3")
                                        .arg(stall.cpu, 0, 'f', 1)
                                        .arg(stall.wall, 0, 'f', 1)
                                        .arg(what));
  }
  std::sort(sorted.begin(), sorted.end());
  constexpr std::size_t kShown = 24;
  for (std::size_t i = 0; i < std::min(sorted.size(), kShown); ++i)
    std::printf("%s\n", qPrintable(sorted[i].second));
}

}  // namespace geargraph::soak
