#pragma once

#include <QString>
#include <array>
#include <map>
#include <vector>

#include "ui/designer/designer_services.h"

namespace geargraph {

/// What a gearbox of the list may be asked for.
enum class HitCondition { error, circulating, drawable, elements, brakes, clutches, efficiency };
inline constexpr std::array kHitConditions = {
    HitCondition::error,  HitCondition::circulating, HitCondition::drawable,  HitCondition::elements,
    HitCondition::brakes, HitCondition::clutches,    HitCondition::efficiency};

/// Which gearboxes of a list are shown.
class HitFilter {
 public:
  /// By condition its bound: the most, of an efficiency the least; 0 where there is nothing to choose.
  using Conditions = std::map<HitCondition, Rational>;

  void set(HitCondition condition, const Rational& bound) { m_conditions[condition] = bound; }
  void remove(HitCondition condition) { m_conditions.erase(condition); }
  [[nodiscard]] const Conditions& conditions() const { return m_conditions; }
  [[nodiscard]] bool accepts(const Gearbox& hit) const;
  /// How many of these only this condition hides.
  [[nodiscard]] int hiddenBy(HitCondition condition, const std::vector<GearboxPtr>& hits) const;

 private:
  Conditions m_conditions;
};

/// "error ≤ 0.5 %": the condition with its bound.
[[nodiscard]] QString conditionText(HitCondition condition, const Rational& bound);
/// The bounds worth choosing for these hits, and that leave some and hide some; one 0 where there is nothing
/// to choose; none where the condition tells no hits apart.
[[nodiscard]] std::vector<Rational> boundsOf(HitCondition condition, const std::vector<GearboxPtr>& hits);

}  // namespace geargraph
