#include "ui/designer/hit_filter.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <set>

#include "ui/designer/hit_words.h"

namespace geargraph {
namespace {

Rational countedElements(HitCondition condition, const Gearbox& hit) {
  const auto brakes = std::count_if(hit.elements.begin(), hit.elements.end(),
                                    [](const ElementLinks& each) { return each.isBrake(); });
  const auto all = static_cast<std::ptrdiff_t>(hit.elements.size());
  if (condition == HitCondition::brakes) return {static_cast<std::int64_t>(brakes)};
  if (condition == HitCondition::clutches) return {static_cast<std::int64_t>(all - brakes)};
  return {static_cast<std::int64_t>(all)};
}

bool meets(HitCondition condition, const Rational& bound, const Gearbox& hit) {
  switch (condition) {
    case HitCondition::error:
      return hit.error <= bound;
    case HitCondition::circulating: {
      const HitMeasured found = measured(HitMeasure::circulating, hit);
      return found.value && found.value->isZero();
    }
    case HitCondition::drawable:
      return !hit.brokenRule;
    case HitCondition::efficiency: {
      const HitMeasured found = measured(HitMeasure::efficiency, hit);
      return found.value && *found.value >= bound;
    }
    default:
      return countedElements(condition, hit) <= bound;
  }
}

/// Bounds that people ask for; of numbers of elements those that occur.
std::vector<Rational> usualBounds(HitCondition condition, const std::vector<GearboxPtr>& hits) {
  switch (condition) {
    case HitCondition::error:
      return {Rational(1, 2000), Rational(1, 1000), Rational(1, 500), Rational(1, 200), Rational(1, 100)};
    case HitCondition::efficiency:
      return {Rational(19, 20), Rational(9, 10), Rational(17, 20), Rational(4, 5), Rational(7, 10)};
    case HitCondition::circulating:
    case HitCondition::drawable:
      return {Rational(0)};
    default: {
      std::set<Rational> numbers;
      for (const GearboxPtr& each : hits) numbers.insert(countedElements(condition, *each));
      return {numbers.begin(), numbers.end()};
    }
  }
}

}  // namespace

bool HitFilter::accepts(const Gearbox& hit) const {
  return std::all_of(m_conditions.begin(), m_conditions.end(),
                     [&](const auto& each) { return meets(each.first, each.second, hit); });
}

int HitFilter::hiddenBy(HitCondition condition, const std::vector<GearboxPtr>& hits) const {
  HitFilter others = *this;
  others.remove(condition);
  return static_cast<int>(std::count_if(hits.begin(), hits.end(), [&](const GearboxPtr& each) {
    return others.accepts(*each) && !accepts(*each);
  }));
}

QString conditionText(HitCondition condition, const Rational& bound) {
  const QString number = QLocale().toString(bound.toDouble());
  switch (condition) {
    case HitCondition::error:
      return QCoreApplication::translate("designer", "error ≤ %1 %")
          .arg(QLocale().toString((bound * Rational(100)).toDouble()));
    case HitCondition::circulating:
      return QCoreApplication::translate("designer", "no circulating power");
    case HitCondition::drawable:
      return QCoreApplication::translate("designer", "buildable");
    case HitCondition::elements:
      return QCoreApplication::translate("designer", "elements ≤ %1").arg(number);
    case HitCondition::brakes:
      return QCoreApplication::translate("designer", "brakes ≤ %1").arg(number);
    case HitCondition::clutches:
      return QCoreApplication::translate("designer", "clutches ≤ %1").arg(number);
    case HitCondition::efficiency:
      return QCoreApplication::translate("designer", "worst η ≥ %1").arg(number);
  }
  return {};
}

std::vector<Rational> boundsOf(HitCondition condition, const std::vector<GearboxPtr>& hits) {
  std::vector<Rational> bounds;
  for (const Rational& bound : usualBounds(condition, hits)) {
    const auto met = std::count_if(hits.begin(), hits.end(),
                                   [&](const GearboxPtr& each) { return meets(condition, bound, *each); });
    if (met > 0 && met < static_cast<std::ptrdiff_t>(hits.size())) bounds.push_back(bound);
  }
  return bounds;
}

}  // namespace geargraph
