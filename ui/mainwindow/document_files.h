#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <optional>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

class QWidget;

namespace geargraph {

/// Is it a table of a document (`geargraph-cli convert`), judged by its name: "*.csv" or "*.tsv"? A table is
/// imported, and the document is saved to a different file.
[[nodiscard]] bool isTable(const QString& path);

/// Reads a document or a table from a file or, for a path that begins with ":/", from the program's own
/// resources. A file that cannot be read gives a `syntax` diagnostic with the system's reason.
[[nodiscard]] Expected<Mechanism> readDocument(const QString& path);

/// Reads on a background thread while the window stays responsive. After `silence` ms a dialog shows `name`
/// and offers to cancel. std::nullopt if cancelled, or if the window was closed meanwhile: it is background
/// work of the window, which must not be deleted while it goes on.
[[nodiscard]] std::optional<Expected<Mechanism>> readInBackground(
    const std::function<Expected<Mechanism>()>& read, const QString& name, QWidget* window,
    int silence = 400);

/// Does readInBackground() go on for this window?
[[nodiscard]] bool isReading(const QWidget& window);

/// readDocument(), by readInBackground() for large files.
[[nodiscard]] std::optional<Expected<Mechanism>> readDocument(const QString& path, QWidget* window);

/// Writes the file atomically. std::nullopt on success, else the reason.
[[nodiscard]] std::optional<QString> writeDocument(const Mechanism& mechanism, const QString& path);

/// Examples of one kind, as the start page and File > Open example group them.
struct ExampleGroup {
  QString title;
  QStringList paths;
};

/// All examples of the program, each in one group, in the language of the window.
[[nodiscard]] std::vector<ExampleGroup> exampleGroups();

/// The examples that come with the program, as paths of its resources, group by group: the paper's robot
/// first.
[[nodiscard]] QStringList examplePaths();
[[nodiscard]] QString robotExamplePath();
/// The title of an example, read off the beginning of its file; the name of the file where it has none.
[[nodiscard]] QString exampleTitle(const QString& path);

}  // namespace geargraph
