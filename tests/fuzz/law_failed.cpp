#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/laws.h"

namespace geargraph::test {

void lawFailed(const char* what, std::string_view input) {
  std::fprintf(stderr, "%s, for these %zu bytes:\n", what, input.size());
  std::fwrite(input.data(), 1, input.size(), stderr);
  std::fputc('\n', stderr);
  std::abort();
}

}  // namespace geargraph::test
