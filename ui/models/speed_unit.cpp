#include "ui/models/speed_unit.h"

#include <numbers>

#include "ui/models/printed_number.h"

namespace geargraph {

QString speedText(const Rational& speed, const SpeedUnit& unit, const std::optional<Rational>& reference) {
  switch (unit.kind) {
    case SpeedUnit::Kind::radPerSecond:
      return printedFraction(speed);
    case SpeedUnit::Kind::ratio:
      return reference && !reference->isZero() ? printedFraction(speed / *reference) : QStringLiteral("–");
    default:
      return speedText(speed.toDouble(), unit, {});
  }
}

QString speedText(double speed, const SpeedUnit& unit, std::optional<double> reference) {
  switch (unit.kind) {
    case SpeedUnit::Kind::rpm:
      return printedNumber(speed * 30 / std::numbers::pi);
    case SpeedUnit::Kind::ratio:
      return reference && *reference != 0 ? printedNumber(speed / *reference) : QStringLiteral("–");
    default:
      return printedNumber(speed);
  }
}

}  // namespace geargraph
