#include <sys/personality.h>
#include <unistd.h>

#include "core/foundations/platform/fixed_addresses.h"

namespace geargraph {

void restartWithFixedAddresses(char** words) {
  constexpr unsigned long kAsk = 0xffffffff;
  const int now = ::personality(kAsk);
  if (now == -1 || (now & ADDR_NO_RANDOMIZE) != 0) return;
  if (::personality(static_cast<unsigned long>(now) | ADDR_NO_RANDOMIZE) != -1)
    ::execv("/proc/self/exe", words);
}

}  // namespace geargraph
