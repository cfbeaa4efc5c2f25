#pragma once

#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline synthesis {

/// Tooth counts of a planetary set with equal planets; the ring follows, so that sun and ring are coaxial.
struct PlanetaryTeeth {
  int sun = 24;
  int planet = 18;
  [[nodiscard]] int ring() const { return sun + 2 * planet; }
  friend bool operator==(const PlanetaryTeeth&, const PlanetaryTeeth&) = default;
};

enum class PlanetaryMember { sun, ring, carrier };

/// What somebody wants of a planetary set; the third member is held.
struct PlanetaryWish {
  Rational ratio = Rational(7, 2);  ///< speed of drive over speed of driven
  PlanetaryMember drive = PlanetaryMember::sun;
  PlanetaryMember driven = PlanetaryMember::carrier;
  int planets = 3;
  int fewestTeeth = 17;
  int mostTeeth = 120;
};

struct PlanetaryChoice {
  PlanetaryTeeth teeth;
  Rational ratio;
  double error = 0;  ///< relative to the wish
};

/// Willis: sun w_s + ring w_r = (sun + ring) w_c, with the third member at 0. @pre drive and driven differ
[[nodiscard]] Rational planetaryRatio(const PlanetaryTeeth& teeth, PlanetaryMember drive,
                                      PlanetaryMember driven);

/// Do so many planets go in evenly: (sun + ring) / planets is whole.
[[nodiscard]] bool assembles(const PlanetaryTeeth& teeth, int planets);
/// Do neighbouring planets clear each other: (sun + planet) sin(pi / planets) > planet + 2, tips of one
/// module.
[[nodiscard]] bool neighboursClear(const PlanetaryTeeth& teeth, int planets);

/// Tooth counts within the limits that assemble with clear neighbours, nearest to the wished ratio first, of
/// equals the smallest first; `most` at most. Empty where the signs can never agree. Cost: O(teeth^2).
[[nodiscard]] std::vector<PlanetaryChoice> planetaryChoices(const PlanetaryWish& wish, std::size_t most = 20);

/// Sun 1, ring 2, carrier 3, planets 4..; places left open. Inputs: the sun at 1 rad/s, the ring at 0.
[[nodiscard]] Mechanism planetarySet(const PlanetaryTeeth& teeth, int planets);

/// How a member of a set is held: by an engaged brake, which can let go of it, or cut into the ground.
enum class PlanetaryHolding { brake, ground };

/// What a planetary set is for: `drive` turns at 1 rad/s, the member that is neither drive nor driven is
/// held.
struct PlanetaryUse {
  PlanetaryMember drive = PlanetaryMember::sun;
  PlanetaryMember driven = PlanetaryMember::carrier;
  PlanetaryHolding holding = PlanetaryHolding::brake;
};

/// Sun, ring, carrier, planets in this order; a member that is cut into the ground is link 0. A brake is
/// named "B". @pre drive and driven differ
[[nodiscard]] Mechanism planetarySet(const PlanetaryTeeth& teeth, int planets, const PlanetaryUse& use);

}  // namespace geargraph::inline synthesis
