#pragma once

#include "core/design/synthesis/planetary_set.h"
#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline synthesis {

/// Tooth counts of a Ravigneaux set: the short planet meshes with the small sun and the long planet, the long
/// one with the large sun and the ring. The ring follows: large sun + 2 long planet.
struct RavigneauxTeeth {
  int smallSun = 30;
  int largeSun = 36;
  int shortPlanet = 20;
  int longPlanet = 18;
  [[nodiscard]] int ring() const { return largeSun + 2 * longPlanet; }
};

/// Small sun 1, large sun 2, ring 3, carrier 4, then short and long planet of each pair; brakes on large sun
/// and carrier, a clutch of both suns, and the states 1, 2, 3 and R. Rejects teeth-geometry if the planets
/// cannot mesh or the pairs interfere, assembly if the assembly condition is violated: ring + large sun and
/// ring - small sun have to be multiples of the number of pairs.
[[nodiscard]] Expected<Mechanism> ravigneauxSet(const RavigneauxTeeth& teeth, int pairs);

/// A Simpson set: two equal planetary sets with a common sun shaft; the first carrier is connected to the
/// second ring and is the output. Suns 1, first ring 2, output 3, second carrier 4, then the planets; brakes
/// on suns and second carrier, a clutch of suns and first ring, and the states 1, 2, 3 and R. Rejects
/// assembly and teeth-geometry as above.
[[nodiscard]] Expected<Mechanism> simpsonSet(const PlanetaryTeeth& teeth, int planets);

}  // namespace geargraph::inline synthesis
