#pragma once

#include <vector>

#include "core/foundations/base/diagnostic.h"

namespace geargraph::test {

/// The codes of the diagnostics, in order.
inline std::vector<Code> codesOf(const std::vector<Diagnostic>& diagnostics) {
  std::vector<Code> codes;
  for (const Diagnostic& diagnostic : diagnostics) codes.push_back(diagnostic.code);
  return codes;
}

}  // namespace geargraph::test
