#include "core/mechanism/fitting/pin_rejection.h"

#include "core/foundations/base/wording.h"
#include "core/foundations/base/words.h"
#include "core/mechanism/model/pins.h"

namespace geargraph::inline fitting {

const Axis& axisOfClass(const Mechanism& mechanism, const Placement& placement, int axisClass) {
  const int axis = placement.classes->classes[static_cast<std::size_t>(axisClass)].axis;
  return mechanism.axes[static_cast<std::size_t>(axis)];
}

Diagnostic pinRejection(const Mechanism& mechanism, const Placement& placement, int mesh) {
  const MeshGeometry& geometry = *placement.meshes[static_cast<std::size_t>(mesh)];
  Diagnostic rejection;
  rejection.code = Code::teethGeometry;
  rejection.detail = Detail::pinnedWheel;
  rejection.elements.emplace_back(mechanism.gearMeshes[static_cast<std::size_t>(mesh)].id);
  std::vector<std::string> pinned;
  for (const int link : {geometry.tail, geometry.head}) {
    const Link& element = mechanism.links[static_cast<std::size_t>(link)];
    if (!isPinned(element)) continue;
    rejection.elements.emplace_back(element.id);
    pinned.push_back(translated("gear %1", {std::to_string(mechanism.linkLabel(link))}));
  }
  for (const int axisClass : {geometry.tailClass, geometry.headClass}) {
    const Axis& axis = axisOfClass(mechanism, placement, axisClass);
    if (!isPinned(axis)) continue;
    rejection.elements.emplace_back(axis.id);
    pinned.push_back(translated("axis %1", {axis.id.text()}));
  }
  if (pinned.empty()) {  // what holds it lies farther along the train
    for (const Axis& axis : mechanism.axes) {
      if (!isPinned(axis)) continue;
      rejection.elements.emplace_back(axis.id);
      pinned.push_back(translated("axis %1", {axis.id.text()}));
    }
  }
  const std::string label = std::to_string(mechanism.meshLabel(mesh));
  const std::string holding = listed(pinned, kAllNames);
  rejection.message =
      pinned.size() == 1
          ? translated("Mesh %1 cannot follow: %2 is pinned. What fits: unpin it, or another change.",
                       {label, holding})
          : translated(
                "Mesh %1 cannot follow: %2 are pinned. What fits: unpin one of them, or another change.",
                {label, holding});
  return rejection;
}

Diagnostic modulePinRejection(const Mechanism& mechanism, int mesh) {
  Diagnostic rejection;
  rejection.code = Code::teethGeometry;
  rejection.detail = Detail::pinnedModule;
  rejection.message =
      translated("The module of mesh %1 is pinned, and would change. What fits: unpin it, or another change.",
                 {std::to_string(mechanism.meshLabel(mesh))});
  rejection.elements.emplace_back(mechanism.gearMeshes[static_cast<std::size_t>(mesh)].id);
  return rejection;
}

Diagnostic pinRejection(const Axis& axis) {
  Diagnostic rejection;
  rejection.code = Code::teethGeometry;
  rejection.detail = Detail::pinnedAxis;
  rejection.message = translated("Axis %1 is pinned. What fits: unpin it to move it.", {axis.id.text()});
  rejection.elements.emplace_back(axis.id);
  return rejection;
}

}  // namespace geargraph::inline fitting
