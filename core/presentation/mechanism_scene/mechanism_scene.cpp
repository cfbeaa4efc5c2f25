#include "core/presentation/mechanism_scene/mechanism_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/body_recipe.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/machine/solids/spec_diagnostics.h"
#include "core/machine/solids/toothless_gear.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/drawing/palette.h"
#include "core/presentation/mechanism_scene/joint_motion.h"
#include "core/presentation/mechanism_scene/joint_stops.h"
#include "core/presentation/mechanism_scene/scene_marks.h"
#include "core/theory/pose/link_twists.h"
#include "core/theory/pose/turning_lines.h"

namespace geargraph {
namespace {

constexpr int kMaxCloseMeshes = 100;
constexpr std::size_t kLevelsOfGear = 4;
constexpr double kMaxPeriod = 3600;  // s; beyond, nobody waits for it to come round

Rgb colourOf(const Mechanism& mechanism, LinkOrdinal link) {
  const Color color = linkColor(mechanism.colorNumber(link));
  return Rgb::fromHex(static_cast<unsigned>(color.red << 16 | color.green << 8 | color.blue));
}

/// Middle of a gear's teeth, in its own frame.
Eigen::Vector3d middleOf(const GearSpec& spec) {
  if (!isConical(spec)) return Eigen::Vector3d::Zero();
  return {0, 0, (coneDistance(spec) - 0.5 * spec.faceWidth) * std::cos(spec.coneAngle)};
}

/// The stage while it is built, with the link of every instance.
class SceneBuilder {
 public:
  SceneBuilder(const DerivedGeometry& geometry, GearCache& cache, const ShapeSource* shapes,
               SceneMemory* memory, const std::stop_token& stop)
      : m_geometry(geometry),
        m_mechanism(geometry.mechanism()),
        m_placement(geometry.placement()),
        m_cache(cache),
        m_shapes(shapes),
        m_memory(memory),
        m_stop(stop) {}

  /// Null when `stop` was requested meanwhile.
  std::shared_ptr<MechanismScene> build();
  [[nodiscard]] const std::vector<int>& linkOfInstance() const { return m_links; }

 private:
  Instance& add(LinkOrdinal link, const std::shared_ptr<const Solid>& solid, const Pose& pose);
  [[nodiscard]] DetailLevels& levelsOf(std::size_t solid);
  void addGear(const TrainGear& gear, std::size_t position);
  void noteToothless(const TrainGear& gear);
  void addBody(const LinkBody& body);
  void addShapes(LinkOrdinal link);
  void addLabels();

