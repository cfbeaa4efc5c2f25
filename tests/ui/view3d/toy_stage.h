#pragma once

#include "core/presentation/gl_renderer/primitives.h"
#include "core/presentation/scene3d/stage.h"

namespace geargraph::test {

/// Two wheels on parallel shafts and a box between them, above: a stage whose every pixel can be foretold.
/// The left wheel (link 1) turns with the input, the right one (link 2) the other way; the box (link 3)
/// swings round z.
inline MechanismScenePtr toyStage(double period = 4) {
  auto stage = std::make_shared<MechanismScene>();
  const auto add = [&](Solid solid, const Eigen::Vector3d& at, unsigned colour, const char* link) {
    stage->scene.solids.push_back(std::make_shared<const Solid>(std::move(solid)));
    Instance instance;
    instance.solid = stage->scene.solids.size() - 1;
    instance.pose.translation() = at;
    instance.colour = Rgb::fromHex(colour);
    instance.element = LinkId(link);
    stage->scene.instances.push_back(instance);
    SceneLabel label;
    label.text = link;
    label.colour = instance.colour;
    label.element = instance.element;
    label.instance = stage->scene.instances.size() - 1;
    label.radius = 20;
    stage->labels.push_back(label);
  };
  add(revolvedSolid({{5, -4}, {20, -4}, {20, 4}, {5, 4}}, 24), {0, -22, 0}, 0x0072B2, "1");
  add(revolvedSolid({{5, -4}, {20, -4}, {20, 4}, {5, 4}}, 24), {0, 22, 0}, 0xD55E00, "2");
  add(boxSolid({-8, -8, -8}, {8, 8, 8}), {0, 0, 30}, 0x009E73, "3");
  stage->inputSpeeds = {1.5};
  stage->period = period;
  stage->handles.resize(3);
  for (const std::size_t wheel : {0, 1}) {
    stage->handles[wheel].point = stage->scene.instances[wheel].pose.translation();
    stage->handles[wheel].gains = {wheel == 0 ? 1.0 : -1.0};
  }
  stage->place = [reference = stage->scene.instances](std::span<const double> angles, std::span<Pose> poses) {
    const auto turned = [](double angle) { return Pose(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())); };
    poses[0] = reference[0].pose * turned(angles[0]);
    poses[1] = reference[1].pose * turned(-angles[0]);
    Pose swung = reference[2].pose;
    swung.translation() += Eigen::Vector3d(0, 10 * std::sin(angles[0]), 0);
    poses[2] = swung;
  };
  return stage;
}

}  // namespace geargraph::test
