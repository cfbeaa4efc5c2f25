#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/foundations/files/json.h"
#include "core/mechanism/model/limits.h"

namespace geargraph {

/// Collects the diagnostics of one JSON text with their positions.
class JsonDiagnostics {
 public:
  explicit JsonDiagnostics(const JsonDocument& document) : m_document(document) {}

  /// `pointer` is the JSON pointer of the wrong value; `at` is that value, or the one that should contain it
  /// if it is missing.
  void add(Code code, std::string message, std::vector<ElementId> elements, std::string pointer,
           JsonValue at);

  /// Is there a diagnostic for this pointer, or for a value that contains it? Then a further one here would
  /// only be its consequence.
  [[nodiscard]] bool covers(std::string_view pointer) const;

  [[nodiscard]] bool empty() const { return m_diagnostics.empty(); }
  /// All diagnostics in the order of the text, with line and column; those of `schema` include their pointer.
  /// Cost: O(text + k log k).
  [[nodiscard]] Diagnostics inOrder() const;

 private:
  struct Placed {
    Diagnostic diagnostic;
    std::size_t offset = 0;
  };
  const JsonDocument& m_document;
  std::vector<Placed> m_diagnostics;
  std::unordered_set<std::string> m_pointers;
};

/// Checks that apply whatever the members mean: lists of more than kMaxListLength elements, a member name
/// twice in one object, numbers too large for a double. One `schema` diagnostic each. Cost: O(values).
void checkJson(const JsonDocument& document, JsonDiagnostics& diagnostics);

/// One step of a JSON pointer (RFC 6901), with its slash.
[[nodiscard]] std::string pointerStep(std::string_view name);
[[nodiscard]] std::string pointerStep(std::size_t position);

}  // namespace geargraph
