#include "tests/soak/resident_code.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <string>

namespace geargraph::soak {

void keepCodeResident() {
#ifdef __linux__
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t begin = 0, end = 0;
    char rights[5] = {};
    const bool isRead = std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR " %4s", &begin, &end, rights) == 3;
    const bool isFile = line.find(" /") != std::string::npos;
    if (!isRead || !isFile || rights[0] != 'r' || rights[1] == 'w') continue;
    if (::mlock(reinterpret_cast<void*>(begin), end - begin) == 0) continue;
    std::fprintf(stderr, "pages of code may be read from the disk again: no right to lock them\n");
    return;
  }
#endif
}

}  // namespace geargraph::soak
