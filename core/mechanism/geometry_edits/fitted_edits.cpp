#include "core/mechanism/geometry_edits/fitted_edits.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "core/mechanism/geometry_edits/axis_fit.h"
#include "core/mechanism/geometry_edits/fitting_guards.h"
#include "core/mechanism/geometry_edits/pin_rejection.h"
#include "core/mechanism/geometry_edits/teeth_fit.h"
#include "core/mechanism/geometry_edits/written_numbers.h"
#include "core/mechanism/kinds/pair_kind.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/pins.h"

namespace geargraph {
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
  for (MeshOrdinal mesh = 0; mesh < edited.c(); ++mesh) {
    GearMesh& element = edited.gearMeshes[mesh];
    element.tailTeeth = fit->teeth[static_cast<std::size_t>(2 * mesh)];
    element.headTeeth = fit->teeth[static_cast<std::size_t>(2 * mesh + 1)];
    if (mesh == change.mesh && change.kind != placement.meshes[mesh]->kind) element.kind = change.kind;
  }
  return unlessBroken(placed, fitAxes(before, placement, std::move(edited), fit->scales));
}

/// The new centre distance of every pair of parallel axes over the old one; a pinned link whose gears would
/// get other teeth, or an internal pair with equal teeth, is an error.
Expected<std::map<AxisPair, Rational>> distancesAfter(const Mechanism& before, const Placement& placement,
                                                      const Mechanism& edited) {
  std::map<AxisPair, MeshOrdinal> bases;
  const auto rank = [&](MeshOrdinal mesh) {
    return (isPinned(before.gearMeshes[mesh]) ? 2 : 0) +
           (isBesideEachOther(placement.meshes[mesh]->kind) ? 1 : 0);
  };
  for (MeshOrdinal mesh = 0; mesh < before.c(); ++mesh) {
    const GearMesh& was = before.gearMeshes[mesh];
    const GearMesh& now = edited.gearMeshes[mesh];
    const MeshGeometry& geometry = *placement.meshes[mesh];
    if ((was.tailTeeth != now.tailTeeth && isPinned(before.links[geometry.tail])) ||
        (was.headTeeth != now.headTeeth && isPinned(before.links[geometry.head])))
      return pinRejection(before, placement, mesh);
    if (!hasParallelAxes(geometry.kind)) continue;
    if (hasRing(geometry.kind) && now.tailTeeth == now.headTeeth) return equalInternalTeeth(edited, mesh);
    const auto [base, isFirst] = bases.try_emplace(axisPairOf(geometry), mesh);
    if (!isFirst && rank(mesh) > rank(base->second)) base->second = mesh;
  }
  std::map<AxisPair, Rational> scales;
  for (const auto& [pair, mesh] : bases) {
    const MeshKind kind = placement.meshes[mesh]->kind;
    const GearMesh& was = before.gearMeshes[mesh];
    const GearMesh& now = edited.gearMeshes[mesh];
    const bool stays = isPinned(axisOfClass(before, placement, pair.first)) &&
                       isPinned(axisOfClass(before, placement, pair.second));
    scales[pair] = stays ? Rational(1)
                         : Rational(distanceTeeth(kind, now.tailTeeth, now.headTeeth),
                                    distanceTeeth(kind, was.tailTeeth, was.headTeeth));
  }
  return scales;
}

bool isSharedWheel(const Mechanism& mechanism, const Placement& placement, MeshOrdinal mesh, int other) {
  const auto wheelsOf = [&](int each) {
    const GearMesh& element = mechanism.gearMeshes[each];
    const MeshGeometry& geometry = *placement.meshes[each];
    using Wheel = std::tuple<int, int, int>;
    return std::pair(Wheel(geometry.tail, geometry.tailClass, element.tailTeeth),
                     Wheel(geometry.head, geometry.headClass, element.headTeeth));
  };
  const auto [a, b] = wheelsOf(mesh);
  const auto [c, d] = wheelsOf(other);
  return a == c || a == d || b == c || b == d;
}

bool areBetweenTheSame(const MeshGeometry& a, const MeshGeometry& b) {
  return std::minmax(a.tailClass, a.headClass) == std::minmax(b.tailClass, b.headClass);
}

/// Meshes that can only be bevels together with this one: between the same two axes, or on one of its wheels.
std::vector<int> bevelsWith(const Mechanism& mechanism, const Placement& placement, MeshOrdinal mesh) {
  std::vector<int> found{mesh};
  ByMesh<bool> isFound(placement.meshes.size(), false);
  isFound[mesh] = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const MeshGeometry& geometry = *placement.meshes[found[i]];
    for (int other = 0; other < mechanism.c(); ++other) {
      const MeshGeometry& each = *placement.meshes[other];
      if (isFound[other] || each.carrier != geometry.carrier) continue;
      if (!areBetweenTheSame(geometry, each) && !isSharedWheel(mechanism, placement, found[i], other))
        continue;
      isFound[other] = true;
      found.push_back(other);
    }
  }
  return found;
}

