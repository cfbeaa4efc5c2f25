#include "core/foundations/files/file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <system_error>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/file_identity.h"
#include "core/foundations/files/overwrite.h"
#include "core/foundations/platform/system.h"

namespace geargraph {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) {
  return "\"" + path.string() + "\"";
}

fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// What the name of a temporary file shows of the file's own.
std::string shortName(const fs::path& path) {
  return path.filename().string().substr(0, 100);
}

constexpr const char* kInterruptedSuffix = ".saving";

}  // namespace

std::variant<std::string, FileError> readFile(const fs::path& path, std::size_t most) {
  const bool isStandardInput = path == "-";
  std::error_code error;
  OpenFile file = isStandardInput ? OpenFile::standardInput() : OpenFile(path, OpenMode::read, error);
  std::string bytes;
  std::array<char, 65536> chunk{};
  while (!error && bytes.size() <= most) {
    const std::size_t count = file.read(chunk.data(), std::min(chunk.size(), most + 1 - bytes.size()), error);
    if (count == 0) break;
    bytes.append(chunk.data(), count);
  }
  if (!error) return bytes;
  return FileError{isStandardInput
                       ? translated("Standard input could not be read: %1.", {error.message()})
                       : translated("%1 could not be read: %2.", {quoted(path), error.message()})};
}

AtomicFile::AtomicFile(const fs::path& path) : m_shown(path), m_target(followedLinks(path)) {
  std::error_code error;
  const fs::file_status status = fs::status(m_target, error);
  if (fs::is_symlink(m_target, error)) {
    fail(std::make_error_code(std::errc::too_many_symbolic_link_levels));
  } else if (fs::is_directory(status)) {
    m_error = FileError{translated("%1 could not be written: it is a folder.", {quoted(m_shown)})};
  } else if (fs::exists(status) && !fs::is_regular_file(status)) {
    m_file = OpenFile(m_target, OpenMode::write, error);
    if (error) fail(error);
  } else if (fs::exists(status) && !isWritable(m_target, error)) {
    fail(error);
  } else {
    openTemporary();
  }
}

AtomicFile::~AtomicFile() {
  discard();
}

void AtomicFile::openTemporary() {
  static std::atomic<unsigned> counter{0};
  constexpr int kAttempts = 100;  // only a crash of a process with the same number leaves a name taken
  std::error_code error;
  for (int i = 0; i < kAttempts && !m_file.isOpen(); ++i) {
    const std::string name = "." + shortName(m_target) + "." + std::to_string(processId()) + "-" +
                             std::to_string(counter++) + ".tmp";
    m_temporary = folderOf(m_target) / name;
    m_file = OpenFile(m_temporary, OpenMode::createNew, error);
    if (error && error != std::errc::file_exists) break;
  }
  if (!m_file.isOpen()) {
    m_temporary.clear();
    fail(error);
    return;
  }
  takeAttributes();
}

/// Prepares the temporary file to take the place of the one that is there, or decides that it cannot.
void AtomicFile::takeAttributes() {
  const auto before = attributesOf(m_target);
  if (!before) return;
  const bool isOwnerKept = m_file.takeOwner(*before);
  m_mode = before->mode;
  // A file of that name, but with another inode, would leave its hard links or its owner behind.
  m_isInPlace = before->links > 1 || !isOwnerKept;
  // In place the temporary file is a copy for the case of a crash, which only its owner may read.
  std::error_code error;
  m_file.setMode(m_isInPlace ? 0600U : m_mode, error);
  if (error) return fail(error);
  if (!m_isInPlace) m_file.takeExtendedAttributes(m_target);
}

void AtomicFile::fail(const std::error_code& what, const std::string& more) {
  if (!m_error)
    m_error = FileError{translated("%1 could not be written: %2.", {quoted(m_shown), what.message() + more})};
}

void AtomicFile::discard() {
  std::error_code ignored;
  m_file.close(ignored);
  if (!m_temporary.empty()) fs::remove(m_temporary, ignored);
  m_temporary.clear();
}

void AtomicFile::write(std::string_view bytes) {
  if (m_error) return;
  std::error_code error;
  m_file.write(bytes, error);
  if (error) fail(error);
}

std::optional<FileError> AtomicFile::commit() {
  const bool isRegular = !m_temporary.empty();
  std::error_code error;
  if (!m_error && isRegular) m_file.sync(error);
  if (error) fail(error);
  if (!m_error && isRegular && m_isInPlace && fs::exists(m_target, error)) {
    overwrite();
    return m_error;
  }
  if (!m_error) {
    if (isRegular && m_isInPlace) m_file.setMode(m_mode, error);  // the file went meanwhile
    m_file.close(error);
    if (error) fail(error);
  }
  if (!m_error && isRegular) replace();
  discard();
  return m_error;
}

void AtomicFile::replace() {
  std::error_code error;
  fs::rename(m_temporary, m_target, error);
  if (error) return fail(error);
  m_temporary.clear();
  syncFolder(folderOf(m_target));  // a folder that cannot be synced is no failure of the file
}

void AtomicFile::overwrite() {
  // From here on a crash may leave a mixture of old and new bytes; this name tells where the new ones are.
  fs::path copy = m_temporary;
  copy.replace_extension(kInterruptedSuffix);
  std::error_code error;
  fs::rename(m_temporary, copy, error);
  if (error) {
    fail(error);
    return discard();
  }
  m_temporary = copy;
  const Overwritten done = overwriteInPlace(m_target, m_file);
  if (done.error)
    fail(done.error,
         done.isTargetWhole ? "" : translated("; what should be in it is kept in %1", {quoted(m_temporary)}));
  if (!done.isTargetWhole) m_temporary.clear();  // it is the only whole copy
  discard();
}

std::vector<fs::path> interruptedWrites(const fs::path& path) {
  const fs::path target = followedLinks(path);
  const std::string prefix = "." + shortName(target) + ".";
  std::vector<fs::path> left;
  std::error_code error;
  for (fs::directory_iterator each(folderOf(target), error), end; !error && each != end;
       each.increment(error)) {
    const std::string name = each->path().filename().string();
    if (!name.starts_with(prefix) || each->path().extension() != kInterruptedSuffix) continue;
    const auto writer = static_cast<int>(std::strtol(name.c_str() + prefix.size(), nullptr, 10));
    if (!isProcessRunning(writer)) left.push_back(each->path());
  }
  std::sort(left.begin(), left.end());
  return left;
}

void StandardOutput::write(std::string_view bytes) {
  if (m_failed) return;
  std::error_code error;
  m_file.write(bytes, error);
  m_failed = static_cast<bool>(error);
}

std::optional<FileError> writeFile(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  return file.commit();
}

}  // namespace geargraph
