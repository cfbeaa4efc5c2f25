#include "core/mechanism/model/shift_edits.h"

#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/rejections.h"

namespace geargraph {
namespace {

/// "A", "B", ... "Z", "A1", ...
ShiftElementId freshCouplingId(const Mechanism& mechanism) {
  for (int round = 0;; ++round) {
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
      const ShiftElementId id(std::string(1, letter) + (round == 0 ? "" : std::to_string(round)));
      if (mechanism.find(id) == nullptr) return id;
    }
  }
}

Expected<Mechanism> withCoupling(Mechanism mechanism, ShiftElementKind kind, std::vector<LinkId> links,
                                 const std::string& id) {
  for (const LinkId link : links) {
    if (mechanism.find(link) == nullptr) return unknownElement(link);
  }
  const ShiftElementId name = id.empty() ? freshCouplingId(mechanism) : ShiftElementId(id);
  if (mechanism.find(name) != nullptr)
    return rejection(Code::duplicateId, translated("There is a coupling \"%1\" already.", {id}), {name});
  mechanism.couplings.push_back({name, kind, std::move(links), {}});
  return mechanism;
}

bool contains(const std::vector<ShiftElementId>& list, ShiftElementId coupling) {
  return std::find(list.begin(), list.end(), coupling) != list.end();
}

bool isFreewheel(const Mechanism& mechanism, ShiftElementId coupling) {
  const ShiftElement* const found = mechanism.find(coupling);
  return found != nullptr && found->kind == ShiftElementKind::freewheel;
}

ShiftState& stateAt(Mechanism& mechanism, int state) {
  GEARGRAPH_REQUIRE(state >= 0 && state < static_cast<int>(mechanism.states.size()));
  return mechanism.states[static_cast<std::size_t>(state)];
}

bool isStateName(const Mechanism& mechanism, const std::string& name) {
  return std::any_of(mechanism.states.begin(), mechanism.states.end(),
                     [&](const ShiftState& state) { return state.name == name; });
}

Expected<Mechanism> withEnd(Mechanism mechanism, int state, LinkId link,
                            std::optional<LinkId> ShiftState::*end) {
  if (mechanism.find(link) == nullptr) return unknownElement(link);
  if (state >= 0) {
    stateAt(mechanism, state).*end = link;
  } else {
    for (ShiftState& each : mechanism.states) each.*end = link;
  }
  return mechanism;
}

}  // namespace

Expected<Mechanism> withBrake(Mechanism mechanism, LinkId link, const std::string& id) {
  if (link == mechanism.links.front().id)
    return rejection(Code::schema, translated("The ground does not move: a brake is for a moving link."),
                     {link});
  return withCoupling(std::move(mechanism), ShiftElementKind::brake, {link}, id);
}

Expected<Mechanism> withClutch(Mechanism mechanism, LinkId one, LinkId other, const std::string& id) {
  if (one == other)
    return rejection(Code::selfJoint, translated("A clutch needs two different links."), {one});
  return withCoupling(std::move(mechanism), ShiftElementKind::clutch, {one, other}, id);
}

Expected<Mechanism> withFreewheel(Mechanism mechanism, LinkId first, LinkId second, const std::string& id) {
  if (first == second)
    return rejection(Code::selfJoint, translated("A freewheel needs two different links."), {first});
  return withCoupling(std::move(mechanism), ShiftElementKind::freewheel, {first, second}, id);
}

Expected<Mechanism> withCouplingRenamed(Mechanism mechanism, ShiftElementId coupling,
                                        const std::string& name) {
  const auto found = std::find_if(mechanism.couplings.begin(), mechanism.couplings.end(),
                                  [&](const ShiftElement& each) { return each.id == coupling; });
  if (found == mechanism.couplings.end()) return unknownElement(coupling);
  const ShiftElementId id(name);
  if (id == coupling) return mechanism;
  if (id.empty()) return rejection(Code::schema, translated("A coupling needs a name."), {coupling});
  if (mechanism.find(id) != nullptr)
    return rejection(Code::duplicateId, translated("There is a coupling \"%1\" already.", {name}), {id});
  found->id = id;
  for (ShiftState& state : mechanism.states)
    std::replace(state.engaged.begin(), state.engaged.end(), coupling, id);
  std::replace(mechanism.engaged.begin(), mechanism.engaged.end(), coupling, id);
  return mechanism;
}

