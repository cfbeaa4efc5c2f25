#include "core/io/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <system_error>

namespace geargraph {
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

/// What a chain of symbolic links ends in, which need not exist.
fs::path followed(fs::path path) {
  constexpr int kLongestChain = 40;  // the kernel's own limit
  std::error_code error;
  for (int i = 0; i < kLongestChain && fs::is_symlink(path, error); ++i) {
    const fs::path to = fs::read_symlink(path, error);
    if (error) break;
    path = to.is_absolute() ? to : path.parent_path() / to;
  }
  return path;
}

fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

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

AtomicFile::AtomicFile(const fs::path& path) : m_shown(path), m_target(followed(path)) {
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
    const std::string name = "." + m_target.filename().string().substr(0, 100) + "." +
                             std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp";
    m_temporary = folderOf(m_target) / name;
    m_descriptor = ::open(m_temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (m_descriptor < 0 && errno != EEXIST) break;
  }
  if (m_descriptor < 0) {
    m_temporary.clear();
    fail(reason(errno));
    return;
  }
  struct stat before {};
  if (::stat(m_target.c_str(), &before) != 0) return;
  // The owner can only be kept by one who may give files away; then the permissions must come after it. Who
  // may not shall not make a program that runs as its owner either.
  const bool isSameOwner = ::fchown(m_descriptor, before.st_uid, before.st_gid) == 0;
  const mode_t mode = before.st_mode & (isSameOwner ? 07777U : 0777U);
  if (::fchmod(m_descriptor, mode) != 0) fail(reason(errno));
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
  if (!m_error) {
    const int descriptor = m_descriptor;
    m_descriptor = -1;
    if (::close(descriptor) != 0) fail(reason(errno));
  }
  if (!m_error && isRegular) {
    if (::rename(m_temporary.c_str(), m_target.c_str()) == 0) {
      m_temporary.clear();
      // So that the new name survives a power cut too; a folder that cannot be synced is no failure of the
      // file.
      const int folder = ::open(folderOf(m_target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (folder >= 0) {
        ::fsync(folder);
        ::close(folder);
      }
    } else {
      fail(reason(errno));
    }
  }
  discard();
  return m_error;
}

void DescriptorSink::write(std::string_view bytes) {
  m_failed = m_failed || !writeAll(m_descriptor, bytes);
}

std::optional<FileError> writeFile(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  return file.commit();
}

}  // namespace geargraph
