#include "core/design/gearboxes/wish_members.h"

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

std::optional<int> wholeOf(JsonValue value) {
  if (!value.is(JsonKind::number)) return std::nullopt;
  const auto exact = Rational::fromText(value.slice());
  if (!exact || !exact->isInteger() || exact->abs() > Rational(1'000'000)) return std::nullopt;
  return static_cast<int>(exact->toDouble());
}

std::string wholeWords(int lowest, int highest) {
  return translated("a whole number from %1 to %2", {std::to_string(lowest), std::to_string(highest)});
}

constexpr std::string_view kRatio =
    toTranslate("a ratio above 0 in a string: a decimal like \"2.34\" or a fraction like \"7/3\"");

}  // namespace

int wholeMember(JsonObject& object, std::string_view name, int lowest, int highest, int otherwise) {
  const auto value = object.member(name);
  if (!value) return otherwise;
  const auto whole = wholeOf(*value);
  if (whole && *whole >= lowest && *whole <= highest) return *whole;
  object.wrong(name, *value, wholeWords(lowest, highest));
  return otherwise;
}

std::array<int, 2> rangeMember(JsonObject& object, std::string_view name, int lowest, int highest,
                               const std::array<int, 2>& otherwise) {
  const auto value = object.member(name);
  if (!value) return otherwise;
  if (value->is(JsonKind::array) && value->size() == 2) {
    const auto from = wholeOf(*value->element(0));
    const auto to = wholeOf(*value->element(1));
    if (from && to && *from >= lowest && *to <= highest && *from <= *to) return {*from, *to};
  }
  object.wrong(name, *value,
               translated("a list of two whole numbers from %1 to %2, the smaller one first",
                          {std::to_string(lowest), std::to_string(highest)}));
  return otherwise;
}

std::optional<Rational> positiveMember(JsonObject& object, std::string_view name) {
  const auto value = object.member(name);
  if (!value) return std::nullopt;
  const auto number = object.number(name);
  if (!number) return std::nullopt;
  if (number->exact().sign() > 0) return number->exact();
  object.wrong(name, *value, toTranslate("a number above 0"));
  return std::nullopt;
}

std::optional<Rational> toleranceMember(JsonObject& object) {
  const auto value = object.member("tolerance");
  if (!value) return std::nullopt;
  const auto number = object.number("tolerance");
  if (!number) return std::nullopt;
  if (number->exact().sign() >= 0 && number->exact() < Rational(1)) return number->exact();
  object.wrong("tolerance", *value, toTranslate("a number from 0 to below 1, the part of each ratio"));
  return std::nullopt;
}

std::vector<WantedRatio> ratiosMember(JsonObject& object, std::string_view name, std::size_t most,
                                      const std::optional<Rational>& tolerance) {
  const std::string expected =
      translated("a list of 1 to %1 ratios in strings, each above 0", {std::to_string(most)});
  const auto value = object.required(name, expected);
  std::vector<WantedRatio> ratios;
  if (!value) return ratios;
  if (!value->is(JsonKind::array) || value->size() == 0 || value->size() > most) {
    object.wrong(name, *value, expected);
    return ratios;
  }
  value->forEachElement([&](JsonValue each, std::size_t position) {
    auto ratio = each.is(JsonKind::string) ? wantedRatio(each.string(), tolerance) : std::nullopt;
    if (ratio) {
      ratios.push_back(*std::move(ratio));
    } else {
      object.diagnostics().add(Code::schema,
                               translated("expected %1, found %2.", {translated(kRatio), each.slice()}), {},
                               object.pointer() + pointerStep(name) + pointerStep(position), each);
    }
  });
  return ratios;
}

std::optional<WantedRatio> sizeOf(JsonObject& object, std::string_view name, JsonValue value,
                                  const std::optional<Rational>& tolerance) {
  std::string text = value.is(JsonKind::string) ? value.string() : std::string();
  if (text.starts_with('-')) text.erase(0, 1);
  auto ratio = wantedRatio(text, tolerance);
  if (!ratio) object.wrong(name, value, kRatio);
  return ratio;
}

void rejectUnknown(JsonObject& object, JsonValue value) {
  if (!value.is(JsonKind::object)) return;
  for (const auto& [name, text] : object.unknown()) {
    object.diagnostics().add(Code::schema, translated("a wish has no member \"%1\".", {name}), {},
                             object.pointer() + pointerStep(name), *value.member(name));
  }
}

}  // namespace geargraph
