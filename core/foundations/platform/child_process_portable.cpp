// Programs by Boost.Process, which knows how each system starts and ends them. The answer goes through files,
// not pipes: two children at a time would inherit each other's.

#include "core/foundations/platform/child_process.h"

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <cstdio>
#include <fstream>
#include <memory>
#include <mutex>
#include <random>

// Its newer releases have another one under the old names.
#if __has_include(<boost/process/v1/child.hpp>)
#include <boost/process/v1/args.hpp>
#include <boost/process/v1/child.hpp>
#include <boost/process/v1/error.hpp>
#include <boost/process/v1/exe.hpp>
#include <boost/process/v1/io.hpp>
#else
#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/error.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/io.hpp>
#endif
#ifdef _WIN32
#include <boost/process/windows.hpp>
#endif

namespace geargraph {
namespace {

#if __has_include(<boost/process/v1/child.hpp>)
namespace processes = boost::process::v1;
#else
namespace processes = boost::process;
#endif
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// A folder of this process, which goes with what is in it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::random_device random;
    std::error_code error;
    const fs::path parent = fs::temp_directory_path(error);
    for (int attempt = 0; attempt < 10 && !error && !m_isMade; ++attempt) {
      m_path = parent / ("geargraph-" + std::to_string(random()) + std::to_string(random()));
      m_isMade = fs::create_directory(m_path, error);  // false where it is there
    }
    if (m_isMade) fs::permissions(m_path, fs::perms::owner_all, error);
  }
  ~ScratchFolder() {
    std::error_code error;
    if (m_isMade) fs::remove_all(m_path, error);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] bool isMade() const { return m_isMade; }
  [[nodiscard]] fs::path file(const char* name) const { return m_path / name; }

 private:
  fs::path m_path;
  bool m_isMade = false;
};

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

File opened(const fs::path& path, bool isToWrite) {
#ifdef _WIN32
  return File(::_wfopen(path.c_str(), isToWrite ? L"wb" : L"rb"));
#else
  return File(std::fopen(path.c_str(), isToWrite ? "wb" : "rb"));
#endif
}

/// The first bytes of a file.
std::string beginningOf(const fs::path& path, std::size_t most) {
  std::ifstream file(path, std::ios::binary);
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  std::string bytes(error ? 0 : static_cast<std::size_t>(std::min<std::uintmax_t>(size, most)), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

/// Why the input is not given to a program; `exited` where it is.
ChildEnd inputProblem(const ChildProgram& child, ChildResult& result) {
  std::error_code error;
  const fs::file_status status = fs::status(child.input, error);
  if (!fs::exists(status))
    return error && status.type() == fs::file_type::none ? ChildEnd::inputUnreadable : ChildEnd::inputMissing;
  if (!fs::is_regular_file(status)) return ChildEnd::inputNoFile;
  result.inputSize = fs::file_size(child.input, error);
  if (error) return ChildEnd::inputUnreadable;
  return result.inputSize > child.mostInput ? ChildEnd::inputTooLarge : ChildEnd::exited;
}

/// Did the program end otherwise than by itself?
bool isCrash(int nativeStatus) {
#ifdef _WIN32
  return static_cast<unsigned>(nativeStatus) >= 0xC0000000U;  // an exception that it did not handle
#else
  return (static_cast<unsigned>(nativeStatus) & 0x7FU) != 0;  // the signal that ended it
#endif
}

/// Waits for the program, looking ever less often, at most 20 ms late.
ChildEnd waitFor(processes::child& process, const ChildProgram& child, const fs::path& output,
                 const std::stop_token& stop) {
  constexpr std::uintmax_t kSpare = std::uintmax_t{1} << 20U;  // of output beyond what is kept
  constexpr std::chrono::milliseconds kMaxWait(20);
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any never;
  std::chrono::milliseconds wait(1);
  std::error_code error;
  while (process.running(error) && !error) {
    if (stop.stop_requested()) return ChildEnd::stopped;
    if (Clock::now() >= child.deadline) return ChildEnd::outOfTime;
    const std::uintmax_t size = fs::file_size(output, error);
    if (!error && size > child.mostOutput + kSpare) return ChildEnd::crashed;
    error.clear();
    (void)never.wait_for(lock, stop, wait, [] { return false; });
    wait = std::min(2 * wait, kMaxWait);
  }
  return stop.stop_requested()                 ? ChildEnd::stopped
         : isCrash(process.native_exit_code()) ? ChildEnd::crashed
                                               : ChildEnd::exited;
}

}  // namespace

ChildResult runChild(const ChildProgram& child, const std::stop_token& stop) {
  ChildResult result;
  const ScratchFolder folder;
  if (child.given) {
    const File written = folder.isMade() ? opened(folder.file("input"), true) : File();
    if (!written ||
        std::fwrite(child.given->data(), 1, child.given->size(), written.get()) != child.given->size())
      return result;
  } else {
    result.end = inputProblem(child, result);
    if (result.end != ChildEnd::exited) return result;
  }
  errno = 0;
  const File input = opened(child.given ? folder.file("input") : child.input, false);
  if (!input) {
    result.end = errno == EMFILE ? ChildEnd::tooManyFiles : ChildEnd::inputUnreadable;
    return result;
  }
  result.end = ChildEnd::notStarted;
  if (!folder.isMade()) return result;
  const fs::path answer = folder.file("answer"), report = folder.file("report");
  File output = opened(answer, true), errors = opened(report, true);
  std::error_code error;
  if (!output || !errors || !fs::is_regular_file(child.program, error)) return result;
  processes::child process(processes::exe = child.program.string(), processes::args = child.words,
                           processes::std_in<input.get(), processes::std_out> output.get(),
                           processes::std_err > errors.get(),
#ifdef _WIN32
                           boost::process::windows::hide,
#endif
                           error);
  if (error) return result;
  result.end = waitFor(process, child, answer, stop);
  if (process.running(error)) process.terminate(error);
  output.reset();
  errors.reset();
  if (result.end != ChildEnd::exited) return result;
  result.status = process.exit_code();
  result.output = beginningOf(answer, child.mostOutput);
  result.errors = beginningOf(report, child.mostErrors);
  return result;
}

bool confinesChildren() {
  return false;
}

}  // namespace geargraph
