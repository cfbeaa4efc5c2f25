#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <optional>

#include "core/foundations/files/file_identity.h"

namespace geargraph::inline mainwindow {

/// Tells when another program writes or removes a file.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(QObject* parent = nullptr);

  /// From now on this file, as it stands now; an empty path watches nothing.
  void watch(const QString& path);
  /// The file as it stands now is known.
  void accept();
  /// Has the file been touched since it was known, or is it another one? Its bytes may be the same. A file
  /// that is gone is not foreign.
  [[nodiscard]] bool isForeign() const;

 signals:
  void changed();
  void removed();

 private:
  struct Stamp {
    qint64 size = -1;  ///< -1: there is no file
    qint64 modified = 0;
    qint64 changed = 0;  ///< ns, as above; set by the system alone, so that no program can keep it
    std::optional<FileIdentity> identity;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  [[nodiscard]] Stamp stampNow() const;
  void look();

  QFileSystemWatcher m_watcher;
  QString m_path;
  Stamp m_known;
  Stamp m_told;
};

}  // namespace geargraph::inline mainwindow
