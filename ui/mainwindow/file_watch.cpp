#include "ui/mainwindow/file_watch.h"

#include <QFile>
#include <QFileInfo>

#include "core/foundations/platform/system.h"

namespace geargraph {

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
  connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &FileWatch::check);
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &FileWatch::check);
}

FileWatch::Stamp FileWatch::stampNow() const {
  if (m_path.isEmpty()) return {};
  const auto stamp = fileStamp(QFile::encodeName(m_path).toStdString());
  if (!stamp) return {};
  std::optional<FileIdentity> identity;
  if (stamp->numbers) identity = FileIdentity{stamp->numbers->device, stamp->numbers->inode};
  return {static_cast<qint64>(stamp->size), stamp->modified, stamp->changed, identity};
}

void FileWatch::watch(const QString& path) {
  const QStringList old = m_watcher.files() + m_watcher.directories();
  if (!old.isEmpty()) m_watcher.removePaths(old);
  m_path = path;
  accept();
  // The folder tells of files that take the name of the old one, as most programs save.
  if (!path.isEmpty()) m_watcher.addPaths({path, QFileInfo(path).absolutePath()});
}

void FileWatch::accept() {
  m_known = stampNow();
  m_told = m_known;
}

bool FileWatch::isForeign() const {
  const Stamp now = stampNow();
  return now.size >= 0 && now != m_known;
}

void FileWatch::check() {
  const Stamp now = stampNow();
  if (now.size >= 0 && !m_watcher.files().contains(m_path)) m_watcher.addPath(m_path);
  if (now == m_told) return;
  m_told = now;
  if (now.size < 0) {
    emit removed();
  } else if (now != m_known) {
    emit changed();
  }
}

}  // namespace geargraph

#include "moc_file_watch.cpp"
