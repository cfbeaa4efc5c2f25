#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <optional>

#include "core/foundations/files/file_identity.h"

namespace geargraph {

/// Signals when another program writes or removes a file.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(QObject* parent = nullptr);

  /// Watches this file from its present state; an empty path watches nothing.
  void watch(const QString& path);
  /// Accepts the present state of the file as known.
  void accept();
  /// Has the file been modified or replaced since it was known? Its content may be the same. A deleted file
  /// is not foreign.
  [[nodiscard]] bool isForeign() const;

 signals:
  void changed();
  void removed();

 private:
  struct Stamp {
    qint64 size = -1;  ///< -1: there is no file
    qint64 modified = 0;
    qint64 changed = 0;  ///< ns; set by the system only, so programs cannot preserve it
    std::optional<FileIdentity> identity;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  [[nodiscard]] Stamp stampNow() const;
  void check();

  QFileSystemWatcher m_watcher;
  QString m_path;
  Stamp m_known;
  Stamp m_told;
};

}  // namespace geargraph
