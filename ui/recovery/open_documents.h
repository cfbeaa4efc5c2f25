#pragma once

#include <QHash>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QLocalServer;

namespace geargraph {

/// Another running program that has a document open.
struct DocumentHolder {
  QString server;  ///< name of its local socket
  QString path;    ///< of the document, as that program opened it
  qint64 process = 0;
};

/// The documents that all running programs of this user have open, so that only one program writes each.
/// Every program keeps a list in a common folder, locked while the program runs, and listens for requests to
/// show a window. Lists of terminated programs are removed. Paths are of the same document if isSameFile()
/// holds. If the folder is not writable nothing is known of other programs, and only FileWatch protects the
/// files.
class OpenDocuments : public QObject {
  Q_OBJECT

 public:
  explicit OpenDocuments(const QString& folder, QObject* parent = nullptr);
  ~OpenDocuments() override;

  /// The other program that has this document open. Cost: one read per running program, two look-ups per open
  /// document.
  [[nodiscard]] std::optional<DocumentHolder> holderOf(const QString& path) const;
  /// Registers this document for the window, in place of its former one. If another program has it open
  /// nothing is registered, and that program is returned. An empty path registers nothing.
  std::optional<DocumentHolder> claim(const QObject* window, const QString& path);
  void release(const QObject* window);

  /// Asks a program to show the window with its document. `done` is called later, with false if the program
  /// has not answered within kPatience; never if `context` is destroyed before.
  void show(const DocumentHolder& holder, QObject* context, const std::function<void(bool)>& done);
  static constexpr int kPatience = 2000;  ///< ms

  /// Sets the function that shows the window with the document that another program asks for; it returns
  /// false if there is none.
  void setShower(std::function<bool(const QString& path)> shower) { m_shower = std::move(shower); }

 private:
  struct List {
    DocumentHolder program;  ///< without a path
    QStringList paths;
  };
  [[nodiscard]] std::vector<List> listsOfOthers() const;
  void write() const;
  void listen();
  void serve();

  QString m_folder;
  QString m_name;  ///< of this program's list, without a suffix
  std::unique_ptr<QLockFile> m_alive;
  QLocalServer* m_server;
  QHash<const QObject*, QString> m_open;
  std::function<bool(const QString&)> m_shower;
};

}  // namespace geargraph
