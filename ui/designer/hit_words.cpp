#include "ui/designer/hit_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <limits>

#include "core/design/gearboxes/gearbox_json.h"
#include "core/presentation/diagrams/lever_words.h"
#include "ui/models/printed_number.h"

namespace geargraph {
namespace {

QString membersJoined(const std::vector<std::string>& members) {
  QStringList words;
  for (const std::string& each : members) words << QString::fromStdString(each);
  return words.join(' ');
}

/// The least or the largest of the gears; one without a number is worse than any.
HitMeasured extremeOf(const std::vector<std::optional<Rational>>& gears, bool isLeast) {
  HitMeasured found;
  for (std::size_t i = 0; i < gears.size(); ++i) {
    if (!gears[i]) return {std::nullopt, static_cast<int>(i)};
    if (!found.value || (isLeast ? *gears[i] < *found.value : *gears[i] > *found.value))
      found = {gears[i], static_cast<int>(i)};
  }
  return found;
}

}  // namespace

QString elementLetter(int position) {
  return QChar('A' + position);
}

QString decimalOf(const Rational& value) {
  return QString::fromStdString(threeDecimals(value));
}

QString percentOf(const Rational& part) {
  if (part.isZero()) return QCoreApplication::translate("designer", "exact");
  return decimalOf(part * Rational(100)) + QStringLiteral(" %");
}

QString fractionOf(const Rational& value) {
  return withPrintedMinus(QString::fromStdString(value.toString()));
}

QString elementText(const GearboxWish& wish, const Gearbox& gearbox, const ElementLinks& element) {
  const BasicSets sets = basicSets(wish.limits.kinds);
  const std::string other = element.isBrake() ? "0" : linkWord(sets, gearbox.layout, element.b);
  return QStringLiteral("%1 = %2").arg(QString::fromStdString(linkWord(sets, gearbox.layout, element.a)),
                                       QString::fromStdString(other));
}

QString elementsOf(const GearboxWish& wish, const Gearbox& gearbox) {
  QStringList words;
  for (std::size_t i = 0; i < gearbox.elements.size(); ++i)
    words << QStringLiteral("%1: %2").arg(elementLetter(static_cast<int>(i)),
                                          elementText(wish, gearbox, gearbox.elements[i]));
  return words.join(QStringLiteral(", "));
}

QString linksOf(const GearboxWish& wish, const Gearbox& gearbox) {
  const BasicSets sets = basicSets(wish.limits.kinds);
  QStringList links;
  for (int link = 1; link <= wish.limits.shafts; ++link)
    links << membersJoined(membersOn(sets, gearbox.layout, link));
  const QString held = membersJoined(membersOn(sets, gearbox.layout, 0));
  if (!held.isEmpty()) links << held + QStringLiteral(" = 0");
  return links.join(QStringLiteral(", "));
}

QString teethOf(const Gearbox& gearbox) {
  QStringList sets;
  for (const TeethOption& option : gearbox.teeth) {
    QStringList parts;
    for (const SetTeeth& part : option.parts) {
      QStringList numbers{QString::number(part.sun), QString::number(part.planet)};
      if (part.outer != 0) numbers << QString::number(part.outer);
      parts << (numbers << QString::number(part.ring)).join(' ');
    }
    sets << parts.join(QStringLiteral(" + "));
  }
  return sets.join(QStringLiteral(", "));
}

HitMeasured measured(HitMeasure measure, const Gearbox& gearbox) {
  const auto largest = [&](const auto& of) {
    HitMeasured found;
    for (std::size_t i = 0; i < gearbox.gears.size(); ++i) {
      const Rational& value = of(gearbox.gears[i]);
      if (!found.value || *found.value < value) found = {value, static_cast<int>(i)};
    }
    return found;
  };
  switch (measure) {
    case HitMeasure::error:
      return largest([](const GearState& gear) -> auto& { return gear.error; });
    case HitMeasure::speed:
      return largest([](const GearState& gear) -> auto& { return gear.measures.speed; });
    case HitMeasure::torque:
      return largest([](const GearState& gear) -> auto& { return gear.measures.torque; });
    case HitMeasure::slip:
      return largest([](const GearState& gear) -> auto& { return gear.measures.slip; });
    case HitMeasure::efficiency:
      return gearbox.losses ? extremeOf(gearbox.losses->efficiencies, true) : HitMeasured();
    case HitMeasure::circulating:
      return gearbox.losses ? extremeOf(gearbox.losses->circulating, false) : HitMeasured();
    case HitMeasure::spread: {
      Rational least = gearbox.gears.front().ratio;
      for (const GearState& each : gearbox.gears)
        if (each.ratio.sign() > 0) least = std::min(least, each.ratio);
      return {gearbox.gears.front().ratio / least, -1};
    }
    case HitMeasure::ring: {
      int ring = 0;
      for (const TeethOption& option : gearbox.teeth)
        for (const SetTeeth& part : option.parts) ring = std::max(ring, part.ring);
      return {Rational(ring), -1};
    }
  }
  return {};
}

QString measureName(HitMeasure measure) {
  switch (measure) {
    case HitMeasure::error:
      return QCoreApplication::translate("designer", "largest error");
    case HitMeasure::efficiency:
      return QCoreApplication::translate("designer", "worst efficiency");
    case HitMeasure::circulating:
      return QCoreApplication::translate("designer", "circulating power");
    case HitMeasure::speed:
      return QCoreApplication::translate("designer", "fastest member");
    case HitMeasure::torque:
      return QCoreApplication::translate("designer", "largest torque");
    case HitMeasure::slip:
      return QCoreApplication::translate("designer", "largest slip");
    case HitMeasure::spread:
      return QCoreApplication::translate("designer", "spread");
    case HitMeasure::ring:
      return QCoreApplication::translate("designer", "largest ring");
  }
  return {};
}

QString measureText(HitMeasure measure, const Gearbox& gearbox) {
  const HitMeasured found = measured(measure, gearbox);
  if (!found.value) return QCoreApplication::translate("designer", "none");
  return measure == HitMeasure::error ? percentOf(*found.value) : decimalOf(*found.value);
}

QString measureGear(HitMeasure measure, const Gearbox& gearbox) {
  const auto [value, gear] = measured(measure, gearbox);
  if (gear < 0 || (value && value->isZero())) return {};  // nowhere more than elsewhere
  return QCoreApplication::translate("designer", "in %1")
      .arg(QString::fromStdString(gearbox.gears[static_cast<std::size_t>(gear)].name));
}

bool isWarning(HitMeasure measure, const Gearbox& gearbox) {
  const HitMeasured found = measured(measure, gearbox);
  if (measure == HitMeasure::efficiency) return !found.value || *found.value < Rational(4, 5);
  return measure == HitMeasure::circulating && found.value && *found.value > Rational(1);
}

bool isBetter(HitMeasure measure, const Gearbox& a, const Gearbox& b) {
  if (measure == HitMeasure::spread || measure == HitMeasure::ring) return false;
  const HitMeasured of = measured(measure, a);
  const HitMeasured other = measured(measure, b);
  if (!of.value || !other.value) return of.value.has_value() && other.gear >= 0;
  return measure == HitMeasure::efficiency ? *of.value > *other.value : *of.value < *other.value;
}

double sortKeyOf(HitMeasure measure, const Gearbox& gearbox) {
  const HitMeasured found = measured(measure, gearbox);
  if (!found.value) return std::numeric_limits<double>::max();
  const bool isMoreBetter = measure == HitMeasure::efficiency || measure == HitMeasure::spread;
  return isMoreBetter ? -found.value->toDouble() : found.value->toDouble();
}

}  // namespace geargraph
