#include "ui/recovery/crash_handler.h"

#include <backtrace.h>
#include <cxxabi.h>
#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <exception>
#include <string_view>
#include <typeinfo>

#include "core/foundations/base/broken_contract.h"
#include "ui/recovery/action_log.h"

namespace geargraph {
namespace {

struct Signal {
  int number;
  const char* name;
  struct sigaction before;
};

constexpr unsigned kMaxReport = 10;  ///< s
constexpr int kMaxFrames = 100;

// What the handler needs, all of it there before the first crash.
std::array<Signal, 5> crashSignals{{{SIGSEGV, "SIGSEGV (invalid memory access)", {}},
                                    {SIGBUS, "SIGBUS (invalid memory access)", {}},
                                    {SIGILL, "SIGILL (invalid instruction)", {}},
                                    {SIGFPE, "SIGFPE (arithmetic error)", {}},
                                    {SIGABRT, "SIGABRT (the program stopped itself)", {}}}};
std::array<char, 4096> reportPath{};
std::array<char, 4096> details{};
std::array<char, 256> exceptionType{};
std::array<char, 256 * 1024> handlerStack{};
backtrace_state* symbols = nullptr;
std::terminate_handler terminateBefore = nullptr;
std::atomic<pid_t> crashing{0};
static_assert(std::atomic<pid_t>::is_always_lock_free);

template <std::size_t size>
void keep(std::array<char, size>& to, std::string_view text) {
  text = text.substr(0, size - 1);
  text.copy(to.data(), text.size());
  to[text.size()] = '\0';
}

/// Writes to a descriptor without allocating.
class CrashText {
 public:
  explicit CrashText(int descriptor) : m_descriptor(descriptor) {}

  const CrashText& operator<<(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t count = ::write(m_descriptor, text.data(), text.size());
      if (count > 0) {
        text.remove_prefix(static_cast<std::size_t>(count));
      } else if (errno != EINTR) {
        break;
      }
    }
    return *this;
  }
  const CrashText& operator<<(const char* text) const { return *this << std::string_view(text); }
  const CrashText& operator<<(std::int64_t number) const { return put(number, 10, 1); }
  const CrashText& hex(std::uint64_t number) const {
    return (*this << "0x").put(static_cast<std::int64_t>(number), 16, 1);
  }
  const CrashText& padded(std::int64_t number, int digits) const { return put(number, 10, digits); }

 private:
  const CrashText& put(std::int64_t number, unsigned base, int digits) const {
    std::array<char, 24> text{};
    std::size_t at = text.size();
    auto rest = static_cast<std::uint64_t>(number);
    const bool isNegative = base == 10 && number < 0;
    if (isNegative) rest = 0 - rest;
    do {
      text[--at] = "0123456789abcdef"[rest % base];
      rest /= base;
    } while (rest > 0 || text.size() - at < static_cast<std::size_t>(digits));
    if (isNegative) text[--at] = '-';
    return *this << std::string_view(text.data() + at, text.size() - at);
  }

