#include "core/fitting/fitted_edits.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/fitting/axis_fit.h"
#include "core/fitting/teeth_fit.h"
#include "core/mechanism/edits.h"

namespace geargraph {
namespace {

bool hasGeometry(const Placement& placement) {
  if (placement.meshes.size() > kMostFittedMeshes) return false;
  return placement.tree && std::all_of(placement.meshes.begin(), placement.meshes.end(),
                                       [](const auto& mesh) { return mesh.has_value(); });
}

int positionOf(const Mechanism& mechanism, MeshId mesh) {
  const auto found = std::find_if(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(),
                                  [mesh](const GearMesh& each) { return each.id == mesh; });
  return found == mechanism.gearMeshes.end() ? -1 : static_cast<int>(found - mechanism.gearMeshes.begin());
}

/// The edited document, unless the edit broke a geometry that was sound.
Expected<Mechanism> unlessBroken(Expected<Mechanism> edited) {
  if (!edited) return edited;
  Diagnostics broken;
  for (Diagnostic& diagnostic : placementOf(*edited).diagnostics) {
    if (diagnostic.severity() == Severity::error) broken.push_back(std::move(diagnostic));
  }
  if (!broken.empty()) return broken;
  return edited;
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

/// Pairs of axes whose wheels are those of one, step by step: their modules are one.
std::set<AxisPair> pairsOfOneModule(const Mechanism& mechanism, const Placement& placement, int axisClass) {
  const WheelMap wheels(mechanism, placement);
  std::set<AxisPair> pairs;
  std::set<int> reached;
  const auto isParallel = [&](int mesh) {
    return placement.meshes[static_cast<std::size_t>(mesh)]->kind != MeshKind::bevel;
  };
  for (bool grows = true; grows;) {
    grows = false;
    for (int mesh = 0; mesh < mechanism.c(); ++mesh) {
      if (!isParallel(mesh)) continue;
      const MeshGeometry& geometry = *placement.meshes[static_cast<std::size_t>(mesh)];
      const AxisPair pair = axisPairOf(geometry);
      const bool touches = geometry.tailClass == axisClass || geometry.headClass == axisClass ||
                           pairs.contains(pair) || reached.contains(wheels.wheelOf(2 * mesh)) ||
                           reached.contains(wheels.wheelOf(2 * mesh + 1));
      if (!touches) continue;
      grows = pairs.insert(pair).second || grows;
      grows = reached.insert(wheels.wheelOf(2 * mesh)).second || grows;
      grows = reached.insert(wheels.wheelOf(2 * mesh + 1)).second || grows;
    }
  }
  return pairs;
}

struct MovedAxis {
  int axisClass = -1;
  int neighbour = -1;  ///< the class that it meshes with, nearest the ground
};

MovedAxis movedAxis(const Mechanism& mechanism, const Placement& placement, AxisId axis) {
  MovedAxis moved;
  const auto& classes = placement.classes->classes;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    if (mechanism.axes[static_cast<std::size_t>(classes[c].axis)].id == axis)
      moved.axisClass = static_cast<int>(c);
  }
  for (const auto& mesh : placement.meshes) {
    if (mesh->kind == MeshKind::bevel) continue;
    if (mesh->tailClass != moved.axisClass && mesh->headClass != moved.axisClass) continue;
    const int other = mesh->tailClass == moved.axisClass ? mesh->headClass : mesh->tailClass;
    const auto depth = [&](int c) { return classes[static_cast<std::size_t>(c)].depth; };
    if (moved.neighbour < 0 || depth(other) < depth(moved.neighbour)) moved.neighbour = other;
  }
  return moved;
}

double distanceFrom(const Placement& placement, int axisClass, const Vector3& point) {
  const AxisLine& line = placement.lineOfClass(axisClass);
  return length(cross(line.direction, point - line.point));
}

Vector3 valuesOf(const NumberTriple& triple) {
  return {triple[0].value(), triple[1].value(), triple[2].value()};
}

}  // namespace

Expected<Mechanism> withTeethFitted(Mechanism mechanism, MeshId mesh, int tailTeeth, int headTeeth) {
  auto plain = withTeeth(mechanism, mesh, tailTeeth, headTeeth);
  if (!plain) return plain;
  const Placement placement = placementOf(mechanism);
  if (!hasGeometry(placement)) return plain;
  const int position = positionOf(mechanism, mesh);
  const MeshKind kind = placement.meshes[static_cast<std::size_t>(position)]->kind;
  return fitted(mechanism, placement, {position, tailTeeth, headTeeth, kind});
}

Expected<Mechanism> withKindFitted(Mechanism mechanism, MeshId mesh, MeshKind kind) {
  auto plain = withMeshKind(mechanism, mesh, kind);
  if (!plain) return plain;
  const Placement placement = placementOf(mechanism);
  if (!hasGeometry(placement)) return plain;
  const int position = positionOf(mechanism, mesh);
  const MeshKind was = placement.meshes[static_cast<std::size_t>(position)]->kind;
  if (was == kind || (was == MeshKind::bevel) != (kind == MeshKind::bevel))
    return unlessBroken(std::move(plain));
  const GearMesh& element = mechanism.gearMeshes[static_cast<std::size_t>(position)];
  return fitted(mechanism, placement, {position, element.tailTeeth, element.headTeeth, kind});
}

Expected<Mechanism> withAxisMoved(Mechanism mechanism, AxisId axis, const NumberTriple& point) {
  const Axis* found = mechanism.find(axis);
  auto plain = withAxisPlaced(mechanism, axis, point, found == nullptr ? std::nullopt : found->direction);
  if (!plain) return plain;
  const Placement placement = placementOf(mechanism);
  if (!hasGeometry(placement)) return plain;
  const MovedAxis moved = movedAxis(mechanism, placement, axis);
  if (moved.neighbour < 0) return unlessBroken(std::move(plain));
  const double was = distanceFrom(placement, moved.neighbour, placement.lineOfClass(moved.axisClass).point);
  const double now = distanceFrom(placement, moved.neighbour, valuesOf(point));
  if (now < 1e-9 * was) {
    return Diagnostic{Code::pitchPointOnAxis,
                      "The axis would coincide with the one that its wheels mesh with.",
                      {axis},
                      {},
                      0,
                      0};
  }
  std::map<AxisPair, Rational> scales;
  const Rational factor = Rational::fromDouble(now / was);
  for (const AxisPair& pair : pairsOfOneModule(mechanism, placement, moved.axisClass)) scales[pair] = factor;
  const std::map<int, ExactVector3> pinned{
      {moved.axisClass, {point[0].exact(), point[1].exact(), point[2].exact()}}};
  Mechanism edited = mechanism;
  const auto stated =
      std::find_if(edited.axes.begin(), edited.axes.end(), [&](const Axis& a) { return a.id == axis; });
  if (!stated->point) {
    const ExactVector3 chosen = exactLineOfClass(mechanism, placement, moved.axisClass).point;
    stated->point = NumberTriple{Number(chosen[0]), Number(chosen[1]), Number(chosen[2])};
  }
  return unlessBroken(fitAxes(mechanism, placement, std::move(edited), scales, pinned));
}

std::vector<TeethOffer> teethNear(const Mechanism& mechanism, AxisId axis, const NumberTriple& point,
                                  std::size_t most) {
  std::vector<TeethOffer> offers;
  const Placement placement = placementOf(mechanism);
  if (mechanism.find(axis) == nullptr || !hasGeometry(placement)) return offers;
  const MovedAxis moved = movedAxis(mechanism, placement, axis);
  if (moved.neighbour < 0) return offers;
  const double wanted = distanceFrom(placement, moved.neighbour, valuesOf(point));
  const double was = distanceFrom(placement, moved.neighbour, placement.lineOfClass(moved.axisClass).point);
  for (std::size_t m = 0; m < placement.meshes.size(); ++m) {
    const MeshGeometry& geometry = *placement.meshes[m];
    if (geometry.kind != MeshKind::external) continue;
    if (axisPairOf(geometry) !=
        AxisPair(std::min(moved.axisClass, moved.neighbour), std::max(moved.axisClass, moved.neighbour)))
      continue;
    const GearMesh& mesh = mechanism.gearMeshes[m];
    const double toothReach = was / (mesh.tailTeeth + mesh.headTeeth);
    const bool tailMoves = geometry.tailClass == moved.axisClass;
    const int kept = tailMoves ? mesh.headTeeth : mesh.tailTeeth;
    const int nearest = static_cast<int>(std::lround(wanted / toothReach)) - kept;
    for (int teeth = nearest - 2; teeth <= nearest + 2; ++teeth) {
      if (teeth < kFewestTeeth || teeth > kMostTeeth) continue;
      offers.push_back(
          {mesh.id, tailMoves ? teeth : kept, tailMoves ? kept : teeth, toothReach * (kept + teeth)});
    }
  }
  std::stable_sort(offers.begin(), offers.end(), [wanted](const TeethOffer& a, const TeethOffer& b) {
    return std::abs(a.distance - wanted) < std::abs(b.distance - wanted);
  });
  if (offers.size() > most) offers.resize(most);
  return offers;
}

}  // namespace geargraph
