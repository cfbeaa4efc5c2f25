#pragma once

#include <string>
#include <variant>

#include "core/foundations/base/expected.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::cli {

/// The document of a file, or why it is none, or why there is no such file.
[[nodiscard]] std::variant<Expected<Mechanism>, FileError> load(const std::string& path);

/// The document of a file. Where there is none, standard error says why, and the result is the exit status.
[[nodiscard]] std::variant<Mechanism, int> loadOrSay(const std::string& path);

}  // namespace geargraph::cli
