#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "core/foundations/platform/system.h"

namespace geargraph {

namespace fs = std::filesystem;

std::string_view platformName() {
  return "Linux";
}

int processId() {
  return ::getpid();
}

bool isProcessRunning(int id) {
  return id > 0 && (::kill(id, 0) == 0 || errno == EPERM);
}

fs::path programPath() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

void lowerThreadPriority() {
  // Linux knows a priority by thread; to lower it needs no right, so that it cannot fail.
  constexpr int kNicer = 5;
  static thread_local bool isLowered = false;
  if (isLowered) return;
  isLowered = true;
  const auto thread = static_cast<id_t>(::gettid());
  ::setpriority(PRIO_PROCESS, thread, ::getpriority(PRIO_PROCESS, thread) + kNicer);  // cut off at 19
}

bool isWritable(const fs::path& path, std::error_code& error) {
  error.clear();
  if (::access(path.c_str(), W_OK) == 0) return true;
  error = std::error_code(errno, std::generic_category());
  return false;
}

void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

std::optional<FileStamp> fileStamp(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  const auto nanoseconds = [](const timespec& time) {
    constexpr std::int64_t kPerSecond = 1'000'000'000;
    return time.tv_sec * kPerSecond + time.tv_nsec;
  };
  return FileStamp{static_cast<std::uint64_t>(status.st_size), nanoseconds(status.st_mtim),
                   nanoseconds(status.st_ctim), FileNumbers{status.st_dev, status.st_ino}};
}

}  // namespace geargraph
