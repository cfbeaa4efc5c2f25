#include "core/mechanism/placement/hypoid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

std::string measureText(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.6g", value == 0 ? 0.0 : value);
  return buffer;
}

/// The feet of the common perpendicular, relative to the point of the tail's line, and how far they are
/// apart.
struct Feet {
  Vector3 tail{};
  Vector3 head{};
  double distance = 0;
};

Feet feetOf(const GearPair<double>& pair) {
  const Vector3 across = cross(pair.tailDirection, pair.headDirection);
  const double along = dot(cross(pair.headPoint, pair.headDirection), across) / dot(across, across);
  const Vector3 normal = unit(across);
  const double apart = dot(pair.headPoint, normal);
  Feet feet;
  feet.tail = along * pair.tailDirection;
  feet.head = feet.tail + apart * normal;
  feet.distance = std::abs(apart);
  return feet;
}

/// The gear of the pair, which has more teeth, and its pinion: half axes and feet.
struct GearAndPinion {
  Vector3 gearAxis, pinionAxis;
  Vector3 gearFoot, pinionFoot;
  int gearTeeth = 1;
  int pinionTeeth = 1;
};

GearAndPinion gearAndPinion(const GearPair<double>& pair, const Feet& feet, BevelSides sides) {
  const Vector3 tail = static_cast<double>(sides.tail) * pair.tailDirection;
  const Vector3 head = static_cast<double>(sides.head) * pair.headDirection;
  if (pair.tailTeeth > pair.headTeeth)
    return {tail, head, feet.tail, feet.head, pair.tailTeeth, pair.headTeeth};
  return {head, tail, feet.head, feet.tail, pair.headTeeth, pair.tailTeeth};
}

/// R (1 + q^2) for the module 1: the largest offset.
double reachOfModule(const GearAndPinion& wheels) {
  const double share = static_cast<double>(wheels.pinionTeeth) / wheels.gearTeeth;
  return wheels.gearTeeth / 2.0 * (1 + share * share);
}

Vector3 derivedPoint(const GearAndPinion& wheels, double distance, double module) {
  const double radius = module * wheels.gearTeeth / 2;
  const double share = static_cast<double>(wheels.pinionTeeth) / wheels.gearTeeth;
  const double sine = distance / (module * reachOfModule(wheels));
  const Vector3 aside = unit(wheels.pinionFoot - wheels.gearFoot);
  return wheels.gearFoot + radius * share * wheels.gearAxis +
         radius * std::sqrt(1 - sine * sine) * wheels.pinionAxis + radius * sine * aside;
}

double halfAxisOf(const Vector3& point, const Vector3& foot, const Vector3& direction, double reach) {
  const double along = dot(point - foot, direction);
  return std::abs(along) <= kGeometryFits * reach ? 0 : along;
}

/// One cone of a geometry: `fromLine` leads from a point of the axis to the pitch point.
OffsetCone coneOf(const Vector3& pitchPoint, const Vector3& onAxis, const Vector3& direction,
                  const Vector3& pitchNormal) {
  OffsetCone cone;
  const double along = dot(pitchPoint - onAxis, pitchNormal) / dot(direction, pitchNormal);
  cone.apex = onAxis + along * direction;
  const Vector3 line = pitchPoint - cone.apex;
  cone.axis = dot(line, direction) < 0 ? -1.0 * direction : direction;
  cone.angle = std::atan2(length(cross(cone.axis, line)), dot(cone.axis, line));
  return cone;
}

/// Between the trace of the teeth and the cone's line through the pitch point; positive where the teeth turn
/// about the half axis in the positive sense as they lead away from the apex.
double spiralOf(const OffsetCone& cone, const Vector3& pitchPoint, const Vector3& trace) {
  const Vector3 line = unit(pitchPoint - cone.apex);
  const Vector3 turning = unit(cross(cone.axis, pitchPoint - cone.apex));
  return std::atan(dot(trace, turning) / dot(trace, line));
}

OffsetCones conesOf(const Vector3& pitchPoint, const Vector3& headPoint, const Vector3& tailDirection,
                    const Vector3& headDirection) {
  const Vector3 normal =
      unit(cross(cross(tailDirection, pitchPoint), cross(headDirection, pitchPoint - headPoint)));
  return {coneOf(pitchPoint, {0, 0, 0}, tailDirection, normal),
          coneOf(pitchPoint, headPoint, headDirection, normal)};
}

}  // namespace

OffsetCones offsetCones(const MeshGeometry& geometry, const Vector3& tailDirection,
                        const Vector3& headDirection) {
  return conesOf(geometry.tailToPitch, geometry.tailToHead, tailDirection, headDirection);
}

