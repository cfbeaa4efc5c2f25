#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/foundations/files/json.h"
#include "core/mechanism/model/limits.h"

namespace geargraph::inline document_format {

/// The findings about one JSON text, gathered with their places.
class JsonFindings {
 public:
  explicit JsonFindings(const JsonDocument& document) : m_document(document) {}

  /// `pointer` is the JSON pointer of what is wrong; `at` is it, or what surrounds it where it is missing.
  void add(Code code, std::string message, std::vector<ElementId> elements, std::string pointer,
           JsonValue at);

  /// Is there a finding about this pointer, or about something that contains it? Then another one at this
  /// place would only be its consequence.
  [[nodiscard]] bool covers(std::string_view pointer) const;

  [[nodiscard]] bool empty() const { return m_findings.empty(); }
  /// All of them in the order of the text, with line and column; schema findings say their pointer.
  /// Cost: O(text + k log k).
  [[nodiscard]] Diagnostics inOrder() const;

 private:
  struct Placed {
    Diagnostic diagnostic;
    std::size_t offset = 0;
  };
  const JsonDocument& m_document;
  std::vector<Placed> m_findings;
  std::unordered_set<std::string> m_pointers;
};

/// What no JSON file may have, whatever its members mean: a list of more than kLongestList elements, a member
/// name twice in one object, a number too large for a double. One `schema` finding each. Cost: O(values).
void checkJson(const JsonDocument& document, JsonFindings& findings);

/// One step of a JSON pointer (RFC 6901), with its slash.
[[nodiscard]] std::string pointerStep(std::string_view name);
[[nodiscard]] std::string pointerStep(std::size_t position);

}  // namespace geargraph::inline document_format
