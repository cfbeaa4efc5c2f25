#include "core/foundations/files/overwrite.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <string>
#include <string_view>

namespace geargraph::inline files {
namespace {

/// The bytes of an open file, wherever its position is; std::nullopt with errno if they cannot be read.
std::optional<std::string> bytesOf(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return std::nullopt;
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count =
        ::pread(descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (count == 0) break;
    if (count > 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      return std::nullopt;
    }
  }
  bytes.resize(done);
  return bytes;
}

/// Makes a file of these bytes and no others, on the disk; errno of what failed.
int put(int descriptor, std::string_view bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count =
        ::pwrite(descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      return errno;
    }
  }
  if (::ftruncate(descriptor, static_cast<off_t>(bytes.size())) != 0) return errno;
  return ::fsync(descriptor) != 0 ? errno : 0;
}

class Descriptor {
 public:
  explicit Descriptor(int descriptor) : m_descriptor(descriptor) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (m_descriptor >= 0) ::close(m_descriptor);
  }
  [[nodiscard]] int get() const { return m_descriptor; }

 private:
  int m_descriptor;
};

}  // namespace

Overwritten overwriteInPlace(const std::filesystem::path& target, int source) {
  const Descriptor file(::open(target.c_str(), O_RDWR | O_CLOEXEC));
  if (file.get() < 0) return {errno, true};
  const auto fresh = bytesOf(source);
  if (!fresh) return {errno, true};
  const auto old = bytesOf(file.get());
  if (!old) return {errno, true};
  if (fresh->size() > old->size()) {
    const int reserved = ::posix_fallocate(file.get(), static_cast<off_t>(old->size()),
                                           static_cast<off_t>(fresh->size() - old->size()));
    if (reserved != 0 && reserved != EOPNOTSUPP && reserved != EINVAL) {
      return {reserved, ::ftruncate(file.get(), static_cast<off_t>(old->size())) == 0};
    }
  }
  const int error = put(file.get(), *fresh);
  return error == 0 ? Overwritten{} : Overwritten{error, put(file.get(), *old) == 0};
}

}  // namespace geargraph::inline files
