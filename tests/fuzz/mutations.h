#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace geargraph::test {

using Random = std::mt19937_64;

inline std::size_t below(Random& random, std::size_t limit) {
  return limit == 0 ? 0 : static_cast<std::size_t>(random() % limit);
}

/// Pieces that parsers stumble over, and pieces of the format in wrong places.
inline const std::vector<std::string> kPieces = {
    "{",
    "}",
    "[",
    "]",
    ",",
    ":",
    "\"",
    "\\",
    "\\u0000",
    "\\ud800",
    "\\udc00",
    "\\ud83d\\ude00",
    "null",
    "true",
    "-",
    "0",
    "-0",
    "1e999",
    "1e-999",
    "9999999999999999999999",
    "0.1e+1",
    "01",
    ".5",
    "1.",
    "\xFF",
    "\xC0\x80",
    "\xED\xA0\x80",
    "\xEF\xBB\xBF",
    "\xF4\x90\x80\x80",
    "\n",
    "\t",
    std::string(1, '\0'),
    "\"22/7\"",
    "\"1/0\"",
    "\"id\": ",
    "{}",
    "[]",
    "\"\"",
    "\"links\": ",
    "\"0\"",
    "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[["};

/// One small change of a text.
inline void mutate(std::string& text, Random& random) {
  const std::size_t at = below(random, text.size() + 1);
  switch (below(random, 7)) {
    case 0:
      if (at < text.size()) text[at] = static_cast<char>(random());
      return;
    case 1:
      text.erase(at, below(random, 12));
      return;
    case 2:
      text.insert(at, kPieces[below(random, kPieces.size())]);
      return;
    case 3:
      text.resize(at);
      return;
    case 4:
      text.insert(at, text.substr(below(random, text.size()), below(random, 60)));
      return;
    case 5: {  // one value in place of another
      const std::size_t quote = text.find('"', at);
      if (quote == std::string::npos) return;
      const std::size_t end = text.find('"', quote + 1);
      if (end != std::string::npos)
        text.replace(quote, end + 1 - quote, kPieces[below(random, kPieces.size())]);
      return;
    }
    default: {  // another digit
      const std::size_t digit = text.find_first_of("0123456789", at);
      if (digit != std::string::npos) text[digit] = static_cast<char>('0' + below(random, 10));
    }
  }
}

}  // namespace geargraph::test
