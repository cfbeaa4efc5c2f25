#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace geargraph {

enum class OpenMode {
  read,
  write,      ///< to an existing device or pipe
  change,     ///< to read and overwrite an existing file
  createNew,  ///< to write and read back a file that must not exist yet
};

/// The attributes that are kept when a file is replaced by another one; 0 if the system has none.
struct FileAttributes {
  std::uint64_t owner = 0;
  std::uint64_t group = 0;
  unsigned mode = 0;        ///< POSIX permissions
  std::uint64_t links = 1;  ///< number of hard links
};

/// Follows symbolic links. std::nullopt if there is no such file.
[[nodiscard]] std::optional<FileAttributes> attributesOf(const std::filesystem::path& path);

/// An open file, closed by the destructor. Every call reports its failure in `error`, which is cleared on
/// success.
class OpenFile {
 public:
  OpenFile();  ///< no file
  OpenFile(const std::filesystem::path& path, OpenMode mode, std::error_code& error);
  ~OpenFile();
  OpenFile(OpenFile&& other) noexcept;
  OpenFile& operator=(OpenFile&& other) noexcept;

  /// These are never closed.
  [[nodiscard]] static OpenFile standardInput();
  [[nodiscard]] static OpenFile standardOutput();

  [[nodiscard]] bool isOpen() const { return m_state != nullptr; }
  /// Reads at most `most` bytes; 0 at the end, or on failure.
  [[nodiscard]] std::size_t read(char* to, std::size_t most, std::error_code& error);
  /// Writes all bytes, repeating partial writes.
  void write(std::string_view bytes, std::error_code& error);
  /// Blocks until the bytes are on the disk, if the system supports it.
  void sync(std::error_code& error);
  void close(std::error_code& error);

  // For regular files only. These functions neither depend on the file position nor change it.

  /// Reads the whole file.
  [[nodiscard]] std::string contents(std::error_code& error);
  /// Replaces the content of the file, and syncs it to the disk.
  void setContents(std::string_view bytes, std::error_code& error);
  /// Reserves space, if the system supports it, for growing the file from one size to another.
  void reserve(std::size_t from, std::size_t to, std::error_code& error);
  void truncate(std::size_t size, std::error_code& error);

  /// Sets owner and group, as far as the process is permitted. Returns whether both now match.
  [[nodiscard]] bool takeOwner(const FileAttributes& wanted);
  void setMode(unsigned mode, std::error_code& error);
  /// Copies the extended attributes of another file, including access control lists, and removes others (such
  /// as a list inherited from the folder). What the file system or the permissions of the process do not
  /// allow is skipped. To be called after owner and mode are set.
  void takeExtendedAttributes(const std::filesystem::path& from);

 private:
  struct State;
  explicit OpenFile(std::unique_ptr<State> state);
  std::unique_ptr<State> m_state;  ///< null while no file is open
};

}  // namespace geargraph
