#include "core/theory/states/state_findings.h"

#include <string>

#include "core/foundations/base/wording.h"

namespace geargraph::inline states {
namespace {

constexpr std::size_t kMostNames = 12;

Diagnostic finding(const ShiftState& state, Code code) {
  Diagnostic result;
  result.code = code;
  result.message = "State " + state.name;
  result.elements.emplace_back(ElementKind::state, Atom(state.name));
  return result;
}

std::string linkName(const Mechanism& mechanism, LinkId link) {
  return "link " + labelOf(mechanism, link).value_or(link.text());
}

}  // namespace

Diagnostic stateLocked(const Mechanism& mechanism, const ShiftState& state, const std::vector<int>& locking,
                       bool byTrain) {
  Diagnostic result = finding(state, Code::stateLocked);
  result.message += " locks its drive, " + linkName(mechanism, *state.drive) + ": ";
  std::vector<std::string> names;
  for (const int coupling : locking) {
    names.push_back(mechanism.couplings[static_cast<std::size_t>(coupling)].id.text());
    result.elements.emplace_back(mechanism.couplings[static_cast<std::size_t>(coupling)].id);
  }
  if (byTrain) {
    result.message += "the train holds it with nothing engaged. Change the train, or drive another link.";
  } else if (names.empty()) {
    result.message += "more couplings than one hold it. Release two or more, or drive another link.";
  } else if (names.size() == 1) {
    result.message += names.front() + " holds it. Release it, or drive another link.";
  } else {
    result.message +=
        listed(names, kMostNames) + " hold it together. Release one of them, or drive another link.";
  }
  result.elements.emplace_back(*state.drive);
  return result;
}

Diagnostic stateFree(const Mechanism& mechanism, const ShiftState& state, int dof,
                     const std::vector<int>& links) {
  Diagnostic result = finding(state, Code::stateFree);
  result.message += " leaves " + std::to_string(dof) + " degrees of freedom: ";
  std::vector<std::string> names;
  for (const int link : links) {
    names.push_back(std::to_string(mechanism.linkLabel(link)));
    result.elements.emplace_back(mechanism.links[static_cast<std::size_t>(link)].id);
  }
  if (state.drive) result.message += "with the drive, " + linkName(mechanism, *state.drive) + ", held, ";
  const int missing = dof - 1;
  result.message += (names.size() == 1 ? "link " + names.front() + " still turns"
                                       : "links " + listed(names, kMostNames) + " still turn") +
                    ". Engage " +
                    (missing == 1 ? "one more coupling" : std::to_string(missing) + " more couplings") +
                    " that " + (missing == 1 ? "holds" : "hold") + " them.";
  return result;
}

Diagnostic couplingLinkage(const Mechanism& mechanism, const Coupling& coupling, const ShiftState* state) {
  Diagnostic result;
  if (state != nullptr) result = finding(*state, Code::turningLoop);
  result.code = Code::turningLoop;
  result.detail = Detail::couplingLinkage;
  result.message +=
      (state != nullptr ? ": coupling " : "Engaged coupling ") + coupling.id.text() + " ties " +
      linkName(mechanism, coupling.links.front()) + " to " +
      (coupling.kind == CouplingKind::brake ? "the ground" : linkName(mechanism, coupling.links.back())) +
      " over axes of four directions or more. That is a linkage whose speeds depend on the "
      "pose: there is no ratio to state. Couple links that lie nearer to each other.";
  result.elements.emplace_back(coupling.id);
  for (const LinkId link : coupling.links) result.elements.emplace_back(link);
  return result;
}

Diagnostic ratioBeyondRange(const ShiftState& state) {
  Diagnostic result = finding(state, Code::schema);
  result.message +=
      " has a ratio beyond the largest number that the analysis can hold, 1.79e308. Tooth counts nearer to "
      "each other, or fewer meshes in a row, give one that it can.";
  return result;
}

}  // namespace geargraph::inline states
