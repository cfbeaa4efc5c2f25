#include "core/mechanism/fitting/pin_refusal.h"

#include "core/foundations/base/wording.h"
#include "core/mechanism/model/pins.h"

namespace geargraph::inline fitting {

const Axis& axisOfClass(const Mechanism& mechanism, const Placement& placement, int axisClass) {
  const int axis = placement.classes->classes[static_cast<std::size_t>(axisClass)].axis;
  return mechanism.axes[static_cast<std::size_t>(axis)];
}

Diagnostic pinRefusal(const Mechanism& mechanism, const Placement& placement, int mesh) {
  const MeshGeometry& geometry = *placement.meshes[static_cast<std::size_t>(mesh)];
  Diagnostic refusal;
  refusal.code = Code::teethGeometry;
  refusal.detail = Detail::pinnedWheel;
  refusal.elements.emplace_back(mechanism.gearMeshes[static_cast<std::size_t>(mesh)].id);
  std::vector<std::string> pinned;
  for (const int link : {geometry.tail, geometry.head}) {
    const Link& element = mechanism.links[static_cast<std::size_t>(link)];
    if (!isPinned(element)) continue;
    refusal.elements.emplace_back(element.id);
    pinned.push_back("gear " + std::to_string(mechanism.linkLabel(link)));
  }
  for (const int axisClass : {geometry.tailClass, geometry.headClass}) {
    const Axis& axis = axisOfClass(mechanism, placement, axisClass);
    if (!isPinned(axis)) continue;
    refusal.elements.emplace_back(axis.id);
    pinned.push_back("axis " + axis.id.text());
  }
  if (pinned.empty()) {  // what holds it lies farther along the train
    for (const Axis& axis : mechanism.axes) {
      if (!isPinned(axis)) continue;
      refusal.elements.emplace_back(axis.id);
      pinned.push_back("axis " + axis.id.text());
    }
  }
  refusal.message = "Mesh " + std::to_string(mechanism.meshLabel(mesh)) +
                    " cannot follow: " + listed(pinned, kAllNames) + (pinned.size() == 1 ? " is" : " are") +
                    " pinned. What fits: unpin " + (pinned.size() == 1 ? "it" : "one of them") +
                    ", or another change.";
  return refusal;
}

Diagnostic modulePinRefusal(const Mechanism& mechanism, int mesh) {
  Diagnostic refusal;
  refusal.code = Code::teethGeometry;
  refusal.detail = Detail::pinnedModule;
  refusal.message = "The module of mesh " + std::to_string(mechanism.meshLabel(mesh)) +
                    " is pinned, and would change. What fits: unpin it, or another change.";
  refusal.elements.emplace_back(mechanism.gearMeshes[static_cast<std::size_t>(mesh)].id);
  return refusal;
}

Diagnostic pinRefusal(const Axis& axis) {
  Diagnostic refusal;
  refusal.code = Code::teethGeometry;
  refusal.detail = Detail::pinnedAxis;
  refusal.message = "Axis " + axis.id.text() + " is pinned. What fits: unpin it to move it.";
  refusal.elements.emplace_back(axis.id);
  return refusal;
}

}  // namespace geargraph::inline fitting
