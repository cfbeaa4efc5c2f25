#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <optional>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

class QWidget;

namespace geargraph::inline mainwindow {

/// Is it a table of a document (`geargraph-cli convert`), by its name: "*.csv" or "*.tsv"? A table is
/// imported, and the document saved to a file of its own.
[[nodiscard]] bool isTable(const QString& path);

/// Reads a document or a table from a file or, for a path that begins with ":/", from the program's own
/// resources. A file that cannot be read at all is a `syntax` finding with the system's reason.
[[nodiscard]] Expected<Mechanism> readDocument(const QString& path);

/// Reads on a thread while the window goes on painting. After a silence (ms) a dialog says what is read, and
/// offers to cancel. Nothing where it was cancelled, or the window closed meanwhile.
[[nodiscard]] std::optional<Expected<Mechanism>> readPatiently(
    const std::function<Expected<Mechanism>()>& read, const QString& name, QWidget* window,
    int silence = 400);

/// readDocument(), patiently where the file is so large that it takes longer than some frames.
[[nodiscard]] std::optional<Expected<Mechanism>> readDocument(const QString& path, QWidget* window);

/// Writes whole or not at all. Nothing where all went well, else why not.
[[nodiscard]] std::optional<QString> writeDocument(const Mechanism& mechanism, const QString& path);

/// The examples that come with the program, as paths of its resources: the paper's robot first, then
/// from the simple to the strange.
[[nodiscard]] QStringList examplePaths();
[[nodiscard]] QString robotExamplePath();

}  // namespace geargraph::inline mainwindow
