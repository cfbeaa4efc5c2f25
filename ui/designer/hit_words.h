#pragma once

#include <QString>
#include <array>
#include <optional>

#include "core/design/gearboxes/gearbox.h"

namespace geargraph {

// The words and numbers of a gearbox, the same in the list, its filters and the card.

/// "A", "B", ...
[[nodiscard]] QString elementLetter(int position);
/// "0.125 %", rounded from the fraction; "exact" for 0.
[[nodiscard]] QString percentOf(const Rational& part);
/// A whole number, or three decimals rounded from the fraction.
[[nodiscard]] QString decimalOf(const Rational& value);
/// The fraction with a printed minus.
[[nodiscard]] QString fractionOf(const Rational& value);
/// "S1 = 0", "in = R1": what an element joins; 0 is the housing.
[[nodiscard]] QString elementText(const GearboxWish& wish, const Gearbox& gearbox,
                                  const ElementLinks& element);
/// "A: S1 = 0, B: in = R1": all of them.
[[nodiscard]] QString elementsOf(const GearboxWish& wish, const Gearbox& gearbox);
/// "in S1 S2, out C1 R2": the members on each link.
[[nodiscard]] QString linksOf(const GearboxWish& wish, const Gearbox& gearbox);
/// "33 21 75, 30 24 78": sun, planet and ring of each set; a Ravigneaux set has two joined by "+".
[[nodiscard]] QString teethOf(const Gearbox& gearbox);

/// What gearboxes are compared by.
enum class HitMeasure { error, efficiency, circulating, speed, torque, slip, spread, ring };
inline constexpr std::array kHitMeasures = {
    HitMeasure::error,  HitMeasure::efficiency, HitMeasure::circulating, HitMeasure::speed,
    HitMeasure::torque, HitMeasure::slip,       HitMeasure::spread,      HitMeasure::ring};

/// A measure of one gearbox: the worst of its gears.
struct HitMeasured {
  std::optional<Rational> value;  ///< none where it is not known, or a gear locks itself
  int gear = -1;                  ///< where; -1: in none of them by itself
};
[[nodiscard]] HitMeasured measured(HitMeasure measure, const Gearbox& gearbox);
/// "largest error"
[[nodiscard]] QString measureName(HitMeasure measure);
/// "0.125 %", "0.894", "none".
[[nodiscard]] QString measureText(HitMeasure measure, const Gearbox& gearbox);
/// "in R"; empty if it is in no gear by itself.
[[nodiscard]] QString measureGear(HitMeasure measure, const Gearbox& gearbox);
/// More circulates than goes in, or a gear loses a fifth.
[[nodiscard]] bool isWarning(HitMeasure measure, const Gearbox& gearbox);
/// Is the first gearbox better, by a measure of which less or more is better?
[[nodiscard]] bool isBetter(HitMeasure measure, const Gearbox& a, const Gearbox& b);
/// By how much it is worse than none, in doubles, for sorting.
[[nodiscard]] double sortKeyOf(HitMeasure measure, const Gearbox& gearbox);

}  // namespace geargraph
