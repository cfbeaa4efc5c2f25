#pragma once

#include <optional>

#include "core/design/synthesis/planetary_set.h"
#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Tooth counts of a Ravigneaux set: the short planet meshes with the small sun and the long planet, the long
/// one with the large sun and the ring. The ring follows: large sun + 2 long planet.
struct RavigneauxTeeth {
  int smallSun = 30;
  int largeSun = 36;
  int shortPlanet = 20;
  int longPlanet = 18;
  [[nodiscard]] int ring() const { return largeSun + 2 * longPlanet; }
};

/// A point of the plane that planets turn in, the main axis at the origin; lengths in half modules.
struct PlanePoint {
  double x = 0;
  double y = 0;
};

/// Where the first pair of planets of a set is: the one that meshes with the small sun, and the one that
/// meshes with the ring.
struct PairPlaces {
  PlanePoint shortPlanet;
  PlanePoint longPlanet;
};

/// std::nullopt if short and long planet cannot touch each other.
[[nodiscard]] std::optional<PairPlaces> pairPlaces(const RavigneauxTeeth& teeth);
/// The same of double planets between a sun and a ring, without a large sun.
[[nodiscard]] std::optional<PairPlaces> doublePlanetPlaces(int sun, int inner, int outer, int ring);
/// Do the wheels of neighbouring pairs clear each other, tips of one module each?
[[nodiscard]] bool pairsClear(const PairPlaces& places, int shortPlanet, int longPlanet, int pairs);
/// Where two wheels touch, in the base frame for a module of 2; `teethOfB` of a ring are negative.
[[nodiscard]] NumberTriple touchingPoint(const PlanePoint& a, int teethOfA, const PlanePoint& b, int teethOfB,
                                         int level);
/// 12 digits of a coordinate, so that what is 0 is written as 0.
[[nodiscard]] Number planeCoordinate(double value);

/// Why so many pairs cannot be in a set of these teeth, as ravigneauxSet() rejects it; std::nullopt if they
/// can.
[[nodiscard]] std::optional<Diagnostic> ravigneauxFault(const RavigneauxTeeth& teeth, int pairs);

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

}  // namespace geargraph
