#include "core/presentation/mechanism_scene/train_forces.h"

#include <array>
#include <cstdio>

#include "core/foundations/base/position_index.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

Eigen::Vector3d vectorOf(const Vector3& vector) {
  return {vector[0], vector[1], vector[2]};
}

/// "443 N", in kN from 10 kN on.
std::string textOf(double force) {
  std::array<char, 64> text{};
  const bool isLarge = force >= 9999.5;
  std::snprintf(text.data(), text.size(), "%.*g %s", isLarge || force < 1000 ? 3 : 4,
                isLarge ? force / 1000 : force, isLarge ? "kN" : "N");
  return text.data();
}

/// "mesh 9: 443 N"
std::string textOfMesh(int label, double force) {
  return translated("mesh %1: %2", {std::to_string(label), textOf(force)});
}
std::string textOfJoint(int label, double force) {
  return translated("joint %1: %2", {std::to_string(label), textOf(force)});
}

std::optional<ElementId> movingLink(const Mechanism& mechanism, LinkOrdinal link) {
  if (link == 0) return std::nullopt;
  return mechanism.links[link].id;
}

}  // namespace

std::vector<SceneForce> stageForces(const Mechanism& mechanism, const Placement& placement,
                                    const StaticsReport& report) {
  std::vector<SceneForce> forces;
  if (!report.isAnswered() || !report.problem.hasLoads()) return forces;
  for (std::size_t mesh = 0; mesh < report.forces.meshes.size(); ++mesh) {
    const ToothForce& tooth = report.forces.meshes[mesh];
    if (!tooth.isDetermined || !report.solution().isDetermined(static_cast<int>(mesh))) continue;
    const MeshGeometry& geometry = *placement.meshes[mesh];
    forces.push_back({ForceKind::tooth, mechanism.gearMeshes[mesh].id,
                      textOfMesh(mechanism.meshLabel(static_cast<int>(mesh)), length(tooth.force)),
                      vectorOf(tooth.point), vectorOf(tooth.force), movingLink(mechanism, geometry.carrier)});
  }
  const PositionIndex<LinkTag> links(mechanism.links);
  for (std::size_t joint = 0; joint < report.forces.bearings.size(); ++joint) {
    const BearingReaction& bearing = report.forces.bearings[joint];
    if (!bearing.isDetermined) continue;
    const TurningJoint& turning = mechanism.turningJoints[joint];
    forces.push_back({ForceKind::bearing, turning.id,
                      textOfJoint(mechanism.jointLabel(static_cast<int>(joint)), length(bearing.force)),
                      vectorOf(bearing.point), vectorOf(bearing.force),
                      movingLink(mechanism, links.at(turning.tail))});
  }
  return forces;
}

}  // namespace geargraph
