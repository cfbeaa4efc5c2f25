#include "ui/recovery/open_documents.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocalServer>
#include <QLocalSocket>
#include <QPointer>
#include <QTimer>
#include <QUuid>
#include <boost/date_time/posix_time/posix_time_types.hpp>
#include <boost/interprocess/exceptions.hpp>
#include <boost/interprocess/sync/file_lock.hpp>
#include <filesystem>
#include <system_error>

#include "core/foundations/files/file_identity.h"

namespace geargraph {
namespace {

using FileLock = boost::interprocess::file_lock;

const QString kListSuffix = QStringLiteral(".json");
const QString kLockSuffix = QStringLiteral(".alive");
constexpr int kRegistryPatience = 500;  ///< ms; another program holds the lock for some system calls only
constexpr const char* kShown = "shown\n";

std::filesystem::path nativePath(const QString& path) {
  return QFile::encodeName(path).toStdString();
}

/// A lock is stale when its process has died, however old it is.
std::unique_ptr<QLockFile> lockAt(const QString& path) {
  auto lock = std::make_unique<QLockFile>(path);
  lock->setStaleLockTime(0);
  return lock;
}

/// Not a QLockFile, which waits until the disk has it: only running programs read it. Null if it cannot be
/// held.
std::unique_ptr<FileLock> heldRegistry(const QString& path) {
  namespace time = boost::posix_time;
  try {
    if (!QFile(path).open(QIODevice::ReadWrite)) return nullptr;  // it is made once, and stays
    auto lock = std::make_unique<FileLock>(nativePath(path).c_str());
    const auto end = time::microsec_clock::universal_time() + time::milliseconds(kRegistryPatience);
    return lock->timed_lock(end) ? std::move(lock) : nullptr;
  } catch (const boost::interprocess::interprocess_exception&) {
    return nullptr;  // the file system knows no locks
  }
}

}  // namespace

OpenDocuments::OpenDocuments(const QString& folder, QObject* parent)
    : QObject(parent),
      m_folder(QDir(folder).filePath(QStringLiteral("open"))),
      m_name(QUuid::createUuid().toString(QUuid::Id128)),
      m_server(new QLocalServer(this)) {
  QDir().mkpath(m_folder);
  m_alive = lockAt(QDir(m_folder).filePath(m_name + kLockSuffix));
  if (m_alive->tryLock(0)) listen();
}

OpenDocuments::~OpenDocuments() {
  QFile::remove(QDir(m_folder).filePath(m_name + kListSuffix));
}

void OpenDocuments::listen() {
  m_server->setSocketOptions(QLocalServer::UserAccessOption);
  connect(m_server, &QLocalServer::newConnection, this, &OpenDocuments::serve);
  m_server->listen(QStringLiteral("geargraph-") + m_name);
}

void OpenDocuments::serve() {
  while (QLocalSocket* socket = m_server->nextPendingConnection()) {
    connect(socket, &QLocalSocket::disconnected, socket, &QObject::deleteLater);
    const auto answer = [this, socket] {
      if (!socket->canReadLine()) return;
      const QString path = QString::fromUtf8(socket->readLine().chopped(1));
      if (m_shower && m_shower(path)) socket->write(kShown);
      socket->disconnectFromServer();
    };
    connect(socket, &QLocalSocket::readyRead, this, answer);
    answer();
  }
}

void OpenDocuments::show(const DocumentHolder& holder, QObject* context,
                         const std::function<void(bool)>& done) {
  auto* socket = new QLocalSocket(this);
  const auto isDone = std::make_shared<bool>(false);
  const auto finish = [socket, done, isDone, context = QPointer<QObject>(context)](bool shown) {
    if (std::exchange(*isDone, true)) return;
    socket->deleteLater();
    if (context) done(shown);
  };
  connect(socket, &QLocalSocket::connected, socket,
          [socket, path = holder.path] { socket->write(path.toUtf8() + '\n'); });
  connect(socket, &QLocalSocket::readyRead, socket, [socket, finish] {
    if (socket->canReadLine()) finish(socket->readLine() == kShown);
  });
  connect(socket, &QLocalSocket::disconnected, socket, [finish] { finish(false); });
  connect(
      socket, &QLocalSocket::errorOccurred, socket, [finish] { finish(false); }, Qt::QueuedConnection);
  QTimer::singleShot(kPatience, socket, [finish] { finish(false); });
  socket->connectToServer(holder.server);
}

std::vector<OpenDocuments::List> OpenDocuments::listsOfOthers() const {
  std::vector<List> lists;
  const QDir folder(m_folder);
  for (const QString& file : folder.entryList({QLatin1Char('*') + kListSuffix}, QDir::Files, QDir::Name)) {
    const QString name = file.chopped(kListSuffix.size());
    if (name == m_name) continue;
    QFile list(folder.filePath(file));
    if (!list.open(QIODevice::ReadOnly)) continue;  // its program has just ended
    const QJsonObject object = QJsonDocument::fromJson(list.readAll()).object();
    List read;
    read.program.server = object[QStringLiteral("server")].toString();
    read.program.process = object[QStringLiteral("process")].toInteger();
    for (const QJsonValue& each : object[QStringLiteral("documents")].toArray())
      read.paths << each.toString();
    if (const auto lock = lockAt(folder.filePath(name + kLockSuffix)); lock->tryLock(0)) {
      list.remove();  // its program has died
      QLocalServer::removeServer(read.program.server);
    } else {
      lists.push_back(std::move(read));
    }
  }
  return lists;
}

std::optional<DocumentHolder> OpenDocuments::holderOf(const QString& path) const {
  if (path.isEmpty()) return std::nullopt;
  for (const List& list : listsOfOthers()) {
    for (const QString& open : list.paths) {
      if (!isSameFile(nativePath(open), nativePath(path))) continue;
      DocumentHolder holder = list.program;
      holder.path = open;
      return holder;
    }
  }
  return std::nullopt;
}

std::optional<DocumentHolder> OpenDocuments::claim(const QObject* window, const QString& path) {
  // Two programs that open one document at a time must not both find it free.
  const auto registry = heldRegistry(QDir(m_folder).filePath(QStringLiteral("registry.lock")));
  auto holder = holderOf(path);
  const bool isOpen = !path.isEmpty() && !holder;
  const QString claimed = isOpen ? path : QString();
  if (m_open.value(window) == claimed) return holder;
  if (isOpen) {
    m_open[window] = path;
  } else {
    m_open.remove(window);
  }
  write();
  return holder;
}

void OpenDocuments::release(const QObject* window) {
  if (m_open.remove(window) > 0) write();
}

void OpenDocuments::write() const {
  if (!m_alive->isLocked()) return;
  const QJsonObject object{
      {QStringLiteral("server"), m_server->fullServerName()},
      {QStringLiteral("process"), QCoreApplication::applicationPid()},
      {QStringLiteral("documents"), QJsonArray::fromStringList(QStringList(m_open.values()))}};
  // Replaced by renaming, so that nobody reads half a list; not synced, as it means nothing after a power
  // cut. A list that cannot be written leaves this program's documents unknown to others: see above.
  const QString list = QDir(m_folder).filePath(m_name + kListSuffix);
  QFile fresh(list + QStringLiteral(".new"));
  const bool isWritten = fresh.open(QIODevice::WriteOnly) && fresh.write(QJsonDocument(object).toJson()) > 0;
  fresh.close();
  std::error_code error;
  if (isWritten) std::filesystem::rename(nativePath(fresh.fileName()), nativePath(list), error);
}

}  // namespace geargraph

#include "moc_open_documents.cpp"
