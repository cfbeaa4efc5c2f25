#include "core/foundations/files/json.h"

#include <charconv>

#include "core/foundations/base/contract.h"
#include "core/foundations/files/utf8.h"

namespace geargraph {
namespace {

std::uint32_t hexOf(std::string_view digits) {
  std::uint32_t code = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
  return code;
}

/// Appends what the escape at the start of `text` stands for and returns its length. @pre checked by the
/// parser
std::size_t appendEscape(std::string& result, std::string_view text) {
  constexpr std::string_view kNames = "bfnrt";
  constexpr std::string_view kMeanings = "\b\f\n\r\t";
  if (text[1] != 'u') {
    const std::size_t name = kNames.find(text[1]);
    result += name == std::string_view::npos ? text[1] : kMeanings[name];
    return 2;
  }
  std::uint32_t code = hexOf(text.substr(2, 4));
  const bool pair = code >= 0xD800 && code < 0xDC00;
  if (pair) code = 0x10000 + ((code - 0xD800) << 10U) + (hexOf(text.substr(8, 4)) - 0xDC00);
  appendUtf8(result, code);
  return pair ? 12 : 6;
}

}  // namespace

JsonValue JsonDocument::root() const {
  return {*this, 0};
}

std::string JsonValue::string() const {
  GEARGRAPH_REQUIRE(is(JsonKind::string));
  const std::string_view inner = slice().substr(1, slice().size() - 2);
  std::string result;
  result.reserve(inner.size());
  for (std::size_t at = 0; at < inner.size();) {
    const std::size_t escape = std::min(inner.find('\\', at), inner.size());
    result += inner.substr(at, escape - at);
    at = escape;
    if (at < inner.size()) at += appendEscape(result, inner.substr(at));
  }
  return result;
}

bool JsonValue::equals(std::string_view text) const {
  GEARGRAPH_REQUIRE(is(JsonKind::string));
  const std::string_view inner = slice().substr(1, slice().size() - 2);
  return inner.find('\\') == std::string_view::npos ? inner == text : string() == text;
}

std::size_t JsonValue::size() const {
  GEARGRAPH_REQUIRE(is(JsonKind::array) || is(JsonKind::object));
  std::size_t count = 0;
  if (is(JsonKind::array)) {
    forEachElement([&](JsonValue, std::size_t) { ++count; });
  } else {
    forEachMember([&](JsonValue, JsonValue) { ++count; });
  }
  return count;
}

std::optional<JsonValue> JsonValue::member(std::string_view name) const {
  GEARGRAPH_REQUIRE(is(JsonKind::object));
  const auto& nodes = m_document->m_nodes;
  for (std::uint32_t at = m_index + 1; at < node().next; at = nodes[at + 1].next) {
    if (JsonValue(*m_document, at).equals(name)) return JsonValue(*m_document, at + 1);
  }
  return std::nullopt;
}

std::optional<JsonValue> JsonValue::element(std::size_t position) const {
  GEARGRAPH_REQUIRE(is(JsonKind::array));
  const auto& nodes = m_document->m_nodes;
  for (std::uint32_t at = m_index + 1; at < node().next; at = nodes[at].next) {
    if (position-- == 0) return JsonValue(*m_document, at);
  }
  return std::nullopt;
}

std::string JsonValue::compact() const {
  std::string result;
  if (is(JsonKind::array)) {
    forEachElement([&](JsonValue value, std::size_t position) {
      result += (position == 0 ? "" : ", ") + value.compact();
    });
    return "[" + result + "]";
  }
  if (is(JsonKind::object)) {
    forEachMember([&](JsonValue key, JsonValue value) {
      result += result.empty() ? "" : ", ";
      result += key.slice();
      result += ": " + value.compact();
    });
    return "{" + result + "}";
  }
  return std::string(slice());
}

void appendJsonString(std::string& json, std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  json += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      json += '\\';
      json += c;
    } else if (c == '\n') {
      json += "\\n";
    } else if (c == '\t') {
      json += "\\t";
    } else if (byte < 0x20) {
      json += "\\u00";
      json += kDigits[byte / 16];
      json += kDigits[byte % 16];
    } else {
      json += c;
    }
  }
  json += '"';
}

}  // namespace geargraph
