#include "core/mechanism/geometry_edits/axis_drag.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/geometry_edits/axis_fit.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/geometry_edits/fitting_guards.h"
#include "core/mechanism/geometry_edits/module_pairs.h"
#include "core/mechanism/geometry_edits/pin_rejection.h"
#include "core/mechanism/geometry_edits/written_numbers.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/pins.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {
namespace {

/// Pairs of axes whose wheels are those of one, step by step: their modules are one.
std::set<AxisPair> pairsOfOneModule(const Mechanism& mechanism, const Placement& placement,
                                    AxisGroupOrdinal axisGroup) {
  std::set<AxisPair> pairs;
  for (const MeshOrdinal mesh : meshesOfOneModule(mechanism, placement, [&](int each) {
         const MeshGeometry& geometry = *placement.meshes[each];
         return hasParallelAxes(geometry.kind) &&
                (geometry.tailClass == axisGroup || geometry.headClass == axisGroup);
       })) {
    pairs.insert(axisPairOf(*placement.meshes[mesh]));
  }
  return pairs;
}

struct MovedAxis {
  AxisGroupOrdinal axisGroup = -1;
  AxisGroupOrdinal neighbour = -1;  ///< the class that it meshes with, nearest the ground
};

MovedAxis movedAxis(const Mechanism& mechanism, const Placement& placement, AxisId axis) {
  MovedAxis moved;
  const auto& classes = placement.classes->classes;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    if (mechanism.axes[classes[c].axis].id == axis) moved.axisGroup = static_cast<int>(c);
  }
  for (const auto& mesh : placement.meshes) {
    if (!hasParallelAxes(mesh->kind)) continue;
    if (mesh->tailClass != moved.axisGroup && mesh->headClass != moved.axisGroup) continue;
    const int other = mesh->tailClass == moved.axisGroup ? mesh->headClass : mesh->tailClass;
    const auto depth = [&](int c) { return classes[c].depth; };
    if (moved.neighbour < 0 || depth(other) < depth(moved.neighbour)) moved.neighbour = other;
  }
  return moved;
}

double distanceFrom(const Placement& placement, AxisGroupOrdinal axisGroup, const Vector3& point) {
  const AxisLine& line = placement.lineOfClass(axisGroup);
  return length(cross(line.direction, point - line.point));
}

Vector3 valuesOf(const NumberTriple& triple) {
  return {triple[0].value(), triple[1].value(), triple[2].value()};
}

/// A mesh whose distance is that between the moved axis and its neighbour.
bool isBetween(const MeshGeometry& geometry, const MovedAxis& moved) {
  return hasParallelAxes(geometry.kind) &&
         axisPairOf(geometry) ==
             AxisPair(std::min(moved.axisGroup, moved.neighbour), std::max(moved.axisGroup, moved.neighbour));
}

int reachOf(MeshKind kind, const GearMesh& mesh) {
  return distanceTeeth(kind, mesh.tailTeeth, mesh.headTeeth);
}

}  // namespace

Expected<PlacedMechanism> withAxisMoved(const PlacedMechanism& before, AxisId axis,
                                        const NumberTriple& point) {
  const Mechanism& mechanism = before.mechanism();
  const Axis* found = mechanism.find(axis);
  Expected<Mechanism> plain =
      withAxisPlaced(mechanism, axis, point, found == nullptr ? std::nullopt : found->direction);
  if (!plain) return plain.error();
  if (isPinned(*found)) return pinRejection(*found);
  const Placement& placement = before.placement();
  if (!canBeFitted(placement)) return unplaced(std::move(plain));
  const MovedAxis moved = movedAxis(mechanism, placement, axis);
  if (moved.neighbour < 0) return unlessBroken(before, std::move(plain));
  const double was = distanceFrom(placement, moved.neighbour, placement.lineOfClass(moved.axisGroup).point);
  const double now = distanceFrom(placement, moved.neighbour, valuesOf(point));
  if (now < 1e-9 * was) {
    return Diagnostic{Code::pitchPointOnAxis,
                      translated("The axis would coincide with the one that its wheels mesh with."),
                      {axis},
                      {},
                      0,
                      0};
  }
  std::map<AxisPair, Rational> scales;
  const Rational factor = Rational::fromDouble(now / was);
  for (const AxisPair& pair : pairsOfOneModule(mechanism, placement, moved.axisGroup)) scales[pair] = factor;
  const std::map<int, ExactVector3> pinned{
      {moved.axisGroup, {point[0].exact(), point[1].exact(), point[2].exact()}},
      {moved.neighbour, exactLineOfClass(mechanism, placement, moved.neighbour).point}};
  Mechanism edited = mechanism;
  const auto stated =
      std::find_if(edited.axes.begin(), edited.axes.end(), [&](const Axis& a) { return a.id == axis; });
  if (!stated->point) {
    stated->point = numbersOf(exactLineOfClass(mechanism, placement, moved.axisGroup).point);
  }
  return unlessBroken(before, fitAxes(mechanism, placement, std::move(edited), scales, pinned));
}

