// `geargraph-step MEMORY SECONDS`: reads an assembly by its exact faces from standard input
// (packedAssembly()) and writes it as a STEP file to standard output. It enters the sandbox before the first
// byte: a fault in a large library for CAD then costs a file that is not written, and nothing else.

#include <Standard_Failure.hxx>
#include <array>
#include <charconv>
#include <cstdlib>
#include <iostream>
#include <new>

#include "app/step/occ_file.h"
#include "core/foundations/files/byte_sink.h"
#include "core/foundations/files/file.h"
#include "core/foundations/platform/fixed_addresses.h"
#include "core/foundations/sandbox/sandbox.h"
#include "core/presentation/step/step_process.h"

namespace geargraph {
namespace {

constexpr std::size_t kMostRequest = std::size_t{1} << 31U;

std::optional<std::size_t> number(std::string_view word) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

int write() {
  const auto input = readFile("-", kMostRequest);
  if (!std::holds_alternative<std::string>(input)) return kStepUnreadable;
  const auto assembly = unpackedAssembly(std::get<std::string>(input));
  if (!assembly) return kStepUnreadable;
  double told = 0;
  const auto made = stepFile(*assembly, [&told](double done) {
    if (done < told + 0.01 && done < 1) return;
    told = done;
    std::cerr << "done " << done << '\n' << std::flush;
  });
  if (const auto* invalid = std::get_if<std::string>(&made)) {
    std::cerr << "invalid " << *invalid << '\n' << std::flush;
    return kStepInvalid;
  }
  const auto& file = std::get<StepFile>(made);
  std::cerr << "solids " << file.solids << "\nununited " << file.ununited << '\n' << std::flush;
  StandardOutput out;
  out.write(file.bytes);
  return out.failed() ? kStepLimit : kStepFine;
}

int run(int count, char** words) {
  const auto memory = count == 3 ? number(words[1]) : std::nullopt;
  const auto seconds = count == 3 ? number(words[2]) : std::nullopt;
  if (!memory || !seconds) return kStepUnreadable;
  if (enterSandbox({*memory, static_cast<long>(*seconds)})) return kStepUnreadable;
  try {
    return write();
  } catch (const std::bad_alloc&) {
    return kStepLimit;
  } catch (const Standard_Failure&) {
    return kStepInvalid;
  } catch (const std::exception&) {
    return kStepInvalid;
  }
}

}  // namespace
}  // namespace geargraph

// Ends without destructors: the system takes everything back at once.
int main(int count, char** words) {
  // OpenCASCADE puts some of a file in the order of addresses; what it reads is the parent's own.
  geargraph::restartWithFixedAddresses(words);
  std::_Exit(geargraph::run(count, words));
}
