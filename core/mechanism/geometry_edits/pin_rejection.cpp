#include "core/mechanism/geometry_edits/pin_rejection.h"

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/pins.h"

namespace geargraph {

const Axis& axisOfClass(const Mechanism& mechanism, const Placement& placement, AxisGroupOrdinal axisGroup) {
  const AxisOrdinal axis = placement.classes->classes[axisGroup].axis;
  return mechanism.axes[axis];
}

Diagnostic pinRejection(const Mechanism& mechanism, const Placement& placement, MeshOrdinal mesh) {
  const MeshGeometry& geometry = *placement.meshes[mesh];
  Diagnostic rejection;
  rejection.code = Code::teethGeometry;
  rejection.detail = Detail::pinnedWheel;
  rejection.elements.emplace_back(mechanism.gearMeshes[mesh].id);
  std::vector<std::string> pinned;
  for (const LinkOrdinal link : {geometry.tail, geometry.head}) {
    const Link& element = mechanism.links[link];
    if (!isPinned(element)) continue;
    rejection.elements.emplace_back(element.id);
    pinned.push_back(translated("gear %1", {std::to_string(mechanism.linkLabel(link))}));
  }
  for (const AxisGroupOrdinal axisGroup : {geometry.tailClass, geometry.headClass}) {
    const Axis& axis = axisOfClass(mechanism, placement, axisGroup);
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

Diagnostic modulePinRejection(const Mechanism& mechanism, MeshOrdinal mesh) {
  Diagnostic rejection;
  rejection.code = Code::teethGeometry;
  rejection.detail = Detail::pinnedModule;
  rejection.message =
      translated("The module of mesh %1 is pinned, and would change. What fits: unpin it, or another change.",
                 {std::to_string(mechanism.meshLabel(mesh))});
  rejection.elements.emplace_back(mechanism.gearMeshes[mesh].id);
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

}  // namespace geargraph
