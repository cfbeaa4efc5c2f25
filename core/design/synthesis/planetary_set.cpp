#include "core/design/synthesis/planetary_set.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/design/synthesis/set_sketch.h"
#include "core/foundations/base/contract.h"

namespace geargraph::inline synthesis {
namespace {

/// The member's weight in Willis' equation: the weighted speeds add up to 0.
int weightOf(const PlanetaryTeeth& teeth, PlanetaryMember member) {
  switch (member) {
    case PlanetaryMember::sun:
      return teeth.sun;
    case PlanetaryMember::ring:
      return teeth.ring();
    default:
      return -(teeth.sun + teeth.ring());
  }
}

}  // namespace

Rational planetaryRatio(const PlanetaryTeeth& teeth, PlanetaryMember drive, PlanetaryMember driven) {
  GEARGRAPH_REQUIRE(drive != driven);
  return {-weightOf(teeth, driven), weightOf(teeth, drive)};
}

bool assembles(const PlanetaryTeeth& teeth, int planets) {
  return (teeth.sun + teeth.ring()) % planets == 0;
}

bool neighboursClear(const PlanetaryTeeth& teeth, int planets) {
  return planets < 2 || (teeth.sun + teeth.planet) * std::sin(std::numbers::pi / planets) > teeth.planet + 2;
}

std::vector<PlanetaryChoice> planetaryChoices(const PlanetaryWish& wish, std::size_t most) {
  std::vector<PlanetaryChoice> choices;
  const double wanted = wish.ratio.toDouble();
  for (int sun = wish.fewestTeeth; sun <= wish.mostTeeth; ++sun) {
    for (int planet = wish.fewestTeeth; sun + 2 * planet <= wish.mostTeeth; ++planet) {
      const PlanetaryTeeth teeth{sun, planet};
      if (!assembles(teeth, wish.planets) || !neighboursClear(teeth, wish.planets)) continue;
      const double ratio = static_cast<double>(-weightOf(teeth, wish.driven)) / weightOf(teeth, wish.drive);
      if (ratio * wanted <= 0) continue;
      choices.push_back({teeth, Rational(), std::abs(ratio - wanted) / std::abs(wanted)});
    }
  }
  const auto nearer = [](const PlanetaryChoice& a, const PlanetaryChoice& b) {
    if (a.error != b.error) return a.error < b.error;
    return a.teeth.ring() != b.teeth.ring() ? a.teeth.ring() < b.teeth.ring() : a.teeth.sun < b.teeth.sun;
  };
  const auto end = choices.begin() + static_cast<std::ptrdiff_t>(std::min(most, choices.size()));
  std::partial_sort(choices.begin(), end, choices.end(), nearer);
  choices.erase(end, choices.end());
  for (PlanetaryChoice& choice : choices)
    choice.ratio = planetaryRatio(choice.teeth, wish.drive, wish.driven);
  return choices;
}

Mechanism planetarySet(const PlanetaryTeeth& teeth, int planets) {
  SetSketch set("Planetary set");
  const int sun = set.link(0, "a", "sun");
  const int ring = set.link(0, "a", "ring");
  const int carrier = set.link(0, "a", "carrier");
  for (int i = 0; i < planets; ++i) {
    const std::string number = planets == 1 ? "" : " " + std::to_string(i + 1);
    const int planet = set.link(carrier, "b" + std::to_string(i), "planet" + number);
    set.mesh(sun, planet, teeth.sun, teeth.planet, MeshKind::external);
    set.mesh(planet, ring, teeth.planet, teeth.ring(), MeshKind::internal);
  }
  set.input(sun, Number(1));
  set.input(ring, Number(0));
  return std::move(set).build();
}

}  // namespace geargraph::inline synthesis
