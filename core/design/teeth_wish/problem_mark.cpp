#include "core/design/teeth_wish/problem_mark.h"

#include "core/foundations/base/contract.h"
#include "core/foundations/files/json.h"

namespace geargraph {

std::string problemText(std::string_view document, std::string_view wish) {
  std::string text = "{\"document\": ";
  text.append(document).append(", \"wish\": ").append(wish).append("}");
  const auto parsed = JsonDocument::parse(text);
  GEARGRAPH_REQUIRE(parsed.has_value());
  return parsed->root().compact();
}

std::string markOf(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string mark;
  for (int shift = 60; shift >= 0; shift -= 4) mark += kDigits[hash >> static_cast<unsigned>(shift) & 15U];
  return mark;
}

}  // namespace geargraph
