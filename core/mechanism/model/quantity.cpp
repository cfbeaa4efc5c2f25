#include "core/mechanism/model/quantity.h"

#include <array>
#include <cmath>
#include <string>

#include "core/foundations/base/arithmetic.h"

namespace geargraph {
namespace {

/// rad in a degree, with 17 digits, so that products with whole numbers stay short decimals.
constexpr std::string_view kDegree = "0.017453292519943295";

struct QuantityUnit {
  Quantity quantity;
  std::string_view name;    ///< with a point between its parts, where blanks, · * - or nothing may be typed
  std::string_view factor;  ///< in the unit of the quantity
  bool isByDegree = false;  ///< the factor is in degrees, the quantity in radians
};

/// A name that ends another one comes after it. 1 lbf is 4.4482216152605 N, 1 kgf 9.80665 N, exactly.
constexpr std::array kQuantityUnits = {
    QuantityUnit{Quantity::angle, "deg", "1"},
    QuantityUnit{Quantity::angle, "\xC2\xB0", "1"},
    QuantityUnit{Quantity::angle, "turns", "360"},
    QuantityUnit{Quantity::angle, "turn", "360"},
    QuantityUnit{Quantity::angle, "rev", "360"},
    QuantityUnit{Quantity::speed, "rad/s", "1"},
    QuantityUnit{Quantity::speed, "rad/min", "1/60"},
    QuantityUnit{Quantity::speed, "deg/s", "1", true},
    QuantityUnit{Quantity::speed, "\xC2\xB0/s", "1", true},
    QuantityUnit{Quantity::speed, "deg/min", "1/60", true},
    QuantityUnit{Quantity::speed, "rpm", "6", true},
    QuantityUnit{Quantity::speed, "rev/min", "6", true},
    QuantityUnit{Quantity::speed, "turns/min", "6", true},
    QuantityUnit{Quantity::speed, "turn/min", "6", true},
    QuantityUnit{Quantity::speed, "U/min", "6", true},
    QuantityUnit{Quantity::speed, "r/min", "6", true},
    QuantityUnit{Quantity::speed, "/min", "6", true},
    QuantityUnit{Quantity::speed, "1/min", "6", true},
    QuantityUnit{Quantity::speed, "min-1", "6", true},
    QuantityUnit{Quantity::speed, "min^-1", "6", true},
    QuantityUnit{Quantity::speed, "rev/s", "360", true},
    QuantityUnit{Quantity::speed, "turns/s", "360", true},
    QuantityUnit{Quantity::speed, "turn/s", "360", true},
    QuantityUnit{Quantity::speed, "rps", "360", true},
    QuantityUnit{Quantity::torque, "kN.m", "1000"},
    QuantityUnit{Quantity::torque, "mN.m", "0.001"},
    QuantityUnit{Quantity::torque, "N.mm", "0.001"},
    QuantityUnit{Quantity::torque, "N.cm", "0.01"},
    QuantityUnit{Quantity::torque, "N.m", "1"},
    QuantityUnit{Quantity::torque, "lbf.ft", "1.3558179483314004"},
    QuantityUnit{Quantity::torque, "lb.ft", "1.3558179483314004"},
    QuantityUnit{Quantity::torque, "ft.lbf", "1.3558179483314004"},
    QuantityUnit{Quantity::torque, "ft.lb", "1.3558179483314004"},
    QuantityUnit{Quantity::torque, "lbf.in", "0.1129848290276167"},
    QuantityUnit{Quantity::torque, "lb.in", "0.1129848290276167"},
    QuantityUnit{Quantity::torque, "in.lbf", "0.1129848290276167"},
    QuantityUnit{Quantity::torque, "in.lb", "0.1129848290276167"},
    QuantityUnit{Quantity::torque, "ozf.in", "0.00706155181422604375"},
    QuantityUnit{Quantity::torque, "oz.in", "0.00706155181422604375"},
    QuantityUnit{Quantity::torque, "kgf.cm", "0.0980665"},
    QuantityUnit{Quantity::torque, "kg.cm", "0.0980665"},
    QuantityUnit{Quantity::torque, "kgf.m", "9.80665"},
    QuantityUnit{Quantity::force, "kN", "1000"},
    QuantityUnit{Quantity::force, "mN", "0.001"},
    QuantityUnit{Quantity::force, "N", "1"},
    QuantityUnit{Quantity::force, "lbf", "4.4482216152605"},
    QuantityUnit{Quantity::force, "kgf", "9.80665"},
};

/// W; 1 hp is 550 ft lbf/s, 1 PS 75 kgf m/s.
struct PowerUnit {
  std::string_view name;
  std::string_view watts;
};
constexpr std::array kPowerUnits = {PowerUnit{"kW", "1000"},
                                    PowerUnit{"MW", "1000000"},
                                    PowerUnit{"mW", "0.001"},
                                    PowerUnit{"W", "1"},
                                    PowerUnit{"hp", "745.69987158227022"},
                                    PowerUnit{"PS", "735.49875"}};

Rational exactly(std::string_view text) {
  return *Rational::fromText(text);
}

std::string_view withoutBlanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Takes what may stand between the parts of a unit from the end of the text.
std::string_view withoutSeparators(std::string_view text) {
  constexpr std::string_view kDot = "\xC2\xB7";
  while (true) {
    if (text.ends_with(' ') || text.ends_with('*') || text.ends_with('-')) {
      text.remove_suffix(1);
    } else if (text.ends_with(kDot)) {
      text.remove_suffix(kDot.size());
    } else {
      return text;
    }
  }
}

/// The text before a unit at its end; std::nullopt if it does not end with the unit.
std::optional<std::string_view> beforeUnit(std::string_view text, std::string_view unit) {
  while (true) {
    const std::size_t point = unit.rfind('.');
    const std::string_view part = point == std::string_view::npos ? unit : unit.substr(point + 1);
    if (!text.ends_with(part)) return std::nullopt;
    text.remove_suffix(part.size());
    if (point == std::string_view::npos) return withoutBlanks(text);
    text = withoutSeparators(text);
    unit = unit.substr(0, point);
  }
}

/// As a decimal where it ends, else as a fraction; std::nullopt beyond the range of doubles.
std::optional<Number> spelledNumber(const Rational& value) {
  constexpr int kMaxPlaces = 40;
  Rational scaled = value;
  for (int decimals = 0; decimals <= kMaxPlaces; ++decimals, scaled *= Rational(10)) {
    if (!scaled.isInteger()) continue;
    std::string digits = scaled.abs().toString();
    const auto places = static_cast<std::size_t>(decimals);
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    if (places > 0) digits.insert(digits.size() - places, ".");
    return Number::fromText((value.sign() < 0 ? "-" : "") + digits);
  }
  return Number::fromText(value.toString());
}

/// "2 kW @ 1500 rpm" in N m.
std::optional<Number> torqueOfPower(std::string_view text) {
  const std::size_t sign = text.find('@');
  const std::size_t word = text.find(" at ");
  const std::size_t at = std::min(sign, word);
  if (at == std::string_view::npos) return std::nullopt;
  const auto speed = withUnitFromText(text.substr(at + (at == sign ? 1 : 4)), Quantity::speed);
  if (!speed || speed->isZero()) return std::nullopt;
  for (const PowerUnit& unit : kPowerUnits) {
    const auto rest = beforeUnit(withoutBlanks(text.substr(0, at)), unit.name);
    const auto power = rest ? typedNumber(*rest) : std::nullopt;
    if (!power) continue;
    const double torque = (power->exact() * exactly(unit.watts) / speed->exact()).toDouble();
    return std::isfinite(torque) ? std::optional(Number::fromDouble(torque)) : std::nullopt;
  }
  return std::nullopt;
}

/// The unit that the text ends with, and the number before it.
std::optional<std::pair<const QuantityUnit*, Number>> unitAndNumber(std::string_view text,
                                                                    Quantity quantity) {
  for (const QuantityUnit& unit : kQuantityUnits) {
    if (unit.quantity != quantity) continue;
    const auto rest = beforeUnit(text, unit.name);
    auto number = rest ? typedNumber(*rest) : std::nullopt;
    if (number) return std::pair(&unit, *std::move(number));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Number> typedNumber(std::string_view text) {
  text = withoutBlanks(text);
  if (auto number = Number::fromText(text)) return number;
  const auto value = arithmeticFromText(text);
  if (!value || !std::isfinite(value->toDouble())) return std::nullopt;
  return Number(*value);
}

std::optional<Number> withUnitFromText(std::string_view text, Quantity quantity) {
  text = withoutBlanks(text);
  if (const auto found = unitAndNumber(text, quantity)) {
    const auto& [unit, number] = *found;
    if (unit->factor == "1" && !unit->isByDegree) return number;  // as it is written
    Rational value = number.exact() * exactly(unit->factor);
    if (unit->isByDegree) value *= exactly(kDegree);
    return spelledNumber(value);
  }
  if (quantity == Quantity::torque) return torqueOfPower(text);
  if (quantity == Quantity::angle) {
    const auto rest = beforeUnit(text, "rad");
    const auto radians = rest ? typedNumber(*rest) : std::nullopt;
    if (radians) return spelledNumber(radians->exact() / exactly(kDegree));
  }
  return std::nullopt;
}

std::optional<Number> quantityFromText(std::string_view text, Quantity quantity) {
  auto number = typedNumber(text);
  return number ? number : withUnitFromText(text, quantity);
}

std::optional<TypedAngle> angleFromText(std::string_view text) {
  text = withoutBlanks(text);
  if (const auto rest = beforeUnit(text, "rad")) {
    const auto radians = arithmeticFromText(*rest);
    return radians ? std::optional(TypedAngle{Rational(), *radians}) : std::nullopt;
  }
  for (const QuantityUnit& unit : kQuantityUnits) {
    if (unit.quantity != Quantity::angle) continue;
    const auto rest = beforeUnit(text, unit.name);
    const auto value = rest ? arithmeticFromText(*rest) : std::nullopt;
    if (value) return TypedAngle{*value * exactly(unit.factor), Rational()};
  }
  const auto value = arithmeticFromText(text);
  return value && value->isZero() ? std::optional(TypedAngle{}) : std::nullopt;
}

}  // namespace geargraph
