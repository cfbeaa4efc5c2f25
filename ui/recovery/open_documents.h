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

namespace geargraph::inline recovery {

/// Another running program that has a document open.
struct DocumentHolder {
  QString server;  ///< where it listens
  QString path;    ///< of the document, as it opened it
  qint64 process = 0;
};

/// Which documents the running programs of this user have open, so that only one of them writes each: every
/// program keeps a list in a common folder, locked while it lives, and listens for requests to show a window.
/// Lists of programs that have died are removed. Documents are the same if isSameFile() holds, whatever
/// their spelling and links. A folder that cannot be written to holds no lists: then nothing is known of
/// other programs, and only the watch on the file (FileWatch) protects it.
class OpenDocuments : public QObject {
  Q_OBJECT

 public:
  explicit OpenDocuments(const QString& folder, QObject* parent = nullptr);
  ~OpenDocuments() override;

  /// The other program that has this document open. Cost: a read per running program, two look-ups per
  /// document that is open.
  [[nodiscard]] std::optional<DocumentHolder> holderOf(const QString& path) const;
  /// From now on the window has this document open, instead of its last one, unless another program has;
  /// then nothing is claimed and that program is returned. An empty path claims nothing.
  std::optional<DocumentHolder> claim(const QObject* window, const QString& path);
  void release(const QObject* window);

  /// Asks a program to show the window with its document; `done` is called later, with false if it has not
  /// answered within kPatience.
  void show(const DocumentHolder& holder, QObject* context, const std::function<void(bool)>& done);
  static constexpr int kPatience = 2000;  ///< ms

  /// Shows the window with the document that another program asks for; false if there is none.
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

}  // namespace geargraph::inline recovery
