#include "core/theory/states/state_diagnostics.h"

#include <string>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxStateNames = 12;

Diagnostic makeDiagnostic(const ShiftState& state, Code code) {
  Diagnostic result;
  result.code = code;
  result.elements.emplace_back(ElementKind::state, InternedString(state.name));
  return result;
}

std::string linkLabel(const Mechanism& mechanism, LinkId link) {
  return labelOf(mechanism, link).value_or(link.text());
}

}  // namespace

Diagnostic stateLocked(const Mechanism& mechanism, const ShiftState& state, const std::vector<int>& locking,
                       bool byTrain) {
  Diagnostic result = makeDiagnostic(state, Code::stateLocked);
  const std::string drive = linkLabel(mechanism, *state.drive);
  std::vector<std::string> names;
  for (const ShiftElementOrdinal coupling : locking) {
    names.push_back(mechanism.couplings[coupling].id.text());
    result.elements.emplace_back(mechanism.couplings[coupling].id);
  }
  if (byTrain) {
    result.message = translated(
        "State %1 locks its drive, link %2: the train holds it with nothing engaged. Change the train, or "
        "drive another link.",
        {state.name, drive});
  } else if (names.empty()) {
    result.message = translated(
        "State %1 locks its drive, link %2: more couplings than one hold it. Release two or more, or drive "
        "another link.",
        {state.name, drive});
  } else if (names.size() == 1) {
    result.message =
        translated("State %1 locks its drive, link %2: %3 holds it. Release it, or drive another link.",
                   {state.name, drive, names.front()});
  } else {
    result.message = translated(
        "State %1 locks its drive, link %2: %3 hold it together. Release one of them, or drive another link.",
        {state.name, drive, listed(names, kMaxStateNames)});
  }
  result.elements.emplace_back(*state.drive);
  return result;
}

Diagnostic stateFree(const Mechanism& mechanism, const ShiftState& state, int dof,
                     const std::vector<int>& links) {
  Diagnostic result = makeDiagnostic(state, Code::stateFree);
  std::vector<std::string> names;
  for (const LinkOrdinal link : links) {
    names.push_back(std::to_string(mechanism.linkLabel(link)));
    result.elements.emplace_back(mechanism.links[link].id);
  }
  const std::string freedoms = std::to_string(dof);
  const std::string turning = listed(names, kMaxStateNames);
  const bool isOne = names.size() == 1;
  if (state.drive) {
    const std::string drive = linkLabel(mechanism, *state.drive);
    result.message = isOne ? translated(
                                 "State %1 leaves %2 degrees of freedom: with the drive, link %3, held, link "
                                 "%4 still turns.",
                                 {state.name, freedoms, drive, turning})
                           : translated(
                                 "State %1 leaves %2 degrees of freedom: with the drive, link %3, held, "
                                 "links %4 still turn.",
                                 {state.name, freedoms, drive, turning});
  } else {
    result.message = isOne ? translated("State %1 leaves %2 degrees of freedom: link %3 still turns.",
                                        {state.name, freedoms, turning})
                           : translated("State %1 leaves %2 degrees of freedom: links %3 still turn.",
                                        {state.name, freedoms, turning});
  }
  const int missing = dof - 1;
  result.message += ' ';
  result.message += missing == 1
                        ? translated("Engage one more coupling that holds them.")
                        : translated("Engage %1 more couplings that hold them.", {std::to_string(missing)});
  return result;
}

Diagnostic stateIdle(const Mechanism& mechanism, const ShiftState& state, const std::vector<int>& links) {
  Diagnostic result = makeDiagnostic(state, Code::stateIdle);
  std::vector<std::string> names;
  for (const LinkOrdinal link : links) {
    names.push_back(std::to_string(mechanism.linkLabel(link)));
    result.elements.emplace_back(mechanism.links[link].id);
  }
  const std::string turning = listed(names, kMaxStateNames);
  result.message = names.size() == 1
                       ? translated(
                             "State %1: link %2 turns freely beside it, at any speed. The ratio does not "
                             "depend on it.",
                             {state.name, turning})
                       : translated(
                             "State %1: links %2 turn freely beside it, at any speed. The ratio does not "
                             "depend on them.",
                             {state.name, turning});
  return result;
}

namespace {

/// The locked freewheels by name; all are blamed.
std::string lockedNames(const Mechanism& mechanism, const std::vector<StateSolution::Freewheel>& freewheels,
                        Diagnostic& result) {
  std::vector<std::string> names;
  for (const StateSolution::Freewheel& each : freewheels) {
    result.elements.emplace_back(mechanism.couplings[each.coupling].id);
    if (each.isLocked) names.push_back(mechanism.couplings[each.coupling].id.text());
  }
  return names.empty() ? translated("none") : listed(names, kMaxStateNames);
}

}  // namespace