  const DerivedGeometry& m_geometry;
  const Mechanism& m_mechanism;
  const Placement& m_placement;
  GearCache& m_cache;
  const ShapeSource* m_shapes;
  SceneMemory* m_memory;
  const std::stop_token& m_stop;
  std::shared_ptr<MechanismScene> m_stage = std::make_shared<MechanismScene>();
  std::vector<int> m_links;
  std::unordered_map<const Solid*, std::size_t> m_placeOf;  ///< among the scene's solids
  std::vector<std::optional<std::size_t>> m_instanceOfGear;
  ByLink<SceneLabel> m_labelOf;  ///< radius 0: none yet
};

Instance& SceneBuilder::add(LinkOrdinal link, const std::shared_ptr<const Solid>& solid, const Pose& pose) {
  auto& solids = m_stage->scene.solids;
  const auto [known, isNew] = m_placeOf.try_emplace(solid.get(), solids.size());
  if (isNew) solids.push_back(solid);
  Instance instance;
  instance.solid = known->second;
  instance.pose = pose;
  instance.colour = colourOf(m_mechanism, link);
  instance.element = m_mechanism.links[link].id;
  m_links.push_back(link);
  return m_stage->scene.instances.emplace_back(std::move(instance));
}

/// Those of a solid: without finer ones yet, where nobody has told them.
DetailLevels& SceneBuilder::levelsOf(std::size_t solid) {
  auto& levels = m_stage->scene.levels;
  if (levels.size() <= solid) levels.resize(solid + 1);
  return levels[solid];
}

// The link's number stands beside its largest wheel. Gears that cannot be made are left out; the train's
// diagnostics say why.
void SceneBuilder::addGear(const TrainGear& gear, std::size_t position) {
  const bool isToothless = gear.spec.teeth > kMaxShownTeeth;
  const auto detail = [&](double tolerance) -> Expected<std::shared_ptr<const DeferredSolid>> {
    if (!isToothless) return m_cache.deferred(gear.spec, tolerance);
    return std::make_shared<const DeferredSolid>(
        [spec = gear.spec, tolerance] { return toothlessGear(spec, tolerance); });
  };
  if (!specDiagnostics(gear.spec).empty()) return;
  if (isToothless) noteToothless(gear);
  Instance& instance = add(gear.link, (*detail(kMaxTolerance))->solid(), gear.pose);
  if (DetailLevels& levels = levelsOf(instance.solid); levels.finer.empty()) {
    levels.unit = toothSize(gear.spec);
    levels.error = kMaxTolerance;
    std::vector<double> finer{kFarTolerance, kScreenTolerance};
    // Of a large train who sees a wheel from close by sees few of them, and all would have to be made.
    if (m_mechanism.c() <= kMaxCloseMeshes) finer.push_back(kExportTolerance);
    for (const double error : finer) levels.finer.push_back({error, *detail(error)});
  }
  m_instanceOfGear[position] = m_stage->scene.instances.size() - 1;
  for (const MeshOrdinal mesh : gear.meshes) {
    instance.also.push_back(m_mechanism.gearMeshes[mesh].id);
  }
  if (gear.wheel) instance.also.push_back(*gear.wheel);
  SceneLabel& label = m_labelOf[gear.link];
  const double radius = nominalTipRadius(gear.spec);
  if (radius <= label.radius) return;
  label.radius = radius;
  label.instance = m_stage->scene.instances.size() - 1;
  label.place = middleOf(gear.spec);
}

void SceneBuilder::noteToothless(const TrainGear& gear) {
  m_stage->notes.push_back(
      {m_mechanism.links[gear.link].id,
       translated("Gear %1 has %2 teeth, too fine to be distinguished: it is shown without "
                  "them.",
                  {gear.name, std::to_string(gear.spec.teeth)})});
}

void SceneBuilder::addBody(const LinkBody& body) {
  const bool keeps = m_memory != nullptr;
  const auto coarse = keeps ? m_memory->bodies().deferred(*body.recipe, kMaxTolerance) : body.coarse;
  const auto fine = keeps ? m_memory->bodies().deferred(*body.recipe, kBodyTolerance) : body.fine;
  const Solid& solid = *coarse->solid();
  Instance& instance = add(body.link, coarse->solid(), Pose::Identity());
  levelsOf(instance.solid) = {body.module, kMaxTolerance, {{kBodyTolerance, fine}}};
  const JointOrdinal joint = m_placement.tree->joint[body.link];
  if (joint >= 0) instance.also.push_back(m_mechanism.turningJoints[joint].id);
  SceneLabel& label = m_labelOf[body.link];
  if (label.radius > 0) return;
  const Eigen::AlignedBox3d box = boundsOf(solid);
  label.radius = 0.25 * box.diagonal().norm();
  label.instance = m_stage->scene.instances.size() - 1;
  label.place = box.center();
}

/// A file's frame in the base frame, reference pose.
Pose poseOf(const LinkShape& shape) {
  constexpr double kDegree = std::numbers::pi / 180;
  const auto triple = [](const std::optional<NumberTriple>& numbers) -> Eigen::Vector3d {
    if (!numbers) return Eigen::Vector3d::Zero();
    return {(*numbers)[0].value(), (*numbers)[1].value(), (*numbers)[2].value()};
  };
  const Eigen::Vector3d turns = kDegree * triple(shape.orientation);
  Pose pose = Pose::Identity();
  pose.translate(triple(shape.position));
  for (const int axis : {2, 1, 0}) pose.rotate(Eigen::AngleAxisd(turns[axis], Eigen::Vector3d::Unit(axis)));
  return pose;
}

void SceneBuilder::addShapes(LinkOrdinal link) {
  const Link& owner = m_mechanism.links[link];
  const std::string label = std::to_string(m_mechanism.linkLabel(link));
  for (const LinkShape& shape : owner.shapes) {
    const double scale = shape.scale ? shape.scale->value() : 1;
    const auto found = m_shapes->cache.find(m_shapes->folder, shape.file, scale, m_shapes->stop);
    if (const auto* why = std::get_if<std::string>(&found)) {
      m_stage->notes.push_back(
          {owner.id, translated("Link %1 wears \"%2\", which is not shown: %3", {label, shape.file, *why}),
           true});
      continue;
    }
    add(link, std::get<std::shared_ptr<const Solid>>(found), poseOf(shape)).isOpen = true;
  }
}

void SceneBuilder::addLabels() {
  for (LinkOrdinal link = 1; link <= m_mechanism.n(); ++link) {
    SceneLabel& label = m_labelOf[link];
    if (label.radius == 0) continue;
    label.text = std::to_string(m_mechanism.linkLabel(link));
    label.colour = colourOf(m_mechanism, link);
    label.colourNumber = m_mechanism.colorNumber(link);
    label.element = m_mechanism.links[link].id;
    m_stage->labels.push_back(std::move(label));
  }
}

std::shared_ptr<MechanismScene> SceneBuilder::build() {
  const std::shared_ptr<const GearTrain> made = m_geometry.train(m_stop);
  if (!made) return nullptr;
  const GearTrain& train = *made;
  if (train.hasSimpleBodies) {
    m_stage->notes.push_back(
        {m_mechanism.links.front().id,
         translated(
             "A train of %1 gears: its wheels are plain discs, its shafts and arms are straight and pass "
             "through what they meet (up to %2 gears they are routed past it).",
             {std::to_string(train.gears.size()), std::to_string(kMaxRoutedGears)})});
  }
  m_cache.makeRoomFor(kLevelsOfGear * train.gears.size());
  // Two details, of this edit and the one before.
  if (m_memory != nullptr) m_memory->bodies().makeRoomFor(4 * train.bodies.size());
  m_labelOf.resize(m_mechanism.links.size());
  m_instanceOfGear.resize(train.gears.size());
  for (std::size_t gear = 0; gear < train.gears.size() && !m_stop.stop_requested(); ++gear)
    addGear(train.gears[gear], gear);
  for (const LinkBody& body : train.bodies) {
    if (m_stop.stop_requested()) return nullptr;
    addBody(body);
  }
  for (LinkOrdinal link = 0; m_shapes != nullptr && link <= m_mechanism.n(); ++link) {
    if (m_stop.stop_requested()) return nullptr;
    addShapes(link);
  }
  if (m_stop.stop_requested()) return nullptr;
  addLabels();
  if (m_memory != nullptr) {
    m_memory->addFactsTo(m_stage->scene, m_stop);
  } else {
    SolidProperties().addBoxesTo(m_stage->scene, m_stop);
  }
  if (m_stop.stop_requested()) return nullptr;
  m_stage->unit = m_mechanism.unit;
  addMarks(*m_stage, {m_mechanism, m_placement, train, m_instanceOfGear, m_links});
  return m_stage;
}

/// What moves the stage; shared by the function that places it, and by its copies.
struct Mover {
  SpanningTree tree;
  ForwardKinematics kinematics;
  JointMotion motion;
  std::vector<int> linkOfInstance;
  std::vector<Pose> reference;

