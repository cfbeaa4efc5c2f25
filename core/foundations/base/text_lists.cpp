#include "core/foundations/base/text_lists.h"

#include <algorithm>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

[[maybe_unused]] constexpr const char* kUsualLast = toTranslate("and");  // the default of listed()

}  // namespace

std::string listed(const std::vector<std::string>& names, std::size_t most, const char* last) {
  const std::size_t shown = std::min(names.size(), most);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) text += i + 1 == names.size() ? " " + translated(last) + " " : ", ";
    text += names[i];
  }
  if (shown == names.size()) return text;
  return translated("%1 and %2 more", {text, std::to_string(names.size() - shown)});
}

std::string escapedXml(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

}  // namespace geargraph
