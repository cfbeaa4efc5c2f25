#include "core/foundations/base/translation.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/geometry_edits/fitting_guards.h"
#include "core/mechanism/geometry_edits/module_fit.h"
#include "core/mechanism/geometry_edits/wheel_map.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {
namespace {

/// On the other half of the axis of one of its wheels, at the module that the mesh has.
NumberTriple mirroredPoint(const Mechanism& mechanism, const Placement& placement, int end) {
  const MeshGeometry& geometry = *placement.meshes[end / 2];
  const GearMesh& mesh = mechanism.gearMeshes[end / 2];
  const AxisLine& tail = placement.lineOfClass(geometry.tailClass);
  const AxisLine& head = placement.lineOfClass(geometry.headClass);
  const GearPair<double> pair{tail.point,     tail.direction, head.point,
                              head.direction, mesh.tailTeeth, mesh.headTeeth};
  // P - O = x u_A + y u_B; the signs of x and y are the half axes.
  const Vector3 off = geometry.pitchPoint - apexOf(pair);
  const double cosine = dot(tail.direction, head.direction);
  BevelSides sides;
  sides.tail = dot(off, tail.direction - cosine * head.direction) < 0 ? -1 : 1;
  sides.head = dot(off, head.direction - cosine * tail.direction) < 0 ? -1 : 1;
  int& flipped = isTailEnd(end) ? sides.tail : sides.head;
  flipped = -flipped;
  const Vector3 point = bevelPitchPoint(pair, sides, *moduleOf(mechanism, placement, end / 2));
  return {Number::fromDouble(point[0]), Number::fromDouble(point[1]), Number::fromDouble(point[2])};
}

}  // namespace

Expected<PlacedMechanism> withBevelSideFlipped(const PlacedMechanism& before, MeshId mesh, bool ofTail) {
  const Mechanism& mechanism = before.mechanism();
  const GearMesh* found = mechanism.find(mesh);
  if (found == nullptr) return unplaced(withPitchPoint(mechanism, mesh, std::nullopt));  // rejects unknown-id
  const int position = static_cast<int>(found - mechanism.gearMeshes.data());
  const Placement& placement = before.placement();
  const auto& geometry = placement.meshes[position];
  if (!geometry || !hasIntersectingAxes(geometry->kind)) {
    Diagnostic rejection;
    rejection.code = Code::pitchGeometry;
    rejection.detail = Detail::noBevelPair;
    rejection.message = translated("Mesh %1 is no bevel pair: only bevels have an apex with two sides.",
                                   {std::to_string(mechanism.meshLabel(position))});
    rejection.elements.emplace_back(mesh);
    return rejection;
  }
  std::vector<int> ends{2 * position + (ofTail ? 0 : 1)};
  if (canBeFitted(placement)) {
    const WheelMap wheels(mechanism, placement);
    ends = wheels.ends(wheels.wheelOf(ends.front()));
  }
  Mechanism edited = mechanism;
  std::vector<NumberTriple> points;
  for (const int end : ends) points.push_back(mirroredPoint(edited, placement, end));
  for (std::size_t i = 0; i < ends.size(); ++i) edited.gearMeshes[ends[i] / 2].pitchPoint = points[i];
  return unlessBroken(before, std::move(edited));
}

}  // namespace geargraph