  void operator()(std::span<const double> inputAngles, std::span<Pose> poses) const {
    std::vector<double> angles(static_cast<std::size_t>(kinematics.jointCount()));
    motion.angles(inputAngles, angles);
    const std::vector<Pose> links = kinematics.poses(angles);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      poses[i] = links[static_cast<std::size_t>(linkOfInstance[i])] * reference[i];
    }
  }

  /// The joints' rates depend on the inputs' as their angles do.
  void twists(std::span<const double> inputAngles, std::span<const double> inputSpeeds,
              std::span<Twist3> result) const {
    std::vector<double> angles(static_cast<std::size_t>(kinematics.jointCount())), rates(angles.size());
    motion.angles(inputAngles, angles);
    motion.angles(inputSpeeds, rates);
    const std::vector<LinkTwist> links = linkTwists(tree, kinematics, kinematics.poses(angles), rates);
    for (std::size_t i = 0; i < result.size(); ++i) {
      const LinkTwist& twist = links[static_cast<std::size_t>(linkOfInstance[i])];
      result[i] = {twist.angular, twist.linear};
    }
  }
};

/// What every instance's link turns about, and how much for each input.
std::vector<SceneHandle> handlesOf(const Mover& mover, const SpanningTree& tree) {
  std::vector<SceneHandle> handles;
  const std::size_t columns = mover.motion.inputs.size();
  for (const LinkOrdinal link : mover.linkOfInstance) {
    SceneHandle& handle = handles.emplace_back();
    if (link == 0) continue;
    const JointOrdinal joint = tree.jointToParent(link);
    const double sense = -tree.directionToGround(joint);
    handle.point = mover.kinematics.line(joint).point;
    handle.direction = mover.kinematics.line(joint).direction;
    handle.slides = mover.kinematics.line(joint).kind == JointKind::sliding;
    for (std::size_t k = 0; k < columns; ++k) {
      handle.gains.push_back(sense * mover.motion.gains[static_cast<std::size_t>(joint) * columns + k]);
    }
  }
  return handles;
}

std::vector<SceneJoint> jointsOf(const Mover& mover, const Mechanism& mechanism) {
  std::vector<SceneJoint> joints(mechanism.turningJoints.size());
  const std::size_t columns = mover.motion.inputs.size();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const int position = static_cast<int>(i);
    joints[i].element = mechanism.turningJoints[i].id;
    joints[i].text = std::to_string(mechanism.jointLabel(position));
    joints[i].slides = slides(mechanism.turningJoints[i]);
    const auto first = mover.motion.gains.begin() + static_cast<std::ptrdiff_t>(i * columns);
    joints[i].gains.assign(first, first + static_cast<std::ptrdiff_t>(columns));
  }
  for (LinkOrdinal link = 1; link <= mechanism.n(); ++link)
    joints[static_cast<std::size_t>(mover.tree.jointToParent(link))].colour = colourOf(mechanism, link);
  return joints;
}

}  // namespace

