#include "tests/faults/child.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace geargraph::test {
namespace {

[[noreturn]] void fail(const char* what) {
  std::perror(what);
  std::exit(3);
}

std::array<int, 2> openPipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe");
  return ends;
}

/// False where the other side has closed.
bool take(int descriptor, std::string& text) {
  std::array<char, 1 << 16> piece{};
  const ssize_t count = ::read(descriptor, piece.data(), piece.size());
  if (count < 0) return errno == EINTR;
  text.append(piece.data(), static_cast<std::size_t>(count));
  return count > 0;
}

}  // namespace

Child::Child(const std::vector<std::string>& words, const std::map<std::string, std::string>& environment) {
  std::vector<std::string> variables;
  for (char** each = environ; *each != nullptr; ++each) variables.emplace_back(*each);
  for (const auto& [name, value] : environment) variables.push_back(name + "=" + value);
  std::vector<char*> arguments, settings;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));     // NOLINT
  for (const std::string& each : variables) settings.push_back(const_cast<char*>(each.c_str()));  // NOLINT
  arguments.push_back(nullptr);
  settings.push_back(nullptr);

  const auto output = openPipe(), errors = openPipe();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors[1], STDERR_FILENO);
  const int error =
      ::posix_spawn(&m_pid, words.front().c_str(), &actions, nullptr, arguments.data(), settings.data());
  posix_spawn_file_actions_destroy(&actions);
  ::close(output[1]);
  ::close(errors[1]);
  m_output = output[0];
  m_errors = errors[0];
  errno = error;
  if (error != 0) fail(words.front().c_str());
}

Child::~Child() {
  kill();
  if (m_pid > 0) ::waitpid(m_pid, nullptr, 0);
  ::close(m_output);
  ::close(m_errors);
}

bool Child::waitFor(const std::string& word) {
  while (!m_read.starts_with(word) && m_read.find("\n" + word) == std::string::npos) {
    if (!take(m_output, m_read)) return false;
  }
  return true;
}

void Child::kill() const {
  if (m_pid > 0) ::kill(m_pid, SIGKILL);
}

Ended Child::ended() {
  Ended result;
  result.output = std::move(m_read);
  std::array<pollfd, 2> ends = {pollfd{m_output, POLLIN, 0}, pollfd{m_errors, POLLIN, 0}};
  while (ends[0].fd >= 0 || ends[1].fd >= 0) {
    if (::poll(ends.data(), ends.size(), -1) < 0) continue;
    if (ends[0].revents != 0 && !take(m_output, result.output)) ends[0].fd = -1;
    if (ends[1].revents != 0 && !take(m_errors, result.errors)) ends[1].fd = -1;
  }
  int status = 0;
  while (::waitpid(m_pid, &status, 0) < 0 && errno == EINTR) continue;
  m_pid = -1;
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

TemporaryFolder::TemporaryFolder()
    : m_path((std::filesystem::temp_directory_path() / "geargraph-XXXXXX").string()) {
  if (::mkdtemp(m_path.data()) == nullptr) fail("mkdtemp");
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  std::filesystem::remove_all(m_path, error);
}

}  // namespace geargraph::test
