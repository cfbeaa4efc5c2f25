#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace geargraph {

/// A program that reads a file, or bytes, from its standard input and writes its result to standard output.
struct ChildProgram {
  std::filesystem::path program;
  std::vector<std::string> words;  ///< command line arguments
  std::filesystem::path input;
  std::size_t mostInput = 0;   ///< bytes; a larger file is rejected
  std::size_t mostOutput = 0;  ///< bytes that are kept
  std::size_t mostErrors = 0;  ///< bytes of standard error that are kept
  std::chrono::steady_clock::time_point deadline{};
  /// All of standard error so far, whenever there is more of it, on the caller's thread; may be empty.
  /// Portable version: not called.
  std::function<void(std::string_view)> heard = {};
  std::optional<std::string_view> given = {};  ///< what it reads instead of a file
};

enum class ChildEnd {
  exited,           ///< with `status`
  crashed,          ///< by a signal
  outOfTime,        ///< killed at the deadline, or by its own limit of CPU time
  stopped,          ///< killed because `stop` was requested
  notStarted,       ///< the program cannot be run
  tooManyFiles,     ///< this process has too many open files
  inputMissing,     ///< there is no such file
  inputUnreadable,  ///< it cannot be opened
  inputNoFile,      ///< it is a folder, a device or a pipe
  inputTooLarge,    ///< its size is in `inputSize`
};

struct ChildResult {
  ChildEnd end = ChildEnd::notStarted;
  int status = 0;
  std::uintmax_t inputSize = 0;
  std::string output{};
  std::string errors{};
};

/// Runs the program to its end, without environment and with no other open files; it never outlives the call.
/// The input is opened without blocking (a pipe without a writer would block). Returns within 0.1 s after
/// `stop` is requested. Portable version: the program inherits the environment and the open files of this
/// process, only the deadline limits its processor time, and it is terminated (`crashed`) once its output
/// exceeds `mostOutput` by 1 MiB.
[[nodiscard]] ChildResult runChild(const ChildProgram& child, const std::stop_token& stop);

/// Can a program on this system drop its rights before it reads a file (core/foundations/sandbox)?
[[nodiscard]] bool confinesChildren();

}  // namespace geargraph
