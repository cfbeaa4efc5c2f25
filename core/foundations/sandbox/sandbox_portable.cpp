// The standard library cannot confine a process. It has the clock only, and the parent's eye on it.

#include "core/foundations/sandbox/sandbox.h"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace geargraph {

std::optional<std::string> enterSandbox(const SandboxLimits& limits) {
  // For a parent that is gone; one that is there is quicker.
  std::thread([seconds = limits.mostSeconds] {
    std::this_thread::sleep_for(std::chrono::seconds(seconds));
    std::_Exit(EXIT_FAILURE);
  }).detach();
  return std::nullopt;
}

bool renouncePrivileges() {
  errno = ENOSYS;
  return false;
}

bool limitResources(const SandboxLimits& limits) {
  (void)limits;
  errno = ENOSYS;
  return false;
}

int landlockVersion() {
  return 0;
}

bool forbidFiles() {
  return true;
}

int filterCalls() {
  return ENOSYS;
}

}  // namespace geargraph
