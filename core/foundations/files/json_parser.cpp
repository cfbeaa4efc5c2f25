#include <limits>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/json.h"
#include "core/foundations/files/utf8.h"

namespace geargraph {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
bool isHexDigit(char c) {
  return isDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

std::size_t digitsAt(std::string_view text, std::size_t at) {
  std::size_t count = 0;
  while (at + count < text.size() && isDigit(text[at + count])) ++count;
  return count;
}

/// The length of the JSON number at the start of the text, or 0. `stop` is where it ceases to be one.
std::size_t numberLength(std::string_view text, std::size_t& stop) {
  std::size_t at = !text.empty() && text[0] == '-' ? 1 : 0;
  const auto some = [&] {
    const std::size_t digits = digitsAt(text, at);
    at += digits;
    stop = at;
    return digits > 0;
  };
  if (at < text.size() && text[at] == '0') {
    ++at;
  } else if (!some()) {
    return 0;
  }
  if (at < text.size() && text[at] == '.') {
    ++at;
    if (!some()) return 0;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    if (!some()) return 0;
  }
  stop = at;
  return at;
}

}  // namespace

bool isJsonNumber(std::string_view text) {
  std::size_t stop = 0;
  return !text.empty() && numberLength(text, stop) == text.size();
}

/// Recursive descent; the depth is bounded, so the stack is.
class JsonParser {
 public:
  explicit JsonParser(std::string_view text) { m_document.m_text = text; }

  Expected<JsonDocument> run() {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text().size() >= std::numeric_limits<std::uint32_t>::max()) {
      return Diagnostic{Code::schema, translated("The file is far too large."), {}, {}, 0, 0};
    }
    if (text().starts_with(kByteOrderMark)) m_at = kByteOrderMark.size();
    skipSpace();
    if (!value(1)) return failure();
    skipSpace();
    if (m_at < text().size()) {
      fail(translated("expected the end of the file after the outermost value"));
      return failure();
    }
    return std::move(m_document);
  }

 private:
  [[nodiscard]] std::string_view text() const { return m_document.m_text; }
  [[nodiscard]] bool at(char c) const { return m_at < text().size() && text()[m_at] == c; }

  /// Remembers what was expected where the text stands now.
  bool fail(std::string expected, Code code = Code::syntax) {
    m_expected = std::move(expected);
    m_code = code;
    return false;
  }

  void skipSpace() {
    while (at(' ') || at('\n') || at('\t') || at('\r')) ++m_at;
  }

  std::size_t open(JsonKind kind) {
    const auto begin = static_cast<std::uint32_t>(m_at);
    m_document.m_nodes.push_back({begin, begin, 0, kind});
    return m_document.m_nodes.size() - 1;
  }
  bool close(std::size_t node) {
    m_document.m_nodes[node].end = static_cast<std::uint32_t>(m_at);
    m_document.m_nodes[node].next = static_cast<std::uint32_t>(m_document.m_nodes.size());
    return true;
  }

  bool value(int depth) {
    if (m_at == text().size()) return fail(translated("expected a value"));
    const char first = text()[m_at];
    if (first == '{' || first == '[') {
      if (depth > JsonDocument::kDeepest) {
        return fail(translated("lists and objects are nested deeper than %1",
                               {std::to_string(JsonDocument::kDeepest)}),
                    Code::schema);
      }
      return first == '{' ? object(depth) : array(depth);
    }
    if (first == '"') return string();
    if (first == '-' || isDigit(first)) return number();
    if (first == 't') return word("true", JsonKind::boolean);
    if (first == 'f') return word("false", JsonKind::boolean);
    if (first == 'n') return word("null", JsonKind::null);
    return fail(translated("expected a value"));
  }

  bool word(std::string_view wanted, JsonKind kind) {
    if (text().substr(m_at, wanted.size()) != wanted) return fail(translated("expected a value"));
    const std::size_t node = open(kind);
    m_at += wanted.size();
    return close(node);
  }

  bool number() {
    const std::size_t node = open(JsonKind::number);
    std::size_t stop = 0;
    const std::size_t length = numberLength(text().substr(m_at), stop);
    m_at += length > 0 ? length : stop;
    if (length == 0) return fail(translated("expected a digit of a number"));
    return close(node);
  }

  bool array(int depth) {
    const std::size_t node = open(JsonKind::array);
    ++m_at;
    skipSpace();
    if (!at(']')) {
      while (true) {
        skipSpace();
        if (!value(depth + 1)) return false;
        skipSpace();
        if (!at(',')) break;
        ++m_at;
      }
    }
    if (!at(']')) return fail(translated("expected ',' or ']' in a list"));
    ++m_at;
    return close(node);
  }

