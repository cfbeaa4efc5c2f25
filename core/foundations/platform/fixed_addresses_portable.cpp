#include "core/foundations/platform/fixed_addresses.h"

namespace geargraph {

void restartWithFixedAddresses(char** /*words*/) {}

}  // namespace geargraph
