#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline document_format {

constexpr std::size_t kLargestFile = std::size_t{64} * 1024 * 1024;
constexpr int kFileVersion = 1;

/// Reads a document (`*.geargraph`). Survives any bytes: the result is a well-formed mechanism, or every
/// problem of the file in the order of the file, with line and column: `syntax`; `format` or `version`; else
/// all of `schema` (the JSON pointer is said), `duplicate-id`, `unknown-id` and `self-joint` together.
/// Members it does not know are kept. Whether the turning joints make a tree is not asked here
/// (treeDiagnostics()): a disconnected document is still one to edit.
///
/// Identity  readMechanism(writeMechanism(m)) is m.
/// Cost      O(bytes); memory at most about 16 times the file.
[[nodiscard]] Expected<Mechanism> readMechanism(std::string_view bytes);

/// The document as readable JSON: two spaces, one element a line, every number as it was written, the members
/// of the format in their order and the unknown ones behind them.
[[nodiscard]] std::string writeMechanism(const Mechanism& mechanism);

}  // namespace geargraph::inline document_format
