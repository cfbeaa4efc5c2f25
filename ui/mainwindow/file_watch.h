#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>

namespace geargraph {

/// Tells when another program writes or removes a file.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(QObject* parent = nullptr);

  /// From now on this file, as it stands now; an empty path watches nothing.
  void watch(const QString& path);
  /// The file as it stands now is known.
  void accept();
  /// Is the file another one than the one known? A file that is gone is not.
  [[nodiscard]] bool isForeign() const;

 signals:
  void changed();
  void removed();

 private:
  struct Stamp {
    qint64 size = -1;  ///< -1: there is no file
    QDateTime time;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  [[nodiscard]] Stamp stampNow() const;
  void look();

  QFileSystemWatcher m_watcher;
  QString m_path;
  Stamp m_known;
  Stamp m_told;
};

}  // namespace geargraph
