#include "core/foundations/platform/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <optional>
#include <utility>

namespace geargraph {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLookAround = 50;  // ms between two looks at the stop token

/// A file descriptor that is closed again.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : m_number(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(m_number, other.m_number);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return m_number; }
  [[nodiscard]] bool isOpen() const { return m_number >= 0; }
  void close() {
    if (m_number >= 0) ::close(m_number);
    m_number = -1;
  }

 private:
  int m_number;
};

/// The program's process; killed and waited for when it goes.
class Process {
 public:
  Process() = default;
  ~Process() {
    if (m_pid <= 0) return;
    ::kill(m_pid, SIGKILL);
    (void)wait();
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  bool start(const ChildProgram& child, int input, int output, int errors) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    const char* const name = child.program.c_str();
    std::vector<char*> arguments = {const_cast<char*>(name)};  // NOLINT: they are only read
    for (const std::string& word : child.words)
      arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT
    arguments.push_back(nullptr);
    std::array<char*, 1> environment = {nullptr};
    const int failed = ::posix_spawn(&m_pid, name, &actions, nullptr, arguments.data(), environment.data());
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) m_pid = 0;
    return failed == 0;
  }

  /// How it ended.
  int wait() {
    int status = 0;
    while (::waitpid(m_pid, &status, 0) < 0 && errno == EINTR) continue;
    m_pid = 0;
    return status;
  }

 private:
  pid_t m_pid = 0;
};

/// Takes what is there; false where the other side has closed.
bool take(int descriptor, std::string& text, std::size_t most) {
  std::array<char, 1 << 16> piece{};
  const ssize_t count = ::read(descriptor, piece.data(), piece.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  const std::size_t room = most > text.size() ? most - text.size() : 0;
  text.append(piece.data(), std::min(room, static_cast<std::size_t>(count)));
  return count > 0;
}

/// Listens until both ends are closed; otherwise how it ended.
std::optional<ChildEnd> listen(Descriptor output, Descriptor errors, const ChildProgram& child,
                               const std::stop_token& stop, ChildResult& result) {
  while (output.isOpen() || errors.isOpen()) {
    if (stop.stop_requested()) return ChildEnd::stopped;
    if (Clock::now() >= child.deadline) return ChildEnd::outOfTime;
    std::array<pollfd, 2> ends = {pollfd{output.number(), POLLIN, 0}, pollfd{errors.number(), POLLIN, 0}};
    if (::poll(ends.data(), ends.size(), kLookAround) <= 0) continue;
    if (ends[0].revents != 0 && !take(output.number(), result.output, child.mostOutput)) output.close();
    if (ends[1].revents == 0) continue;
    const std::size_t before = result.errors.size();
    if (!take(errors.number(), result.errors, child.mostErrors)) errors.close();
    if (child.heard && result.errors.size() > before) child.heard(result.errors);
  }
  return std::nullopt;
}

/// Opens the input if it is a file of a size that may be read; else tells why not.
Descriptor openInput(const ChildProgram& child, ChildResult& result) {
  Descriptor file(::open(child.input.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat what {};
  if (!file.isOpen()) {
    result.end = errno == ENOENT ? ChildEnd::inputMissing : ChildEnd::inputUnreadable;
    return file;
  }
  if (::fstat(file.number(), &what) != 0 || !S_ISREG(what.st_mode)) {
    result.end = ChildEnd::inputNoFile;
    return Descriptor();
  }
  result.inputSize = static_cast<std::uintmax_t>(what.st_size);
  if (result.inputSize <= child.mostInput) return file;
  result.end = ChildEnd::inputTooLarge;
  return Descriptor();
}

/// Bytes as a file without a name, which cannot block like a pipe that nobody reads.
Descriptor fileOf(std::string_view bytes) {
  Descriptor file(::memfd_create("input", MFD_CLOEXEC));
  while (file.isOpen() && !bytes.empty()) {
    const ssize_t count = ::write(file.number(), bytes.data(), bytes.size());
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      file.close();
    }
  }
  if (file.isOpen() && ::lseek(file.number(), 0, SEEK_SET) != 0) file.close();
  return file;
}

std::optional<std::pair<Descriptor, Descriptor>> pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
  return std::pair(Descriptor(ends[0]), Descriptor(ends[1]));
}

}  // namespace

ChildResult runChild(const ChildProgram& child, const std::stop_token& stop) {
  ChildResult result;
  const Descriptor input = child.given ? fileOf(*child.given) : openInput(child, result);
  if (!input.isOpen()) return result;
  auto output = pipe(), errors = pipe();
  if (!output || !errors) {
    result.end = ChildEnd::tooManyFiles;
    return result;
  }
  Process process;
  if (!process.start(child, input.number(), output->second.number(), errors->second.number())) {
    result.end = ChildEnd::notStarted;
    return result;
  }
  output->second.close();
  errors->second.close();
  const auto early = listen(std::move(output->first), std::move(errors->first), child, stop, result);
  if (early) {
    result.end = *early;
    return result;
  }
  const int status = process.wait();
  if (WIFEXITED(status)) {
    result.end = ChildEnd::exited;
    result.status = WEXITSTATUS(status);
  } else {
    result.end = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU ? ChildEnd::outOfTime : ChildEnd::crashed;
  }
  return result;
}

bool confinesChildren() {
  return true;
}

}  // namespace geargraph
