#include "core/design/fixes/fixes.h"

#include <array>

#include "core/design/fixes/fix_makers.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/edits.h"

namespace geargraph {
namespace {

std::vector<Fix> allFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  switch (diagnostic.code) {
    case Code::disconnected:
    case Code::turningLoop:
      return treeFixes(diagnostic, snapshot);
    case Code::pitchGeometry:
    case Code::pitchPointOnAxis:
    case Code::teethGeometry:
    case Code::coaxialMesh:
    case Code::noTransferVertex:
    case Code::redundantMesh:
    case Code::splitAxis:
      return meshFixes(diagnostic, snapshot);
    case Code::interference:
      return overlapFixes(diagnostic, snapshot);
    case Code::invalidInputs:
      return inputFixes(snapshot);
    case Code::redundantCoupling:
      return couplingFixes(diagnostic, snapshot);
    case Code::locked:
      if (snapshot.matroid() != nullptr && !snapshot.matroid()->independentHeld.empty())
        return couplingFixes(diagnostic, snapshot);
      [[fallthrough]];
    case Code::assembly:
    case Code::undercut:
    case Code::deadJoint:
      return teethFixes(diagnostic, snapshot);
    default:
      return {};
  }
}

}  // namespace

bool triesBodies(const Diagnostic& diagnostic) {
  return diagnostic.code == Code::interference || diagnostic.detail == Detail::unequalPlanets;
}

std::string wordFor(const Mechanism& mechanism, const ElementId& element) {
  const std::string label = labelOf(mechanism, element).value_or(element.id.text());
  switch (element.kind) {
    case ElementKind::link:
      return translated("link %1", {label});
    case ElementKind::turningJoint:
      return translated("joint %1", {label});
    case ElementKind::gearMesh:
      return translated("mesh %1", {label});
    case ElementKind::coupling: {
      const ShiftElement* coupling = mechanism.find(ShiftElementId(element.id));
      return couplingName(coupling == nullptr ? ShiftElementKind::clutch : coupling->kind, element.id.text());
    }
    default:
      return label;
  }
}

Fix removalOf(const AnalysisSnapshot& snapshot, const ElementId& element, const std::string& why) {
  return {translated("Delete %1", {wordFor(*snapshot.mechanism, element)}) + why,
          [element](const Mechanism& before) { return withoutElements(before, std::array{element}); }};
}

std::vector<Fix> fixesFor(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  std::vector<Fix> fixes = allFixes(diagnostic, snapshot);
  if (fixes.size() > kMaxFixes) fixes.resize(kMaxFixes);
  return fixes;
}

}  // namespace geargraph
