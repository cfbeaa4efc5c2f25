#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/files/json.h"
#include "core/foundations/files/json_writer.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// A member of the parameters of a request or of an edit. One list of these reads the members, rejects
/// others, and is what `help` shows.
struct RequestMember {
  std::string_view name;
  std::string_view value;  ///< what it holds, e.g. "id of a link"
  bool isNeeded = false;
};

/// Which members an object has that are not in the list, as a sentence with the nearest names that are;
/// std::nullopt if it has none. `owner` is the method or edit, `but` a further member that is known.
[[nodiscard]] std::optional<std::string> unknownMember(std::string_view owner, const JsonValue& object,
                                                       std::span<const RequestMember> known,
                                                       std::string_view but = {});

/// "tail, head, [axis]": optional ones in brackets.
[[nodiscard]] std::string membersText(std::span<const RequestMember> members);
/// A list of objects with name, value and needed.
void writeMembers(JsonWriter& json, std::span<const RequestMember> members);

/// Reads the members of one edit that its list has; the first that is missing or wrong is kept as problem().
/// @pre names are in the list
class EditMembers {
 public:
  EditMembers(const JsonValue& edit, std::span<const RequestMember> known, std::string pointer)
      : m_edit(edit), m_known(known), m_pointer(std::move(pointer)) {}

  [[nodiscard]] const JsonValue& json() const { return m_edit; }
  /// JSON pointer of the edit.
  [[nodiscard]] const std::string& pointer() const { return m_pointer; }

  /// Empty if the member is optional and missing.
  [[nodiscard]] std::string text(std::string_view name);
  [[nodiscard]] int whole(std::string_view name);
  [[nodiscard]] std::vector<std::string> texts(std::string_view name);
  /// std::nullopt if the member is missing or null.
  [[nodiscard]] std::optional<NumberTriple> triple(std::string_view name);
  [[nodiscard]] std::vector<Input> inputs(std::string_view name);

  /// Is this a member of the list that was not read yet? For the members of an element that are read
  /// together.
  [[nodiscard]] bool isUnread(std::string_view name) const;
  [[nodiscard]] const std::optional<Diagnostic>& problem() const { return m_problem; }

 private:
  [[nodiscard]] std::optional<JsonValue> member(std::string_view name);
  [[nodiscard]] bool isNeeded(std::string_view name) const;
  void wrong(std::string_view name, std::string_view expected);

  JsonValue m_edit;
  std::span<const RequestMember> m_known;
  std::string m_pointer;
  std::vector<std::string_view> m_read;
  std::optional<Diagnostic> m_problem;
};

}  // namespace geargraph
