#include "core/mechanism/placement/placed_mechanism.h"

#include <stop_token>
#include <utility>

namespace geargraph {

PlacedMechanism::PlacedMechanism(MechanismPtr mechanism)
    : m_mechanism(std::move(mechanism)),
      m_placement(std::make_shared<const DeferredValue<Placement>>(
          [mechanism = m_mechanism](const std::stop_token&) { return placementOf(*mechanism); })) {}

PlacedMechanism PlacedMechanism::withSamePlacement(MechanismPtr mechanism) const {
  PlacedMechanism other = *this;
  other.m_mechanism = std::move(mechanism);
  return other;
}

Expected<PlacedMechanism> unplaced(Expected<Mechanism> edited) {
  if (!edited) return edited.error();
  return PlacedMechanism(std::move(edited).value());
}

}  // namespace geargraph
