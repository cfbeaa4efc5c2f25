#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/files/json.h"
#include "core/mechanism/document_format/json_checks.h"
#include "core/mechanism/model/limits.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Reads the members of one object of the file. A member of the wrong type adds a diagnostic with the
/// expected and the actual type and reads as its default, so that all problems of a file are found in one
/// pass. Members that were never read are unknown().
class JsonObject {
 public:
  /// Adds a diagnostic if the value is no object; then every member reads as absent, without further
  /// diagnostics.
  JsonObject(JsonDiagnostics& diagnostics, JsonValue value, std::string pointer);

  /// From here on, diagnostics name this element.
  void blame(const ElementId& element) { m_blamed = {element}; }
  [[nodiscard]] const std::string& pointer() const { return m_pointer; }
  [[nodiscard]] JsonDiagnostics& diagnostics() { return m_diagnostics; }

  [[nodiscard]] std::optional<JsonValue> member(std::string_view name);
  /// As member(), with a diagnostic if it is missing. `expected` is marked by toTranslate().
  [[nodiscard]] std::optional<JsonValue> required(std::string_view name, std::string_view expected);

  /// An id, or a reference to one: a string, or a whole number that is read as its decimal digits. Empty,
  /// with a diagnostic, if it is missing.
  [[nodiscard]] InternedString requiredId(std::string_view name);
  [[nodiscard]] std::optional<InternedString> id(std::string_view name);
  [[nodiscard]] std::optional<std::vector<InternedString>> ids(std::string_view name);
  [[nodiscard]] std::optional<std::string> text(std::string_view name);
  /// A text of at most kMaxNameLength characters.
  [[nodiscard]] std::optional<std::string> shortText(std::string_view name);
  [[nodiscard]] std::optional<Number> number(std::string_view name);
  [[nodiscard]] std::optional<NumberTriple> triple(std::string_view name);
  [[nodiscard]] std::optional<InertiaNumbers> inertia(std::string_view name);
  [[nodiscard]] std::optional<bool> flag(std::string_view name);
  /// The ends of a range: a list of two, each a number or null.
  using Ends = std::array<std::optional<Number>, 2>;
  [[nodiscard]] std::optional<Ends> ends(std::string_view name);
  /// A required whole number in lowest..highest; `lowest`, with a diagnostic, otherwise.
  [[nodiscard]] int requiredWhole(std::string_view name, int lowest, int highest);

  /// Adds a diagnostic at a member of this object. `expected` is marked by toTranslate(), or translated.
  void wrong(std::string_view name, JsonValue found, std::string_view expected);
  /// The members that were not read, in the order of the file. Adds a diagnostic for a common misspelling of
  /// one that was asked for (misspelledMember()), also beside that one: if it were kept there, the document
  /// could not be read again once the other is removed.
  [[nodiscard]] UnknownMembers unknown();

 private:
  [[nodiscard]] std::optional<InternedString> idOf(JsonValue value, const std::string& pointer);
  template <std::size_t count>
  [[nodiscard]] std::optional<std::array<Number, count>> numbers(std::string_view name,
                                                                 std::string_view expected);
  [[nodiscard]] std::optional<Number> numberOf(JsonValue value, const std::string& pointer);
  void rejectMisspelling(const std::string& name, JsonValue key);
  void wrongAt(const std::string& pointer, JsonValue found, std::string_view expected);
  [[nodiscard]] std::string pointerTo(std::string_view name) const { return m_pointer + pointerStep(name); }

  JsonDiagnostics& m_diagnostics;
  JsonValue m_value;
  std::string m_pointer;
  std::vector<ElementId> m_blamed;
  std::vector<std::string_view> m_known;  // names are literals of the caller
  bool m_isObject;
};

}  // namespace geargraph
