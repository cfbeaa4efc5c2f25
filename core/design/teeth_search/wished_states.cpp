#include "core/design/teeth_search/wished_states.h"

#include <algorithm>

namespace geargraph {
namespace {

/// A name that no coupling has.
ShiftElementId freshBrake(const Mechanism& mechanism) {
  for (int number = 1;; ++number) {
    const ShiftElementId id("held " + std::to_string(number));
    const auto hasId = [&](const ShiftElement& each) { return each.id == id; };
    if (std::none_of(mechanism.couplings.begin(), mechanism.couplings.end(), hasId)) return id;
  }
}

ShiftElementId brakeOn(Mechanism& mechanism, LinkId link) {
  for (const ShiftElement& each : mechanism.couplings)
    if (each.kind == ShiftElementKind::brake && each.links.front() == link) return each.id;
  ShiftElement brake;
  brake.id = freshBrake(mechanism);
  brake.kind = ShiftElementKind::brake;
  brake.links = {link};
  mechanism.couplings.push_back(brake);
  return brake.id;
}

}  // namespace

Mechanism withWishedStates(const Mechanism& mechanism, const TeethWish& wish) {
  Mechanism result = mechanism;
  result.states.clear();
  result.engaged.clear();
  for (std::size_t i = 0; i < wish.ratios.size(); ++i) {
    const RatioWish& ratio = wish.ratios[i];
    ShiftState state;
    state.name = std::to_string(i + 1);
    if (ratio.state >= 0) state.engaged = mechanism.states[static_cast<std::size_t>(ratio.state)].engaged;
    if (ratio.isEngaged) state.engaged = mechanism.engaged;
    for (const LinkOrdinal link : ratio.held)
      if (link != 0) state.engaged.push_back(brakeOn(result, result.links[link].id));
    state.drive = mechanism.links[ratio.drive].id;
    state.driven = mechanism.links[ratio.driven].id;
    result.states.push_back(std::move(state));
  }
  return result;
}

}  // namespace geargraph
