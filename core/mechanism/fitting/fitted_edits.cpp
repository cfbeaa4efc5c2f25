#include "core/mechanism/fitting/fitted_edits.h"

#include <algorithm>
#include <set>

#include "core/mechanism/fitting/axis_fit.h"
#include "core/mechanism/fitting/fitting_guards.h"
#include "core/mechanism/fitting/pin_refusal.h"
#include "core/mechanism/fitting/teeth_fit.h"
#include "core/mechanism/fitting/written_numbers.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/pins.h"

namespace geargraph::inline fitting {
namespace {

int positionOf(const Mechanism& mechanism, MeshId mesh) {
  const auto found = std::find_if(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(),
                                  [mesh](const GearMesh& each) { return each.id == mesh; });
  return found == mechanism.gearMeshes.end() ? -1 : static_cast<int>(found - mechanism.gearMeshes.begin());
}

Expected<PlacedMechanism> fitted(const PlacedMechanism& placed, const MeshChange& change) {
  const Mechanism& before = placed.mechanism();
  const Placement& placement = placed.placement();
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
  return unlessBroken(placed, fitAxes(before, placement, std::move(edited), fit->scales));
}

/// The class of an axis, the classes of the wheels of a mesh; none where they have no place.
std::vector<int> classesOf(const Mechanism& mechanism, const Placement& placement, const ElementId& element) {
  if (element.kind == ElementKind::gearMesh) {
    const auto& mesh = placement.meshes[static_cast<std::size_t>(positionOf(mechanism, MeshId(element.id)))];
    return mesh ? std::vector{mesh->tailClass, mesh->headClass} : std::vector<int>{};
  }
  for (int axisClass = 0; axisClass < static_cast<int>(placement.classes->classes.size()); ++axisClass) {
    if (ElementId(axisOfClass(mechanism, placement, axisClass).id) == element) return {axisClass};
  }
  return {};
}

}  // namespace

Expected<PlacedMechanism> withTeethFitted(const PlacedMechanism& before, MeshId mesh, int tailTeeth,
                                          int headTeeth) {
  const Mechanism& mechanism = before.mechanism();
  Expected<Mechanism> plain = withTeeth(mechanism, mesh, tailTeeth, headTeeth);
  if (!plain) return plain.error();
  const Placement& placement = before.placement();
  if (!canBeFitted(placement)) return unplaced(std::move(plain));
  const int position = positionOf(mechanism, mesh);
  const MeshKind kind = placement.meshes[static_cast<std::size_t>(position)]->kind;
  return fitted(before, {position, tailTeeth, headTeeth, kind});
}

Expected<PlacedMechanism> withKindFitted(const PlacedMechanism& before, MeshId mesh, MeshKind kind) {
  const Mechanism& mechanism = before.mechanism();
  Expected<Mechanism> plain = withMeshKind(mechanism, mesh, kind);
  if (!plain) return plain.error();
  const Placement& placement = before.placement();
  if (!canBeFitted(placement)) return unplaced(std::move(plain));
  const int position = positionOf(mechanism, mesh);
  const MeshKind was = placement.meshes[static_cast<std::size_t>(position)]->kind;
  if (was == kind || (was == MeshKind::bevel) != (kind == MeshKind::bevel))
    return unlessBroken(before, std::move(plain));
  const GearMesh& element = mechanism.gearMeshes[static_cast<std::size_t>(position)];
  return fitted(before, {position, element.tailTeeth, element.headTeeth, kind});
}

Expected<PlacedMechanism> withPinned(const PlacedMechanism& before, const ElementId& element, bool pinned) {
  return withAllPinned(before, std::span(&element, 1), pinned);
}

Expected<PlacedMechanism> withAllPinned(const PlacedMechanism& before, std::span<const ElementId> elements,
                                        bool pinned) {
  const Mechanism& mechanism = before.mechanism();
  Expected<Mechanism> marked = mechanism;
  for (const ElementId& element : elements) {
    marked = withPinMark(std::move(marked).value(), element, pinned);
    if (!marked) return marked.error();
  }
  const bool arePlaced = std::all_of(elements.begin(), elements.end(), [](const ElementId& element) {
    return element.kind == ElementKind::link;
  });
  if (!pinned || arePlaced) return unplaced(std::move(marked));
  const Placement& placement = before.placement();
  if (!placement.tree) return unplaced(std::move(marked));
  std::set<int> classes;
  for (const ElementId& element : elements) {
    if (element.kind == ElementKind::link) continue;
    for (const int axisClass : classesOf(mechanism, placement, element)) classes.insert(axisClass);
  }
  for (const int axisClass : classes) {
    const Axis& axis = axisOfClass(mechanism, placement, axisClass);
    if (axis.point && axis.direction) continue;
    const ExactLine line = exactLineOfClass(mechanism, placement, axisClass);
    marked =
        withAxisPlaced(std::move(marked).value(), axis.id, numbersOf(line.point), numbersOf(line.direction));
    if (!marked) return marked.error();
  }
  return unplaced(std::move(marked));
}

}  // namespace geargraph::inline fitting
