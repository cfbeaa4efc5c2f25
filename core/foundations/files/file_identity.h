#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace geargraph {

/// The identity of a file in the file system, equal for all its symbolic and hard links.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};

/// std::nullopt if there is no file of this name, none that can be looked up, or the system has no
/// identities.
[[nodiscard]] std::optional<FileIdentity> identityOf(const std::filesystem::path& path);

/// The end of a chain of symbolic links, which need not exist; still a link if the chain is a loop.
[[nodiscard]] std::filesystem::path followedLinks(std::filesystem::path path);

/// The absolute path without ".", ".." and symbolic links, as far as the path exists.
[[nodiscard]] std::filesystem::path canonicalPath(const std::filesystem::path& path);

/// Do both paths name one file? Decided by its identity if both exist, else by the canonical paths.
/// Cost: some system calls per component.
[[nodiscard]] bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace geargraph
