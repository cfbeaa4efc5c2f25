#include "core/machine/body_layout/complete_train.h"

#include <utility>

#include "core/machine/body_layout/body_recipe.h"
#include "core/machine/body_layout/train_bodies.h"
#include "core/machine/train/toothed_train.h"
#include "core/mechanism/placement/recentred.h"

namespace geargraph {

AssembledTrain assembledTrain(const Mechanism& mechanism, const Placement& placement, TrainWheels wheels,
                              const std::stop_token& stop) {
  AssembledTrain assembled;
  if (!placement.tree || !placement.classes) return assembled;
  if (wheels.wheels.size() <= kMaxRoutedGears) shortenFaces(wheels, placement, stop);
  if (stop.stop_requested()) return assembled;
  assembled.train = toothedTrain(mechanism, wheels);
  assembled.wheels = std::move(wheels);
  assembled.arrangement = addBodies(mechanism, placement, assembled.train, stop);
  // Bodies are planned about axes of rotation: beside a slide they would not hold what they seem to hold.
  if (hasSlides(mechanism)) assembled.train.bodies.clear();
  return assembled;
}

Diagnostics diagnosticsOf(const Mechanism& mechanism, const Placement& placement,
                          const AssembledTrain& assembled, const std::stop_token& stop) {
  Diagnostics found = wheelDiagnostics(mechanism, placement, assembled.train, stop);
  if (stop.stop_requested() || assembled.train.gears.empty() || hasSlides(mechanism)) return found;
  append(found, bodyDiagnostics(mechanism, assembled.train));
  append(found, placeDiagnostics(mechanism, placement, assembled.wheels, assembled.train, stop));
  return found;
}

TrainWheels moved(TrainWheels wheels, const Eigen::Vector3d& by) {
  for (TrainWheel& wheel : wheels.wheels) wheel.origin += by;
  for (TrainPair& pair : wheels.pairs) pair.pitchPoint += by;
  return wheels;
}

GearTrain moved(const GearTrain& train, const Eigen::Vector3d& by) {
  GearTrain result = train;
  for (TrainGear& gear : result.gears) gear.pose.pretranslate(by);
  for (TrainMesh& mesh : result.meshes) mesh.pitchPoint += by;
  for (LinkBody& body : result.bodies) {
    BodyRecipe recipe = *body.recipe;
    for (BodyPart& part : recipe) part.placed.pretranslate(by);
    body = bodyOf(body.link, std::move(recipe));
  }
  return result;
}

Arrangement moved(Arrangement arrangement, const Eigen::Vector3d& by) {
  for (AxisLayout& axis : arrangement.axes) axis.point += by;
  for (FrameBar& bar : arrangement.frame.bars) {
    bar.from += by;
    bar.to += by;
  }
  for (FramePlan::Foot& foot : arrangement.frame.feet) foot.place += by.head<2>();
  arrangement.frame.top += by.z();
  return arrangement;
}

GearTrain trainOf(const Mechanism& mechanism, const Placement& placement, const std::stop_token& stop) {
  const std::optional<Recentred> elsewhere = recentred(mechanism, placement);
  const Placement& near = elsewhere ? elsewhere->placement : placement;
  TrainWheels wheels = shapedWheels(mechanism, near, stop);
  stackWheels(wheels, near, stop);
  AssembledTrain assembled = assembledTrain(mechanism, near, std::move(wheels), stop);
  return elsewhere ? moved(assembled.train, wide(elsewhere->origin)) : std::move(assembled.train);
}

Diagnostics trainDiagnostics(const Mechanism& mechanism, const Placement& placement,
                             const std::stop_token& stop) {
  const std::optional<Recentred> elsewhere = recentred(mechanism, placement);
  const Placement& near = elsewhere ? elsewhere->placement : placement;
  TrainWheels wheels = shapedWheels(mechanism, near, stop);
  if (stop.stop_requested()) return {};
  if (wheels.wheels.size() > kMaxRoutedGears)
    return wheelDiagnostics(mechanism, near, toothedTrain(mechanism, wheels), stop);
  stackWheels(wheels, near, stop);
  const AssembledTrain assembled = assembledTrain(mechanism, near, std::move(wheels), stop);
  return stop.stop_requested() ? Diagnostics{} : diagnosticsOf(mechanism, near, assembled, stop);
}

}  // namespace geargraph
