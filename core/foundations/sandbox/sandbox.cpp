#include "core/foundations/sandbox/sandbox.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace geargraph {
namespace {

// A sanitizer reserves terabytes of addresses.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif

bool limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  const rlimit both{soft, hard};
  return ::setrlimit(resource, &both) == 0;
}

std::string failure(const char* wall, int error) {
  return std::string(wall) + ": " + std::generic_category().message(error);
}

}  // namespace

bool renouncePrivileges() {
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
}

bool limitResources(const SandboxLimits& limits) {
  const auto seconds = static_cast<rlim_t>(limits.mostSeconds);
  // SIGKILL at the hard limit would tell the parent nothing, so the soft one comes first.
  return (!kLimitsMemory || limit(RLIMIT_AS, limits.mostMemory, limits.mostMemory)) &&
         limit(RLIMIT_CPU, seconds, seconds + 1) && limit(RLIMIT_CORE, 0, 0) && limit(RLIMIT_FSIZE, 0, 0) &&
         limit(RLIMIT_NPROC, 0, 0);
}

std::optional<std::string> enterSandbox(const SandboxLimits& limits) {
  ::closefrom(STDERR_FILENO + 1);
  if (!limitResources(limits)) return failure("resource limits", errno);
  if (!renouncePrivileges()) return failure("no new privileges", errno);
  if (!forbidFiles()) return failure("Landlock", errno);
  // After Landlock, whose rule set is an open file.
  constexpr rlim_t kStandardFiles = STDERR_FILENO + 1;
  if (!limit(RLIMIT_NOFILE, kStandardFiles, kStandardFiles)) return failure("resource limits", errno);
  if (const int error = filterCalls(); error != 0) return failure("seccomp", error);
  return std::nullopt;
}

}  // namespace geargraph
