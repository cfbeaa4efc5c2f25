#pragma once

/// Programmer errors: a condition that no input can break. Always on, in every build, because a wrong number
/// on a lecturer's screen is worse than a stop. Errors of users are `Expected` (expected.h), never this.
#define GEARGRAPH_REQUIRE(condition) \
  ((condition) ? void(0) : ::geargraph::contractBroken(#condition, __FILE__, __LINE__))

namespace geargraph::inline base {

/// Prints the broken condition with its place and aborts.
[[noreturn]] void contractBroken(const char* condition, const char* file, int line);

}  // namespace geargraph::inline base
