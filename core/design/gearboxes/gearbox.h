#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/design/gearboxes/gearbox_wish.h"
#include "core/design/gearboxes/section_rules.h"
#include "core/design/gearboxes/set_teeth.h"

namespace geargraph {

/// What gears ask of the parts of a gearbox, for the input at speed and torque 1 without losses.
struct GearMeasures {
  Rational power;   ///< largest through a member of a set, seen from the ground
  Rational torque;  ///< largest in an engaged element
  Rational slip;    ///< largest between the sides of an open element
  Rational speed;   ///< largest of a link
};

/// One gear of a gearbox, exactly.
struct GearState {
  std::string name;          ///< "1", "2", ..., "R"
  std::vector<int> engaged;  ///< elements by position, ascending
  Rational ratio;            ///< input over output; below 0 in reverse
  Rational error;            ///< relative to the wanted ratio; 0 for any reverse
  GearMeasures measures;
};

/// With losses and circulating power as the shift table has them, by gear.
struct GearboxLosses {
  std::vector<std::optional<Rational>> efficiencies;  ///< none where the gear locks itself
  std::vector<std::optional<Rational>> circulating;   ///< largest over input power; none if not determined
};

/// A gearbox in whole teeth.
struct Gearbox {
  GearLayout layout;
  std::vector<ElementLinks> elements;
  std::vector<std::vector<ElementLinks>> variants;  ///< by element: all with the same speeds, its own too
  std::vector<GearState> gears;                     ///< forward, then reverse
  std::vector<TeethOption> teeth;                   ///< by set, a Ravigneaux set once
  Rational error;                                   ///< the largest of the gears
  GearMeasures measures;                            ///< the largest of the gears
  std::optional<SectionRule> brokenRule;            ///< none: the section can be drawn
  std::optional<GearboxLosses> losses;
};

/// Why candidates were dropped, by step.
struct JudgeCounts {
  std::int64_t candidates = 0;  ///< with ring ratios near the wish
  std::int64_t teeth = 0;       ///< of these: whole teeth meet the ratios, in fractions
  std::int64_t elements = 0;    ///< brakes and clutches are as many as wished
  std::int64_t limits = 0;      ///< torque, speed, slip, spread, losses and section too
  JudgeCounts& operator+=(const JudgeCounts& other);
};

/// The candidate in whole teeth, with the elements that ask least of them: those that can be drawn, then the
/// least torque, then the least slip. std::nullopt if no teeth meet the wish or a limit is exceeded. All
/// comparisons with limits are of fractions. Losses are left out (gearbox_document.h).
[[nodiscard]] std::optional<Gearbox> judged(const GearboxWish& wish, const GearboxCandidate& candidate,
                                            JudgeCounts& counts);

/// A gearbox of which layout, elements, engaged elements by gear and tooth counts are known, with all that
/// follows from them but losses. std::nullopt if it does not meet the wish.
[[nodiscard]] std::optional<Gearbox> evaluated(const GearboxWish& wish, Gearbox gearbox);

/// The gearbox with another of the variants of one element, of the same speeds, with all that follows from it
/// but losses. std::nullopt if a limit of the wish is exceeded then. @pre `element` is one of
/// `variants[position]`
[[nodiscard]] std::optional<Gearbox> withVariant(const GearboxWish& wish, const Gearbox& gearbox,
                                                 std::size_t position, const ElementLinks& element);

/// The order of a list: fewest elements, then what can be drawn, then the least error, power, torque; then by
/// the layout.
[[nodiscard]] bool ranksBefore(const Gearbox& a, const Gearbox& b);

}  // namespace geargraph
