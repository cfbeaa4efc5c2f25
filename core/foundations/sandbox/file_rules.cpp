// Landlock by its system calls: Debian 12's C library has no functions for it, and its headers describe
// version 2 only.

#include <linux/landlock.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

#include "core/foundations/sandbox/sandbox.h"

namespace geargraph {
namespace {

/// landlock_ruleset_attr of version 6. An older kernel takes the longer structure where what it does not know
/// is zero.
struct RulesetAttributes {
  std::uint64_t files = 0;
  std::uint64_t network = 0;
  std::uint64_t scopes = 0;
};

constexpr std::uint64_t lowBits(int count) {
  return (std::uint64_t{1} << static_cast<unsigned>(count)) - 1;
}

/// All rights that this version can withhold.
RulesetAttributes everything(int version) {
  constexpr int kOfVersion1 = 13, kMove = 14, kTruncate = 15, kDeviceControl = 16;
  RulesetAttributes all;
  all.files = lowBits(version >= 5   ? kDeviceControl
                      : version >= 3 ? kTruncate
                      : version == 2 ? kMove
                                     : kOfVersion1);
  if (version >= 4) all.network = lowBits(2);  // bind and connect a TCP port
  if (version >= 6) all.scopes = lowBits(2);   // abstract Unix sockets and signals
  return all;
}

}  // namespace

int landlockVersion() {
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  return version > 0 ? static_cast<int>(version) : 0;
}

bool forbidFiles() {
  const int version = landlockVersion();
  if (version == 0) return true;
  const RulesetAttributes attributes = everything(version);
  const long ruleset = ::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0);
  if (ruleset < 0) return false;
  const bool isInForce = ::syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
  const int error = errno;
  ::close(static_cast<int>(ruleset));
  errno = error;
  return isInForce;
}

}  // namespace geargraph
