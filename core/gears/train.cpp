#include "core/gears/train.h"

#include "core/gears/bodies.h"
#include "core/gears/phase.h"
#include "core/gears/train_bodies.h"
#include "core/gears/train_findings.h"
#include "core/gears/train_wheels.h"

namespace geargraph {
namespace {

std::string nameOf(const Mechanism& mechanism, const TrainWheels& train, std::size_t w) {
  const TrainWheel& wheel = train.wheels[w];
  if (wheel.id) return wheel.id->text();
  const int mesh = wheel.meshes.front();
  for (const TrainPair& pair : train.pairs) {
    if (pair.mesh != mesh) continue;
    return std::to_string(mechanism.meshLabel(mesh)) + (pair.tail == static_cast<int>(w) ? ":tail" : ":head");
  }
  return {};
}

PhaseSolution phasesOf(const TrainWheels& train, std::vector<Eigen::Isometry3d>& frames) {
  std::vector<PhaseWheel> wheels;
  for (const TrainWheel& w : train.wheels) {
    frames.push_back(frameAlong(w.origin, w.axis));
    wheels.push_back({w.origin, w.axis, frames.back().linear().col(0), w.spec.teeth});
  }
  std::vector<PhaseMesh> meshes;
  for (const TrainPair& pair : train.pairs) meshes.push_back({pair.tail, pair.head, pair.pitchPoint});
  return solvePhases(wheels, meshes);
}

}  // namespace

GearTrain trainOf(const Mechanism& mechanism, const Placement& placement) {
  GearTrain train;
  if (!placement.tree || !placement.classes) return train;
  TrainWheels wheels = wheelsOf(mechanism, placement);
  shapeWheels(mechanism, wheels);
  stackWheels(wheels);
  std::vector<Eigen::Isometry3d> frames;
  const PhaseSolution phases = phasesOf(wheels, frames);
  for (std::size_t w = 0; w < wheels.wheels.size(); ++w) {
    TrainWheel& wheel = wheels.wheels[w];
    TrainGear gear{nameOf(mechanism, wheels, w),
                   wheel.link,
                   wheel.axisClass,
                   wheel.meshes,
                   wheel.id,
                   wheel.spec,
                   frames[w] * Eigen::AngleAxisd(phases.angles[w], Eigen::Vector3d::UnitZ())};
    train.gears.push_back(std::move(gear));
  }
  for (std::size_t p = 0; p < wheels.pairs.size(); ++p) {
    const TrainPair& pair = wheels.pairs[p];
    train.meshes.push_back({pair.mesh, pair.tail, pair.head, pair.pitchPoint, phases.residuals[p]});
  }
  addBodies(mechanism, placement, train);
  train.diagnostics = toothDiagnostics(mechanism, train);
  const Diagnostics loops = assemblyDiagnostics(mechanism, train);
  train.diagnostics.insert(train.diagnostics.end(), loops.begin(), loops.end());
  return train;
}

}  // namespace geargraph
