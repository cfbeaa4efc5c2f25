#pragma once

#include <filesystem>

namespace geargraph::inline files {

/// What became of a file that was to be overwritten in place.
struct Overwritten {
  int error = 0;              ///< errno of what failed first; 0: the file has the new bytes
  bool isTargetWhole = true;  ///< false: neither the new bytes nor the old ones could be written
};

/// Overwrites a file with the bytes of another one (an open descriptor) and keeps its inode: its other names,
/// owner and attributes. Space is reserved before the first byte changes; if anything fails after that, the
/// old bytes are written back. Only a process that is killed in between leaves a mixture, so the caller keeps
/// the source until this returns.
/// Cost: both files are read once; the old one is held in memory.
[[nodiscard]] Overwritten overwriteInPlace(const std::filesystem::path& target, int source);

}  // namespace geargraph::inline files
