#include "core/presentation/export_api/train_export.h"

#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/presentation/drawing/palette.h"
#include "core/theory/pose/joint_limits.h"

namespace geargraph {
namespace {

using Kind = ExportFailure::Kind;

std::vector<std::vector<Rational>> motionsOf(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  std::vector<std::vector<Rational>> motions;
  const MatroidAnalysis* matroid = snapshot.matroid();
  if (matroid == nullptr || !matroid->solution) return motions;
  const std::vector<int>& inputs = matroid->choice.joints;
  for (const auto& speeds : {matroid->speeds, genericSpeeds(inputs.size())}) {
    if (auto solution = solveExact(*snapshot.kinematics->model, inputs, speeds, stop)) {
      motions.push_back(std::move(solution->rates));
    }
  }
  return motions;
}

Float3 colourOfLink(int number) {
  const Color color = linkColor(number);
  constexpr float kFull = 255;
  return {static_cast<float>(color.red) / kFull, static_cast<float>(color.green) / kFull,
          static_cast<float>(color.blue) / kFull};
}

/// None where gears that fine, or any at all, are within the limit.
std::optional<ExportFailure> tooManyTriangles(const GearTrain& train, double tolerance) {
  const double triangles = expectedTriangles(train, tolerance);
  if (triangles <= static_cast<double>(kMaxTriangles)) return std::nullopt;
  return ExportFailure{Kind::triangles, translated("About %1 triangles are more than the limit of %2",
                                                   {std::to_string(static_cast<long long>(triangles)),
                                                    std::to_string(kMaxTriangles)})};
}

/// The solids of a train at the tolerance chosen, and that tolerance.
std::pair<TrainParts, double> fittingParts(const ExportTrain& from, const SolidsChoice& choice,
                                           const std::stop_token& stop) {
  std::vector<double> tolerances{choice.tolerance.value_or(kExportTolerance)};
  if (!choice.tolerance)
    tolerances.insert(tolerances.end(), {kScreenTolerance, kFarTolerance, kMaxTolerance, kCoarsestTolerance});
  std::pair<TrainParts, double> made;
  for (const double each : tolerances) {
    const bool isLast = each == tolerances.back();
    if (!isLast && expectedTriangles(from.train, each) > static_cast<double>(kMaxTriangles)) continue;
    made = {};  // before the next are made: they take most of the memory
    GearCache cache;
    made = {trainParts(from.mechanism(), from.train, cache, each, stop), each};
    std::size_t triangles = 0;
    for (const LinkPart& part : made.first.parts) triangles += part.solid->triangles.size();
    if (isLast || triangles <= kMaxTriangles || stop.stop_requested()) break;
  }
  return made;
}

/// Some seconds of a motion whose period is too long, `seconds` where they are said; `shows` says so then.
std::variant<MeshScene, MeshFileError> stretchScene(const LinkSceneSource& source, UniformMotion motion,
                                                    double seconds, std::string& shows) {
  motion.stretch = seconds > 0 ? seconds : kStretch;
  auto scene = linkScene(source, motion);
  while (std::holds_alternative<MeshFileError>(scene) && seconds <= 0 &&
         *motion.stretch > kShortestAnimation) {
    motion.stretch = *motion.stretch / 10;  // what turns so fast shows enough of it in less
    scene = linkScene(source, motion);
  }
  std::ostringstream text;
  text << *motion.stretch;
  shows +=
      ' ' + translated("The file shows the first %1 s of it, at its speed; it does not end where it began.",
                       {localizedNumber(text.str())});
  return scene;
}

/// The motion there and back between the limits of joints, if they bound it. `shows`: between which.
bool boundByLimits(const Mechanism& mechanism, UniformMotion& motion, std::string& shows) {
  std::vector<double> rates;
  for (const Rational& rate : motion.rates) rates.push_back(rate.toDouble());
  const std::vector<double> reference(rates.size(), 0);
  const MotionRange range = motionRange(angleLimits(mechanism), reference, rates);
  if (!range.isLimited()) return false;
  std::vector<std::string> ends;
  const auto boundary = [&](double time, JointOrdinal joint) -> double {
    if (joint < 0) return 0;  // open at this end: the motion turns round in the reference pose
    const double degrees = rates[static_cast<std::size_t>(joint)] * time * 180 / std::numbers::pi;
    ends.push_back(translated("joint %1 at %2°", {std::to_string(mechanism.jointLabel(joint)),
                                                  std::to_string(std::lround(degrees))}));
    return time;
  };
  const double from = boundary(range.from, range.fromJoint);
  const double to = boundary(range.to, range.toJoint);
  motion.range = {std::min(from, 0.0), std::max(to, 0.0)};
  shows = translated("The motion in the file goes there and back within the limits of joints: %1.",
                     {listed(ends, kAllNames)});
  return true;
}

/// The same between nearer times where it has too many keys.
std::variant<MeshScene, MeshFileError> narrowedScene(const LinkSceneSource& source, UniformMotion motion) {
  auto& [from, to] = *motion.range;
  from = std::max(from, -kStretch / 2);
  to = std::min(to, kStretch / 2);
  auto scene = linkScene(source, motion);
  while (std::holds_alternative<MeshFileError>(scene) && to - from > kShortestAnimation) {
    from /= 10;
    to /= 10;
    scene = linkScene(source, motion);
  }
  return scene;
}

}  // namespace

std::variant<ExportTrain, ExportFailure> exportTrain(SnapshotPtr snapshot, const std::stop_token& stop) {
  if (hasErrors(snapshot->diagnostics) || !snapshot->kinematics)
    return ExportFailure{Kind::mechanism, translated("A mechanism with errors has no gears")};
  const auto train = snapshot->geometry->train(stop);
  const auto found = snapshot->geometry->diagnostics(stop);
  if (!train || !found) return ExportFailure{Kind::stopped, translated("the gear train")};
  ExportTrain made{std::move(snapshot), *train, *found, {}};
  made.motions = motionsOf(*made.snapshot, stop);
  if (stop.stop_requested()) return ExportFailure{Kind::stopped, translated("the motion")};
  return made;
}

const TrainGear* gearNamed(const ExportTrain& from, std::string_view name) {
  for (const TrainMesh& mesh : from.train.meshes) {
    const std::string label = std::to_string(from.mechanism().meshLabel(mesh.mesh));
    if (name == label + ":tail") return &from.train.gears[static_cast<std::size_t>(mesh.tailGear)];
    if (name == label + ":head") return &from.train.gears[static_cast<std::size_t>(mesh.headGear)];
  }
  for (const TrainGear& gear : from.train.gears) {
    if (gear.name == name) return &gear;
  }
  return nullptr;
}

std::variant<TrainSolids, ExportFailure> trainSolids(const ExportTrain& from, const SolidsChoice& choice,
                                                     const std::stop_token& stop) {
  if (auto failure = tooManyTriangles(from.train, choice.tolerance.value_or(kCoarsestTolerance)))
    return *std::move(failure);
  const PlacedTrain placed = from.placed();
  auto [made, tolerance] = fittingParts(from, choice, stop);
  if (stop.stop_requested()) return ExportFailure{Kind::stopped, translated("the solids")};
  if (!made.diagnostics.empty() && !from.train.hasSimpleBodies)
    return ExportFailure{Kind::mechanism, {}, std::move(made.diagnostics)};
  if (choice.link) {
    std::erase_if(made.parts, [&](const LinkPart& part) {
      return std::to_string(from.mechanism().linkLabel(part.link)) != *choice.link;
    });
    if (made.parts.empty())
      return ExportFailure{Kind::choice, translated("There is no link \"%1\" with solids", {*choice.link})};
  }
  const LinkSceneSource source{from.mechanism(), *from.snapshot->tree, placed.kinematics, made.parts,
                               colourOfLink};
  std::optional<UniformMotion> motion;
  if (choice.moves && !from.motions.empty()) {
    motion = UniformMotion{from.motions.front(), std::nullopt};
    if (choice.seconds > 0) motion->seconds = choice.seconds;
  }
  TrainSolids solids{{}, tolerance, std::move(made.diagnostics), {}};
  const bool isBound = motion && boundByLimits(from.mechanism(), *motion, solids.shows);
  if (isBound && motion->range->first == motion->range->second) motion.reset();
  auto scene = linkScene(source, motion);
  if (const auto* error = std::get_if<MeshFileError>(&scene); error != nullptr && isBound) {
    if (choice.seconds == 0) scene = narrowedScene(source, *std::move(motion));
  } else if (error != nullptr) {
    solids.shows = error->message;
    scene = stretchScene(source, *std::move(motion), choice.seconds, solids.shows);
  }
  if (const auto* error = std::get_if<MeshFileError>(&scene)) {
    std::string message = error->message;
    if (choice.seconds > 0) {
      if (message.ends_with('.')) message.pop_back();
      return ExportFailure{Kind::limit, std::move(message)};
    }
    // The duration was not asked for, and the shortest stretch of the motion has too many keys.
    solids.shows = std::move(message) + ' ' + translated("Nothing in the file moves.");
    scene = linkScene(source, std::nullopt);
  }
  solids.scene = std::get<MeshScene>(std::move(scene));
  return solids;
}

std::variant<MeshScene, ExportFailure> gearScene(const ExportTrain& from, const std::string& name,
                                                 double tolerance) {
  const TrainGear* gear = gearNamed(from, name);
  if (gear == nullptr)
    return ExportFailure{
        Kind::choice, translated("There is no gear \"%1\"; gears are named like 15:tail, 15:head", {name})};
  GearTrain alone;
  alone.gears.push_back(*gear);
  if (auto failure = tooManyTriangles(alone, tolerance)) return *std::move(failure);
  auto solid = gearSolid(gear->spec, tolerance);
  if (!solid) return ExportFailure{Kind::mechanism, {}, solid.error()};
  const Link& link = from.mechanism().links[gear->link];
  const int label = from.mechanism().linkLabel(gear->link);
  MeshScene scene{gear->name, from.mechanism().unit, {}, {}};
  scene.materials.push_back({link.name.empty() ? "link " + std::to_string(label) : link.name,
                             colourOfLink(from.mechanism().colorNumber(gear->link))});
  MeshNode& node = scene.nodes.emplace_back();
  node.name = gear->name;
  node.solid = std::make_shared<const Solid>(*std::move(solid));
  return scene;
}

std::variant<Assembly, ExportFailure> trainAssembly(const ExportTrain& from, double tolerance,
                                                    std::size_t frames, const std::stop_token& stop) {
  if (auto failure = tooManyTriangles(from.train, tolerance)) return *std::move(failure);
  std::vector<std::vector<Rational>> motions = from.motions;
  if (motions.empty()) motions.emplace_back(static_cast<std::size_t>(from.mechanism().t()));  // all at rest
  GearCache cache;
  auto assembly = assemblyOf(from.placed(), cache, tolerance, motions, frames);
  if (stop.stop_requested()) return ExportFailure{Kind::stopped, translated("the assembly")};
  if (!assembly) return ExportFailure{Kind::mechanism, {}, assembly.error()};
  return *std::move(assembly);
}

}  // namespace geargraph