Diagnostic freewheelsOpen(const Mechanism& mechanism, const ShiftState& state,
                          const std::vector<StateSolution::Freewheel>& found) {
  Diagnostic result = makeDiagnostic(state, Code::stateFree);
  const std::string names = lockedNames(mechanism, found, result);
  result.message = translated(
      "State %1: more than one pattern of locked and free freewheels is possible; shown is the one with "
      "these "
      "locked: %2.",
      {state.name, names});
  return result;
}

Diagnostic freewheelsOverrun(const Mechanism& mechanism, const ShiftState& state,
                             const std::vector<StateSolution::Freewheel>& wanted) {
  Diagnostic result = makeDiagnostic(state, Code::stateFree);
  const std::string names = lockedNames(mechanism, wanted, result);
  result.message = translated(
      "State %1: the drive overruns its freewheels and drives nothing this way (locked they would turn as "
      "shown: %2). Exchange the two links of one, or turn the drive the other way.",
      {state.name, names});
  return result;
}

Diagnostic freewheelDirection(const Mechanism& mechanism, const ShiftElement& freewheel,
                              const Rational& slip) {
  Diagnostic result;
  result.code = Code::freewheelDirection;
  result.elements = {freewheel.id, freewheel.links.front(), freewheel.links.back()};
  result.message = translated(
      "Freewheel %1 locks before link %2 turns faster than link %3, but the given speeds make it faster by "
      "%4 "
      "rad/s. Engage it, exchange its links, or turn the inputs the other way.",
      {freewheel.id.text(), linkLabel(mechanism, freewheel.links.front()),
       linkLabel(mechanism, freewheel.links.back()), slip.toString()});
  return result;
}

Diagnostic couplingLinkage(const Mechanism& mechanism, const ShiftElement& coupling,
                           const ShiftState* state) {
  Diagnostic result;
  if (state != nullptr) result = makeDiagnostic(*state, Code::turningLoop);
  result.code = Code::turningLoop;
  result.detail = Detail::couplingLinkage;
  const std::string& name = coupling.id.text();
  const std::string link = linkLabel(mechanism, coupling.links.front());
  const std::string other = linkLabel(mechanism, coupling.links.back());
  const bool isBrake = coupling.kind == ShiftElementKind::brake;
  if (state != nullptr) {
    result.message =
        isBrake
            ? translated(
                  "State %1: coupling %2 ties link %3 to the ground over axes of four directions or more.",
                  {state->name, name, link})
            : translated(
                  "State %1: coupling %2 ties link %3 to link %4 over axes of four directions or more.",
                  {state->name, name, link, other});
  } else {
    result.message =
        isBrake
            ? translated(
                  "Engaged coupling %1 ties link %2 to the ground over axes of four directions or more.",
                  {name, link})
            : translated("Engaged coupling %1 ties link %2 to link %3 over axes of four directions or more.",
                         {name, link, other});
  }
  result.message += ' ' + translated(
                              "That is a linkage whose speeds depend on the pose: there is no ratio to "
                              "state. Couple links that lie nearer to each other.");
  result.elements.emplace_back(coupling.id);
  for (const LinkId tied : coupling.links) result.elements.emplace_back(tied);
  return result;
}

Diagnostic clutchAxes(const Mechanism& mechanism, const ShiftElement& clutch) {
  Diagnostic result;
  result.code = Code::turningLoop;
  result.detail = Detail::clutchAxes;
  result.message = translated(
      "Clutch %1 couples links %2 and %3, which do not turn about one axis against each other: their axes "
      "are "
      "not one line. Couple links on one axis, or a planet and its carrier.",
      {clutch.id.text(), linkLabel(mechanism, clutch.links.front()),
       linkLabel(mechanism, clutch.links.back())});
  result.elements.emplace_back(clutch.id);
  for (const LinkId tied : clutch.links) result.elements.emplace_back(tied);
  return result;
}

Diagnostic ratioBeyondRange(const ShiftState& state) {
  Diagnostic result = makeDiagnostic(state, Code::schema);
  result.message = translated(
      "State %1 has a ratio beyond the largest number that the analysis can hold, 1.79e308. Tooth counts "
      "nearer to "
      "each other, or fewer meshes in a row, give one that it can.",
      {state.name});
  return result;
}

}  // namespace geargraph
