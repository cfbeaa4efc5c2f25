#include "core/ttgraph/wording.h"

#include <algorithm>
#include <array>

namespace geargraph {

std::string listed(const std::vector<std::string>& names, const char* last) {
  constexpr std::size_t kMostNames = 8;
  const std::size_t shown = std::min(names.size(), kMostNames);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) text += i + 1 == names.size() ? " " + std::string(last) + " " : ", ";
    text += names[i];
  }
  if (shown < names.size()) text += " and " + std::to_string(names.size() - shown) + " more";
  return text;
}

std::string countInWords(int count) {
  constexpr std::array<const char*, 13> kWords = {"no",    "one",   "two",  "three", "four",   "five",  "six",
                                                  "seven", "eight", "nine", "ten",   "eleven", "twelve"};
  return count >= 0 && count < static_cast<int>(kWords.size()) ? kWords[static_cast<std::size_t>(count)]
                                                               : std::to_string(count);
}

}  // namespace geargraph
