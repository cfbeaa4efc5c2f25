#include "ui/mainwindow/document_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QFutureWatcher>
#include <QPointer>
#include <QProgressDialog>
#include <QPromise>
#include <QThreadPool>
#include <QTimer>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_table.h"

namespace geargraph::inline mainwindow {
namespace {

/// A file of so many bytes is read within a frame or two (3 MB: 0.1 to 0.2 s).
constexpr qint64 kReadAtOnce = 200'000;

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
  const QPointer<QWidget> open(window);
  QEventLoop loop;
  QFutureWatcher<ReadResult> watcher;
  QObject::connect(&watcher, &QFutureWatcherBase::finished, &loop, &QEventLoop::quit);
  watcher.setFuture(onThread(read));
  QTimer::singleShot(silence, &loop, &QEventLoop::quit);
  loop.exec(QEventLoop::ExcludeUserInputEvents);
  if (!watcher.isFinished() && open) {
    // The window owns it and may be deleted while the loop runs, with it.
    const QPointer<QProgressDialog> dialog =
        new QProgressDialog(QCoreApplication::translate("DocumentFiles", "Reading %1 …").arg(name),
                            QCoreApplication::translate("DocumentFiles", "Cancel"), 0, 0, window);
    dialog->setWindowModality(Qt::WindowModal);
    QObject::connect(dialog, &QProgressDialog::canceled, &loop, &QEventLoop::quit);
    QObject::connect(window, &QObject::destroyed, &loop, &QEventLoop::quit);
    dialog->show();
    loop.exec();
    delete dialog;
  }
  if (!watcher.isFinished() || !open) return std::nullopt;
  return std::move(*watcher.result());
}

std::optional<Expected<Mechanism>> readDocument(const QString& path, QWidget* window) {
  if (QFileInfo(path).size() < kReadAtOnce) return readDocument(path);
  return readInBackground([path] { return readDocument(path); }, QFileInfo(path).fileName(), window);
}

std::optional<QString> writeDocument(const Mechanism& mechanism, const QString& path) {
  return reason(writeFile(nativePath(path), writeMechanism(mechanism)));
}

QStringList examplePaths() {
  // From the simple to the strange; what is not named here comes last.
  const QDir examples(QStringLiteral(":/examples"));
  QStringList paths{robotExamplePath()};
  for (const char* name : {"spur-pair", "reverted-train", "planetary-ring-held", "three-planets",
                           "bevel-differential", "simpson", "ravigneaux", "eight-speed-gearbox",
                           "humpage-reduction", "bevel-wrist", "three-roll-wrist", "ferguson-paradox",
                           "redundant-planetary", "locked-train", "cannot-be-assembled", "robot-to-mend"}) {
    const QString path = examples.filePath(QLatin1String(name) + QStringLiteral(".geargraph"));
    if (QFile::exists(path)) paths << path;
  }
  for (const QString& name : examples.entryList({QStringLiteral("*.geargraph")}, QDir::Files, QDir::Name)) {
    const QString path = examples.filePath(name);
    if (!paths.contains(path)) paths << path;
  }
  return paths;
}

QString robotExamplePath() {
  return QStringLiteral(":/examples/robot.geargraph");
}

}  // namespace geargraph::inline mainwindow
