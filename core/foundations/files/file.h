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

namespace geargraph {

/// Why a file could not be read or written, as a sentence for the user. No diagnostic, because it does not
/// concern a document.
struct FileError {
  std::string message;
};

/// The bytes of a file, or of standard input for the path "-". Reads at most `most` + 1 bytes, so that a
/// caller can reject longer files without reading them completely.
[[nodiscard]] std::variant<std::string, FileError> readFile(const std::filesystem::path& path,
                                                            std::size_t most);

/// Writes a file atomically: bytes go to a temporary file in the same folder, which replaces the file at
/// commit(), after they are on the disk. Without commit(), or on failure, the temporary file is deleted and
/// the old file stays untouched. Owner, permissions and extended attributes are kept.
///
/// A symbolic link stays one: what it points to is replaced. A device or pipe is written to directly.
///
/// A file with several hard links, or whose owner the process may not give to a new one, is overwritten in
/// place instead, because a new inode would lose them. Meanwhile a complete copy of the new bytes is in a
/// second file in its folder; a process that is killed then leaves it there (interruptedWrites()).
class AtomicFile final : public ByteSink {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile() override;

  void write(std::string_view bytes) override;
  [[nodiscard]] bool failed() const override { return m_error.has_value(); }
  /// Replaces the file. std::nullopt on success, else the first failure.
  [[nodiscard]] std::optional<FileError> commit();

 private:
  void openTemporary();
  void takeAttributes();
  void replace();
  void overwrite();
  /// Stores the first failure as a sentence, with `more` appended.
  void fail(const std::error_code& what, const std::string& more = {});
  void discard();

  std::filesystem::path m_shown;  ///< as the user named it
  std::filesystem::path m_target;
  std::filesystem::path m_temporary;  ///< empty while there is none
  OpenFile m_file;
  bool m_isInPlace = false;
  unsigned m_mode = 0;  ///< permissions of the existing file; used if m_isInPlace
  std::optional<FileError> m_error;
};

/// Writes to standard output, which stays open.
class StandardOutput final : public ByteSink {
 public:
  void write(std::string_view bytes) override;
  [[nodiscard]] bool failed() const override { return m_failed; }

 private:
  OpenFile m_file = OpenFile::standardOutput();
  bool m_failed = false;
};

/// The complete copies left behind by processes that were killed while overwriting this file in place; the
/// file itself may then be a mixture of old and new bytes. Cost: lists the folder.
[[nodiscard]] std::vector<std::filesystem::path> interruptedWrites(const std::filesystem::path& path);

/// Writes a file atomically in one call; std::nullopt on success.
[[nodiscard]] std::optional<FileError> writeFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace geargraph
