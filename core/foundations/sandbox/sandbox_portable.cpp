// The standard library cannot confine a process, so none is let loose on files of unknown origin.

#include <cerrno>

#include "core/foundations/sandbox/sandbox.h"

namespace geargraph::inline sandbox {

std::optional<std::string> enterSandbox(const SandboxLimits& limits) {
  (void)limits;
  return "This system cannot confine the program that reads 3D files.";
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

}  // namespace geargraph::inline sandbox
