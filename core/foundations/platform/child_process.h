#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace geargraph::inline platform {

/// A program that reads one file from its standard input and answers on standard output.
struct ChildProgram {
  std::filesystem::path program;
  std::vector<std::string> words;  ///< of its command line, without its name
  std::filesystem::path input;
  std::size_t mostInput = 0;   ///< bytes; a larger file is not given to it
  std::size_t mostOutput = 0;  ///< bytes that are kept
  std::size_t mostErrors = 0;  ///< bytes of standard error that are kept
  std::chrono::steady_clock::time_point deadline{};
};

enum class ChildEnd {
  exited,           ///< with `status`
  crashed,          ///< by a signal
  outOfTime,        ///< killed at the deadline, or by its own limit of processor time
  stopped,          ///< killed, as `stop` was requested
  notStarted,       ///< the program cannot be run
  tooManyFiles,     ///< this process has too many open files
  inputMissing,     ///< there is no such file
  inputUnreadable,  ///< it cannot be opened
  inputNoFile,      ///< it is a folder, a device or a pipe
  inputTooLarge,    ///< `inputSize` tells how large
};

struct ChildResult {
  ChildEnd end = ChildEnd::notStarted;
  int status = 0;
  std::uintmax_t inputSize = 0;
  std::string output{};
  std::string errors{};
};

/// Runs the program to its end, without environment and with no other open files; it is never left behind.
/// The input is opened without waiting for anybody (a pipe without a writer would). Ends within 0.1 s once
/// `stop` is requested. Portable: it has the environment and the open files of this process, nothing limits
/// its processor time but the deadline, and it is ended (`crashed`) where it writes 1 MiB more than is kept.
[[nodiscard]] ChildResult runChild(const ChildProgram& child, const std::stop_token& stop);

/// Can a program on this system give up its rights before it reads a file (core/foundations/sandbox)?
[[nodiscard]] bool confinesChildren();

}  // namespace geargraph::inline platform
