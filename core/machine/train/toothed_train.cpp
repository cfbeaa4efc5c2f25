#include "core/machine/train/toothed_train.h"

#include "core/foundations/base/translation.h"
#include "core/machine/solids/part_solids.h"
#include "core/machine/teeth/phase.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/train_diagnostics.h"

namespace geargraph {
namespace {

/// The wheels' ids in the document, else "15:tail" by the first mesh of each.
std::vector<std::string> namesOf(const Mechanism& mechanism, const TrainWheels& train) {
  std::vector<std::string> names(train.wheels.size());
  const auto name = [&](GearOrdinal w, MeshOrdinal mesh, const char* side) {
    const TrainWheel& wheel = train.wheels[static_cast<std::size_t>(w)];
    if (wheel.meshes.front() != mesh) return;
    names[static_cast<std::size_t>(w)] =
        wheel.id ? wheel.id->text() : std::to_string(mechanism.meshLabel(mesh)) + side;
  };
  for (const TrainPair& pair : train.pairs) {
    name(pair.tail, pair.mesh, ":tail");
    name(pair.head, pair.mesh, ":head");
  }
  return names;
}

PhaseSolution phasesOf(const TrainWheels& train, std::vector<Eigen::Isometry3d>& frames) {
  std::vector<PhaseWheel> wheels;
  for (const TrainWheel& w : train.wheels) {
    frames.push_back(frameAlong(w.origin, w.axis));
    wheels.push_back(phaseWheelOf(w.spec, w.origin, w.axis, frames.back().linear().col(0)));
  }
  std::vector<PhaseMesh> meshes;
  for (const TrainPair& pair : train.pairs) {
    if (touches(pair.kind)) meshes.push_back({pair.tail, pair.head, pair.pitchPoint, pair.normal});
  }
  return solvePhases(wheels, meshes);
}

/// What would separate the two, of what the document has not left open already.
std::string overlapAdvice(const Mechanism& mechanism, const TrainGear& one, const TrainGear& other) {
  bool statesPoint = false;
  bool statesFace = mechanism.gearDefaults && mechanism.gearDefaults->faceWidth;
  for (const TrainGear* gear : {&one, &other}) {
    for (const MeshOrdinal mesh : gear->meshes) {
      statesPoint = statesPoint || mechanism.gearMeshes[mesh].pitchPoint.has_value();
      statesFace = statesFace || mechanism.gearMeshes[mesh].faceWidth.has_value();
    }
  }
  const bool bevels = isConical(one.spec) && isConical(other.spec);
  if (bevels && statesFace)
    return translated("Use smaller face widths, or leave them or a pitch point open.");
  if (bevels && statesPoint) return translated("Move a pitch point on its axes, or leave it open.");
  if (statesPoint) return translated("Move the pitch point of one along its axis, or leave it open.");
  return translated(
      "No free places along their axes clear them: move an axis, change tooth counts, or state pitch "
      "points.");
}

}  // namespace

TrainWheels shapedWheels(const Mechanism& mechanism, const Placement& placement,
                         const std::stop_token& stop) {
  TrainWheels wheels = wheelsOf(mechanism, placement, stop);
  shapeWheels(mechanism, wheels, stop);
  return wheels;
}

GearTrain toothedTrain(const Mechanism& mechanism, const TrainWheels& wheels) {
  GearTrain train;
  std::vector<Eigen::Isometry3d> frames;
  const PhaseSolution phases = phasesOf(wheels, frames);
  const std::vector<std::string> names = namesOf(mechanism, wheels);
  for (const GearOrdinal w : wheels.wheels.ordinals()) {
    const TrainWheel& wheel = wheels.wheels[w];
    train.gears.push_back(
        {names[static_cast<std::size_t>(w)], wheel.link, wheel.axisGroup, wheel.meshes, wheel.id, wheel.spec,
         frames[static_cast<std::size_t>(w)] *
             Eigen::AngleAxisd(phases.angles[static_cast<std::size_t>(w)], Eigen::Vector3d::UnitZ())});
  }
  for (const TrainPair& pair : wheels.pairs) {
    if (!touches(pair.kind)) {
      train.strands.push_back({pair.mesh, pair.tail, pair.head});
      continue;
    }
    const double residual = phases.residuals[train.meshes.size()];
    train.meshes.push_back({pair.mesh, pair.tail, pair.head, pair.pitchPoint, residual});
  }
  train.conflicts = wheels.conflicts;
  return train;
}

namespace {

/// teeth-geometry of wheels that two meshes give different teeth.
Diagnostics conflictDiagnostics(const Mechanism& mechanism, const GearTrain& train) {
  Diagnostics found;
  for (const TeethConflict& conflict : train.conflicts) {
    const TrainGear& gear = train.gears[conflict.wheel];
    const std::string first = std::to_string(mechanism.meshLabel(conflict.first));
    const std::string mesh = std::to_string(mechanism.meshLabel(conflict.mesh));
    found.push_back(makeDiagnostic(
        conflict.isHelix ? Detail::helixAgainstTeeth : Detail::teethAgainstRadii,
        conflict.isHelix
            ? translated("Meshes %1 and %2 give the teeth of gear %3 different helix angles or hands. What "
                         "fits: one helix for both (a wheel and the ring round it have the same hand, two "
                         "wheels beside each other opposite ones), or two wheels with names of their own.",
                         {first, mesh, gear.name})
            : translated("Meshes %1 and %2 give gear %3 different modules. What fits: one module for both, "
                         "or two wheels with names of their own.",
                         {first, mesh, gear.name}),
        {mechanism.gearMeshes[conflict.mesh].id, mechanism.gearMeshes[conflict.first].id,
         mechanism.links[gear.link].id}));
  }
  return found;
}

}  // namespace

Diagnostics wheelDiagnostics(const Mechanism& mechanism, const Placement& placement, const GearTrain& train,
                             const std::stop_token& stop) {
  if (!placement.tree || !placement.classes) return {};
  Diagnostics found = conflictDiagnostics(mechanism, train);
  append(found, toothDiagnostics(mechanism, train, stop));
  if (stop.stop_requested()) return found;
  append(found, neighbourDiagnostics(mechanism, placement, train));
  append(found, assemblyDiagnostics(mechanism, train, stop));
  append(found, planetDiagnostics(mechanism, placement, train, stop));
  return found;
}

Diagnostics placeDiagnostics(const Mechanism& mechanism, const Placement& placement,
                             const TrainWheels& wheels, const GearTrain& train, const std::stop_token& stop) {
  Diagnostics found;
  for (const auto& [a, b] : overlappingWheels(wheels, placement, stop)) {
    const TrainGear& one = train.gears[static_cast<std::size_t>(a)];
    const TrainGear& other = train.gears[static_cast<std::size_t>(b)];
    found.push_back(
        makeDiagnostic(Detail::wheelsOverlap,
                       translated("Gears %1 and %2 overlap and do not mesh.", {one.name, other.name}) + ' ' +
                           overlapAdvice(mechanism, one, other),
                       {mechanism.links[one.link].id, mechanism.links[other.link].id}));
  }
  return found;
}

}  // namespace geargraph
