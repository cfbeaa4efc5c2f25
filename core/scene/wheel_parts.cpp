#include "core/scene/wheel_parts.h"

#include <algorithm>
#include <cmath>

namespace geargraph {
namespace {

constexpr double kFaceInModules = 5;  // where nobody says how wide a wheel is
constexpr double kSamePlace = 1e-6;   // relative to the pitch radius

/// One end of a mesh.
struct End {
  int link = 0;
  int axisClass = 0;
  int otherClass = 0;
  int teeth = 0;
  int otherTeeth = 0;
  double radius = 0;  ///< of the pitch circle
};

double faceWidthOf(const Mechanism& mechanism, const GearMesh& mesh, double module) {
  if (mesh.faceWidth) return mesh.faceWidth->value();
  if (mechanism.gearDefaults && mechanism.gearDefaults->faceWidth)
    return mechanism.gearDefaults->faceWidth->value();
  return kFaceInModules * module;
}

Eigen::Vector3d apex(const ClassLine& a, const ClassLine& b) {
  const auto triple = [](const Eigen::Vector3d& v) { return Vector3{v.x(), v.y(), v.z()}; };
  return vectorOf(apexOf(
      GearPair<double>{triple(a.point), triple(a.direction), triple(b.point), triple(b.direction), 1, 1}));
}

WheelPart spurWheel(const End& end, const MeshGeometry& geometry, const ClassLine& line, double module,
                    double face) {
  const bool ring = geometry.kind == MeshKind::internal && end.teeth > end.otherTeeth;
  WheelPart wheel;
  wheel.spec = standardGear(ring ? GearKind::internal : GearKind::external, end.teeth, module, face);
  const double along = line.along(vectorOf(geometry.pitchPoint));
  wheel.pose = frameAt(line.at(along), line.direction);
  wheel.from = along - 0.5 * face;
  wheel.to = along + 0.5 * face;
  return wheel;
}

WheelPart bevelWheel(const End& end, const ClassLine& line, const Eigen::Vector3d& origin,
                     const Eigen::Vector3d& pitchPoint, double module, double face) {
  const Eigen::Vector3d outward = pitchPoint - origin;
  const double side = outward.dot(line.direction) < -kSamePlace * outward.norm() ? -1 : 1;
  WheelPart wheel;
  wheel.spec = standardGear(GearKind::bevel, end.teeth, module, std::min(face, 0.4 * outward.norm()));
  wheel.spec.coneAngle = std::atan2(end.radius, side * outward.dot(line.direction));
  wheel.pose = frameAt(origin, side * line.direction);
  const double large = line.along(origin) + outward.dot(line.direction);
  const double depth = wheel.spec.faceWidth * std::cos(wheel.spec.coneAngle);
  wheel.from = std::min(large, large - side * depth);
  wheel.to = std::max(large, large - side * depth);
  return wheel;
}

bool sameWheel(const WheelPart& a, const WheelPart& b) {
  const double fits = kSamePlace * pitchRadius(a.spec);
  return a.link == b.link && a.axisClass == b.axisClass && a.spec.kind == b.spec.kind &&
         a.spec.teeth == b.spec.teeth && std::abs(a.spec.module - b.spec.module) < fits &&
         (a.pose.matrix() - b.pose.matrix()).norm() < fits &&
         std::abs(a.spec.coneAngle - b.spec.coneAngle) < 1e-6;
}

}  // namespace

Eigen::Vector3d WheelPart::middle() const {
  if (spec.kind != GearKind::bevel) return Eigen::Vector3d::Zero();
  return {0, 0, (coneDistance(spec) - 0.5 * spec.faceWidth) * std::cos(spec.coneAngle)};
}

std::vector<WheelPart> wheelParts(const Mechanism& mechanism, const Placement& placement) {
  std::vector<WheelPart> wheels;
  for (std::size_t i = 0; i < placement.meshes.size(); ++i) {
    if (!placement.meshes[i]) continue;
    const MeshGeometry& geometry = *placement.meshes[i];
    const GearMesh& mesh = mechanism.gearMeshes[i];
    const End tail{geometry.tail,  geometry.tailClass, geometry.headClass,
                   mesh.tailTeeth, mesh.headTeeth,     std::abs(geometry.tailRadius)};
    const End head{geometry.head,  geometry.headClass, geometry.tailClass,
                   mesh.headTeeth, mesh.tailTeeth,     std::abs(geometry.headRadius)};
    for (const End& end : {tail, head}) {
      const double module = 2 * end.radius / end.teeth;
      const double face = faceWidthOf(mechanism, mesh, module);
      const ClassLine line = lineOf(placement, end.axisClass);
      WheelPart wheel = geometry.kind == MeshKind::bevel
                            ? bevelWheel(end, line, apex(line, lineOf(placement, end.otherClass)),
                                         vectorOf(geometry.pitchPoint), module, face)
                            : spurWheel(end, geometry, line, module, face);
      wheel.link = end.link;
      wheel.axisClass = end.axisClass;
      const auto known = std::find_if(wheels.begin(), wheels.end(),
                                      [&](const WheelPart& other) { return sameWheel(wheel, other); });
      WheelPart& kept = known != wheels.end() ? *known : wheels.emplace_back(std::move(wheel));
      kept.meshes.push_back(static_cast<int>(i));
    }
  }
  return wheels;
}

}  // namespace geargraph
