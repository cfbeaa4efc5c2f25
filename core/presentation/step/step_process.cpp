#include "core/presentation/step/step_process.h"

#include <charconv>
#include <chrono>
#include <cstdlib>

#include "core/foundations/base/translation.h"
#include "core/foundations/platform/child_process.h"
#include "core/foundations/platform/system.h"

namespace geargraph {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Kind = StepProcessError::Kind;

constexpr std::size_t kMaxReport = 1U << 16U;

/// What follows the word on the last whole line that begins with it.
std::optional<std::string_view> lastOf(std::string_view report, std::string_view word) {
  std::optional<std::string_view> last;
  for (std::size_t end = report.find('\n'); end != std::string_view::npos; end = report.find('\n')) {
    const std::string_view line = report.substr(0, end);
    if (line.starts_with(word)) last = line.substr(word.size());
    report.remove_prefix(end + 1);
  }
  return last;
}

template <class Number>
Number numberOf(std::string_view report, std::string_view word) {
  Number number = 0;
  if (const auto text = lastOf(report, word))
    std::from_chars(text->data(), text->data() + text->size(), number);
  return number;
}

StepProcessError failureOf(const ChildResult& result, const StepLimits& limits) {
  switch (result.end) {
    case ChildEnd::stopped:
      return {Kind::stopped, {}};
    case ChildEnd::outOfTime:
      return {Kind::limit, translated("Writing the STEP file took longer than %1 s.",
                                      {std::to_string(static_cast<int>(limits.mostSeconds))})};
    case ChildEnd::crashed:
      return {Kind::failed, translated("The program geargraph-step crashed; nothing was written.")};
    case ChildEnd::exited:
      break;
    default:
      return {Kind::missing, translated("The program geargraph-step cannot be run.")};
  }
  if (result.status == kStepLimit)
    return {
        Kind::limit,
        translated(
            "The STEP file takes more memory or more bytes than there may be; export a part of the train.")};
  if (const auto name = lastOf(result.errors, "invalid "))
    return {Kind::failed, translated("OpenCASCADE finds no valid solid in \"%1\"; nothing was written.",
                                     {std::string(*name)})};
  return {Kind::failed, translated("The program geargraph-step failed; nothing was written.")};
}

}  // namespace

std::variant<StepBytes, StepProcessError> stepBytes(const fs::path& writer, const CadAssembly& assembly,
                                                    const StepLimits& limits,
                                                    const std::function<void(double)>& progress,
                                                    const std::stop_token& stop) {
  const std::string request = packedAssembly(assembly);
  ChildProgram child;
  child.program = writer;
  child.words = {std::to_string(limits.mostMemory),
                 std::to_string(static_cast<long>(limits.mostSeconds) + 1)};
  child.given = request;
  child.mostOutput = limits.mostBytes;
  child.mostErrors = kMaxReport;
  child.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(limits.mostSeconds));
  if (progress) {
    child.heard = [&progress](std::string_view report) { progress(numberOf<double>(report, "done ")); };
  }
  ChildResult result = runChild(child, stop);
  if (result.end != ChildEnd::exited || result.status != kStepFine) return failureOf(result, limits);
  if (result.output.size() >= limits.mostBytes || !result.output.ends_with("END-ISO-10303-21;\n"))
    return failureOf({ChildEnd::exited, kStepLimit}, limits);
  return StepBytes{std::move(result.output), numberOf<int>(result.errors, "solids "),
                   numberOf<int>(result.errors, "ununited ")};
}

fs::path stepWriter() {
  if (const char* named = std::getenv("GEARGRAPH_STEP_WRITER"))  // NOLINT: nobody sets it meanwhile
    return named;
  std::error_code error;
  const fs::path here = programPath().parent_path();
  for (const char* place :
       {"geargraph-step", "../step/geargraph-step", "../libexec/geargraph/geargraph-step"}) {
    const fs::path program = (here / place).lexically_normal();
    if (!here.empty() && fs::is_regular_file(program, error)) return program;
  }
  const char* const path = std::getenv("PATH");  // NOLINT
  std::string_view folders = path != nullptr ? path : "";
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    const fs::path program = fs::path(folders.substr(0, end)) / "geargraph-step";
    if (program.is_absolute() && fs::is_regular_file(program, error)) return program;
    folders.remove_prefix(std::min(end + 1, folders.size()));
  }
  return {};
}

}  // namespace geargraph
