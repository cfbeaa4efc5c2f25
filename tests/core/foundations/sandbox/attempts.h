#pragma once

#include <string>

namespace geargraph::test {

/// Tries what a hostile file would make its reader do: open, write, start, connect, kill, ... A line
/// "<name> allowed" or "<name> <error>" per attempt ("EPERM", "EACCES", ...), in a fixed order, and the line
/// "end". Attempts that succeed are undone where they can be (children end, files go), so that the same code
/// is its own control outside of a sandbox. `folder` must be writable; it is left as it was.
[[nodiscard]] std::string hostileAttempts(const std::string& folder);

}  // namespace geargraph::test
