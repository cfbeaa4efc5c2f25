#include <fcntl.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <utility>

#include "core/foundations/platform/open_file.h"

namespace geargraph {
namespace {

namespace fs = std::filesystem;

std::error_code lastError() {
  return {errno, std::generic_category()};
}

/// Clears `error`, or sets it to errno.
void report(bool isFine, std::error_code& error) {
  error = isFine ? std::error_code() : lastError();
}

int flagsOf(OpenMode mode) {
  switch (mode) {
    case OpenMode::read:
      return O_RDONLY | O_CLOEXEC;
    case OpenMode::write:
      return O_WRONLY | O_CLOEXEC;
    case OpenMode::change:
      return O_RDWR | O_CLOEXEC;
    case OpenMode::createNew:
      return O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC;
  }
  return O_RDONLY | O_CLOEXEC;
}

/// Calls `step(done)` until all of `size` bytes are done, or it fails (-1) or ends (0); false with errno.
template <class Step>
bool inSteps(std::size_t size, std::size_t& done, const Step& step) {
  while (done < size) {
    const ssize_t count = step(done);
    if (count > 0) {
      done += static_cast<std::size_t>(count);
    } else if (count == 0 || errno != EINTR) {
      return count == 0;
    }
  }
  return true;
}

/// The names of a list in which each ends with a zero byte.
std::set<std::string> namesIn(const std::string& list) {
  std::set<std::string> names;
  for (std::size_t at = 0; at < list.size();) {
    names.insert(list.c_str() + at);
    at = list.find('\0', at) + 1;
    if (at == 0) break;
  }
  return names;
}

/// Calls a function of the kernel that fills a buffer: first for the size, then for the bytes. Empty if it
/// fails.
template <class Fill>
std::string filled(const Fill& fill) {
  const ssize_t wanted = fill(nullptr, 0);
  if (wanted <= 0) return {};
  std::string bytes(static_cast<std::size_t>(wanted), '\0');
  const ssize_t size = fill(bytes.data(), bytes.size());
  bytes.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return bytes;
}

}  // namespace

struct OpenFile::State {
  int descriptor = -1;
  bool isKeptOpen = false;
};

std::optional<FileAttributes> attributesOf(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return FileAttributes{status.st_uid, status.st_gid, status.st_mode & 07777U, status.st_nlink};
}

OpenFile::OpenFile() = default;
OpenFile::OpenFile(std::unique_ptr<State> state) : m_state(std::move(state)) {}
OpenFile::OpenFile(OpenFile&& other) noexcept = default;

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept {
  std::swap(m_state, other.m_state);
  return *this;
}

OpenFile::OpenFile(const fs::path& path, OpenMode mode, std::error_code& error) {
  const int descriptor = ::open(path.c_str(), flagsOf(mode), 0666);
  report(descriptor >= 0, error);
  if (descriptor >= 0) m_state = std::make_unique<State>(State{descriptor, false});
}

OpenFile::~OpenFile() {
  if (m_state && !m_state->isKeptOpen) ::close(m_state->descriptor);
}

OpenFile OpenFile::standardInput() {
  return OpenFile(std::make_unique<State>(State{STDIN_FILENO, true}));
}

OpenFile OpenFile::standardOutput() {
  return OpenFile(std::make_unique<State>(State{STDOUT_FILENO, true}));
}

std::size_t OpenFile::read(char* to, std::size_t most, std::error_code& error) {
  ssize_t count = 0;
  do {
    count = ::read(m_state->descriptor, to, most);
  } while (count < 0 && errno == EINTR);
  report(count >= 0, error);
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

void OpenFile::write(std::string_view bytes, std::error_code& error) {
  error.clear();
  while (!bytes.empty()) {
    const ssize_t written = ::write(m_state->descriptor, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error = lastError();
      return;
    }
  }
}

void OpenFile::sync(std::error_code& error) {
  report(::fsync(m_state->descriptor) == 0, error);
}

void OpenFile::close(std::error_code& error) {
  error.clear();
  const auto state = std::exchange(m_state, nullptr);
  if (state && !state->isKeptOpen) report(::close(state->descriptor) == 0, error);
}

std::string OpenFile::contents(std::error_code& error) {
  struct stat status {};
  report(::fstat(m_state->descriptor, &status) == 0, error);
  if (error) return {};
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t done = 0;
  const bool isRead = inSteps(bytes.size(), done, [&](std::size_t at) {
    return ::pread(m_state->descriptor, bytes.data() + at, bytes.size() - at, static_cast<off_t>(at));
  });
  report(isRead, error);
  bytes.resize(isRead ? done : 0);
  return bytes;
}

void OpenFile::setContents(std::string_view bytes, std::error_code& error) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count =
        ::pwrite(m_state->descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      error = lastError();
      return;
    }
  }
  truncate(bytes.size(), error);
  if (!error) sync(error);
}

void OpenFile::reserve(std::size_t from, std::size_t to, std::error_code& error) {
  error.clear();
  const int failed =
      ::posix_fallocate(m_state->descriptor, static_cast<off_t>(from), static_cast<off_t>(to - from));
  if (failed != 0 && failed != EOPNOTSUPP && failed != EINVAL)
    error = std::error_code(failed, std::generic_category());
}

void OpenFile::truncate(std::size_t size, std::error_code& error) {
  report(::ftruncate(m_state->descriptor, static_cast<off_t>(size)) == 0, error);
}

bool OpenFile::takeOwner(const FileAttributes& wanted) {
  const auto owner = static_cast<uid_t>(wanted.owner);
  const auto group = static_cast<gid_t>(wanted.group);
  if (::fchown(m_state->descriptor, owner, group) == 0) return true;
  // A group that the process belongs to may be given without the right to give files away.
  const int onlyGroup = ::fchown(m_state->descriptor, static_cast<uid_t>(-1), group);
  struct stat now {};
  return onlyGroup == 0 && ::fstat(m_state->descriptor, &now) == 0 && now.st_uid == owner;
}

void OpenFile::setMode(unsigned mode, std::error_code& error) {
  report(::fchmod(m_state->descriptor, mode) == 0, error);
}

void OpenFile::takeExtendedAttributes(const fs::path& from) {
  const int descriptor = m_state->descriptor;
  const auto wanted =
      namesIn(filled([&](char* to, std::size_t size) { return ::listxattr(from.c_str(), to, size); }));
  const auto inherited =
      namesIn(filled([&](char* to, std::size_t size) { return ::flistxattr(descriptor, to, size); }));
  for (const std::string& name : inherited) {
    if (!wanted.contains(name)) ::fremovexattr(descriptor, name.c_str());
  }
  for (const std::string& name : wanted) {
    const std::string value =
        filled([&](char* to, std::size_t size) { return ::getxattr(from.c_str(), name.c_str(), to, size); });
    ::fsetxattr(descriptor, name.c_str(), value.data(), value.size(), 0);
  }
}

}  // namespace geargraph