Expected<Mechanism> withState(Mechanism mechanism) {
  ShiftState state;
  int number = 1;
  while (isStateName(mechanism, std::to_string(number))) ++number;
  state.name = std::to_string(number);
  if (!mechanism.states.empty()) {
    state.drive = mechanism.states.back().drive;
    state.driven = mechanism.states.back().driven;
  }
  mechanism.states.push_back(std::move(state));
  return mechanism;
}

Expected<Mechanism> withoutState(Mechanism mechanism, int state) {
  (void)stateAt(mechanism, state);
  mechanism.states.erase(mechanism.states.begin() + state);
  return mechanism;
}

Expected<Mechanism> withStateRenamed(Mechanism mechanism, int state, const std::string& name) {
  ShiftState& found = stateAt(mechanism, state);
  if (found.name == name) return mechanism;
  if (name.empty()) return rejection(Code::schema, translated("A state needs a name."));
  if (isStateName(mechanism, name))
    return rejection(Code::duplicateId, translated("There is a state \"%1\" already.", {name}),
                     {ElementId(ElementKind::state, InternedString(name))});
  found.name = name;
  return mechanism;
}

Expected<Mechanism> withEngaged(Mechanism mechanism, int state, ShiftElementId coupling, bool engaged) {
  if (mechanism.find(coupling) == nullptr) return unknownElement(coupling);
  ShiftState& found = stateAt(mechanism, state);
  if (engaged && isFreewheel(mechanism, coupling)) {
    return rejection(Code::schema,
                     translated("State \"%1\" engages freewheel \"%2\", which locks by itself: leave it out.",
                                {found.name, coupling.text()}),
                     {coupling});
  }
  std::vector<ShiftElementId> ordered;
  for (const ShiftElement& each : mechanism.couplings) {
    if (each.id == coupling ? engaged : contains(found.engaged, each.id)) ordered.push_back(each.id);
  }
  found.engaged = std::move(ordered);
  return mechanism;
}

Expected<Mechanism> withDrive(Mechanism mechanism, int state, LinkId drive) {
  return withEnd(std::move(mechanism), state, drive, &ShiftState::drive);
}

Expected<Mechanism> withDriven(Mechanism mechanism, int state, LinkId driven) {
  return withEnd(std::move(mechanism), state, driven, &ShiftState::driven);
}

Expected<Mechanism> withEngagement(Mechanism mechanism, const std::vector<ShiftElementId>& engaged) {
  for (auto coupling = engaged.begin(); coupling != engaged.end(); ++coupling) {
    if (mechanism.find(*coupling) == nullptr) return unknownElement(*coupling);
    if (std::find(engaged.begin(), coupling, *coupling) != coupling)
      return rejection(Code::duplicateId, translated("Coupling \"%1\" is listed twice.", {coupling->text()}),
                       {*coupling});
  }
  std::vector<ShiftElementId> ordered;
  for (const ShiftElement& each : mechanism.couplings) {
    if (contains(engaged, each.id)) ordered.push_back(each.id);
  }
  mechanism.engaged = std::move(ordered);
  return mechanism;
}

bool isEngaged(const Mechanism& mechanism, ShiftElementId coupling) {
  return contains(mechanism.engaged, coupling);
}

bool isEngaged(const Mechanism& mechanism, int state) {
  GEARGRAPH_REQUIRE(state >= 0 && state < static_cast<int>(mechanism.states.size()));
  if (mechanism.engaged.empty()) return false;
  const std::vector<ShiftElementId>& wanted = mechanism.states[static_cast<std::size_t>(state)].engaged;
  const auto in = [](const std::vector<ShiftElementId>& list) {
    return [&list](ShiftElementId coupling) { return contains(list, coupling); };
  };
  return std::all_of(wanted.begin(), wanted.end(), in(mechanism.engaged)) &&
         std::all_of(mechanism.engaged.begin(), mechanism.engaged.end(), [&](ShiftElementId coupling) {
           return contains(wanted, coupling) || isFreewheel(mechanism, coupling);
         });
}

int engagedState(const Mechanism& mechanism) {
  const bool hasInput = mechanism.inputs && !mechanism.inputs->empty();
  const TurningJoint* const first = hasInput ? mechanism.find(mechanism.inputs->front().joint) : nullptr;
  int found = -1;
  for (int state = 0; state < static_cast<int>(mechanism.states.size()); ++state) {
    if (!isEngaged(mechanism, state)) continue;
    const auto& drive = mechanism.states[static_cast<std::size_t>(state)].drive;
    if (first != nullptr && drive && (first->tail == *drive || first->head == *drive)) return state;
    if (found < 0) found = state;
  }
  return found;
}

}  // namespace geargraph
