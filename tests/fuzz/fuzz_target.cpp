// libFuzzer's entry for one law, which the build names.

#include <cstddef>
#include <cstdint>

#include "tests/fuzz/laws.h"

/// fontconfig keeps what it has read of the fonts until the process ends.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: LeakSanitizer's name
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libfontconfig.so";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  geargraph::test::GEARGRAPH_LAW(std::string(reinterpret_cast<const char*>(bytes), size));  // NOLINT
  return 0;
}
