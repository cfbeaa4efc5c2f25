#include "core/scene/train_stage.h"

#include <algorithm>
#include <cmath>

#include "core/drawing/palette.h"
#include "core/gears/gear_body.h"
#include "core/pose/forward_kinematics.h"
#include "core/scene/frame_parts.h"
#include "core/scene/joint_motion.h"

namespace geargraph {
namespace {

constexpr double kLongestPeriod = 3600;  // s; beyond, nobody waits for it to come round

Rgb colourOf(int link) {
  const Color color = linkColor(link);
  return Rgb::fromHex(static_cast<unsigned>(color.red << 16 | color.green << 8 | color.blue));
}

/// The stage while it is built, with the link of every instance.
class StageBuilder {
 public:
  StageBuilder(const Mechanism& mechanism, const Placement& placement, GearCache& cache)
      : m_mechanism(mechanism), m_placement(placement), m_cache(cache) {}

  std::shared_ptr<Stage> build();
  [[nodiscard]] const std::vector<int>& linkOfInstance() const { return m_links; }

 private:
  Instance& add(int link, std::shared_ptr<const Solid> solid, const Pose& pose);
  void addWheels(const std::vector<WheelPart>& wheels, const FrameParts& frame);
  void addFrame(FrameParts frame);
  void addLabels(const std::vector<WheelPart>& wheels, const FrameParts& frame);

  const Mechanism& m_mechanism;
  const Placement& m_placement;
  GearCache& m_cache;
  std::shared_ptr<Stage> m_stage = std::make_shared<Stage>();
  std::vector<int> m_links;
  std::vector<std::size_t> m_instanceOfWheel;  ///< by wheel; its own number of instances where it has none
};

Instance& StageBuilder::add(int link, std::shared_ptr<const Solid> solid, const Pose& pose) {
  auto& solids = m_stage->scene.solids;
  const auto known = std::find(solids.begin(), solids.end(), solid);
  Instance instance;
  instance.solid = static_cast<std::size_t>(known - solids.begin());
  if (known == solids.end()) solids.push_back(std::move(solid));
  instance.pose = pose;
  instance.colour = colourOf(link);
  instance.element = m_mechanism.links[static_cast<std::size_t>(link)].id;
  m_links.push_back(link);
  return m_stage->scene.instances.emplace_back(std::move(instance));
}

void StageBuilder::addWheels(const std::vector<WheelPart>& wheels, const FrameParts& frame) {
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    GearSpec spec = wheels[i].spec;
    spec.body = GearBody::dressed;
    if (spec.kind != GearKind::internal) {
      const double bore = 2 * frame.wheelBoreRadius[i];
      spec.bore = bore < largestBore(spec) ? bore : 0;
    }
    m_instanceOfWheel.push_back(m_stage->scene.instances.size());
    auto solid = m_cache.solid(spec, kScreenTolerance);
    if (!solid) {
      m_instanceOfWheel.back() = SIZE_MAX;
      continue;
    }
    Instance& instance = add(wheels[i].link, *std::move(solid), wheels[i].pose);
    for (const int mesh : wheels[i].meshes) {
      instance.also.push_back(m_mechanism.gearMeshes[static_cast<std::size_t>(mesh)].id);
    }
  }
}

void StageBuilder::addFrame(FrameParts frame) {
  for (LinkFrame& link : frame.links) {
    add(link.link, std::make_shared<const Solid>(std::move(link.solid)), Pose::Identity());
  }
  for (Collar& collar : frame.collars) {
    add(collar.link, std::make_shared<const Solid>(std::move(collar.solid)), Pose::Identity())
        .also.push_back(m_mechanism.turningJoints[static_cast<std::size_t>(collar.joint)].id);
  }
}

// The number stands beside the largest wheel, or at the bearing of a link that has none.
void StageBuilder::addLabels(const std::vector<WheelPart>& wheels, const FrameParts& frame) {
  const auto links = static_cast<int>(m_mechanism.links.size());
  for (int link = 1; link < links; ++link) {
    StageLabel label;
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      const double radius = nominalTipRadius(wheels[i].spec);
      if (wheels[i].link != link || m_instanceOfWheel[i] == SIZE_MAX || radius <= label.radius) continue;
      label.radius = radius;
      label.instance = m_instanceOfWheel[i];
      label.place = wheels[i].middle();
    }
    if (label.radius == 0) {
      const auto own = std::find(m_links.begin(), m_links.end(), link);
      if (own == m_links.end()) continue;
      label.instance = static_cast<std::size_t>(own - m_links.begin());
      label.place =
          frame.bearings[static_cast<std::size_t>(m_placement.tree->joint[static_cast<std::size_t>(link)])];
      label.radius = 2.5 * frame.shaftRadius;
    }
    label.text = std::to_string(m_mechanism.linkLabel(link));
    label.colour = colourOf(link);
    label.element = m_mechanism.links[static_cast<std::size_t>(link)].id;
    m_stage->labels.push_back(std::move(label));
  }
}

std::shared_ptr<Stage> StageBuilder::build() {
  const std::vector<WheelPart> wheels = wheelParts(m_mechanism, m_placement);
  FrameParts frame = frameParts(m_mechanism, m_placement, wheels);
  const FrameParts sizes{{}, {}, frame.shaftRadius, frame.wheelBoreRadius, frame.bearings};
  addFrame(std::move(frame));
  addWheels(wheels, sizes);
  addLabels(wheels, sizes);
  return m_stage;
}

/// What moves the stage; shared by the function that places it, and by its copies.
struct Mover {
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
};

std::vector<TurningLine> turningLines(const Mechanism& mechanism, const Placement& placement) {
  std::vector<TurningLine> lines;
  for (int joint = 0; joint < mechanism.t(); ++joint) {
    const int axis = placement.tree->axisOf[static_cast<std::size_t>(joint)];
    const AxisLine& line = placement.axes[static_cast<std::size_t>(axis)];
    lines.push_back({vectorOf(line.point), vectorOf(line.direction)});
  }
  return lines;
}

}  // namespace

StagePtr trainStage(const Mechanism& mechanism, GearCache& cache) {
  const auto graph = std::make_shared<const Digraph>(mechanism);
  const auto found = SpanningTree::of(*graph);
  const Placement placement = placementOf(mechanism);
  if (!found || !placement.tree) return std::make_shared<const Stage>();
  const auto tree = std::make_shared<const SpanningTree>(*found);
  StageBuilder builder(mechanism, placement, cache);
  const std::shared_ptr<Stage> stage = builder.build();
  const auto motion = jointMotion(mechanism, graph, tree, placement);
  if (!motion) return stage;
  std::vector<Pose> reference;
  for (const Instance& instance : stage->scene.instances) reference.push_back(instance.pose);
  stage->inputSpeeds = motion->speeds;
  stage->period = motion->period <= kLongestPeriod ? motion->period : 0;
  stage->place = [mover = std::make_shared<const Mover>(
                      Mover{ForwardKinematics(*tree, turningLines(mechanism, placement)), *motion,
                            builder.linkOfInstance(), std::move(reference)})](
                     std::span<const double> angles, std::span<Pose> poses) { (*mover)(angles, poses); };
  return stage;
}

}  // namespace geargraph
