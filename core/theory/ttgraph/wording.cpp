#include "core/theory/ttgraph/wording.h"

#include <array>

namespace geargraph::inline ttgraph {

std::string countInWords(int count) {
  constexpr std::array<const char*, 13> kWords = {"no",    "one",   "two",  "three", "four",   "five",  "six",
                                                  "seven", "eight", "nine", "ten",   "eleven", "twelve"};
  return count >= 0 && count < static_cast<int>(kWords.size()) ? kWords[static_cast<std::size_t>(count)]
                                                               : std::to_string(count);
}

}  // namespace geargraph::inline ttgraph
