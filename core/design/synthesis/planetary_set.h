#pragma once

#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Tooth counts of a planetary set with identical planets; the ring follows from the coaxiality condition.
struct PlanetaryTeeth {
  int sun = 24;
  int planet = 18;
  [[nodiscard]] int ring() const { return sun + 2 * planet; }
  friend bool operator==(const PlanetaryTeeth&, const PlanetaryTeeth&) = default;
};

enum class PlanetaryMember { sun, ring, carrier };

/// The requirements on a planetary set; the third member is held.
struct PlanetaryRequirements {
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
  double error = 0;  ///< relative to the required ratio
};

/// Willis equation: sun w_s + ring w_r = (sun + ring) w_c, with the third member at 0. Drive over driven.
/// @pre drive and driven differ
[[nodiscard]] Rational planetaryRatio(const PlanetaryTeeth& teeth, PlanetaryMember drive,
                                      PlanetaryMember driven);

/// The assembly condition for equally spaced planets: (sun + ring) / planets is an integer.
[[nodiscard]] bool assembles(const PlanetaryTeeth& teeth, int planets);
/// The clearance condition of adjacent planets: (sun + planet) sin(pi / planets) > planet + 2, with addenda
/// of one module.
[[nodiscard]] bool neighboursClear(const PlanetaryTeeth& teeth, int planets);

/// Tooth counts within the limits that satisfy the assembly and clearance conditions, nearest to the required
/// ratio first, among equals the smallest first; at most `most`. Empty if the sign of the ratio is
/// impossible. Cost: O(teeth^2).
[[nodiscard]] std::vector<PlanetaryChoice> planetaryChoices(const PlanetaryRequirements& requirements,
                                                            std::size_t most = 20);

/// A planetary set: sun 1, ring 2, carrier 3, planets 4..; places are left open. Inputs: the sun at 1 rad/s,
/// the ring at 0.
[[nodiscard]] Mechanism planetarySet(const PlanetaryTeeth& teeth, int planets);

/// How a member of a set is held: by an engaged brake, which can be released, or as part of the ground.
enum class PlanetaryHolding { brake, ground };

/// The use of a planetary set: `drive` turns at 1 rad/s, the member that is neither drive nor driven is held.
struct PlanetaryUse {
  PlanetaryMember drive = PlanetaryMember::sun;
  PlanetaryMember driven = PlanetaryMember::carrier;
  PlanetaryHolding holding = PlanetaryHolding::brake;
};

/// The same for a use: sun, ring, carrier, planets in this order; a member that is part of the ground is link
/// 0. The brake is named "B". @pre drive and driven differ
[[nodiscard]] Mechanism planetarySet(const PlanetaryTeeth& teeth, int planets, const PlanetaryUse& use);

}  // namespace geargraph
