#include "core/mechanism/geometry_edits/module_fit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/foundations/base/translation.h"
#include "core/mechanism/geometry_edits/axis_fit.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/geometry_edits/fitting_guards.h"
#include "core/mechanism/geometry_edits/module_pairs.h"
#include "core/mechanism/geometry_edits/pin_rejection.h"
#include "core/mechanism/geometry_edits/written_numbers.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/placement/pitch_point.h"

namespace geargraph {
namespace {

const MeshGeometry& geometryOf(const Placement& placement, MeshOrdinal mesh) {
  return *placement.meshes[mesh];
}

/// The pitch point of a bevel mesh, `factor` times as far from the apex.
NumberTriple grownPoint(const Mechanism& mechanism, const Placement& placement, MeshOrdinal mesh,
                        const Rational& factor) {
  const MeshGeometry& geometry = geometryOf(placement, mesh);
  const ExactLine tail = exactLineOfClass(mechanism, placement, geometry.tailClass);
  const ExactLine head = exactLineOfClass(mechanism, placement, geometry.headClass);
  const auto exact = exactPitchPoint(mechanism, placement, mesh);
  if (exact) {
    const ExactVector3 apex =
        apexOf(GearPair<Rational>{tail.point, tail.direction, head.point, head.direction, 1, 1});
    return numbersOf(apex + factor * (*exact - apex));
  }
  const Vector3 apex = apexOf(GearPair<double>{toDoubles(tail.point), toDoubles(tail.direction),
                                               toDoubles(head.point), toDoubles(head.direction), 1, 1});
  const Vector3 point = apex + factor.toDouble() * (geometry.pitchPoint - apex);
  return {Number::fromDouble(point[0]), Number::fromDouble(point[1]), Number::fromDouble(point[2])};
}

/// Open axes have the program's module, so both of a mesh are stated where they lie.
void stateAxes(Mechanism& edited, const Placement& placement, const MeshGeometry& mesh) {
  for (const AxisGroupOrdinal axisGroup : {mesh.tailClass, mesh.headClass}) {
    const AxisOrdinal axis = placement.classes->classes[axisGroup].axis;
    Axis& stated = edited.axes[axis];
    if (!stated.point) stated.point = numbersOf(exactLineOfClass(edited, placement, axisGroup).point);
  }
}

Diagnostic rejection(MeshId mesh, std::string why) {
  return {Code::teethGeometry, std::move(why), {mesh}, {}, 0, 0};
}

}  // namespace

std::optional<double> moduleOf(const Mechanism& mechanism, const Placement& placement, MeshOrdinal mesh) {
  const auto& geometry = placement.meshes[mesh];
  if (!geometry) return std::nullopt;
  const GearMesh& element = mechanism.gearMeshes[mesh];
  if (element.module) return element.module->value();
  if (pairKind(geometry->kind).isThreaded || pairKind(geometry->kind).isOffset) {
    // Of a worm the axial one, which is the transverse one of the wheel; of a hypoid that of the larger gear.
    const bool isTailWheel = element.tailTeeth > element.headTeeth;
    return 2 * (isTailWheel ? geometry->tailPitchRadius() : geometry->headPitchRadius()) /
           std::max(element.tailTeeth, element.headTeeth);
  }
  const double share = hasParallelAxes(geometry->kind) ? std::cos(geometry->tailHelix) : 1;
  return 2 * std::abs(geometry->tailRadius) / element.tailTeeth * share;
}

Expected<PlacedMechanism> withModule(const PlacedMechanism& before, MeshId mesh, const Rational& module) {
  const Mechanism& mechanism = before.mechanism();
  const GearMesh* found = mechanism.find(mesh);
  if (found == nullptr) return unplaced(withPitchPoint(mechanism, mesh, std::nullopt));  // rejects unknown-id
  if (module <= 0)
    return rejection(mesh, translated("A module is more than 0: the pitch diameter over the teeth."));
  const Placement& placement = before.placement();
  if (!canBeFitted(placement))
    return rejection(mesh,
                     translated("Modules can be set where every mesh has its place, in trains of up to %1 "
                                "meshes. Resolve the reported problems first.",
                                {std::to_string(kMaxFittedMeshes)}));
  const int position = static_cast<int>(found - mechanism.gearMeshes.data());
  if (!touches(geometryOf(placement, position).kind))
    return rejection(mesh, translated("A belt and pins have no module: state a pitch or running diameters."));
  const Rational factor = module / plainDecimal(*moduleOf(mechanism, placement, position));
  const std::vector<int> along =
      meshesOfOneModule(mechanism, placement, [position](int each) { return each == position; });
  Mechanism edited = mechanism;
  for (const int each : along) {
    std::optional<Number>& stated = edited.gearMeshes[each].module;
    if (stated) stated = Number(factor * stated->exact());
  }
  if (hasSkewAxes(geometryOf(placement, position).kind)) {
    edited.gearMeshes[position].module = Number(module);
    edited.gearMeshes[position].pitchPoint.reset();
    return unlessBroken(before, std::move(edited));
  }
  if (!hasParallelAxes(geometryOf(placement, position).kind)) {
    for (const int each : along)
      edited.gearMeshes[each].pitchPoint = grownPoint(mechanism, placement, each, factor);
    return unlessBroken(before, std::move(edited));
  }
  std::map<AxisPair, Rational> scales;
  for (const int each : along) {
    scales[axisPairOf(geometryOf(placement, each))] = factor;
    stateAxes(edited, placement, geometryOf(placement, each));
  }
  return unlessBroken(before, fitAxes(mechanism, placement, std::move(edited), scales));
}

}  // namespace geargraph
