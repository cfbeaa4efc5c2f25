#pragma once

#include "core/design/synthesis/planetary_set.h"
#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline synthesis {

/// A Ravigneaux set: the short planet meshes with the small sun and the long planet, the long one with the
/// large sun and the ring. The ring follows: large sun + 2 long planet.
struct RavigneauxTeeth {
  int smallSun = 30;
  int largeSun = 36;
  int shortPlanet = 20;
  int longPlanet = 18;
  [[nodiscard]] int ring() const { return largeSun + 2 * longPlanet; }
};

/// Small sun 1, large sun 2, ring 3, carrier 4, then short and long planet of each pair; brakes on large sun
/// and carrier, a clutch of both suns, and the states 1, 2, 3 and R. Refuses teeth-geometry where the planets
/// cannot touch or the pairs collide, assembly where they do not go in evenly: ring + large sun and ring -
/// small sun have to be multiples of the number of pairs.
[[nodiscard]] Expected<Mechanism> ravigneauxSet(const RavigneauxTeeth& teeth, int pairs);

/// Two equal planetary sets with one shaft for both suns; the first carrier is the second ring and the
/// output. Suns 1, first ring 2, output 3, second carrier 4, then the planets; brakes on suns and second
/// carrier, a clutch of suns and first ring, and the states 1, 2, 3 and R. Refuses assembly and
/// teeth-geometry as above.
[[nodiscard]] Expected<Mechanism> simpsonSet(const PlanetaryTeeth& teeth, int planets);

}  // namespace geargraph::inline synthesis
