#include "core/mechanism/document_format/json_object.h"

#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/utf8.h"
#include "core/mechanism/model/unknown_members.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxQuoteLength = 40;

/// What stands in the file, for a sentence: the number 1.5, the string "abc", a list of 3 elements.
std::string described(JsonValue value) {
  std::string slice(value.slice().substr(0, kMaxQuoteLength));
  if (slice.size() < value.slice().size()) {
    while (!slice.empty() && (static_cast<unsigned char>(slice.back()) & 0xC0U) == 0x80U) slice.pop_back();
    if (!slice.empty() && static_cast<unsigned char>(slice.back()) >= 0x80U) slice.pop_back();
    slice += "...";
  }
  switch (value.kind()) {
    case JsonKind::null:
    case JsonKind::boolean:
      return slice;
    case JsonKind::number:
      return translated("the number %1", {slice});
    case JsonKind::string:
      return translated("the string %1", {slice});
    case JsonKind::array:
      return translated("a list of %1 elements", {std::to_string(value.size())});
    case JsonKind::object:
      return translated("an object");
  }
  return slice;
}

bool isWholeNumber(std::string_view number) {
  return number.find_first_of(".eE") == std::string_view::npos;
}

constexpr std::string_view kId = toTranslate("an id: a string of 1 to 1,000 characters or a whole number");
constexpr std::string_view kNumber = toTranslate("a number, or a fraction as a string like \"22/7\"");

}  // namespace

JsonObject::JsonObject(JsonDiagnostics& diagnostics, JsonValue value, std::string pointer)
    : m_diagnostics(diagnostics),
      m_value(value),
      m_pointer(std::move(pointer)),
      m_isObject(value.is(JsonKind::object)) {
  if (!m_isObject) wrongAt(m_pointer, value, toTranslate("an object"));
}

void JsonObject::wrongAt(const std::string& pointer, JsonValue found, std::string_view expected) {
  if (m_diagnostics.covers(pointer)) return;
  m_diagnostics.add(Code::schema,
                    translated("expected %1, found %2.", {translated(expected), described(found)}), m_blamed,
                    pointer, found);
}

void JsonObject::wrong(std::string_view name, JsonValue found, std::string_view expected) {
  wrongAt(pointerTo(name), found, expected);
}

std::optional<JsonValue> JsonObject::member(std::string_view name) {
  m_known.push_back(name);
  return m_isObject ? m_value.member(name) : std::nullopt;
}

std::optional<JsonValue> JsonObject::required(std::string_view name, std::string_view expected) {
  auto value = member(name);
  if (!value && m_isObject) {
    m_diagnostics.add(Code::schema,
                      translated("the member \"%1\" is missing; expected %2.", {name, translated(expected)}),
                      m_blamed, pointerTo(name), m_value);
  }
  return value;
}

std::optional<InternedString> JsonObject::idOf(JsonValue value, const std::string& pointer) {
  if (value.is(JsonKind::string)) {
    const std::string text = value.string();
    if (!text.empty() && utf8Count(text) <= kMaxNameLength) return InternedString(text);
  } else if (value.is(JsonKind::number) && isWholeNumber(value.slice()) &&
             value.slice().size() <= kMaxNameLength) {
    return InternedString(value.slice() == "-0" ? "0" : value.slice());
  }
  wrongAt(pointer, value, kId);
  return std::nullopt;
}

InternedString JsonObject::requiredId(std::string_view name) {
  const auto value = required(name, kId);
  return value ? idOf(*value, pointerTo(name)).value_or(InternedString()) : InternedString();
}

std::optional<InternedString> JsonObject::id(std::string_view name) {
  const auto value = member(name);
  if (!value) return std::nullopt;
  return idOf(*value, pointerTo(name)).value_or(InternedString());
}

std::optional<std::vector<InternedString>> JsonObject::ids(std::string_view name) {
  const auto value = member(name);
  if (!value) return std::nullopt;
  std::vector<InternedString> result;
  if (!value->is(JsonKind::array)) {
    wrong(name, *value, toTranslate("a list of ids"));
  } else if (!m_diagnostics.covers(pointerTo(name))) {
    value->forEachElement([&](JsonValue element, std::size_t position) {
      result.push_back(idOf(element, pointerTo(name) + pointerStep(position)).value_or(InternedString()));
    });
  }
  return result;
}

std::optional<std::string> JsonObject::text(std::string_view name) {
  const auto value = member(name);
  if (!value) return std::nullopt;
  if (value->is(JsonKind::string)) return value->string();
  wrong(name, *value, toTranslate("a string"));
  return std::nullopt;
}

