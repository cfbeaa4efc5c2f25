#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <variant>

#include "core/presentation/brep/brep.h"

namespace geargraph {

/// The limits for the process that writes a STEP file.
struct StepLimits {
  std::size_t mostBytes = std::size_t{2} << 30U;   ///< of the file
  std::size_t mostMemory = std::size_t{6} << 30U;  ///< bytes
  double mostSeconds = 1800;                       ///< wall-clock time; also the limit of CPU time
};

struct StepBytes {
  std::string bytes;
  int solids = 0;    ///< in all parts
  int ununited = 0;  ///< parts that consist of several solids which could not be united
};

struct StepProcessError {
  enum class Kind {
    missing,  ///< there is no such program
    stopped,
    limit,   ///< of memory, time or size
    failed,  ///< it crashed, or a part has no valid shape
  };
  Kind kind = Kind::failed;
  std::string message;  ///< a sentence
};

/// The assembly as a STEP file, by the program `writer` (geargraph-step) in a confined process. `progress`
/// (may be empty) is called on the caller's thread with the fraction done.
[[nodiscard]] std::variant<StepBytes, StepProcessError> stepBytes(const std::filesystem::path& writer,
                                                                  const CadAssembly& assembly,
                                                                  const StepLimits& limits,
                                                                  const std::function<void(double)>& progress,
                                                                  const std::stop_token& stop);

/// The path of the writer: the environment variable GEARGRAPH_STEP_WRITER, else beside the running program,
/// where the build or a package puts it, or in PATH. Empty if there is none.
[[nodiscard]] std::filesystem::path stepWriter();

// What geargraph-step says on standard error, a line each: "done 0.25", "solids 12", "ununited 1",
// "invalid NAME"; and how it ends.
constexpr int kStepFine = 0;
constexpr int kStepUnreadable = 2;
constexpr int kStepLimit = 3;
constexpr int kStepInvalid = 4;

}  // namespace geargraph
