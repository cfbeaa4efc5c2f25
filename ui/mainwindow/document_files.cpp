#include "ui/mainwindow/document_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QFutureWatcher>
#include <QProgressDialog>
#include <QPromise>
#include <QRegularExpression>
#include <QThreadPool>
#include <QTimer>
#include <algorithm>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_table.h"
#include "ui/service/background_work.h"

namespace geargraph {
namespace {

/// A file of so many bytes is read within a frame or two (3 MB: 0.1 to 0.2 s).
constexpr qint64 kReadAtOnce = 200'000;

const QString kReading = QStringLiteral("documentReading");

using ReadResult = std::shared_ptr<Expected<Mechanism>>;

QFuture<ReadResult> onThread(const std::function<Expected<Mechanism>()>& read) {
  const auto promise = std::make_shared<QPromise<ReadResult>>();
  promise->start();
  QThreadPool::globalInstance()->start([promise, read] {
    promise->addResult(std::make_shared<Expected<Mechanism>>(read()));
    promise->finish();
  });
  return promise->future();
}

/// What a window works at while it reads: closing the window ends the event loop that waits for it, and the
/// window stays until that loop has been left.
class Reading final : public QObject, public BackgroundWork {
 public:
  explicit Reading(QWidget* window) : QObject(window) {
    setObjectName(kReading);
    connect(&m_watcher, &QFutureWatcherBase::finished, &m_loop, &QEventLoop::quit);
  }
  void start(const std::function<Expected<Mechanism>()>& read) { m_watcher.setFuture(onThread(read)); }
  void requestStop() override {
    m_isGivenUp = true;
    m_loop.quit();
  }
  [[nodiscard]] bool hasStopped() const override { return false; }
  /// Waits for at most `silence` ms.
  void wait(int silence) {
    QTimer::singleShot(silence, &m_loop, &QEventLoop::quit);
    m_loop.exec(QEventLoop::ExcludeUserInputEvents);
  }
  void wait(const QProgressDialog& dialog) {
    connect(&dialog, &QProgressDialog::canceled, this, &Reading::requestStop);
    m_loop.exec();
  }
  [[nodiscard]] bool isGoingOn() const { return !m_isGivenUp && !m_watcher.isFinished(); }
  [[nodiscard]] std::optional<Expected<Mechanism>> result() const {
    if (m_isGivenUp || !m_watcher.isFinished()) return std::nullopt;
    return std::move(*m_watcher.result());
  }

 private:
  QEventLoop m_loop;
  QFutureWatcher<ReadResult> m_watcher;
  bool m_isGivenUp = false;
};

std::filesystem::path nativePath(const QString& path) {
  return QFile::encodeName(path).toStdString();
}

std::optional<QString> reason(const std::optional<FileError>& error) {
  if (!error) return std::nullopt;
  return QString::fromStdString(error->message);
}

}  // namespace

Expected<Mechanism> readDocument(const QString& path) {
  if (path.startsWith(QLatin1String(":/"))) {
    QFile resource(path);
    const bool there = resource.open(QIODevice::ReadOnly);
    return readMechanism(there ? resource.readAll().toStdString() : std::string());
  }
  const auto bytes = readFile(nativePath(path), kLargestFile);
  if (const auto* error = std::get_if<FileError>(&bytes)) {
    return Diagnostic{Code::syntax, error->message, {}, {}, 0, 0};
  }
  const auto& text = std::get<std::string>(bytes);
  return isTable(path) ? readMechanismTable(text) : readMechanism(text);
}

bool isTable(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  return suffix == QLatin1String("csv") || suffix == QLatin1String("tsv");
}

std::optional<Expected<Mechanism>> readInBackground(const std::function<Expected<Mechanism>()>& read,
                                                    const QString& name, QWidget* window, int silence) {
  Reading reading(window);
  reading.start(read);
  reading.wait(silence);
  if (reading.isGoingOn()) {
    QProgressDialog dialog(QCoreApplication::translate("DocumentFiles", "Reading %1 …").arg(name),
                           QCoreApplication::translate("DocumentFiles", "Cancel"), 0, 0, window);
    dialog.setWindowModality(Qt::WindowModal);
    dialog.show();
    reading.wait(dialog);
  }
  return reading.result();
}

bool isReading(const QWidget& window) {
  return window.findChild<QObject*>(kReading) != nullptr;
}

std::optional<Expected<Mechanism>> readDocument(const QString& path, QWidget* window) {
  if (QFileInfo(path).size() < kReadAtOnce) return readDocument(path);
  return readInBackground([path] { return readDocument(path); }, QFileInfo(path).fileName(), window);
}

std::optional<QString> writeDocument(const Mechanism& mechanism, const QString& path) {
  return reason(writeFile(nativePath(path), writeMechanism(mechanism)));
}

std::vector<ExampleGroup> exampleGroups() {
  // From the simple to the strange. What is named nowhere comes last.
  const QDir examples(QStringLiteral(":/examples"));
  const auto pathsOf = [&](std::initializer_list<const char*> names) {
    QStringList paths;
    for (const char* name : names) {
      const QString path = examples.filePath(QLatin1String(name) + QStringLiteral(".geargraph"));
      if (QFile::exists(path)) paths << path;
    }
    return paths;
  };
  std::vector<ExampleGroup> groups{
      {QCoreApplication::translate("DocumentFiles", "Robots"),
       pathsOf({"robot", "bevel-wrist", "three-roll-wrist", "puma-wrist"})},
      {QCoreApplication::translate("DocumentFiles", "Gear trains"),
       pathsOf({"spur-pair", "reverted-train", "helical-reverted-train", "planetary-ring-held",
                "three-planets", "bevel-differential", "humpage-reduction", "ferguson-paradox"})},
      {QCoreApplication::translate("DocumentFiles", "Clocks"),
       pathsOf({"mantel-clock", "one-hand-clock", "antikythera"})},
      {QCoreApplication::translate("DocumentFiles", "Gearboxes"),
       pathsOf({"simpson", "ravigneaux", "eight-speed-gearbox", "prius-power-split", "three-speed-hub",
                "hoist-reducer", "worm-hoist", "guided-vehicle", "strain-wave", "cycloidal-drive"})},
      {QCoreApplication::translate("DocumentFiles", "Not as they should be"),
       pathsOf({"redundant-planetary", "locked-train", "cannot-be-assembled", "robot-to-mend"})}};
  for (const QString& name : examples.entryList({QStringLiteral("*.geargraph")}, QDir::Files, QDir::Name)) {
    const QString path = examples.filePath(name);
    const auto hasIt = [&](const ExampleGroup& group) { return group.paths.contains(path); };
    if (std::none_of(groups.begin(), groups.end(), hasIt)) groups.back().paths << path;
  }
  return groups;
}

QStringList examplePaths() {
  QStringList paths;
  for (const ExampleGroup& group : exampleGroups()) paths << group.paths;
  return paths;
}

QString exampleTitle(const QString& path) {
  constexpr qint64 kHead = 600;  // bytes, in which the name is; reading all examples would take a while
  QFile file(path);
  static const QRegularExpression name(QStringLiteral(R"re("name"\s*:\s*"([^"\\]+)")re"));
  const QString head = file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.read(kHead)) : QString();
  const QRegularExpressionMatch found = name.match(head);
  return found.hasMatch() ? found.captured(1) : QFileInfo(path).completeBaseName();
}

QString robotExamplePath() {
  return QStringLiteral(":/examples/robot.geargraph");
}

}  // namespace geargraph
