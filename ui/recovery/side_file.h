#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline recovery {

/// What a side file says about itself.
struct SideNote {
  QString filePath;  ///< of the document; empty: it had no file yet
  QString title;     ///< what its window called it
  int edits = 0;     ///< since it was saved last
  QDateTime savedAt;
};

/// A document as it stood in its side file.
struct SideDocument {
  SideNote note;
  Mechanism mechanism;
};

/// The bytes of a side file: a document like any other, with the note as a member "autosave" behind the
/// members of the format, so that every program that reads documents can read it.
[[nodiscard]] std::string sideFileBytes(const Mechanism& mechanism, const SideNote& note);

/// Where unsaved changes are kept while a program runs, so that a crash does not take them. It belongs to who
/// holds it: a lock file beside it bears the number of the process, and one that has died holds nothing.
class SideFile {
 public:
  /// Takes hold of the side file of this name, whether it exists or not. Null where a living process holds
  /// it, or where no file can be made.
  [[nodiscard]] static std::unique_ptr<SideFile> hold(const QString& path);

  [[nodiscard]] const QString& path() const { return m_path; }
  [[nodiscard]] bool exists() const;
  /// What stands in it. Nothing where it cannot be read.
  [[nodiscard]] std::optional<SideDocument> read() const;
  void remove();

 private:
  explicit SideFile(QString path);

  QString m_path;
  QLockFile m_lock;
};

using SideFiles = std::vector<std::unique_ptr<SideFile>>;

/// The names that the side file of a document may have, the best first: beside the document, else in
/// `folder`; a document without a file has it in `folder`.
[[nodiscard]] QStringList sidePathsOf(const QString& filePath, const QString& folder);

/// A side file for this document that nobody holds and that is not there yet. Null where none can be made.
[[nodiscard]] std::unique_ptr<SideFile> freshSideFile(const QString& filePath, const QString& folder);

/// The side files that were left by programs that ended without saving or giving up: of this document, or all
/// in `folder` and beside these documents. What a living process holds is not among them.
[[nodiscard]] SideFiles leftBehindOf(const QString& filePath, const QString& folder);
[[nodiscard]] SideFiles leftBehind(const QString& folder, const QStringList& documents);

}  // namespace geargraph::inline recovery
