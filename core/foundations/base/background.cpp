#include "core/foundations/base/background.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace geargraph::inline base {

void workInBackground() {
#ifdef __linux__
  // Linux knows a priority by thread; to lower it needs no right, so that it cannot fail.
  constexpr int kNice = 5;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
#endif
}

}  // namespace geargraph::inline base
