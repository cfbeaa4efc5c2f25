#include "ui/models/speed_unit.h"

#include <QCoreApplication>
#include <numbers>

#include "ui/models/printed_number.h"

namespace geargraph {

std::optional<PiNumber> quotient(const PiNumber& one, const PiNumber& other) {
  if (other.terms().size() != 1) return std::nullopt;
  const PiNumber::Term& term = other.terms().front();
  return one * PiNumber(Rational(1) / term.factor, -term.power);
}

QString unitOfRatio(const Mechanism& mechanism, bool slides, bool otherSlides) {
  if (slides == otherSlides) return {};
  const QString length = QString::fromStdString(mechanism.unit);
  return slides ? QCoreApplication::translate("SpeedUnit", "%1/rad").arg(length)
                : QCoreApplication::translate("SpeedUnit", "rad/%1").arg(length);
}

QString unitOfRate(const Mechanism& mechanism, bool slides, const SpeedUnit& unit) {
  if (unit.kind == SpeedUnit::Kind::ratio) {
    const TurningJoint* const reference = mechanism.find(unit.reference);
    return reference == nullptr ? QString() : unitOfRatio(mechanism, slides, geargraph::slides(*reference));
  }
  if (slides)
    return QCoreApplication::translate("SpeedUnit", "%1/s").arg(QString::fromStdString(mechanism.unit));
  return unit.kind == SpeedUnit::Kind::rpm ? QCoreApplication::translate("SpeedUnit", "rpm")
                                           : QCoreApplication::translate("SpeedUnit", "rad/s");
}

QString speedText(const PiNumber& speed, const SpeedUnit& unit, const std::optional<PiNumber>& reference) {
  switch (unit.kind) {
    case SpeedUnit::Kind::radPerSecond:
      return printedExact(speed);
    case SpeedUnit::Kind::ratio: {
      if (!reference || reference->isZero()) return QStringLiteral("–");
      const auto ratio = quotient(speed, *reference);
      return ratio ? printedExact(*ratio) : printedNumber(speed.toDouble() / reference->toDouble());
    }
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