  int m_descriptor;
};

const char* baseName(const char* path) {
  const char* slash = std::strrchr(path, '/');
  return slash != nullptr ? slash + 1 : path;
}

void writeTime(const CrashText& report) {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  const std::chrono::sys_seconds time{std::chrono::seconds(now.tv_sec)};
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss clock(time - day);
  report << "Time: " << static_cast<int>(date.year()) << "-";
  report.padded(static_cast<unsigned>(date.month()), 2) << "-";
  report.padded(static_cast<unsigned>(date.day()), 2) << " ";
  report.padded(clock.hours().count(), 2) << ":";
  report.padded(clock.minutes().count(), 2) << ":";
  report.padded(clock.seconds().count(), 2) << " UTC\n";
}

void writeThread(const CrashText& report, pid_t thread) {
  std::array<char, 17> name{};
  ::prctl(PR_GET_NAME, name.data());
  report << "Thread: " << (thread == ::getpid() ? "main" : name.data()) << "\n";
}

void writeActions(const CrashText& report) {
  report << "\nLast actions (seconds before the crash):\n";
  const std::int64_t now = ActionLog::now();
  actionLog().visit([&](const ActionLog::Entry& entry) {
    const std::int64_t ago = now - entry.milliseconds;
    report << "  " << ago / 1000 << ".";
    report.padded(ago % 1000 / 100, 1) << "  " << entry.name.data();
    if (entry.count > 1) report << " x" << std::int64_t{entry.count};
    report << "\n";
  });
}

struct Frames {
  const CrashText& report;
  int count = 0;
};

void onSymbol(void* data, std::uintptr_t pc, const char* name, std::uintptr_t value, std::uintptr_t) {
  const CrashText& report = static_cast<Frames*>(data)->report;
  if (name == nullptr) return static_cast<void>(report << "?");
  report << name << "+";
  report.hex(pc - value);
}

void onNoSymbol(void* data, const char*, int) {
  static_cast<Frames*>(data)->report << "?";
}

int onFrame(void* data, std::uintptr_t pc, const char* file, int line, const char* function) {
  auto& frames = *static_cast<Frames*>(data);
  const CrashText& report = frames.report;
  report << "  #";
  report.padded(frames.count, 2) << " ";
  if (function != nullptr) {
    report << function;
  } else if (backtrace_syminfo(symbols, pc, onSymbol, onNoSymbol, data) == 0) {
    report << "?";
  }
  if (file != nullptr) report << " at " << baseName(file) << ":" << std::int64_t{line};
  report << "\n";
  return ++frames.count >= kMaxFrames ? 1 : 0;
}

void onNoFrames(void* data, const char* message, int) {
  static_cast<Frames*>(data)->report << "  (" << message << ")\n";
}

void writeReport(const Signal& signal, pid_t thread) {
  const int descriptor = ::open(reportPath.data(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) return;
  const CrashText report(descriptor);
  report << "GearGraph crash report\n" << details.data();
  writeTime(report);
  report << "Signal: " << signal.name << "\n";
  if (brokenContract()[0] != '\0') report << "Broken contract: " << brokenContract() << "\n";
  if (exceptionType[0] != '\0') report << "Uncaught exception: " << exceptionType.data() << "\n";
  writeThread(report, thread);
  writeActions(report);
  report << "\nBacktrace:\n";
  Frames frames{report};
  backtrace_full(symbols, 0, onFrame, onNoFrames, &frames);
  ::close(descriptor);
}

void onCrash(int number) {
  const int errorBefore = errno;
  Signal* signal = &crashSignals.back();
  for (Signal& each : crashSignals) {
    if (each.number == number) signal = &each;
  }
  const pid_t thread = ::gettid();
  pid_t none = 0;
  if (crashing.compare_exchange_strong(none, thread)) {
    // If the program's own state makes the report hang, the process ends all the same.
    std::signal(SIGALRM, SIG_DFL);
    ::alarm(kMaxReport);
    writeReport(*signal, thread);
  } else if (none != thread) {
    for (;;) ::pause();  // the process ends when the thread that crashed first has its report
  }
  // As without a handler: with a core file if the system is set to, and for a debugger or sanitizer.
  ::sigaction(number, &signal->before, nullptr);
  errno = errorBefore;
  ::raise(number);  // blocked until the handler returns
}

/// Keeps the type only: what() may quote a document.
[[noreturn]] void onTerminate() {
  if (const std::type_info* type = abi::__cxa_current_exception_type()) keep(exceptionType, type->name());
  if (terminateBefore != nullptr) terminateBefore();
  std::abort();
}

void onSymbolError(void*, const char*, int) {}

}  // namespace

void installCrashHandler(const std::filesystem::path& folder, const std::string& about) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  keep(reportPath,
       (folder / ("crash-" + std::to_string(now.tv_sec) + "-" + std::to_string(::getpid()) + ".txt"))
           .string());
  keep(details, about);
  symbols = backtrace_create_state(nullptr, 1, onSymbolError, nullptr);
  terminateBefore = std::set_terminate(onTerminate);

  stack_t stack{};
  ::sigaltstack(nullptr, &stack);
  if ((stack.ss_flags & SS_DISABLE) != 0) {  // else a sanitizer has given it one, and frees it
    stack = {};
    stack.ss_sp = handlerStack.data();
    stack.ss_size = handlerStack.size();
    ::sigaltstack(&stack, nullptr);
  }
  struct sigaction action {};
  action.sa_handler = onCrash;
  action.sa_flags = SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  for (Signal& each : crashSignals) ::sigaction(each.number, &action, &each.before);
}

}  // namespace geargraph
