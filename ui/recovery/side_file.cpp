#include "ui/recovery/side_file.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph {
namespace {

constexpr const char* kMember = "autosave";
constexpr int kMaxSideFiles = 99;  ///< of documents without a file, or of one document in several programs

std::filesystem::path nativePath(const QString& path) {
  return QFile::encodeName(path).toStdString();
}

/// Bytes that a killed process was writing, under the name of AtomicFile's temporary files.
void removeTorn(const QString& path) {
  const QFileInfo info(path);
  QDir folder = info.dir();
  const QString pattern = QStringLiteral(".%1.*.tmp").arg(info.fileName());
  for (const QString& torn : folder.entryList({pattern}, QDir::Files | QDir::Hidden)) folder.remove(torn);
}

SideNote noteFrom(const std::string& json) {
  const QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
  return {object[QStringLiteral("file")].toString(), object[QStringLiteral("title")].toString(),
          object[QStringLiteral("edits")].toInt(),
          QDateTime::fromString(object[QStringLiteral("time")].toString(), Qt::ISODate)};
}

void addHeld(SideFiles& held, const QString& path) {
  if (!QFileInfo::exists(path)) return;
  if (auto side = SideFile::hold(path); side && side->exists()) held.push_back(std::move(side));
}

}  // namespace

std::string sideFileBytes(const Mechanism& mechanism, const SideNote& note) {
  const QJsonObject object{{QStringLiteral("file"), note.filePath},
                           {QStringLiteral("title"), note.title},
                           {QStringLiteral("edits"), note.edits},
                           {QStringLiteral("time"), note.savedAt.toString(Qt::ISODate)}};
  Mechanism noted = mechanism;
  noted.unknown.emplace_back(kMember, QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString());
  return writeMechanism(noted);
}

SideFile::SideFile(QString path) : m_path(std::move(path)), m_lock(m_path + QStringLiteral(".lock")) {
  m_lock.setStaleLockTime(0);  // a lock is stale when its process has died, however old it is
}

std::unique_ptr<SideFile> SideFile::hold(const QString& path) {
  std::unique_ptr<SideFile> side(new SideFile(path));
  if (!side->m_lock.tryLock(0)) return nullptr;
  removeTorn(path);
  return side;
}

bool SideFile::exists() const {
  return QFileInfo::exists(m_path);
}

std::optional<SideDocument> SideFile::read() const {
  const auto bytes = readFile(nativePath(m_path), kLargestFile);
  if (!std::holds_alternative<std::string>(bytes)) return std::nullopt;
  Expected<Mechanism> mechanism = readMechanism(std::get<std::string>(bytes));
  if (!mechanism) return std::nullopt;
  SideDocument document{{}, std::move(mechanism).value()};
  auto& unknown = document.mechanism.unknown;
  const auto note =
      std::find_if(unknown.begin(), unknown.end(), [](const auto& each) { return each.first == kMember; });
  if (note == unknown.end()) return std::nullopt;
  document.note = noteFrom(note->second);
  unknown.erase(note);
  return document;
}

void SideFile::remove() {
  QFile::remove(m_path);
}

QStringList sidePathsOf(const QString& filePath, const QString& folder) {
  QStringList paths;
  QString name = QStringLiteral("untitled");
  if (!filePath.isEmpty()) {
    const QFileInfo file(filePath);
    paths << file.dir().filePath(QStringLiteral(".%1.autosave").arg(file.fileName()));
    const QByteArray key =
        QCryptographicHash::hash(file.absoluteFilePath().toUtf8(), QCryptographicHash::Sha1);
    name = QString::fromLatin1(key.toHex().left(16));
  }
  for (int i = 1; i <= kMaxSideFiles; ++i) {
    paths << QDir(folder).filePath(QStringLiteral("%1-%2.geargraph").arg(name).arg(i));
  }
  return paths;
}

std::unique_ptr<SideFile> freshSideFile(const QString& filePath, const QString& folder) {
  QDir().mkpath(folder);
  for (const QString& path : sidePathsOf(filePath, folder)) {
    if (QFileInfo::exists(path)) continue;
    if (auto side = SideFile::hold(path)) {
      if (!side->exists()) return side;
    }
  }
  return nullptr;
}

SideFiles recoverableFilesOf(const QString& filePath, const QString& folder) {
  SideFiles held;
  for (const QString& path : sidePathsOf(filePath, folder)) addHeld(held, path);
  return held;
}

SideFiles recoverableFiles(const QString& folder, const QStringList& documents) {
  SideFiles held;
  const QDir all(folder);
  for (const QString& name : all.entryList({QStringLiteral("*.geargraph")}, QDir::Files, QDir::Name)) {
    addHeld(held, all.filePath(name));
  }
  for (const QString& document : documents) addHeld(held, sidePathsOf(document, folder).front());
  return held;
}

}  // namespace geargraph