std::optional<std::string> JsonObject::shortText(std::string_view name) {
  auto result = text(name);
  if (!result || utf8Count(*result) <= kMaxNameLength) return result;
  m_diagnostics.add(
      Code::schema,
      translated("expected at most 1,000 characters, found %1.", {std::to_string(utf8Count(*result))}),
      m_blamed, pointerTo(name), *m_value.member(name));
  return std::nullopt;
}

std::optional<Number> JsonObject::numberOf(JsonValue value, const std::string& pointer) {
  std::optional<Number> number;
  if (value.is(JsonKind::number)) number = Number::fromText(value.slice());
  if (value.is(JsonKind::string)) number = Number::fromText(value.string());
  if (!number) wrongAt(pointer, value, kNumber);
  return number;
}

std::optional<Number> JsonObject::number(std::string_view name) {
  const auto value = member(name);
  return value ? numberOf(*value, pointerTo(name)) : std::nullopt;
}

template <std::size_t count>
std::optional<std::array<Number, count>> JsonObject::numbers(std::string_view name,
                                                             std::string_view expected) {
  const auto value = member(name);
  if (!value) return std::nullopt;
  if (!value->is(JsonKind::array) || value->size() != count) {
    wrong(name, *value, expected);
    return std::nullopt;
  }
  std::array<Number, count> result;
  bool complete = true;
  value->forEachElement([&](JsonValue element, std::size_t position) {
    const auto number = numberOf(element, pointerTo(name) + pointerStep(position));
    if (number) result.at(position) = *number;
    complete = complete && number.has_value();
  });
  if (!complete) return std::nullopt;
  return result;
}

std::optional<NumberTriple> JsonObject::triple(std::string_view name) {
  return numbers<3>(name, toTranslate("a list of three numbers"));
}

std::optional<InertiaNumbers> JsonObject::inertia(std::string_view name) {
  return numbers<6>(name, toTranslate("a list of six numbers, xx, yy, zz, xy, xz, yz"));
}

std::optional<bool> JsonObject::flag(std::string_view name) {
  const auto value = member(name);
  if (!value) return std::nullopt;
  if (value->is(JsonKind::boolean)) return value->slice() == "true";
  wrong(name, *value, toTranslate("true or false"));
  return std::nullopt;
}

std::optional<JsonObject::Ends> JsonObject::ends(std::string_view name) {
  const auto value = member(name);
  if (!value) return std::nullopt;
  if (!value->is(JsonKind::array) || value->size() != 2) {
    wrong(name, *value, toTranslate("a list of two, each a number or null"));
    return std::nullopt;
  }
  Ends result;
  value->forEachElement([&](JsonValue element, std::size_t position) {
    if (element.is(JsonKind::null)) return;
    result.at(position) = numberOf(element, pointerTo(name) + pointerStep(position));
  });
  return result;
}

int JsonObject::requiredWhole(std::string_view name, int lowest, int highest) {
  const auto value = member(name);
  if (value && value->is(JsonKind::number)) {
    const auto exact = Rational::fromText(value->slice());
    if (exact && exact->isInteger() && *exact >= lowest && *exact <= highest) {
      return static_cast<int>(exact->toDouble());
    }
  }
  const std::string expected =
      lowest == highest
          ? translated("the whole number %1", {std::to_string(lowest)})
          : translated("a whole number from %1 to %2", {std::to_string(lowest), std::to_string(highest)});
  if (value) {
    wrong(name, *value, expected);
  } else {
    (void)required(name, expected);
  }
  return lowest;
}

void JsonObject::rejectMisspelling(const std::string& name, JsonValue key) {
  const std::string_view meant = misspelledMember(name);
  const bool isAsked = std::find(m_known.begin(), m_known.end(), meant) != m_known.end();
  if (!isAsked || m_diagnostics.covers(pointerTo(meant))) return;  // said already where it is missing
  m_diagnostics.add(Code::schema, translated("there is no member \"%1\"; \"%2\" is meant.", {name, meant}),
                    m_blamed, pointerTo(name), key);
}

UnknownMembers JsonObject::unknown() {
  UnknownMembers result;
  if (!m_isObject) return result;
  m_value.forEachMember([&](JsonValue key, JsonValue value) {
    std::string name = key.string();
    if (std::find(m_known.begin(), m_known.end(), name) == m_known.end()) {
      rejectMisspelling(name, key);
      result.emplace_back(std::move(name), value.compact());
    }
  });
  return result;
}

}  // namespace geargraph
