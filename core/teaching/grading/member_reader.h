#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/json.h"

namespace geargraph {

/// Reads members of JSON objects and keeps the first error with its JSON pointer: `schema`, unless another
/// code is given.
class MemberReader {
 public:
  [[nodiscard]] const std::optional<Diagnostic>& fault() const { return m_fault; }

  void fail(const std::string& pointer, const std::string& message, Code code = Code::schema) {
    if (m_fault) return;
    m_fault = Diagnostic{code, message, {}, pointer};
  }

  /// The member, if it exists and is of this kind; an error if it is of another kind, or missing although
  /// needed.
  std::optional<JsonValue> member(const JsonValue& object, std::string_view name, JsonKind kind,
                                  const std::string& pointer, bool isNeeded = true) {
    if (!object.is(JsonKind::object)) {
      fail(pointer, translated("An object is needed here."));
      return std::nullopt;
    }
    const auto found = object.member(name);
    const std::string place = pointer + '/' + std::string(name);
    if (!found && isNeeded) fail(place, translated("The member \"%1\" is missing.", {name}));
    if (found && !found->is(kind)) {
      fail(place, translated("The member \"%1\" is of the wrong type.", {name}));
      return std::nullopt;
    }
    return found;
  }

  std::string text(const JsonValue& object, std::string_view name, const std::string& pointer,
                   bool isNeeded = true) {
    const auto found = member(object, name, JsonKind::string, pointer, isNeeded);
    return found ? found->string() : std::string();
  }

  int number(const JsonValue& value, const std::string& pointer) {
    int number = 0;
    const std::string_view slice = value.slice();
    const auto [end, error] = std::from_chars(slice.data(), slice.data() + slice.size(), number);
    if (!value.is(JsonKind::number) || error != std::errc() || end != slice.data() + slice.size())
      fail(pointer, translated("A whole number is needed here."));
    return number;
  }

  std::optional<int> memberNumber(const JsonValue& object, std::string_view name, const std::string& pointer,
                                  bool isNeeded = true) {
    const auto found = member(object, name, JsonKind::number, pointer, isNeeded);
    if (!found) return std::nullopt;
    return number(*found, pointer + '/' + std::string(name));
  }

  /// Calls visit(element, pointer) for each element of the member, if it exists.
  template <class Visit>
  void each(const JsonValue& object, std::string_view name, const std::string& pointer, bool isNeeded,
            Visit visit) {
    const auto found = member(object, name, JsonKind::array, pointer, isNeeded);
    if (found) eachElement(*found, pointer + '/' + std::string(name), visit);
  }
  template <class Visit>
  void eachElement(const JsonValue& array, const std::string& pointer, Visit visit) {
    if (!array.is(JsonKind::array)) return fail(pointer, translated("An array is needed here."));
    array.forEachElement([&](const JsonValue& element, std::size_t position) {
      visit(element, pointer + '/' + std::to_string(position));
    });
  }

  std::vector<std::string> texts(const JsonValue& object, std::string_view name, const std::string& pointer,
                                 bool isNeeded) {
    std::vector<std::string> all;
    each(object, name, pointer, isNeeded, [&](const JsonValue& element, const std::string& place) {
      all.push_back(elementText(element, place));
    });
    return all;
  }
  std::string elementText(const JsonValue& element, const std::string& pointer) {
    if (element.is(JsonKind::string)) return element.string();
    fail(pointer, translated("A text is needed here."));
    return {};
  }

  std::vector<int> numbers(const JsonValue& object, std::string_view name, const std::string& pointer) {
    std::vector<int> all;
    each(object, name, pointer, false,
         [&](const JsonValue& element, const std::string& place) { all.push_back(number(element, place)); });
    return all;
  }

  std::vector<ElementId> elements(const JsonValue& object, const std::string& pointer) {
    std::vector<ElementId> all;
    for (const std::string& text : texts(object, "elements", pointer, false)) {
      const auto slash = text.find('/');
      std::optional<ElementKind> kind;
      for (int i = 0; i <= static_cast<int>(ElementKind::load); ++i) {
        if (listName(static_cast<ElementKind>(i)) == text.substr(0, slash))
          kind = static_cast<ElementKind>(i);
      }
      if (!kind || slash == std::string::npos) {
        fail(pointer + "/elements", translated("\"%1\" is no list of the document with an id.", {text}));
        return all;
      }
      all.emplace_back(*kind, InternedString(text.substr(slash + 1)));
    }
    return all;
  }

  /// Checks format and version of a document.
  void heading(const JsonValue& root, std::string_view format, int newest) {
    if (!root.is(JsonKind::object) || text(root, "format", "") != format)
      return fail("/format", translated("This is no file of the format \"%1\".", {format}), Code::format);
    const auto version = memberNumber(root, "version", "");
    if (version && (*version < 1 || *version > newest))
      fail("/version", translated("Version %1 is not known to this program.", {std::to_string(*version)}),
           Code::version);
  }

 private:
  std::optional<Diagnostic> m_fault;
};

}  // namespace geargraph
