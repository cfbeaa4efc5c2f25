#include "core/foundations/platform/child_process.h"

namespace geargraph::inline platform {

ChildResult runChild(const ChildProgram& child, const std::stop_token& stop) {
  (void)child;
  (void)stop;
  return {};
}

}  // namespace geargraph::inline platform
