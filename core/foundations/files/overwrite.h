#pragma once

#include <filesystem>
#include <system_error>

#include "core/foundations/platform/open_file.h"

namespace geargraph {

/// The result of overwriting a file in place.
struct Overwritten {
  std::error_code error{};    ///< the first failure; none: the file has the new bytes
  bool isTargetWhole = true;  ///< false: neither the new bytes nor the old ones could be written
};

/// Overwrites a file with the bytes of another one, keeping its inode: its other names, owner and attributes.
/// Space is reserved before the first byte changes; if anything fails after that, the old bytes are written
/// back. Only a process that is killed in between leaves a mixture, so the caller keeps the source until this
/// returns. Cost: both files are read once; the old one is kept in memory.
[[nodiscard]] Overwritten overwriteInPlace(const std::filesystem::path& target, OpenFile& source);

}  // namespace geargraph
