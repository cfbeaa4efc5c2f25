#include "core/design/gearboxes/element_classes.h"

#include <algorithm>
#include <map>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

using Residue = PrimeField::Residue;
using ResidueDirection = std::array<Residue, kMaxFreedom>;

/// The speeds of a layout at random tooth counts, modulo a prime.
struct GeneralSpeeds {
  ResidueNumbers numbers{PrimeField()};
  std::optional<SpeedSpace<Residue>> space;

  GeneralSpeeds(const BasicSets& sets, const GearLayout& layout, int shafts) {
    ResidueStream stream(numbers.field, PrimeField::kSecondSeed);
    std::vector<Residue> k;
    for (std::size_t set = 0; set < sets.size(); ++set) k.push_back(stream.next());
    space = speedSpace<ResidueNumbers>(sets, layout, shafts, k, numbers);
    GEARGRAPH_REQUIRE(space.has_value());
  }
};

/// The direction with its first component that is not 0 at 1.
ResidueDirection normalised(ResidueDirection direction, const ResidueNumbers& numbers) {
  const auto first = std::find_if(direction.begin(), direction.end(), [](Residue each) { return each != 0; });
  if (first == direction.end()) return direction;
  const Residue scale = numbers.inverse(*first);
  for (Residue& each : direction) each = numbers.multiply(each, scale);
  return direction;
}

}  // namespace

std::vector<ElementClass> elementClasses(const BasicSets& sets, const GearLayout& layout, int shafts) {
  const GeneralSpeeds general(sets, layout, shafts);
  std::map<ResidueDirection, ElementClass> byDirection;
  const auto add = [&](int a, int b) {
    const ElementLinks element{static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)};
    byDirection[normalised(directionOf(*general.space, element, general.numbers), general.numbers)]
        .variants.push_back(element);
  };
  for (int link = 1; link <= shafts; ++link) {
    if (link != layout.input && link != layout.output) add(link, 0);
  }
  for (int a = 1; a <= shafts; ++a) {
    for (int b = a + 1; b <= shafts; ++b) add(a, b);
  }
  std::vector<ElementClass> classes;
  for (auto& [direction, each] : byDirection) classes.push_back(std::move(each));
  std::sort(classes.begin(), classes.end(), [](const ElementClass& x, const ElementClass& y) {
    const ElementLinks& a = x.variants.front();
    const ElementLinks& b = y.variants.front();
    return a.isBrake() != b.isBrake() ? a.isBrake() : a < b;
  });
  // A direction along that of the input or of the output would stop it.
  std::erase_if(classes, [&](const ElementClass& each) {
    const auto direction =
        normalised(directionOf(*general.space, each.variants.front(), general.numbers), general.numbers);
    return direction == normalised(general.space->rows[layout.input], general.numbers) ||
           direction == normalised(general.space->rows[layout.output], general.numbers);
  });
  return classes;
}

StateList gearStates(const BasicSets& sets, const GearLayout& layout, int shafts,
                     const std::vector<ElementClass>& classes) {
  const GeneralSpeeds general(sets, layout, shafts);
  const int freedom = general.space->freedom;
  const auto count = static_cast<int>(classes.size());
  std::vector<ResidueDirection> directions;
  for (const ElementClass& each : classes)
    directions.push_back(directionOf(*general.space, each.variants.front(), general.numbers));
  StateList list;
  std::array<std::uint8_t, 3> members{};
  const auto complete = [&] {
    std::array<ResidueDirection, 3> engaged{};
    std::uint64_t mask = 0;
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(freedom); ++i) {
      engaged[i] = directions[members[i]];
      mask |= std::uint64_t{1} << members[i];
    }
    const Residue in = speedWith(engaged, general.space->rows[layout.input], freedom, general.numbers);
    const Residue out = speedWith(engaged, general.space->rows[layout.output], freedom, general.numbers);
    if (in != 0 && out != 0) list.states.push_back({mask, members, in == out});
  };
  const auto choose = [&](const auto& self, int place, int from) -> void {
    if (place == freedom - 1) return complete();
    for (int i = from; i < count; ++i) {
      members[static_cast<std::size_t>(place)] = static_cast<std::uint8_t>(i);
      self(self, place + 1, i + 1);
    }
  };
  choose(choose, 0, 0);
  return list;
}

}  // namespace geargraph
