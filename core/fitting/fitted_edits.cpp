#include "core/fitting/fitted_edits.h"

#include <algorithm>

#include "core/fitting/axis_fit.h"
#include "core/fitting/fitting_guards.h"
#include "core/fitting/teeth_fit.h"
#include "core/mechanism/edits.h"
#include "core/mechanism/pins.h"

namespace geargraph {
namespace {

int positionOf(const Mechanism& mechanism, MeshId mesh) {
  const auto found = std::find_if(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(),
                                  [mesh](const GearMesh& each) { return each.id == mesh; });
  return found == mechanism.gearMeshes.end() ? -1 : static_cast<int>(found - mechanism.gearMeshes.begin());
}

Expected<Mechanism> fitted(const Mechanism& before, const Placement& placement, const MeshChange& change) {
  const WheelMap wheels(before, placement);
  const auto fit = fitTeeth(before, placement, wheels, change);
  if (!fit) return fit.error();
  Mechanism edited = before;
  for (int mesh = 0; mesh < edited.c(); ++mesh) {
    GearMesh& element = edited.gearMeshes[static_cast<std::size_t>(mesh)];
    element.tailTeeth = fit->teeth[static_cast<std::size_t>(2 * mesh)];
    element.headTeeth = fit->teeth[static_cast<std::size_t>(2 * mesh + 1)];
    if (mesh == change.mesh && change.kind != placement.meshes[static_cast<std::size_t>(mesh)]->kind)
      element.kind = change.kind;
  }
  return unlessBroken(fitAxes(before, placement, std::move(edited), fit->scales));
}

}  // namespace

Expected<Mechanism> withTeethFitted(Mechanism mechanism, MeshId mesh, int tailTeeth, int headTeeth) {
  auto plain = withTeeth(mechanism, mesh, tailTeeth, headTeeth);
  if (!plain) return plain;
  const Placement placement = placementOf(mechanism);
  if (!canBeFitted(placement)) return plain;
  const int position = positionOf(mechanism, mesh);
  const MeshKind kind = placement.meshes[static_cast<std::size_t>(position)]->kind;
  return fitted(mechanism, placement, {position, tailTeeth, headTeeth, kind});
}

Expected<Mechanism> withKindFitted(Mechanism mechanism, MeshId mesh, MeshKind kind) {
  auto plain = withMeshKind(mechanism, mesh, kind);
  if (!plain) return plain;
  const Placement placement = placementOf(mechanism);
  if (!canBeFitted(placement)) return plain;
  const int position = positionOf(mechanism, mesh);
  const MeshKind was = placement.meshes[static_cast<std::size_t>(position)]->kind;
  if (was == kind || (was == MeshKind::bevel) != (kind == MeshKind::bevel))
    return unlessBroken(std::move(plain));
  const GearMesh& element = mechanism.gearMeshes[static_cast<std::size_t>(position)];
  return fitted(mechanism, placement, {position, element.tailTeeth, element.headTeeth, kind});
}

Expected<Mechanism> withPinned(Mechanism mechanism, const ElementId& element, bool pinned) {
  auto marked = withPinMark(mechanism, element, pinned);
  if (!marked || !pinned || element.kind != ElementKind::axis) return marked;
  const AxisId id(element.id);
  const Axis& axis = *mechanism.find(id);
  const Placement placement = placementOf(mechanism);
  if ((axis.point && axis.direction) || !placement.tree) return marked;
  const auto& classes = placement.classes->classes;
  const auto found = std::find_if(classes.begin(), classes.end(), [&](const AxisClasses::Class& each) {
    return mechanism.axes[static_cast<std::size_t>(each.axis)].id == id;
  });
  if (found == classes.end()) return marked;
  const ExactLine line = exactLineOfClass(mechanism, placement, static_cast<int>(found - classes.begin()));
  const auto triple = [](const ExactVector3& v) {
    return NumberTriple{Number(v[0]), Number(v[1]), Number(v[2])};
  };
  return withAxisPlaced(std::move(marked).value(), id, triple(line.point), triple(line.direction));
}

}  // namespace geargraph
