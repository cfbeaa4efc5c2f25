#include "core/foundations/files/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>

#include "core/foundations/files/file_attributes.h"
#include "core/foundations/files/file_identity.h"
#include "core/foundations/files/overwrite.h"

namespace geargraph::inline files {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
  return std::generic_category().message(error);
}

std::string quoted(const fs::path& path) {
  return "\"" + path.string() + "\"";
}

/// Writes all bytes, however often the system takes only some of them; false with errno where it refuses.
bool writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// What the name of a temporary file shows of the file's own.
std::string shortName(const fs::path& path) {
  return path.filename().string().substr(0, 100);
}

constexpr const char* kInterruptedSuffix = ".saving";

/// Owns a descriptor while a file is read.
class ReadDescriptor {
 public:
  explicit ReadDescriptor(const fs::path& path)
      : m_isStandardInput(path == "-"),
        m_descriptor(m_isStandardInput ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ReadDescriptor(const ReadDescriptor&) = delete;
  ReadDescriptor& operator=(const ReadDescriptor&) = delete;
  ~ReadDescriptor() {
    if (!m_isStandardInput && m_descriptor >= 0) ::close(m_descriptor);
  }
  [[nodiscard]] int get() const { return m_descriptor; }

 private:
  bool m_isStandardInput;
  int m_descriptor;
};

}  // namespace

std::variant<std::string, FileError> readFile(const fs::path& path, std::size_t most) {
  const ReadDescriptor file(path);
  const auto failure = [&](int error) {
    return FileError{(path == "-" ? "Standard input" : quoted(path)) +
                     " could not be read: " + reason(error) + "."};
  };
  if (file.get() < 0) return failure(errno);

  std::string bytes;
  std::array<char, 65536> chunk{};
  while (bytes.size() <= most) {
    const ssize_t count = ::read(file.get(), chunk.data(), std::min(chunk.size(), most + 1 - bytes.size()));
    if (count == 0) break;
    if (count > 0) {
      bytes.append(chunk.data(), static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return failure(errno);
    }
  }
  return bytes;
}

AtomicFile::AtomicFile(const fs::path& path) : m_shown(path), m_target(followedLinks(path)) {
  std::error_code error;
  const fs::file_status status = fs::status(m_target, error);
  if (fs::is_symlink(m_target, error)) {
    fail(reason(ELOOP));
  } else if (fs::is_directory(status)) {
    m_error = FileError{quoted(m_shown) + " could not be written: it is a folder."};
  } else if (fs::exists(status) && !fs::is_regular_file(status)) {
    m_descriptor = ::open(m_target.c_str(), O_WRONLY | O_CLOEXEC);
    if (m_descriptor < 0) fail(reason(errno));
  } else if (fs::exists(status) && ::access(m_target.c_str(), W_OK) != 0) {
    fail(reason(errno));
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
  for (int i = 0; i < kAttempts && m_descriptor < 0; ++i) {
    const std::string name = "." + shortName(m_target) + "." + std::to_string(::getpid()) + "-" +
                             std::to_string(counter++) + ".tmp";
    m_temporary = folderOf(m_target) / name;
    m_descriptor = ::open(m_temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (m_descriptor < 0 && errno != EEXIST) break;
  }
  if (m_descriptor < 0) {
    m_temporary.clear();
    fail(reason(errno));
    return;
  }
  takeAttributes();
}

/// Prepares the temporary file to take the place of the one that is there, or decides that it cannot.
void AtomicFile::takeAttributes() {
  struct stat before {};
  if (::stat(m_target.c_str(), &before) != 0) return;
  const bool isOwnerKept = takeOwner(m_descriptor, before);
  m_mode = before.st_mode & 07777U;
  // A file of that name, but with another inode, would leave its hard links or its owner behind.
  m_isInPlace = before.st_nlink > 1 || !isOwnerKept;
  // In place the temporary file is a copy for the case of a crash, which only its owner may read.
  if (::fchmod(m_descriptor, m_isInPlace ? 0600U : m_mode) != 0) return fail(reason(errno));
  if (!m_isInPlace) takeExtendedAttributes(m_descriptor, m_target);
}

void AtomicFile::fail(const std::string& what) {
  if (!m_error) m_error = FileError{quoted(m_shown) + " could not be written: " + what + "."};
}

void AtomicFile::discard() {
  if (m_descriptor >= 0) ::close(m_descriptor);
  m_descriptor = -1;
  if (!m_temporary.empty()) ::unlink(m_temporary.c_str());
  m_temporary.clear();
}

void AtomicFile::write(std::string_view bytes) {
  if (!m_error && !writeAll(m_descriptor, bytes)) fail(reason(errno));
}

std::optional<FileError> AtomicFile::commit() {
  const bool isRegular = !m_temporary.empty();
  if (!m_error && isRegular && ::fsync(m_descriptor) != 0) fail(reason(errno));
  if (!m_error && isRegular && m_isInPlace && ::access(m_target.c_str(), F_OK) == 0) {
    overwrite();
    return m_error;
  }
  if (!m_error) {
    if (isRegular && m_isInPlace) ::fchmod(m_descriptor, m_mode);  // the file went meanwhile
    const int descriptor = m_descriptor;
    m_descriptor = -1;
    if (::close(descriptor) != 0) fail(reason(errno));
  }
  if (!m_error && isRegular) replace();
  discard();
  return m_error;
}

void AtomicFile::replace() {
  if (::rename(m_temporary.c_str(), m_target.c_str()) != 0) return fail(reason(errno));
  m_temporary.clear();
  // So that the new name survives a power cut too; a folder that cannot be synced is no failure of the file.
  const int folder = ::open(folderOf(m_target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);
  ::close(folder);
}

void AtomicFile::overwrite() {
  // From here on a crash may leave a mixture of old and new bytes; this name tells where the new ones are.
  fs::path copy = m_temporary;
  copy.replace_extension(kInterruptedSuffix);
  if (::rename(m_temporary.c_str(), copy.c_str()) != 0) {
    fail(reason(errno));
    return discard();
  }
  m_temporary = copy;
  const Overwritten done = overwriteInPlace(m_target, m_descriptor);
  if (done.error != 0) {
    fail(reason(done.error) +
         (done.isTargetWhole ? "" : "; what should be in it is kept in " + quoted(m_temporary)));
  }
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
    const pid_t writer = static_cast<pid_t>(std::strtol(name.c_str() + prefix.size(), nullptr, 10));
    const bool isAlive = writer > 0 && (::kill(writer, 0) == 0 || errno == EPERM);
    if (!isAlive) left.push_back(each->path());
  }
  std::sort(left.begin(), left.end());
  return left;
}

void DescriptorSink::write(std::string_view bytes) {
  m_failed = m_failed || !writeAll(m_descriptor, bytes);
}

std::optional<FileError> writeFile(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  return file.commit();
}

}  // namespace geargraph::inline files