std::optional<AxisReach> axisReach(const PlacedMechanism& placed, AxisId axis) {
  const Mechanism& mechanism = placed.mechanism();
  const Placement& placement = placed.placement();
  if (mechanism.find(axis) == nullptr || !canBeFitted(placement)) return std::nullopt;
  const MovedAxis moved = movedAxis(mechanism, placement, axis);
  if (moved.neighbour < 0) return std::nullopt;
  AxisReach reach;
  reach.from = axisOfClass(mechanism, placement, moved.neighbour).id;
  const AxisLine& from = placement.lineOfClass(moved.neighbour);
  const Vector3 between = placement.lineOfClass(moved.axisGroup).point - from.point;
  const Vector3 across = between - dot(between, from.direction) * from.direction;
  reach.distance = length(across);
  reach.outward = unit(across);
  for (std::size_t m = 0; m < placement.meshes.size(); ++m) {
    if (!isBetween(*placement.meshes[m], moved)) continue;
    reach.module = 2 * reach.distance / reachOf(placement.meshes[m]->kind, mechanism.gearMeshes[m]);
    break;
  }
  return reach;
}

Expected<PlacedMechanism> withAxisReach(const PlacedMechanism& before, AxisId axis, const Rational& factor) {
  const Mechanism& mechanism = before.mechanism();
  const Placement& placement = before.placement();
  const MovedAxis moved = movedAxis(mechanism, placement, axis);
  GEARGRAPH_REQUIRE(moved.neighbour >= 0 && factor > 0);
  const ExactLine from = exactLineOfClass(mechanism, placement, moved.neighbour);
  const ExactLine line = exactLineOfClass(mechanism, placement, moved.axisGroup);
  const ExactVector3 between = line.point - from.point;
  const Rational along = dot(between, from.direction) / dot(from.direction, from.direction);
  const ExactVector3 place = line.point + (factor - Rational(1)) * (between - along * from.direction);
  return withAxisMoved(before, axis, numbersOf(place));
}

Expected<PlacedMechanism> withAxisDragged(const PlacedMechanism& before, AxisId axis, const Vector3& way,
                                          bool snapped) {
  constexpr double kLeast = 0.02;  ///< of the distance: nearer the wheels would have no room
  const Axis* const found = before.mechanism().find(axis);
  if (found == nullptr) return unplaced(withAxisPlaced(before, axis, {}, {}));
  if (const std::optional<AxisReach> reach = axisReach(before, axis)) {
    const double factor = std::max(1 + dot(way, reach->outward) / reach->distance, kLeast);
    if (!snapped) return withAxisReach(before, axis, Rational::fromDouble(factor));
    const long long steps = std::max(1LL, std::llround(factor * reach->module / kModuleStep));
    return withAxisReach(before, axis, Rational(steps, 20) / Rational::fromDouble(reach->module));
  }
  if (!found->point) return withAxisMoved(before, axis, {});
  Vector3 across = way;
  if (found->direction) {
    const Vector3 along = valuesOf(*found->direction);
    across = way - (dot(way, along) / dot(along, along)) * along;
  }
  NumberTriple place = *found->point;
  for (std::size_t i = 0; i < 3; ++i) {
    const double moved = place[i].value() + across[i];
    if (std::abs(across[i]) > 1e-9)
      place[i] = snapped ? Number(static_cast<int>(std::lround(moved))) : Number::fromDouble(moved);
  }
  return withAxisMoved(before, axis, place);
}

std::vector<TeethOffer> teethNear(const PlacedMechanism& placed, AxisId axis, double distance,
                                  std::size_t most) {
  std::vector<TeethOffer> offers;
  const Mechanism& mechanism = placed.mechanism();
  const Placement& placement = placed.placement();
  if (mechanism.find(axis) == nullptr || !canBeFitted(placement)) return offers;
  const MovedAxis moved = movedAxis(mechanism, placement, axis);
  if (moved.neighbour < 0) return offers;
  const double was = distanceFrom(placement, moved.neighbour, placement.lineOfClass(moved.axisGroup).point);
  for (std::size_t m = 0; m < placement.meshes.size(); ++m) {
    const MeshGeometry& geometry = *placement.meshes[m];
    if (!isBetween(geometry, moved)) continue;
    const GearMesh& mesh = mechanism.gearMeshes[m];
    const double perTooth = was / reachOf(geometry.kind, mesh);
    const bool tailMoves = geometry.tailClass == moved.axisGroup;
    const int kept = tailMoves ? mesh.headTeeth : mesh.tailTeeth;
    const bool isLarger = (tailMoves ? mesh.tailTeeth : mesh.headTeeth) > kept;
    const DistanceForm form = pairKind(geometry.kind).distanceForm(kept, isLarger);
    const int reach = static_cast<int>(std::lround(distance / perTooth));
    for (int other = std::max(reach - 2, 1); other <= reach + 2; ++other) {
      const int teeth = form.sign * (other - form.rest);
      if (teeth < kMinTeeth || teeth > kMaxTeeth) continue;
      offers.push_back({mesh.id, tailMoves ? teeth : kept, tailMoves ? kept : teeth, perTooth * other});
    }
  }
  std::stable_sort(offers.begin(), offers.end(), [distance](const TeethOffer& a, const TeethOffer& b) {
    return std::abs(a.distance - distance) < std::abs(b.distance - distance);
  });
  std::vector<TeethOffer> fitting;
  for (const TeethOffer& offer : offers) {
    if (fitting.size() == most) break;
    // The other meshes have a say, too: with another one as the base the distance may be another.
    const auto taken = withTeethFitted(placed, offer.mesh, offer.tailTeeth, offer.headTeeth);
    const auto reach = taken ? axisReach(*taken, axis) : std::nullopt;
    if (reach && std::abs(reach->distance - offer.distance) < kGeometryFits * distance)
      fitting.push_back(offer);
  }
  return fitting;
}

}  // namespace geargraph
