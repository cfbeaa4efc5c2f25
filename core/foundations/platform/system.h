#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

namespace geargraph::inline platform {

/// "Linux", or "portable" for the fallback that knows the standard library only.
[[nodiscard]] std::string_view platformName();

/// A number above 0 that no other running process has. Portable: drawn at random once, so very likely.
[[nodiscard]] int processId();
/// Is there a process of this number? Portable: only this one is known.
[[nodiscard]] bool isProcessRunning(int id);
/// Where this program is. Empty where the system does not tell.
[[nodiscard]] std::filesystem::path programPath();

/// From now on the calling thread takes of the processors what others leave: for work that is not waited for
/// while there is other work. It still gets on where others never rest. Portable: nothing.
void lowerThreadPriority();

/// May this process write to the file? `error` tells why not.
[[nodiscard]] bool isWritable(const std::filesystem::path& path, std::error_code& error);
/// So that new names in the folder survive a power cut; what cannot be done is left out. Portable: nothing.
void syncFolder(const std::filesystem::path& folder);

/// What the system knows a file by, whatever its names.
struct FileNumbers {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
};

/// By what a change of a file shows.
struct FileStamp {
  std::uint64_t size = 0;
  std::int64_t modified = 0;  ///< ns, since a moment that is the same for all files
  std::int64_t changed = 0;   ///< ns, set by the system alone, so that no program can keep it. Portable: 0
  std::optional<FileNumbers> numbers{};  ///< portable: none
};
/// Follows symbolic links. std::nullopt where there is no such file.
[[nodiscard]] std::optional<FileStamp> fileStamp(const std::filesystem::path& path);

}  // namespace geargraph::inline platform
