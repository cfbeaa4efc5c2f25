// Loaded before the C library (LD_PRELOAD), it makes one call to the disk fail:
//
//   GEARGRAPH_DISK_FAULT=CALL:NUMBER:ERROR    the NUMBER-th CALL (1, 2, ...) fails; "NUMBER+": and all after
//   it GEARGRAPH_DISK_FOLDER=FOLDER              only calls about regular files below this folder count
//   GEARGRAPH_DISK_MARK=FILE                  made when the fault happens
//
// CALL is open (for writing), write, fsync, close (of what was written), rename or fchmod. ERROR is ENOSPC,
// EIO, EDQUOT, EACCES or EINTR; for write also "short", which writes half of the bytes.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdarg>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

struct Fault {
  std::string call;
  long number = 0;
  bool goesOn = false;
  int error = 0;  ///< 0: a short write
};

Fault faultFromEnvironment() {
  const char* text = std::getenv("GEARGRAPH_DISK_FAULT");
  const std::string_view words = text != nullptr ? text : "";
  const std::size_t first = words.find(':'), second = words.find(':', first + 1);
  if (second == std::string_view::npos) return {};
  Fault fault;
  fault.call = words.substr(0, first);
  const std::string_view number = words.substr(first + 1, second - first - 1),
                         error = words.substr(second + 1);
  std::from_chars(number.data(), number.data() + number.size(), fault.number);
  fault.goesOn = number.ends_with('+');
  for (const auto& [name, code] : {std::pair("ENOSPC", ENOSPC),
                                   {"EIO", EIO},
                                   {"EDQUOT", EDQUOT},
                                   {"EACCES", EACCES},
                                   {"EINTR", EINTR}}) {
    if (error == name) fault.error = code;
  }
  return fault;
}

bool isInFolder(std::string_view path) {
  const char* folder = std::getenv("GEARGRAPH_DISK_FOLDER");
  return folder != nullptr && path.starts_with(folder) && path.find(".lock") == std::string_view::npos;
}

bool isOurs(int descriptor) {
  struct stat what {};
  if (::fstat(descriptor, &what) != 0 || !S_ISREG(what.st_mode)) return false;
  std::array<char, 4096> path{};
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const ssize_t length = ::readlink(link.c_str(), path.data(), path.size());
  return length > 0 && isInFolder({path.data(), static_cast<std::size_t>(length)});
}

bool isWritable(int descriptor) {
  const int flags = ::fcntl(descriptor, F_GETFL);
  return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

/// Is this the call that fails? Counts it.
const Fault* faultOf(std::string_view call) {
  static const Fault fault = faultFromEnvironment();
  static std::atomic<long> calls{0};
  if (call != fault.call) return nullptr;
  const long number = ++calls;
  if (number != fault.number && !(fault.goesOn && number > fault.number)) return nullptr;
  if (const char* mark = std::getenv("GEARGRAPH_DISK_MARK")) {
    const long made = ::syscall(SYS_open, mark, O_WRONLY | O_CREAT, 0600);
    if (made >= 0) ::syscall(SYS_close, made);
  }
  return &fault;
}

int failedBy(const Fault& fault) {
  errno = fault.error;
  return -1;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));  // NOLINT: what the call returns
}

int opened(const char* name, const char* path, int flags, mode_t mode) {
  if ((flags & O_CREAT) != 0 && isInFolder(path)) {
    if (const Fault* fault = faultOf("open")) return failedBy(*fault);
  }
  return next<int(const char*, int, ...)>(name)(path, flags, mode);
}

mode_t modeFrom(int flags, std::va_list arguments) {
  return (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  std::va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = modeFrom(flags, arguments);
  va_end(arguments);
  return opened("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  std::va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = modeFrom(flags, arguments);
  va_end(arguments);
  return opened("open64", path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, std::size_t count) {
  if (isOurs(descriptor)) {
    if (const Fault* fault = faultOf("write")) {
      if (fault->error != 0) return failedBy(*fault);
      count = (count + 1) / 2;
    }
  }
  return next<ssize_t(int, const void*, std::size_t)>("write")(descriptor, bytes, count);
}

int fsync(int descriptor) {
  if (isOurs(descriptor)) {
    if (const Fault* fault = faultOf("fsync")) return failedBy(*fault);
  }
  return next<int(int)>("fsync")(descriptor);
}

int close(int descriptor) {
  const Fault* fault = isOurs(descriptor) && isWritable(descriptor) ? faultOf("close") : nullptr;
  const int result = next<int(int)>("close")(descriptor);
  return fault != nullptr ? failedBy(*fault) : result;
}

int rename(const char* from, const char* to) noexcept {
  if (isInFolder(to)) {
    if (const Fault* fault = faultOf("rename")) return failedBy(*fault);
  }
  return next<int(const char*, const char*)>("rename")(from, to);
}

int fchmod(int descriptor, mode_t mode) noexcept {
  if (isOurs(descriptor)) {
    if (const Fault* fault = faultOf("fchmod")) return failedBy(*fault);
  }
  return next<int(int, mode_t)>("fchmod")(descriptor, mode);
}

}  // extern "C"
