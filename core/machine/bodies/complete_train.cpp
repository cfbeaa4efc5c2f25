#include "core/machine/bodies/complete_train.h"

#include "core/machine/bodies/train_bodies.h"
#include "core/machine/solids/part_solids.h"
#include "core/machine/train/toothed_train.h"
#include "core/machine/train/train_findings.h"
#include "core/mechanism/placement/recentred.h"

namespace geargraph::inline bodies {
namespace {

/// Of larger trains the analysis does not say whether wheels and bodies find ways past each other: stacking
/// and planning them compares all with all.
constexpr std::size_t kMostPlannedWheels = 150;

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
  const GearTrain train = toothedTrain(mechanism, wheels);
  Diagnostics found = wheelDiagnostics(mechanism, placement, train, stop);
  if (!planned || stop.stop_requested()) return found;
  append(found, bodyDiagnostics(mechanism, placement, train, stop));
  append(found, placeDiagnostics(mechanism, placement, wheels, train, stop));
  return found;
}

}  // namespace

GearTrain shownTrain(const Mechanism& mechanism, const Placement& placement, BodyCache& bodies,
                     const std::stop_token& stop) {
  if (!placement.tree || !placement.classes) return {};
  const TrainWheels wheels = placedWheels(mechanism, placement, stop);
  if (stop.stop_requested()) return {};
  GearTrain train = toothedTrain(mechanism, wheels);
  addBodies(mechanism, placement, train, &bodies, stop);
  train.diagnostics.clear();
  return train;
}

GearTrain trainOf(const Mechanism& mechanism, const Placement& placement, const std::stop_token& stop) {
  if (!placement.tree || !placement.classes) return {};
  const TrainWheels wheels = placedWheels(mechanism, placement, stop);
  if (stop.stop_requested()) return {};
  GearTrain train = toothedTrain(mechanism, wheels);
  addBodies(mechanism, placement, train, nullptr, stop);
  Diagnostics findings = wheelDiagnostics(mechanism, placement, train, stop);
  append(findings, train.diagnostics);
  train.diagnostics = std::move(findings);
  append(train.diagnostics, placeDiagnostics(mechanism, placement, wheels, train, stop));
  return train;
}

Diagnostics gearDiagnostics(const Mechanism& mechanism, const Placement& placement,
                            const std::stop_token& stop) {
  if (!placement.tree || !placement.classes || stop.stop_requested()) return {};
  const std::optional<Placement> near = recentred(mechanism, placement);
  return diagnosticsOf(mechanism, near ? *near : placement, stop);
}

}  // namespace geargraph::inline bodies
