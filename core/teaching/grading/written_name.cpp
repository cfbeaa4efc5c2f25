#include "core/teaching/grading/written_name.h"

#include <algorithm>
#include <array>
#include <utility>

namespace geargraph {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

std::string plainNotation(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 52> kSigns = {{
      {"\\dot{\\theta}", "theta"},
      {"\\dot\\theta", "theta"},
      {"\\theta", "theta"},
      {"\u03b8\u0307", "theta"},
      {"\u03b8", "theta"},
      {"\\omega", "w"},
      {"\u03c9", "w"},
      {"\\cdot", "*"},
      {"\\times", "*"},
      {"\u00b7", "*"},
      {"\u22c5", "*"},
      {"\u00d7", "*"},
      {"\u2212", "-"},
      {"\u2013", "-"},
      {"\u00f7", "/"},
      {"\u2044", "/"},
      {"\u2010", "-"},
      {"\u2011", "-"},
      {"\\%", "%"},
      {"\\left", ""},
      {"\\right", ""},
      {"\\dfrac", "\\frac"},
      {"\\tfrac", "\\frac"},
      {"\\prime", "'"},
      {"\u2032", "'"},
      {"\u2033", "''"},
      {"\u2034", "'''"},
      {"\\,", " "},
      {"\\;", " "},
      {"\\:", " "},
      {"\\!", ""},
      {"\\ ", " "},
      {"~", " "},
      {"{,}", "."},
      {"\u00a0", " "},
      {"\u202f", " "},
      {"\t", " "},
      {"\u2080", "0"},
      {"\u2081", "1"},
      {"\u2082", "2"},
      {"\u2083", "3"},
      {"\u2084", "4"},
      {"\u2085", "5"},
      {"\u2086", "6"},
      {"\u2087", "7"},
      {"\u2088", "8"},
      {"\u2089", "9"},
      {"\\mathrm", ""},
      {"\\displaystyle", ""},
      {"$", ""},
      {"\\quad", " "},
      {".*", "*"},
  }};
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    const auto sign = std::find_if(kSigns.begin(), kSigns.end(),
                                   [&](const auto& s) { return text.substr(at).starts_with(s.first); });
    if (sign == kSigns.end()) {
      plain += text[at++];
    } else {
      plain += sign->second;
      at += sign->first.size();
    }
  }
  return plain;
}

std::optional<WrittenName> nameAt(const std::string& text, std::size_t& at) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kBases = {{{"thetadot", "theta"},
                                                                                     {"theta", "theta"},
                                                                                     {"omega", "w"},
                                                                                     {"q", "theta"},
                                                                                     {"w", "w"},
                                                                                     {"i", "i"},
                                                                                     {"n", "n"},
                                                                                     {"N", "N"},
                                                                                     {"z", "N"},
                                                                                     {"d", "d"}}};
  const auto base = std::find_if(kBases.begin(), kBases.end(), [&](const auto& candidate) {
    return std::string_view(text).substr(at).starts_with(candidate.first);
  });
  if (base == kBases.end()) return std::nullopt;
  WrittenName name{std::string(base->second), {}, 0};
  std::size_t end = at + base->first.size();
  const auto primes = [&] {
    const bool isRaised =
        end + 1 < text.size() && text[end] == '^' && (text[end + 1] == '{' || text[end + 1] == '\'');
    const bool isRaisedInBraces = isRaised && text[end + 1] == '{';
    const std::size_t begin = end;
    if (isRaised) end += text[end + 1] == '{' ? 2 : 1;
    if (isRaised && (end >= text.size() || text[end] != '\'')) {
      end = begin;
      return;
    }
    for (; end < text.size() && text[end] == '\''; ++end) ++name.primes;
    if (isRaisedInBraces && end < text.size() && text[end] == '}') ++end;
  };
  primes();
  bool isBraced = false;
  if (end < text.size() && text[end] == '_') {
    ++end;
    isBraced = end < text.size() && text[end] == '{';
    if (isBraced) ++end;
  }
  for (; end < text.size(); ++end) {
    const char c = text[end];
    const bool isMark = (c == '_' || c == ',' || c == ' ') && !name.subscript.empty();
    const bool isInside =
        isBraced || ((c == '_' || c == ',') && end + 1 < text.size() && isDigit(text[end + 1]));
    if (isDigit(c)) {
      name.subscript += c;
    } else if (isMark && isInside) {
      if (name.subscript.back() != '_') name.subscript += '_';
    } else {
      break;
    }
  }
  if (isBraced) {
    if (end >= text.size() || text[end] != '}') return std::nullopt;
    ++end;
  }
  primes();
  if (name.subscript.empty() || name.subscript.back() == '_') return std::nullopt;
  at = end;
  return name;
}

}  // namespace geargraph
