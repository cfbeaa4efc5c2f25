#include "core/mechanism/model/length.h"

#include <array>

#include "core/mechanism/model/quantity.h"

namespace geargraph {
namespace {

struct Unit {
  std::string_view name;
  std::int64_t nanometres;
};

/// A name that ends another one comes after it. One inch is 25.4 mm exactly (1959).
constexpr std::array kUnits = {
    Unit{"nm", 1},          Unit{"um", 1'000},       Unit{"µm", 1'000},        Unit{"mm", 1'000'000},
    Unit{"cm", 10'000'000}, Unit{"dm", 100'000'000}, Unit{"m", 1'000'000'000}, Unit{"mil", 25'400},
    Unit{"in", 25'400'000}, Unit{"\"", 25'400'000},  Unit{"ft", 304'800'000},  Unit{"'", 304'800'000},
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::optional<std::string_view> withoutEnding(std::string_view text, std::string_view ending) {
  if (ending.empty() || text.size() < ending.size() || text.substr(text.size() - ending.size()) != ending)
    return std::nullopt;
  return trimmed(text.substr(0, text.size() - ending.size()));
}

std::optional<Rational> nanometres(std::string_view name) {
  for (const Unit& unit : kUnits) {
    if (unit.name == name) return Rational(unit.nanometres);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Number> lengthFromText(std::string_view text, std::string_view unit) {
  text = trimmed(text);
  if (auto number = typedNumber(text)) return number;
  if (const auto rest = withoutEnding(text, unit)) {
    if (auto number = typedNumber(*rest)) return number;
  }
  const auto own = nanometres(unit);
  for (const Unit& typed : kUnits) {
    const auto rest = withoutEnding(text, typed.name);
    if (!rest || !own) continue;
    const auto number = typedNumber(*rest);
    if (number) return Number(number->exact() * Rational(typed.nanometres) / *own);
  }
  return std::nullopt;
}

}  // namespace geargraph
