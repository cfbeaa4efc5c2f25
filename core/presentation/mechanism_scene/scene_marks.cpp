#include "core/presentation/mechanism_scene/scene_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/machine/teeth/wheel_kind.h"
#include "core/theory/pose/turning_lines.h"

namespace geargraph {
namespace {

constexpr int kCircleSides = 96;
constexpr int kConeLines = 4;
constexpr double kBeyond = 0.12;  // of the train's radius: an axis is drawn so far beyond its parts

/// The circle about the gear's axis through a point, in the gear's frame, and of a bevel its cone's lines.
void addPitchCircle(MechanismScene& stage, std::size_t instance, const GearSpec& spec,
                    const Eigen::Vector3d& through) {
  const double radius = through.head<2>().norm();
  SceneMark circle{MarkKind::pitchCircle, instance, {}, false};
  const auto at = [&](double part) -> Eigen::Vector3d {
    const double angle = 2 * std::numbers::pi * part;
    return {radius * std::cos(angle), radius * std::sin(angle), through.z()};
  };
  for (int side = 0; side <= kCircleSides; ++side) circle.points.push_back(at(double(side) / kCircleSides));
  stage.marks.push_back(std::move(circle));
  if (!isConical(spec)) return;
  for (int k = 0; k < kConeLines; ++k) {
    stage.marks.push_back({MarkKind::pitchCircle, instance, {{0, 0, 0}, at(double(k) / kConeLines)}, false});
  }
}

void addMeshes(MechanismScene& stage, const StagedTrain& staged) {
  struct Circle {
    std::size_t instance;
    Eigen::Vector2d place;  // radius, height
  };
  std::vector<Circle> known;
  for (const TrainMesh& mesh : staged.train.meshes) {
    const auto tail = staged.instanceOfGear[static_cast<std::size_t>(mesh.tailGear)];
    const auto head = staged.instanceOfGear[static_cast<std::size_t>(mesh.headGear)];
    if (!tail || !head) continue;
    for (const int gear : {mesh.tailGear, mesh.headGear}) {
      const TrainGear& wheel = staged.train.gears[static_cast<std::size_t>(gear)];
      const std::size_t instance = *staged.instanceOfGear[static_cast<std::size_t>(gear)];
      const Eigen::Vector3d through = wheel.pose.inverse() * mesh.pitchPoint;
      const Eigen::Vector2d place(through.head<2>().norm(), through.z());
      const bool isKnown = std::any_of(known.begin(), known.end(), [&](const Circle& circle) {
        return circle.instance == instance && (circle.place - place).norm() < 1e-6 * place.norm();
      });
      if (isKnown) continue;
      known.push_back({instance, place});
      addPitchCircle(stage, instance, wheel.spec, through);
    }
    SceneContact contact{mesh.pitchPoint, std::nullopt, *tail, *head};
    const LinkOrdinal carrier = staged.placement.meshes[mesh.mesh]->carrier;
    const auto& links = staged.linkOfInstance;
    const auto carried = std::find(links.begin(), links.end(), carrier);
    if (carrier != 0 && carried != links.end()) {
      contact.carrier = static_cast<std::size_t>(carried - links.begin());
    }
    stage.contacts.push_back(contact);
  }
}

/// How far the instances of a link reach along a line, from its point.
std::optional<Eigen::Vector2d> reachOf(const MechanismScene& stage, std::span<const int> links,
                                       LinkOrdinal link, const TurningLine& line) {
  Eigen::Vector2d reach(1e300, -1e300);
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i] != link) continue;
    const Instance& instance = stage.scene.instances[i];
    const Eigen::AlignedBox3d box = stage.scene.boxOf(instance.solid);
    if (box.isEmpty()) continue;
    const Eigen::Vector3d along = instance.pose.linear().transpose() * line.direction;
    const double middle = line.direction.dot(instance.pose * box.center() - line.point);
    const double half = 0.5 * along.cwiseAbs().dot(box.sizes());
    reach = {std::min(reach[0], middle - half), std::max(reach[1], middle + half)};
  }
  return reach[0] < reach[1] ? std::optional(reach) : std::nullopt;
}

SceneLabel labelAt(LabelKind kind, const std::string& text, ElementId element, const SceneMark& axis,
                   const Eigen::Vector3d& place) {
  SceneLabel label;
  label.kind = kind;
  label.text = text;
  label.colour = Rgb::fromHex(0x6B7380);
  label.element = std::move(element);
  label.instance = axis.instance;
  label.place = place;
  return label;
}

void addAxes(MechanismScene& stage, const StagedTrain& staged) {
  const Mechanism& mechanism = staged.mechanism;
  const std::vector<TurningLine> lines = turningLines(staged.placement);
  const double beyond = kBeyond * boundsOf(stage.scene).radius();
  std::vector<bool> labelled(mechanism.axes.size(), false);
  for (std::size_t link = 1; link < mechanism.links.size(); ++link) {
    const JointOrdinal joint = staged.placement.tree->joint[link];
    const TurningLine& line = lines[static_cast<std::size_t>(joint)];
    const auto reach = reachOf(stage, staged.linkOfInstance, static_cast<int>(link), line);
    if (!reach) continue;
    const auto first = std::find(staged.linkOfInstance.begin(), staged.linkOfInstance.end(), int(link));
    SceneMark mark{MarkKind::axis, static_cast<std::size_t>(first - staged.linkOfInstance.begin()), {}, true};
    const Pose toInstance = stage.scene.instances[mark.instance].pose.inverse();
    for (const double end : {(*reach)[0] - beyond, (*reach)[1] + beyond}) {
      mark.points.push_back(toInstance * (line.point + end * line.direction));
    }
    const TurningJoint& turning = mechanism.turningJoints[joint];
    stage.labels.push_back(labelAt(LabelKind::joint, std::to_string(mechanism.jointLabel(joint)), turning.id,
                                   mark, mark.points.front()));
    const auto axis = static_cast<std::size_t>(staged.placement.tree->axisOf[joint]);
    if (!labelled[axis]) {
      const ElementId element = mechanism.axes[axis].id;
      stage.labels.push_back(labelAt(LabelKind::axis, labelOf(mechanism, element).value_or(""), element, mark,
                                     mark.points.back()));
    }
    labelled[axis] = true;
    stage.marks.push_back(std::move(mark));
  }
}

}  // namespace

void addMarks(MechanismScene& stage, const StagedTrain& staged) {
  addMeshes(stage, staged);
  addAxes(stage, staged);
}

}  // namespace geargraph
