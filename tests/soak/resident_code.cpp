#include "tests/soak/resident_code.h"

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

#include <algorithm>
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

void touchMemory() {
#ifdef __linux__
  constexpr std::size_t kMax = std::size_t{1} << 30;
  const std::size_t page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const std::size_t size = std::min(kMax, page * static_cast<std::size_t>(::sysconf(_SC_AVPHYS_PAGES)) / 4);
  void* const memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {  // NOLINT: a macro of the system's
    std::fprintf(stderr, "no memory to touch: the first use of a page may take longer\n");
    return;
  }
  for (std::size_t at = 0; at < size; at += page) static_cast<volatile char*>(memory)[at] = 1;
  ::munmap(memory, size);
#endif
}

}  // namespace geargraph::soak
