#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The metadata of a side file.
struct SideNote {
  QString filePath;  ///< of the document; empty: it had no file yet
  QString title;     ///< as in its window
  int edits = 0;     ///< number of edits since it was last saved
  QDateTime savedAt;
};

/// A document read from a side file.
struct SideDocument {
  SideNote note;
  Mechanism mechanism;
};

/// The bytes of a side file: a document like any other, with the note as an additional last member
/// "autosave", so that every program that reads documents can read it.
[[nodiscard]] std::string sideFileBytes(const Mechanism& mechanism, const SideNote& note);

/// A file that holds unsaved changes while a program runs, so that they survive a crash. A process owns it by
/// a lock file beside it with its process id; locks of terminated processes are void.
class SideFile {
 public:
  /// Locks the side file of this name, whether it exists or not. Null if a running process owns it, or if no
  /// file can be created.
  [[nodiscard]] static std::unique_ptr<SideFile> hold(const QString& path);

  [[nodiscard]] const QString& path() const { return m_path; }
  [[nodiscard]] bool exists() const;
  /// Reads it; std::nullopt if that fails.
  [[nodiscard]] std::optional<SideDocument> read() const;
  void remove();

 private:
  explicit SideFile(QString path);

  QString m_path;
  QLockFile m_lock;
};

using SideFiles = std::vector<std::unique_ptr<SideFile>>;

/// The paths that the side file of a document may have, in order of preference: beside the document, then in
/// `folder`; only in `folder` for a document without a file.
[[nodiscard]] QStringList sidePathsOf(const QString& filePath, const QString& folder);

/// A new, locked side file for this document. Null if none can be created.
[[nodiscard]] std::unique_ptr<SideFile> freshSideFile(const QString& filePath, const QString& folder);

/// The side files left by programs that ended without saving or discarding: of this document, or all in
/// `folder` and beside these documents. Those owned by a running process are not included.
[[nodiscard]] SideFiles recoverableFilesOf(const QString& filePath, const QString& folder);
[[nodiscard]] SideFiles recoverableFiles(const QString& folder, const QStringList& documents);

}  // namespace geargraph