bool placeHypoid(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                 LinePosition position, const SkewChoice& choice, MeshGeometry& geometry,
                 Diagnostics& diagnostics) {
  const GearMesh& element = mechanism.gearMeshes[mesh];
  const auto reject = [&](Detail detail, const std::string& message) {
    Diagnostic why;
    why.code = codeOf(detail);
    why.detail = detail;
    why.message = translated("Mesh %1: %2", {std::to_string(mechanism.meshLabel(mesh)), message});
    why.elements = {element.id, element.tail, element.head};
    diagnostics.push_back(std::move(why));
    return false;
  };
  const MeshKind kind = saidKind(element);
  if (position != LinePosition::skew) {
    return reject(Detail::kindAgainstAxes,
                  position == LinePosition::parallel
                      ? translated("it says %1, but its axes are parallel. What fits: external or internal.",
                                   {kindWord(kind)})
                      : translated("it says %1, but its axes meet. What fits: bevel.", {kindWord(kind)}));
  }
  const Feet feet = feetOf(pair);
  geometry.derived = !element.pitchPoint;
  if (geometry.derived) {
    const double cosine = dot(pair.tailDirection, pair.headDirection);
    if (std::abs(cosine) > kGeometryFits) {
      const double degrees = std::acos(std::min(std::abs(cosine), 1.0)) * 180 / std::numbers::pi;
      return reject(Detail::kindAgainstAxes,
                    translated("it says hypoid, but its axes cross at %1 degrees. What fits: axes that cross "
                               "at 90 degrees, or a pitch point of its own.",
                               {measureText(std::round(degrees * 1e4) / 1e4)}));
    }
    const GearAndPinion wheels = gearAndPinion(pair, feet, choice.sides);
    constexpr double kMostOffset = 0.95;  // beyond, the pinion's cone is a needle
    if (feet.distance > kMostOffset * choice.module * reachOfModule(wheels)) {
      return reject(Detail::teethAgainstRadii,
                    translated("its axes are %1 apart, too far for a gear of %2 teeth and module %3. What "
                               "fits: a module of at least %4, or axes nearer to each other.",
                               {measureText(feet.distance), std::to_string(wheels.gearTeeth),
                                measureText(choice.module),
                                measureText(feet.distance / (kMostOffset * reachOfModule(wheels)))}));
    }
    geometry.tailToPitch = derivedPoint(wheels, feet.distance, choice.module);
    geometry.sides = choice.sides;
  }
  const Vector3& point = geometry.tailToPitch;
  const Vector3 tail = cross(pair.tailDirection, point);
  const Vector3 head = cross(pair.headDirection, point - pair.headPoint);
  const double reach = std::max(length(tail), length(head));
  const double onTail = halfAxisOf(point, feet.tail, pair.tailDirection, reach);
  const double onHead = halfAxisOf(point, feet.head, pair.headDirection, reach);
  const Vector3 across = cross(tail, head);
  const double slack = kGeometryFits * reach * reach;
  // The cones' apexes are where the pitch plane cuts the axes.
  const auto isFlat = [&](const Vector3& direction) {
    return std::abs(dot(across, direction)) <= kGeometryFits * length(across);
  };
  if (onTail == 0 || onHead == 0 || length(across) <= slack || isFlat(pair.tailDirection) ||
      isFlat(pair.headDirection)) {
    return reject(Detail::pitchPointOffPerpendicular,
                  translated("its pitch point leaves one gear no cone: it lies on an axis, or beside the "
                             "common perpendicular of both. What fits: a point farther out along both axes, "
                             "or none (then it follows from the axes)."));
  }
  const double sign = (onTail < 0) == (onHead < 0) ? -1 : 1;
  const Vector3 trace = static_cast<double>(pair.headTeeth) * tail - (sign * pair.tailTeeth) * head;
  const OffsetCones cones = conesOf(point, pair.headPoint, pair.tailDirection, pair.headDirection);
  geometry.kind = kind;
  geometry.normal = orientedNormal(unit(cross(across, trace)));
  geometry.tailRadius = dot(geometry.normal, tail);
  geometry.headRadius = dot(geometry.normal, head);
  geometry.sign = sign < 0 ? -1 : 1;
  geometry.tailHelix = spiralOf(cones.tail, point, trace);
  geometry.headHelix = spiralOf(cones.head, point, trace);
  constexpr double kMaxSpiral = 85;  // degrees
  const double spiral =
      std::max(std::abs(geometry.tailHelix), std::abs(geometry.headHelix)) * 180 / std::numbers::pi;
  if (spiral > kMaxSpiral) {
    return reject(Detail::helixAgainstTeeth,
                  translated("its pitch point asks for a spiral angle of %1 degrees, and at 90 teeth run "
                             "round their axis. What fits: a point whose distances from the axes are nearer "
                             "to the ratio of the teeth, or none.",
                             {measureText(std::round(spiral * 10) / 10)}));
  }
  return true;
}

}  // namespace geargraph
