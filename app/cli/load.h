#pragma once

#include <string>
#include <variant>

#include "app/cli/command.h"
#include "core/foundations/base/expected.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::cli {

/// Reads a document: Expected holds the mechanism or the diagnostics of invalid contents, FileError why the
/// file could not be read, or that it is a table or a graph, which `convert` reads.
[[nodiscard]] std::variant<Expected<Mechanism>, FileError> load(const std::string& path);

/// The same for a command, which rejects what it does not know: FileError where the document has sliding
/// joints and the command no Command::knowsSlides.
[[nodiscard]] std::variant<Expected<Mechanism>, FileError> load(const std::string& path,
                                                                const Command& command);

/// Reads a document. On failure it reports the reason on standard error and returns the exit status.
[[nodiscard]] std::variant<Mechanism, int> loadOrSay(const std::string& path);
[[nodiscard]] std::variant<Mechanism, int> loadOrSay(const std::string& path, const Command& command);

}  // namespace geargraph::cli
