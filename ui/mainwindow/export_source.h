#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <string_view>

#include "core/presentation/exporters/export_context.h"

namespace geargraph {

/// The document that is exported, as its window knows it.
struct ExportedDocument {
  QString file;   ///< its path; empty: it has none yet
  QString title;  ///< its name with or without a suffix; files are proposed under it

  [[nodiscard]] QString stem() const;
};

/// What an export says while it runs: notes for the user, and the first error of the mechanism.
struct HeardFromExport {
  QStringList notes;
  QString error;
};
using HeardFromExportPtr = std::shared_ptr<HeardFromExport>;

/// A source for one export, which may run on another thread. `snapshot`: a complete analysis, or null.
[[nodiscard]] ExportSource exportSourceOf(const MechanismPtr& mechanism, const SnapshotPtr& snapshot,
                                          const ExportedDocument& document, const HeardFromExportPtr& heard);
/// A text of core in the language of the window; empty stays empty.
[[nodiscard]] QString spoken(std::string_view text);
/// Why nothing was written, as a sentence in the words of the window.
[[nodiscard]] QString reasonOf(const ExportError& error, const HeardFromExport& heard);
/// A sentence with the titles of options in the place of their names on the command line.
[[nodiscard]] QString inWindowWords(const std::string& sentence);
/// The name of the file or folder that an exporter is proposed to write: "robot.stl", "robot-mjcf".
[[nodiscard]] QString proposedName(const Exporter& exporter, const ExportedDocument& document);

}  // namespace geargraph
