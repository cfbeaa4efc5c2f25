#include "app/cli/served_command.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <iostream>
#include <new>

#include "core/foundations/base/translation.h"

namespace geargraph::cli {
namespace {

constexpr int kNotRun = 125;
/// The command ends by itself when its time is over; if it does not within this, it is killed.
constexpr double kGrace = 2;

/// A file in memory; closed at the end.
class MemoryFile {
 public:
  explicit MemoryFile(const char* name) : m_descriptor(memfd_create(name, MFD_CLOEXEC)) {}
  ~MemoryFile() {
    if (m_descriptor >= 0) ::close(m_descriptor);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] int descriptor() const { return m_descriptor; }
  void write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(m_descriptor, bytes.data(), bytes.size());
      if (written < 0 && errno != EINTR) break;  // the command finds the document cut
      if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    ::lseek(m_descriptor, 0, SEEK_SET);
  }
  [[nodiscard]] std::string read() const {
    const off_t size = ::lseek(m_descriptor, 0, SEEK_END);
    std::string bytes(static_cast<std::size_t>(size > 0 ? size : 0), '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t count =
          ::pread(m_descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
      if (count <= 0) break;
      done += static_cast<std::size_t>(count);
    }
    bytes.resize(done);
    return bytes;
  }

 private:
  int m_descriptor;
};

/// In the new process: never returns.
[[noreturn]] void runAlone(const Command& command, const std::vector<std::string>& words,
                           const ServedLimits& limits) {
  if (limits.megabytes) {
    const rlim_t bytes = static_cast<rlim_t>(*limits.megabytes) << 20U;
    const rlimit limit{bytes, bytes};
    if (setrlimit(RLIMIT_AS, &limit) != 0) _exit(kNotRun);
  }
  int status = kResourceLimit;
  try {
    status = runCommand(command, words, limits.seconds);
  } catch (const std::bad_alloc&) {
    std::cerr << "geargraph-cli: " << translated("The memory does not suffice for this mechanism.") << '\n';
  }
  std::cerr.flush();
  _exit(status);
}

/// Waits until the process has ended; false if it was killed because its time was over.
bool waitFor(pid_t child, const std::optional<double>& seconds) {
  if (!seconds) return true;
  const int process = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
  if (process < 0) return true;
  pollfd ended{process, POLLIN, 0};
  const int milliseconds = static_cast<int>(std::min((*seconds + kGrace) * 1000, 2e9));
  const bool isInTime = poll(&ended, 1, milliseconds) != 0;
  if (!isInTime) kill(child, SIGKILL);
  ::close(process);
  return isInTime;
}

}  // namespace

HostedOutcome runServed(const Command& command, std::vector<std::string> words, const HostedTexts& texts,
                        const ServedLimits& limits) {
  const MemoryFile input("input"), second("second"), output("output"), messages("messages");
  HostedOutcome outcome;
  if (input.descriptor() < 0 || second.descriptor() < 0 || output.descriptor() < 0 ||
      messages.descriptor() < 0) {
    outcome.failure = "No memory file could be made.";
    return outcome;
  }
  input.write(texts.first);
  second.write(texts.second);
  std::replace(words.begin(), words.end(), std::string(kSecondInput),
               "/proc/self/fd/" + std::to_string(second.descriptor()));
  const pid_t child = fork();
  if (child < 0) {
    outcome.failure = "No process could be started.";
    return outcome;
  }
  if (child == 0) {
    dup2(input.descriptor(), STDIN_FILENO);
    dup2(output.descriptor(), STDOUT_FILENO);
    dup2(messages.descriptor(), STDERR_FILENO);
    runAlone(command, words, limits);
  }
  const bool isInTime = waitFor(child, limits.seconds);
  int ended = 0;
  while (waitpid(child, &ended, 0) < 0 && errno == EINTR) {
  }
  outcome.output = output.read();
  outcome.messages = messages.read();
  if (!isInTime) {
    outcome.failure = "The time was over.";
  } else if (WIFEXITED(ended) && WEXITSTATUS(ended) != kNotRun) {
    outcome.status = WEXITSTATUS(ended);
  } else if (WIFSIGNALED(ended)) {
    outcome.failure = "The command was ended by signal " + std::to_string(WTERMSIG(ended)) +
                      (limits.megabytes ? "; the limit of memory may not suffice." : ".");
  } else {
    outcome.failure = "The limit of memory could not be set.";
  }
  return outcome;
}

}  // namespace geargraph::cli
