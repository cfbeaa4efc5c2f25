#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

namespace geargraph::test {

/// How a program ended and what it printed.
struct Ended {
  int status = -1;  ///< exit status, or -1 where a signal ended it
  std::string output;
  std::string errors;
};

/// A running program, its output in pipes. Killed (SIGKILL) and waited for by the destructor.
class Child {
 public:
  /// `environment` is added to that of this process. Ends the test program where it cannot be started.
  explicit Child(const std::vector<std::string>& words,
                 const std::map<std::string, std::string>& environment = {});
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Reads until a line of the output starts with this word; false where the output ends before.
  bool waitFor(const std::string& word);
  /// SIGKILL, as of a power cut or the kernel's memory killer.
  void kill() const;
  /// Reads until both pipes are closed, and waits for the end.
  [[nodiscard]] Ended ended();

 private:
  pid_t m_pid = -1;
  int m_output = -1;
  int m_errors = -1;
  std::string m_read;  ///< of the output, by waitFor()
};

/// A new empty folder in the folder for temporary files, removed with its contents by the destructor.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::string& path() const { return m_path; }

 private:
  std::string m_path;
};

}  // namespace geargraph::test
