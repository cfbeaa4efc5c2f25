#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace geargraph::inline platform {

enum class OpenMode {
  read,
  write,      ///< to a device or pipe that is there
  change,     ///< to read and overwrite a file that is there
  createNew,  ///< to write and read back a file that must not be there
};

/// What a file keeps when another one takes its place. Where the system has no such thing, 0.
struct FileAttributes {
  std::uint64_t owner = 0;
  std::uint64_t group = 0;
  unsigned mode = 0;        ///< permissions, as of POSIX
  std::uint64_t links = 1;  ///< names of the file
};

/// Follows symbolic links. std::nullopt where there is no such file.
[[nodiscard]] std::optional<FileAttributes> attributesOf(const std::filesystem::path& path);

/// A file that is open, by the calls of the system; closed when it goes. Every call reports its failure in
/// `error`, which is cleared on success.
class OpenFile {
 public:
  OpenFile();  ///< none
  OpenFile(const std::filesystem::path& path, OpenMode mode, std::error_code& error);
  ~OpenFile();
  OpenFile(OpenFile&& other) noexcept;
  OpenFile& operator=(OpenFile&& other) noexcept;

  /// These are never closed.
  [[nodiscard]] static OpenFile standardInput();
  [[nodiscard]] static OpenFile standardOutput();

  [[nodiscard]] bool isOpen() const { return m_state != nullptr; }
  /// At most `most` bytes; 0 at the end, or where it failed.
  [[nodiscard]] std::size_t read(char* to, std::size_t most, std::error_code& error);
  /// All bytes, however often the system takes only some of them.
  void write(std::string_view bytes, std::error_code& error);
  /// Until the bytes are on the disk, where the system can tell.
  void sync(std::error_code& error);
  void close(std::error_code& error);

  // Of regular files. None of them depends on how far the file was read or written, nor changes it.

  /// All bytes, from the first.
  [[nodiscard]] std::string contents(std::error_code& error);
  /// Makes the file these bytes and no others, on the disk.
  void setContents(std::string_view bytes, std::error_code& error);
  /// Makes sure, where the system can, that the file can grow from one size to another.
  void reserve(std::size_t from, std::size_t to, std::error_code& error);
  void truncate(std::size_t size, std::error_code& error);

  /// Gives the file this owner and group, as far as the process may. Returns whether both are now these.
  [[nodiscard]] bool takeOwner(const FileAttributes& wanted);
  void setMode(unsigned mode, std::error_code& error);
  /// Gives the file the extended attributes of another one, access control lists among them, and takes those
  /// away that it does not have (such as a list inherited from the folder). What the file system or the
  /// permissions of the process do not allow is left out. Call it after the owner and the mode are set.
  void takeExtendedAttributes(const std::filesystem::path& from);

 private:
  struct State;
  explicit OpenFile(std::unique_ptr<State> state);
  std::unique_ptr<State> m_state;  ///< none while nothing is open
};

}  // namespace geargraph::inline platform
