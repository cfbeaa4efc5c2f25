// `geargraph-make-atlas LINKS`: all chains of 3 toLINKS links, as a file for the atlas, on standard output.

#include <charconv>
#include <cstdio>
#include <cstring>
#include <string>

#include "core/design/atlas/atlas_file.h"

int main(int count, char** words) {
  int links = 0;
  if (count == 2) std::from_chars(words[1], words[1] + std::strlen(words[1]), links);
  if (links < 3 || links > 8) {
    std::fputs("geargraph-make-atlas: the most links are needed, 3 to 8\n", stderr);
    return 2;
  }
  const std::string text = geargraph::atlasText(links);
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0 ? 0 : 2;
}
