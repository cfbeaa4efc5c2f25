#include "core/theory/ttgraph/wording.h"

#include <array>

#include "core/foundations/base/translation.h"

namespace geargraph {

std::string countInWords(int count) {
  constexpr std::array<const char*, 13> kWords = {
      toTranslate("no"),    toTranslate("one"),  toTranslate("two"), toTranslate("three"),
      toTranslate("four"),  toTranslate("five"), toTranslate("six"), toTranslate("seven"),
      toTranslate("eight"), toTranslate("nine"), toTranslate("ten"), toTranslate("eleven"),
      toTranslate("twelve")};
  return count >= 0 && count < static_cast<int>(kWords.size())
             ? translated(kWords[static_cast<std::size_t>(count)])
             : std::to_string(count);
}

}  // namespace geargraph