SceneMemory::SceneMemory() : m_bodies(std::make_unique<BodyCache>()) {}
SceneMemory::~SceneMemory() = default;

void SceneMemory::addFactsTo(Scene& scene, const std::stop_token& stop) {
  m_properties.addBoxesTo(scene, stop);
  m_properties.addOutlinesTo(scene, stop);
  if (m_findsEdges) m_properties.addEdgesTo(scene, stop);
  m_properties.forgetOthers();
}

MechanismScenePtr mechanismScene(const AnalysisSnapshot& snapshot, GearCache& cache,
                                 const ShapeSource* shapes, SceneMemory* memory,
                                 const std::stop_token& stop) {
  const Mechanism& mechanism = *snapshot.mechanism;
  if (mechanism.n() > kMaxStageLinks || !snapshot.kinematics) return std::make_shared<const MechanismScene>();
  const Placement& placement = snapshot.kinematics->placement();
  const SpanningTree& tree = *snapshot.tree;
  SceneBuilder builder(*snapshot.geometry, cache, shapes, memory, stop);
  const std::shared_ptr<MechanismScene> stage = builder.build();
  if (!stage) return nullptr;
  const auto motion = jointMotion(snapshot, stop);
  if (stop.stop_requested()) return nullptr;
  if (!motion) return stage;
  std::vector<Pose> reference;
  for (const Instance& instance : stage->scene.instances) reference.push_back(instance.pose);
  stage->inputSpeeds = motion->speeds;
  stage->period = motion->period <= kMaxPeriod ? motion->period : 0;
  const auto mover =
      std::make_shared<const Mover>(Mover{tree, ForwardKinematics(tree, turningLines(placement)), *motion,
                                          builder.linkOfInstance(), std::move(reference)});
  addJointStops(*stage, mechanism, *motion);
  stage->handles = handlesOf(*mover, tree);
  stage->joints = jointsOf(*mover, mechanism);
  stage->place = [mover](std::span<const double> angles, std::span<Pose> poses) { (*mover)(angles, poses); };
  stage->twists = [mover](std::span<const double> angles, std::span<const double> speeds,
                          std::span<Twist3> twists) { mover->twists(angles, speeds, twists); };
  return stage;
}

}  // namespace geargraph
