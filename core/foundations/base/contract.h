#pragma once

/// Asserts a condition that no input can violate: only programmer errors. Enabled in every build, because a
/// wrong result on a lecturer's screen is worse than an abort. User errors are reported by `Expected`
/// (expected.h) instead.
#define GEARGRAPH_REQUIRE(condition) \
  ((condition) ? void(0) : ::geargraph::contractBroken(#condition, __FILE__, __LINE__))

namespace geargraph {

/// Prints the violated condition with its location and aborts.
[[noreturn]] void contractBroken(const char* condition, const char* file, int line);

}  // namespace geargraph
