#include "core/mechanism/geometry_edits/mesh_snap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "core/mechanism/geometry_edits/axis_fit.h"
#include "core/mechanism/geometry_edits/fitting_guards.h"
#include "core/mechanism/geometry_edits/written_numbers.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {
namespace {

/// One gear of a mesh.
struct SnapSide {
  LinkOrdinal link = 0;
  AxisGroupOrdinal axisGroup = 0;
  int teeth = 0;
  double radius = 0;
};

std::array<SnapSide, 2> sidesOf(const Mechanism& mechanism, const Placement& placement, MeshOrdinal mesh) {
  const MeshGeometry& geometry = *placement.meshes[mesh];
  const GearMesh& element = mechanism.gearMeshes[mesh];
  return {SnapSide{geometry.tail, geometry.tailClass, element.tailTeeth, geometry.tailPitchRadius()},
          SnapSide{geometry.head, geometry.headClass, element.headTeeth, geometry.headPitchRadius()}};
}

bool hasDistance(const Placement& placement, MeshOrdinal mesh) {
  return hasParallelAxes(placement.meshes[mesh]->kind);
}

/// The module that a gear of the mesh has in the others.
std::optional<double> moduleElsewhere(const Mechanism& mechanism, const Placement& placement,
                                      MeshOrdinal mesh, const SnapSide& wheel) {
  for (MeshOrdinal other = 0; other < mechanism.c(); ++other) {
    if (other == mesh || !hasDistance(placement, other)) continue;
    for (const SnapSide& side : sidesOf(mechanism, placement, other)) {
      if (side.link == wheel.link && side.axisGroup == wheel.axisGroup && side.teeth == wheel.teeth)
        return 2 * side.radius / side.teeth;
    }
  }
  return std::nullopt;
}

bool holdsOther(const Mechanism& mechanism, const Placement& placement, MeshOrdinal mesh, AxisGroupOrdinal a,
                AxisGroupOrdinal b) {
  for (MeshOrdinal other = 0; other < mechanism.c(); ++other) {
    const auto [tail, head] = sidesOf(mechanism, placement, other);
    if (other != mesh && std::minmax(tail.axisGroup, head.axisGroup) == std::minmax(a, b)) return true;
  }
  return false;
}

/// By how much the distance of the axes has to grow; nothing where it is right, or nothing says what is.
std::optional<Rational> growthOf(const Mechanism& mechanism, const Placement& placement, MeshOrdinal mesh) {
  const auto [tail, head] = sidesOf(mechanism, placement, mesh);
  if (!hasDistance(placement, mesh) || placement.lineOfClass(tail.axisGroup).automatic ||
      placement.lineOfClass(head.axisGroup).automatic) {
    return std::nullopt;
  }
  if (holdsOther(mechanism, placement, mesh, tail.axisGroup, head.axisGroup)) return std::nullopt;
  const auto ofTail = moduleElsewhere(mechanism, placement, mesh, tail);
  const auto ofHead = moduleElsewhere(mechanism, placement, mesh, head);
  if (!ofTail && !ofHead) return std::nullopt;
  const double module = ofTail.value_or(ofHead.value_or(1));
  if (ofHead && std::abs(*ofHead - module) > kGeometryFits * module) return std::nullopt;
  const MeshKind kind = placement.meshes[mesh]->kind;
  const double now = pairKind(kind).distance(tail.radius, head.radius);
  const double wanted = module * distanceTeeth(kind, tail.teeth, head.teeth) / 2;
  if (std::abs(now - wanted) <= kGeometryFits * wanted) return std::nullopt;
  return plainDecimal(wanted) / plainDecimal(now);
}

}  // namespace

Expected<PlacedMechanism> withMeshSnapped(const PlacedMechanism& before, MeshId mesh) {
  const Mechanism& mechanism = before.mechanism();
  const auto found = std::find_if(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(),
                                  [mesh](const GearMesh& each) { return each.id == mesh; });
  if (found == mechanism.gearMeshes.end()) return before;
  const int position = static_cast<int>(found - mechanism.gearMeshes.begin());
  const Placement& placement = before.placement();
  if (!canBeFitted(placement)) return before;
  const auto growth = growthOf(mechanism, placement, position);
  if (!growth) return before;
  const MeshGeometry& geometry = *placement.meshes[position];
  const std::map<AxisPair, Rational> scales{{std::minmax(geometry.tailClass, geometry.headClass), *growth}};
  const auto moved = [&](int held) {
    return unlessBroken(before, fitAxes(mechanism, placement, mechanism, scales,
                                        {{held, exactLineOfClass(mechanism, placement, held).point}}));
  };
  Expected<PlacedMechanism> snapped = moved(geometry.tailClass);
  if (snapped) return snapped;
  Expected<PlacedMechanism> other = moved(geometry.headClass);
  return other ? other : snapped;
}

}  // namespace geargraph
