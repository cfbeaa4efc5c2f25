#pragma once

#include <vector>

#include "core/foundations/base/diagnostic.h"

namespace geargraph::test {

/// The codes of the diagnostics, in order.
inline std::vector<base::Code> codesOf(const std::vector<base::Diagnostic>& diagnostics) {
  std::vector<base::Code> codes;
  for (const base::Diagnostic& diagnostic : diagnostics) codes.push_back(diagnostic.code);
  return codes;
}

}  // namespace geargraph::test
