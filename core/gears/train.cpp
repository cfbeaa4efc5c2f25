#include "core/gears/train.h"

#include "core/gears/bodies.h"
#include "core/gears/body_plan.h"
#include "core/gears/phase.h"
#include "core/gears/train_bodies.h"
#include "core/gears/train_findings.h"
#include "core/gears/train_wheels.h"
#include "core/placement/recentred.h"

namespace geargraph {
namespace {

/// Of larger trains the analysis does not say whether wheels and bodies find ways past each other: stacking
/// and planning them compares all with all.
constexpr std::size_t kMostPlannedWheels = 150;

/// The wheels' ids in the document, else "15:tail" by the first mesh of each.
std::vector<std::string> namesOf(const Mechanism& mechanism, const TrainWheels& train) {
  std::vector<std::string> names(train.wheels.size());
  const auto name = [&](int w, int mesh, const char* side) {
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

/// Wheels in their shape, each where it has room.
TrainWheels placedWheels(const Mechanism& mechanism, const Placement& placement,
                         const std::stop_token& stop) {
  TrainWheels wheels = wheelsOf(mechanism, placement, stop);
  shapeWheels(mechanism, wheels, stop);
  stackWheels(wheels, placement, stop);
  if (wheels.wheels.size() <= kMostRoutedGears) shortenFaces(wheels, placement, stop);
  return wheels;
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

/// Wheels and their meshes, each turned into the others' spaces; no bodies.
GearTrain toothed(const Mechanism& mechanism, const TrainWheels& wheels) {
  GearTrain train;
  std::vector<Eigen::Isometry3d> frames;
  const PhaseSolution phases = phasesOf(wheels, frames);
  const std::vector<std::string> names = namesOf(mechanism, wheels);
  for (std::size_t w = 0; w < wheels.wheels.size(); ++w) {
    const TrainWheel& wheel = wheels.wheels[w];
    train.gears.push_back({names[w], wheel.link, wheel.axisClass, wheel.meshes, wheel.id, wheel.spec,
                           frames[w] * Eigen::AngleAxisd(phases.angles[w], Eigen::Vector3d::UnitZ())});
  }
  for (std::size_t p = 0; p < wheels.pairs.size(); ++p) {
    const TrainPair& pair = wheels.pairs[p];
    train.meshes.push_back({pair.mesh, pair.tail, pair.head, pair.pitchPoint, phases.residuals[p]});
  }
  return train;
}

void append(Diagnostics& all, const Diagnostics& more) {
  all.insert(all.end(), more.begin(), more.end());
}

Diagnostics findingsOf(const Mechanism& mechanism, const Placement& placement, const GearTrain& train,
                       const std::stop_token& stop) {
  Diagnostics found = toothDiagnostics(mechanism, train, stop);
  if (stop.stop_requested()) return found;
  append(found, neighbourDiagnostics(mechanism, placement, train));
  append(found, assemblyDiagnostics(mechanism, train, stop));
  return found;
}

Diagnostics placeFindings(const Mechanism& mechanism, const Placement& placement, const TrainWheels& wheels,
                          const GearTrain& train, const std::stop_token& stop) {
  Diagnostics found;
  for (const auto& [a, b] : wheelsInOnePlace(wheels, placement, stop)) {
    const TrainGear& one = train.gears[static_cast<std::size_t>(a)];
    const TrainGear& other = train.gears[static_cast<std::size_t>(b)];
    const bool bevels = one.spec.kind == GearKind::bevel && other.spec.kind == GearKind::bevel;
    found.push_back(finding(Detail::wheelsOverlap,
                            "Gears " + one.name + " and " + other.name +
                                " stand in one place and do not mesh. " +
                                (bevels ? "Use smaller face widths, or leave them or a pitch point open."
                                        : "Move the pitch point of one along its axis, or leave it open."),
                            {mechanism.links[static_cast<std::size_t>(one.link)].id,
                             mechanism.links[static_cast<std::size_t>(other.link)].id}));
  }
  return found;
}

Diagnostics diagnosticsOf(const Mechanism& mechanism, const Placement& placement,
                          const std::stop_token& stop) {
  TrainWheels wheels = wheelsOf(mechanism, placement, stop);
  if (stop.stop_requested()) return {};
  shapeWheels(mechanism, wheels, stop);
  if (stop.stop_requested()) return {};
  const bool planned = wheels.wheels.size() <= kMostPlannedWheels;
  if (planned) {
    stackWheels(wheels, placement, stop);
    shortenFaces(wheels, placement, stop);
    if (stop.stop_requested()) return {};
  }
  const GearTrain train = toothed(mechanism, wheels);
  Diagnostics found = findingsOf(mechanism, placement, train, stop);
  if (!planned || stop.stop_requested()) return found;
  append(found, bodyDiagnostics(mechanism, placement, train, stop));
  append(found, placeFindings(mechanism, placement, wheels, train, stop));
  return found;
}

}  // namespace

GearTrain shownTrain(const Mechanism& mechanism, const Placement& placement, BodyCache& bodies,
                     const std::stop_token& stop) {
  if (!placement.tree || !placement.classes) return {};
  const TrainWheels wheels = placedWheels(mechanism, placement, stop);
  if (stop.stop_requested()) return {};
  GearTrain train = toothed(mechanism, wheels);
  addBodies(mechanism, placement, train, &bodies, stop);
  train.diagnostics.clear();
  return train;
}

GearTrain trainOf(const Mechanism& mechanism, const Placement& placement, const std::stop_token& stop) {
  if (!placement.tree || !placement.classes) return {};
  const TrainWheels wheels = placedWheels(mechanism, placement, stop);
  if (stop.stop_requested()) return {};
  GearTrain train = toothed(mechanism, wheels);
  addBodies(mechanism, placement, train, nullptr, stop);
  Diagnostics findings = findingsOf(mechanism, placement, train, stop);
  append(findings, train.diagnostics);
  train.diagnostics = std::move(findings);
  append(train.diagnostics, placeFindings(mechanism, placement, wheels, train, stop));
  return train;
}

Diagnostics gearDiagnostics(const Mechanism& mechanism, const Placement& placement,
                            const std::stop_token& stop) {
  if (!placement.tree || !placement.classes || stop.stop_requested()) return {};
  const std::optional<Placement> near = recentred(mechanism, placement);
  return diagnosticsOf(mechanism, near ? *near : placement, stop);
}

}  // namespace geargraph