  bool object(int depth) {
    const std::size_t node = open(JsonKind::object);
    ++m_at;
    skipSpace();
    if (!at('}')) {
      while (true) {
        skipSpace();
        if (!at('"')) return fail(translated("expected a member name in double quotes"));
        if (!string()) return false;
        skipSpace();
        if (!at(':')) return fail(translated("expected ':' after a member name"));
        ++m_at;
        skipSpace();
        if (!value(depth + 1)) return false;
        skipSpace();
        if (!at(',')) break;
        ++m_at;
      }
    }
    if (!at('}')) return fail(translated("expected ',' or '}' in an object"));
    ++m_at;
    return close(node);
  }

  bool string() {
    const std::size_t node = open(JsonKind::string);
    for (++m_at; !at('"');) {
      if (m_at == text().size()) return fail(translated("expected the closing quote of a string"));
      if (static_cast<unsigned char>(text()[m_at]) < 0x20) {
        return fail(translated("expected the closing quote of a string, or an escape such as \\n"));
      }
      if (at('\\')) {
        if (!escape()) return false;
        continue;
      }
      const std::size_t length = utf8Length(text(), m_at);
      if (length == 0) return fail(translated("expected a character in UTF-8"));
      m_at += length;
    }
    ++m_at;
    return close(node);
  }

  bool escape() {
    const char kind = m_at + 1 < text().size() ? text()[m_at + 1] : '\0';
    if (kind == 'u') return unicodeEscape();
    if (kind == '\0' || std::string_view("\"\\/bfnrt").find(kind) == std::string_view::npos) {
      return fail(translated("expected an escape that JSON knows (\\\" \\\\ \\/ \\b \\f \\n \\r \\t \\u)"));
    }
    m_at += 2;
    return true;
  }

  [[nodiscard]] std::optional<unsigned> hex(std::size_t from) const {
    if (from + 6 > text().size() || text()[from] != '\\' || text()[from + 1] != 'u') return std::nullopt;
    unsigned code = 0;
    for (const char c : text().substr(from + 2, 4)) {
      if (!isHexDigit(c)) return std::nullopt;
      code = code * 16 + static_cast<unsigned>(isDigit(c) ? c - '0' : (c | 0x20) - 'a' + 10);
    }
    return code;
  }

  bool unicodeEscape() {
    const auto code = hex(m_at);
    if (!code) return fail(translated("expected four hexadecimal digits after \\u"));
    const bool high = *code >= 0xD800 && *code < 0xDC00;
    if (*code >= 0xDC00 && *code < 0xE000)
      return fail(translated("expected no second half of a surrogate pair here"));
    if (high) {
      const auto low = hex(m_at + 6);
      if (!low || *low < 0xDC00 || *low >= 0xE000)
        return fail(translated("expected both halves of a surrogate pair"));
    }
    m_at += high ? 12 : 6;
    return true;
  }

  [[nodiscard]] std::string found() const {
    if (m_at >= text().size()) return translated("the end of the file");
    const std::size_t length = utf8Length(text(), m_at);
    const auto byte = static_cast<unsigned char>(text()[m_at]);
    if (length > 0 && byte >= 0x20 && byte != 0x7F)
      return "'" + std::string(text().substr(m_at, length)) + "'";
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    return translated("the byte 0x%1", {std::string{kDigits[byte / 16], kDigits[byte % 16]}});
  }

  [[nodiscard]] Diagnostic failure() const {
    const std::string_view before = text().substr(0, m_at);
    std::size_t line = 1;
    for (const char c : before) line += c == '\n' ? 1 : 0;
    const std::size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0
    const std::size_t column = utf8Count(before.substr(lineStart)) + 1;
    std::string message =
        m_code == Code::syntax
            ? translated("Line %1, column %2: %3, found %4.",
                         {std::to_string(line), std::to_string(column), m_expected, found()})
            : translated("Line %1, column %2: %3.",
                         {std::to_string(line), std::to_string(column), m_expected});
    return {m_code, std::move(message), {}, {}, static_cast<int>(line), static_cast<int>(column)};
  }

  JsonDocument m_document;
  std::size_t m_at = 0;
  std::string m_expected;
  Code m_code = Code::syntax;
};

Expected<JsonDocument> JsonDocument::parse(std::string_view text) {
  return JsonParser(text).run();
}

}  // namespace geargraph
