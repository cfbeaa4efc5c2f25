#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

#include "core/foundations/files/byte_sink.h"
#include "core/foundations/platform/open_file.h"

namespace geargraph::inline files {

/// Why a file could not be read or written, as a sentence for its user. No diagnostic: nothing is wrong with
/// a document.
struct FileError {
  std::string message;
};

/// The bytes of a file, or of standard input for the path "-". Reads no more than `most` + 1 bytes, so that
/// whoever refuses what is longer need not hold it.
[[nodiscard]] std::variant<std::string, FileError> readFile(const std::filesystem::path& path,
                                                            std::size_t most);

/// A file that is written whole or not at all: bytes go to a temporary file in the same folder, which
/// replaces the file at commit(), after they are on the disk. Without commit(), or if anything failed, the
/// temporary file goes and what was there before stays untouched. Owner, permissions and extended attributes
/// are kept.
///
/// A symbolic link stays one: what it points to is replaced. A device or pipe is written to directly.
///
/// A file with several hard links, or whose owner the process may not give to a new one, is overwritten in
/// place instead, since a new inode would leave them behind. Until that is done its new bytes are whole in a
/// second file in its folder; a process that is killed in that moment leaves it there (interruptedWrites()).
class AtomicFile final : public ByteSink {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile() override;

  void write(std::string_view bytes) override;
  [[nodiscard]] bool failed() const override { return m_error.has_value(); }
  /// Nothing where all went well, else the first thing that went wrong.
  [[nodiscard]] std::optional<FileError> commit();

 private:
  void openTemporary();
  void takeAttributes();
  void replace();
  void overwrite();
  /// Keeps the first failure as a sentence; `more` is added to it.
  void fail(const std::error_code& what, const std::string& more = {});
  void discard();

  std::filesystem::path m_shown;  ///< as the user named it
  std::filesystem::path m_target;
  std::filesystem::path m_temporary;  ///< empty while there is none
  OpenFile m_file;
  bool m_isInPlace = false;
  unsigned m_mode = 0;  ///< permissions of the file that is there; used if m_isInPlace
  std::optional<FileError> m_error;
};

/// Bytes to standard output, which stays open.
class StandardOutput final : public ByteSink {
 public:
  void write(std::string_view bytes) override;
  [[nodiscard]] bool failed() const override { return m_failed; }

 private:
  OpenFile m_file = OpenFile::standardOutput();
  bool m_failed = false;
};

/// The whole copies that processes have left which were killed while they overwrote this file in place: then
/// the file itself may be a mixture of old and new bytes. Cost: its folder is listed.
[[nodiscard]] std::vector<std::filesystem::path> interruptedWrites(const std::filesystem::path& path);

/// A whole file in one call.
[[nodiscard]] std::optional<FileError> writeFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace geargraph::inline files
