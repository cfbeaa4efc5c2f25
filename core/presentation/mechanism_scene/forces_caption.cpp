#include "core/presentation/mechanism_scene/forces_caption.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/foundations/base/position_index.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxNamed = 8;

/// The labels of what is shared in unknown parts.
struct SharedForces {
  std::vector<std::string> meshes;
  std::vector<std::string> joints;
};

SharedForces sharedOf(const Mechanism& mechanism, const StaticsReport& report) {
  SharedForces shared;
  for (std::size_t mesh = 0; mesh < report.forces.meshes.size(); ++mesh) {
    const int position = static_cast<int>(mesh);
    if (!report.forces.meshes[mesh].isDetermined || !report.solution().isDetermined(position))
      shared.meshes.push_back(std::to_string(mechanism.meshLabel(position)));
  }
  for (std::size_t joint = 0; joint < report.forces.bearings.size(); ++joint)
    if (!report.forces.bearings[joint].isDetermined)
      shared.joints.push_back(std::to_string(mechanism.jointLabel(static_cast<int>(joint))));
  return shared;
}

std::string sharedText(const SharedForces& shared) {
  const std::string meshes = listed(shared.meshes, kMaxNamed);
  const std::string joints = listed(shared.joints, kMaxNamed);
  if (shared.joints.empty())
    return translated(
        "Not drawn, as shared in unknown parts: forces at meshes %1. Choose Share by stiffness in Forces to "
        "find them.",
        {meshes});
  if (shared.meshes.empty())
    return translated(
        "Not drawn, as shared in unknown parts: reactions in joints %1. Choose Share by stiffness in Forces "
        "to find them.",
        {joints});
  return translated(
      "Not drawn, as shared in unknown parts: forces at meshes %1, reactions in joints %2. Choose Share by "
      "stiffness in Forces to find them.",
      {meshes, joints});
}

std::string withUnit(double size, const char* unit) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%s%.4g %s", size < 0 ? "\xE2\x88\x92" : "", std::abs(size), unit);
  return text.data();
}

std::string loadText(const Mechanism& mechanism, const Load& load) {
  const auto onLink = [&](LinkId link, const std::string& what) {
    const int position = PositionIndex<LinkTag>(mechanism.links).at(link);
    return translated("link %1: %2", {std::to_string(mechanism.linkLabel(position)), what});
  };
  if (const auto* torque = std::get_if<JointTorque>(&load.action)) {
    const int position = PositionIndex<JointTag>(mechanism.turningJoints).at(torque->joint);
    return translated("joint %1: %2", {std::to_string(mechanism.jointLabel(position)),
                                       withUnit(torque->torque.exact().toDouble(), "N m")});
  }
  if (const auto* torque = std::get_if<LinkTorque>(&load.action))
    return onLink(torque->link, withUnit(torque->torque.exact().toDouble(), "N m"));
  const auto& force = std::get<LinkForce>(load.action);
  double square = 0;
  for (const Number& component : force.force) square += std::pow(component.exact().toDouble(), 2);
  return onLink(force.link, withUnit(std::sqrt(square), "N"));
}

}  // namespace

std::string forcesCaption(const Mechanism& mechanism, const StaticsReport* report) {
  if (report == nullptr || !report->problem.hasLoads())
    return translated("No forces without loads: add one in Forces.");
  if (!report->isSolved || !report->lossless.isBalanced())
    return translated("No forces: the loads are not in balance. Forces names what is missing.");
  if (!report->isAnswered())
    return translated("No forces: with these losses no torques are known. Forces tells why.");
  if (report->forces.bearings.empty()) return translated("Forces need a unit of length whose size is known.");
  const SharedForces shared = sharedOf(mechanism, *report);
  if (!shared.meshes.empty() || !shared.joints.empty()) return sharedText(shared);
  if (report->isShared) return translated("Shared by equal stiffness of all teeth: an assumption.");
  return {};
}

std::string loadsCaption(const Mechanism& mechanism, const StaticsReport* report) {
  if (report == nullptr || report->loads.empty()) return {};
  std::vector<std::string> texts;
  for (const LoadReport& load : report->loads) texts.push_back(loadText(mechanism, load.load));
  return translated("Loads: %1.", {listed(texts, kMaxNamed)});
}

}  // namespace geargraph
