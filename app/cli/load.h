#pragma once

#include <string>
#include <variant>

#include "core/foundations/base/expected.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::cli {

/// Reads a document: Expected holds the mechanism or the diagnostics of invalid contents, FileError why the
/// file could not be read, or that it is a table or a graph, which `convert` reads.
[[nodiscard]] std::variant<Expected<Mechanism>, FileError> load(const std::string& path);

/// Reads a document. On failure it reports the reason on standard error and returns the exit status.
[[nodiscard]] std::variant<Mechanism, int> loadOrSay(const std::string& path);

}  // namespace geargraph::cli
