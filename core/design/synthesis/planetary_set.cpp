#include "core/design/synthesis/planetary_set.h"

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "core/design/synthesis/set_search.h"
#include "core/design/synthesis/set_sketch.h"
#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
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

PlanetaryMember heldMember(const PlanetaryUse& use) {
  GEARGRAPH_REQUIRE(use.drive != use.driven);
  using enum PlanetaryMember;
  for (const PlanetaryMember member : {sun, ring})
    if (member != use.drive && member != use.driven) return member;
  return carrier;
}

/// The numbers of the links.
using Members = std::map<PlanetaryMember, LinkOrdinal>;

/// Links and meshes of a set; `cut` is the ground.
Members addMembers(SetSketch& set, const PlanetaryTeeth& teeth, int planets,
                   std::optional<PlanetaryMember> cut) {
  using enum PlanetaryMember;
  Members members;
  for (const auto& [member, name] :
       {std::pair(sun, toTranslate("sun")), {ring, toTranslate("ring")}, {carrier, toTranslate("carrier")}})
    members[member] = member == cut ? LinkOrdinal(0) : set.link(0, "a", translated(std::string_view(name)));
  for (int i = 0; i < planets; ++i) {
    std::string name = planets == 1 ? translated("planet") : translated("planet %1", {std::to_string(i + 1)});
    const int planet = set.link(members[carrier], "b" + std::to_string(i), std::move(name));
    set.mesh(members[sun], planet, teeth.sun, teeth.planet, MeshKind::external);
    set.mesh(planet, members[ring], teeth.planet, teeth.ring(), MeshKind::internal);
  }
  return members;
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

std::vector<PlanetaryChoice> planetaryChoices(const PlanetaryRequirements& requirements, std::size_t most) {
  // Sun 1, ring 2, carrier 3: the third member is held.
  const auto linkOf = [](PlanetaryMember member) { return LinkOrdinal(static_cast<int>(member) + 1); };
  const PlanetaryTeeth drawn;
  TeethWish wish;
  RatioWish& ratio = wish.ratios.emplace_back();
  ratio.drive = linkOf(requirements.drive);
  ratio.driven = linkOf(requirements.driven);
  ratio.held = {linkOf(heldMember({requirements.drive, requirements.driven}))};
  wish.fewest = requirements.fewestTeeth;
  wish.most = wish.mostRing = requirements.mostTeeth;
  wish.planets = requirements.planets;
  std::vector<PlanetaryChoice> choices;
  const auto isEnough = [&](const std::vector<FoundTeeth>& found) { return found.size() >= most; };
  for (const FoundTeeth& found : nearestTeeth(planetarySet(drawn, requirements.planets), std::move(wish),
                                              requirements.ratio, isEnough)) {
    if (choices.size() == most) break;
    // Wheels in the order of their first ends: sun, planet, ring.
    choices.push_back({{found.teeth[0], found.teeth[1]}, found.ratios.front(), found.error.toDouble()});
  }
  return choices;
}

Mechanism planetarySet(const PlanetaryTeeth& teeth, int planets) {
  SetSketch set(translated("Planetary set"));
  const Members members = addMembers(set, teeth, planets, {});
  set.input(members.at(PlanetaryMember::sun), Number(1));
  set.input(members.at(PlanetaryMember::ring), Number(0));
  return std::move(set).build();
}

Mechanism planetarySet(const PlanetaryTeeth& teeth, int planets, const PlanetaryUse& use) {
  const PlanetaryMember held = heldMember(use);
  const bool isCut = use.holding == PlanetaryHolding::ground;
  SetSketch set(translated("Planetary set"));
  const Members members = addMembers(set, teeth, planets, isCut ? std::optional(held) : std::nullopt);
  set.input(members.at(use.drive), Number(1));
  if (!isCut) {
    set.brake("B", members.at(held));
    set.engage("B");
  }
  return std::move(set).build();
}

}  // namespace geargraph
