#include "core/presentation/drawing/latex_text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace geargraph {
namespace {

/// The longer of two that begin alike comes first.
constexpr std::array<std::pair<std::string_view, std::string_view>, 31> kSigns = {
    {{"\u03b8\u0307", "$\\dot\\theta$"},
     {"\u2212", "$-$"},
     {"\u00b7", "$\\cdot$"},
     {"\u00d7", "$\\times$"},
     {"\u00a6", "$\\mid$"},
     {"\u0393", "$\\Gamma$"},
     {"\u03b7", "$\\eta$"},
     {"\u03b8", "$\\theta$"},
     {"\u03c9", "$\\omega$"},
     {"\u2070", "$^0$"},
     {"\u2080", "$_0$"},
     {"\u2081", "$_1$"},
     {"\u2082", "$_2$"},
     {"\u2083", "$_3$"},
     {"\u2084", "$_4$"},
     {"\u2085", "$_5$"},
     {"\u2086", "$_6$"},
     {"\u2087", "$_7$"},
     {"\u2088", "$_8$"},
     {"\u2089", "$_9$"},
     {"\u2032", "$'$"},
     {"\u00b0", "$^\\circ$"},
     {"\u2192", "$\\to$"},
     {"\u2013", "--"},
     {"\u2014", "---"},
     {"\u2018", "`"},
     {"\u2019", "'"},
     {"\u201c", "``"},
     {"\u201d", "''"},
     {"\u201e", ",,"},
     {"\u2026", "\\dots{}"}}};

}  // namespace

std::string escapedLatex(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto sign = std::find_if(kSigns.begin(), kSigns.end(),
                                   [&](const auto& s) { return text.substr(at).starts_with(s.first); });
    if (sign != kSigns.end()) {
      result += sign->second;
      at += sign->first.size() - 1;
      continue;
    }
    const char c = text[at];
    switch (c) {
      case '\\':
        result += "\\textbackslash{}";
        break;
      case '~':
        result += "\\textasciitilde{}";
        break;
      case '^':
        result += "\\textasciicircum{}";
        break;
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}':
        result += std::string("\\") + c;
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace geargraph
