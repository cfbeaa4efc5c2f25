#include "core/foundations/base/contract.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/foundations/base/broken_contract.h"

namespace geargraph {
namespace {

std::array<char, 512> broken{};

}  // namespace

void contractBroken(const char* condition, const char* file, int line) {
  const char* slash = std::strrchr(file, '/');
  std::snprintf(broken.data(), broken.size(), "%s:%d: %s", slash != nullptr ? slash + 1 : file, line,
                condition);
  std::fprintf(stderr, "%s:%d: contract broken: %s\n", file, line, condition);
  std::abort();
}

const char* brokenContract() {
  return broken.data();
}

}  // namespace geargraph