/// A guess gives way: what was taken for the ring round sun and planet is the second side gear, as large as
/// the sun.
void makeSideGear(GearMesh& ring, const GearMesh& sun, LinkId planet) {
  const bool sunIsTail = sun.head == planet;
  const int planetTeeth = sunIsTail ? sun.headTeeth : sun.tailTeeth;
  const int sunTeeth = sunIsTail ? sun.tailTeeth : sun.headTeeth;
  int& ringTeeth = ring.tail == planet ? ring.headTeeth : ring.tailTeeth;
  if (ringTeeth == sunTeeth + 2 * planetTeeth) ringTeeth = sunTeeth;
}

/// The mesh becomes a bevel pair of this kind, and so do those that must be with it.
Mechanism withBevels(const Mechanism& before, const Placement& placement, MeshOrdinal mesh, MeshKind kind) {
  Mechanism edited = before;
  const std::vector<int> bevels = bevelsWith(before, placement, mesh);
  for (const int each : bevels) {
    const MeshGeometry& geometry = *placement.meshes[each];
    GearMesh& element = edited.gearMeshes[each];
    if (!hasParallelAxes(geometry.kind)) continue;
    element.kind = kind;
    if (!hasRing(geometry.kind)) continue;
    for (const int other : bevels) {
      const GearMesh& sun = before.gearMeshes[other];
      const MeshGeometry& place = *placement.meshes[other];
      if (!isBesideEachOther(place.kind) || !areBetweenTheSame(geometry, place)) continue;
      for (const LinkId planet : {element.tail, element.head}) {
        if (planet == sun.tail || planet == sun.head) makeSideGear(element, sun, planet);
      }
    }
  }
  return edited;
}

/// The class of an axis, the classes of the wheels of a mesh; none where they have no place.
std::vector<AxisGroupOrdinal> classesOf(const Mechanism& mechanism, const Placement& placement,
                                        const ElementId& element) {
  if (element.kind == ElementKind::gearMesh) {
    const auto& mesh = placement.meshes[positionOf(mechanism, MeshId(element.id))];
    return mesh ? std::vector{mesh->tailClass, mesh->headClass} : std::vector<AxisGroupOrdinal>{};
  }
  for (AxisGroupOrdinal axisGroup = 0; axisGroup < static_cast<int>(placement.classes->classes.size());
       ++axisGroup) {
    if (ElementId(axisOfClass(mechanism, placement, axisGroup).id) == element) return {axisGroup};
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
  const MeshKind kind = placement.meshes[position]->kind;
  return fitted(before, {position, tailTeeth, headTeeth, kind});
}

Expected<PlacedMechanism> withAllTeethFitted(const PlacedMechanism& before,
                                             std::span<const MeshTeeth> teeth) {
  Mechanism edited = before.mechanism();
  for (const MeshTeeth& each : teeth) {
    auto next = withTeeth(std::move(edited), before.mechanism().gearMeshes[each.mesh].id, each.tailTeeth,
                          each.headTeeth);
    if (!next) return next.error();
    edited = *std::move(next);
  }
  const Placement& placement = before.placement();
  if (!canBeFitted(placement)) return unplaced(Expected<Mechanism>(std::move(edited)));
  const auto scales = distancesAfter(before.mechanism(), placement, edited);
  if (!scales) return scales.error();
  return unlessBroken(before, fitAxes(before.mechanism(), placement, std::move(edited), *scales));
}

Expected<PlacedMechanism> withKindFitted(const PlacedMechanism& before, MeshId mesh, MeshKind kind) {
  const Mechanism& mechanism = before.mechanism();
  Expected<Mechanism> plain = withMeshKind(mechanism, mesh, kind);
  if (!plain) return plain.error();
  const Placement& placement = before.placement();
  if (!canBeFitted(placement)) return unplaced(std::move(plain));
  const int position = positionOf(mechanism, mesh);
  const MeshKind was = placement.meshes[position]->kind;
  if (was != kind && hasIntersectingAxes(kind))
    return unlessBroken(before, withBevels(mechanism, placement, position, kind));
  if (was == kind || !hasParallelAxes(was) || !hasParallelAxes(kind))
    return unlessBroken(before, std::move(plain));
  const GearMesh& element = mechanism.gearMeshes[position];
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
    for (const AxisGroupOrdinal axisGroup : classesOf(mechanism, placement, element))
      classes.insert(axisGroup);
  }
  for (const AxisGroupOrdinal axisGroup : classes) {
    const Axis& axis = axisOfClass(mechanism, placement, axisGroup);
    if (axis.point && axis.direction) continue;
    const ExactLine line = exactLineOfClass(mechanism, placement, axisGroup);
    marked =
        withAxisPlaced(std::move(marked).value(), axis.id, numbersOf(line.point), numbersOf(line.direction));
    if (!marked) return marked.error();
  }
  return unplaced(std::move(marked));
}

}  // namespace geargraph
