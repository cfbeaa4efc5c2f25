#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

namespace geargraph {

/// "Linux", or "portable" for the fallback with the standard library only.
[[nodiscard]] std::string_view platformName();

/// A number above 0 that no other running process has. Portable version: drawn at random once, so unique with
/// high probability.
[[nodiscard]] int processId();
/// Is there a process with this number? Portable version: only this one is known.
[[nodiscard]] bool isProcessRunning(int id);
/// The path of this program; empty if the system does not tell.
[[nodiscard]] std::filesystem::path programPath();

/// Lowers the priority of the calling thread, for background work: it uses processor time that others leave,
/// without starving. Portable version: no effect.
void lowerThreadPriority();

/// May this process write to the file? If not, `error` has the reason.
[[nodiscard]] bool isWritable(const std::filesystem::path& path, std::error_code& error);
/// Syncs a folder to the disk, so that new names in it survive a power failure; errors are ignored. Portable
/// version: no effect.
void syncFolder(const std::filesystem::path& folder);

/// The identity of a file in the file system, independent of its names.
struct FileNumbers {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
};

/// The data by which a change of a file is detected.
struct FileStamp {
  std::uint64_t size = 0;
  std::int64_t modified = 0;  ///< ns, since an epoch that is the same for all files
  std::int64_t changed = 0;   ///< ns, set by the system only; no program can preserve it. Portable: 0
  std::optional<FileNumbers> numbers{};  ///< portable: none
};
/// Follows symbolic links. std::nullopt where there is no such file.
[[nodiscard]] std::optional<FileStamp> fileStamp(const std::filesystem::path& path);

}  // namespace geargraph
