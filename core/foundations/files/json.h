#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"

namespace geargraph {

enum class JsonKind : std::uint8_t { null, boolean, number, string, array, object };

class JsonValue;

/// A JSON text (RFC 8259), validated and indexed, but not copied: every value is a slice of the text. So
/// numbers keep their spelling (0.10, 1e-3, integers of any size), unknown members can be preserved as
/// written, and every diagnostic has its position.
///
/// The text has to outlive the document. Memory: 16 bytes per value, in addition to the text.
class JsonDocument {
 public:
  /// The deepest nesting of arrays and objects; the outermost is 1.
  static constexpr int kDeepest = 64;

  /// Validates the whole text. Fails with one `syntax` with line and column, or with `schema` if it is nested
  /// deeper than kDeepest. Cost: O(bytes).
  [[nodiscard]] static Expected<JsonDocument> parse(std::string_view text);

  [[nodiscard]] JsonValue root() const;
  [[nodiscard]] std::string_view text() const { return m_text; }

 private:
  friend class JsonValue;
  friend class JsonParser;

  /// One value, or one key of an object (a string before its value), in the order of the text.
  struct Node {
    std::uint32_t begin = 0;  ///< the slice of the text
    std::uint32_t end = 0;
    std::uint32_t next = 0;  ///< the node after this value and its content
    JsonKind kind = JsonKind::null;
  };

  std::string_view m_text;
  std::vector<Node> m_nodes;
};

/// One value of a JsonDocument; cheap to copy, valid as long as the document.
class JsonValue {
 public:
  [[nodiscard]] JsonKind kind() const { return node().kind; }
  [[nodiscard]] bool is(JsonKind kind) const { return node().kind == kind; }
  /// The text as written, e.g. `1e-3` or `"a
  /// "`.
  [[nodiscard]] std::string_view slice() const {
    return m_document->m_text.substr(node().begin, node().end - node().begin);
  }
  [[nodiscard]] std::size_t offset() const { return node().begin; }

  /// The text of a string, escapes resolved. @pre a string
  [[nodiscard]] std::string string() const;
  /// Is this the string `text`? @pre a string
  [[nodiscard]] bool equals(std::string_view text) const;
  /// @pre a boolean
  [[nodiscard]] bool boolean() const { return slice().front() == 't'; }

  /// Calls visit(element, position) for each element. @pre an array
  template <class Visit>
  void forEachElement(Visit visit) const {
    std::size_t position = 0;
    for (std::uint32_t at = m_index + 1; at < node().next; at = m_document->m_nodes[at].next) {
      visit(JsonValue(*m_document, at), position++);
    }
  }
  /// Calls visit(key, value) for each member; the key is a string value. @pre an object
  template <class Visit>
  void forEachMember(Visit visit) const {
    for (std::uint32_t at = m_index + 1; at < node().next; at = m_document->m_nodes[at + 1].next) {
      visit(JsonValue(*m_document, at), JsonValue(*m_document, at + 1));
    }
  }
  /// The number of elements or members. Cost: O(size). @pre an array or object
  [[nodiscard]] std::size_t size() const;
  /// The first member with this name; std::nullopt if there is none. @pre an object
  [[nodiscard]] std::optional<JsonValue> member(std::string_view name) const;
  [[nodiscard]] std::optional<JsonValue> element(std::size_t position) const;

  /// The same JSON in one line with canonical spaces; numbers and strings as written.
  [[nodiscard]] std::string compact() const;

 private:
  friend class JsonDocument;
  JsonValue(const JsonDocument& document, std::uint32_t index) : m_document(&document), m_index(index) {}
  [[nodiscard]] const JsonDocument::Node& node() const { return m_document->m_nodes[m_index]; }

  const JsonDocument* m_document;
  std::uint32_t m_index;
};

/// Is the text a number by JSON's grammar ("1e-3", "-0", but not "+1", ".5", "01")?
[[nodiscard]] bool isJsonNumber(std::string_view text);

/// Appends a text as a JSON string with its quotes; control characters, quote and backslash escaped.
void appendJsonString(std::string& json, std::string_view text);

}  // namespace geargraph
