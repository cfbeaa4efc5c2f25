#include "ui/mainwindow/document_files.h"

#include <QDir>
#include <QFile>

#include "core/io/file.h"
#include "core/io/matrix_csv.h"
#include "core/io/mechanism_file.h"

namespace geargraph {
namespace {

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
  return readMechanism(std::get<std::string>(bytes));
}

std::optional<QString> writeDocument(const Mechanism& mechanism, const QString& path) {
  return reason(writeFile(nativePath(path), writeMechanism(mechanism)));
}

std::optional<QString> exportMatrixCsv(const IntegerMatrix& matrix, const QString& path) {
  AtomicFile file(nativePath(path));
  writeMatrixCsv<MatrixEntry, UniformRow>(file, matrix);
  return reason(file.commit());
}

std::optional<QString> writeText(const std::string& text, const QString& path) {
  return reason(writeFile(nativePath(path), text));
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

}  // namespace geargraph
