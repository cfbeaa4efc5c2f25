#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Bytes; larger files are rejected.
constexpr std::size_t kLargestFile = std::size_t{64} * 1024 * 1024;
/// The newest version that is read; documents are written with the oldest one that they need
/// (file_version.h).
constexpr int kFileVersion = 2;

/// Reads a document (`*.geargraph`). Accepts any bytes: the result is a well-formed mechanism, or every
/// problem of the file in its order, with line and column: `syntax`; `format` or `version`; else all of
/// `schema` (with the JSON pointer), `duplicate-id`, `unknown-id` and `self-joint` together. Unknown members
/// are kept. Whether the turning joints form a tree is not checked here (treeDiagnostics()): a disconnected
/// document can still be edited.
///
/// Identity  readMechanism(writeMechanism(m)) is m.
/// Cost      O(bytes); memory at most about 16 times the file.
[[nodiscard]] Expected<Mechanism> readMechanism(std::string_view bytes);

/// The document as readable JSON: indented by two spaces, one element per line, every number as it was
/// written, the members of the format in their order, followed by the unknown ones.
[[nodiscard]] std::string writeMechanism(const Mechanism& mechanism);

}  // namespace geargraph
