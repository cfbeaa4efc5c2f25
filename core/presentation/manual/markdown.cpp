#include "core/presentation/manual/markdown.h"

#include <md4c-html.h>

#include <array>
#include <utility>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

void append(const MD_CHAR* text, MD_SIZE size, void* html) {
  static_cast<std::string*>(html)->append(text, size);
}

std::string unescaped(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kEntities{
      {{"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}}};
  std::string plain;
  while (!text.empty()) {
    bool isEntity = false;
    for (const auto& [entity, character] : kEntities) {
      if (text.substr(0, entity.size()) != entity) continue;
      plain += character;
      text.remove_prefix(entity.size());
      isEntity = true;
      break;
    }
    if (isEntity) continue;
    plain += text.front();
    text.remove_prefix(1);
  }
  return plain;
}

/// Is this the name of the element that begins here, and not only how another one's begins?
bool isNamed(std::string_view afterBracket, std::string_view name) {
  if (afterBracket.substr(0, name.size()) != name || afterBracket.size() == name.size()) return false;
  const char next = afterBracket[name.size()];
  return next == '>' || next == ' ' || next == '/';
}

}  // namespace

std::string htmlOfMarkdown(std::string_view markdown) {
  std::string html;
  const int failed = md_html(markdown.data(), static_cast<MD_SIZE>(markdown.size()), append, &html,
                             MD_FLAG_TABLES | MD_FLAG_LATEXMATHSPANS, 0);
  GEARGRAPH_REQUIRE(failed == 0);
  return html;
}

std::string escapedMarkdown(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("\\`*_{}[]<>#|$").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string withElements(
    std::string_view html, std::string_view name,
    const std::function<std::string(std::string_view attributes, std::string_view inside)>& replacement) {
  const std::string closing = "</" + std::string(name) + ">";
  const bool isVoid = name == "img";
  std::string replaced;
  while (!html.empty()) {
    const std::size_t bracket = html.find('<');
    replaced += html.substr(0, bracket);
    if (bracket == std::string_view::npos) break;
    html.remove_prefix(bracket);
    if (!isNamed(html.substr(1), name)) {
      replaced += '<';
      html.remove_prefix(1);
      continue;
    }
    const std::size_t end = html.find('>');
    const std::size_t inside = end + 1;
    const std::size_t close = isVoid ? inside : html.find(closing, inside);
    GEARGRAPH_REQUIRE(end != std::string_view::npos && close != std::string_view::npos);
    const std::string_view attributes = html.substr(1 + name.size(), end - 1 - name.size());
    replaced += replacement(attributes, html.substr(inside, close - inside));
    html.remove_prefix(isVoid ? inside : close + closing.size());
  }
  return replaced;
}

std::string attributeOf(std::string_view attributes, std::string_view name) {
  const std::string start = " " + std::string(name) + "=\"";
  const std::size_t at = attributes.find(start);
  if (at == std::string_view::npos) return {};
  const std::string_view value = attributes.substr(at + start.size());
  return unescaped(value.substr(0, value.find('"')));
}

std::string plainTextOf(std::string_view html) {
  const std::string words = withElements(html, "x-equation", [](auto, auto) { return std::string(); });
  std::string text;
  bool isInTag = false;
  for (const char c : words) {
    if (c == '<') isInTag = true;
    if (!isInTag) text += c;
    if (c == '>') isInTag = false;
  }
  return unescaped(text);
}

}  // namespace geargraph
