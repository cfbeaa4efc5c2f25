#pragma once

#include <QString>
#include <vector>

#include "core/design/gearboxes/gearbox.h"

namespace geargraph::inline designer {

// The words and numbers of a gearbox, the same in the list and on the card.

/// "A", "B", ...
[[nodiscard]] QString elementLetter(int position);
/// "0.125 %", rounded from the fraction; "exact" for 0.
[[nodiscard]] QString percentOf(const Rational& part);
/// A whole number, or three decimals rounded from the fraction.
[[nodiscard]] QString decimalOf(const Rational& value);
/// The fraction with a printed minus.
[[nodiscard]] QString fractionOf(const Rational& value);
/// "A: S1 = 0, B: in = R1": what the elements join; 0 is the housing.
[[nodiscard]] QString elementsOf(const GearboxWish& wish, const Gearbox& gearbox);
/// "in S1 S2, out C1 R2": the members on each link.
[[nodiscard]] QString linksOf(const GearboxWish& wish, const Gearbox& gearbox);
/// "33 21 75, 30 24 78": sun, planet and ring of each set; a Ravigneaux set has two joined by "+".
[[nodiscard]] QString teethOf(const Gearbox& gearbox);

/// The gear with the least efficiency. -1 without losses, or if each gear locks itself.
[[nodiscard]] int leastEfficientGear(const Gearbox& gearbox);
/// Some gear locks itself: its position; else -1.
[[nodiscard]] int lockedGear(const Gearbox& gearbox);
/// The gear with the largest error.
[[nodiscard]] int farthestGear(const Gearbox& gearbox);

}  // namespace geargraph::inline designer
