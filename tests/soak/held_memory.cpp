#include "tests/soak/held_memory.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#ifdef GEARGRAPH_JEMALLOC
#include <jemalloc/jemalloc.h>
#else
#include <malloc.h>
#endif

namespace geargraph::soak {

#ifdef GEARGRAPH_JEMALLOC

double heldMemory() {
  std::uint64_t epoch = 1;  // any number: figures are those of the last time that this was set
  std::size_t held = 0;
  std::size_t size = sizeof held;
  if (mallctl("epoch", nullptr, nullptr, &epoch, sizeof epoch) != 0 ||
      mallctl("stats.allocated", &held, &size, nullptr, 0) != 0)
    throw std::runtime_error("jemalloc does not say what is allocated");
  return static_cast<double>(held) / 1e6;
}

#else

double heldMemory() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd) / 1e6;
}

#endif

}  // namespace geargraph::soak
