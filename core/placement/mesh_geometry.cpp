#include "core/placement/mesh_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/placement/tolerance.h"

namespace geargraph {
namespace {

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", std::abs(value) < 1e-12 ? 0.0 : value);
  return buffer;
}

std::string text(const Vector3& v) {
  return "(" + text(v[0]) + ", " + text(v[1]) + ", " + text(v[2]) + ")";
}

Diagnostic finding(const Mechanism& mechanism, int mesh, Code code, const std::string& message) {
  const GearMesh& element = mechanism.gearMeshes[mesh];
  Diagnostic result;
  result.code = code;
  result.message = "Mesh " + std::to_string(mechanism.meshLabel(mesh)) + ": " + message;
  result.elements = {element.id, element.tail, element.head};
  return result;
}

Diagnostic finding(const Mechanism& mechanism, int mesh, Detail detail, const std::string& message) {
  Diagnostic result = finding(mechanism, mesh, codeOf(detail), message);
  result.detail = detail;
  return result;
}

double axisDistance(const GearPair<double>& pair) {
  const Vector3 normal = cross(pair.tailDirection, pair.headDirection);
  const Vector3 between = pair.headPoint - pair.tailPoint;
  if (length(normal) < kSameLine) return length(cross(pair.tailDirection, between));
  return std::abs(dot(between, unit(normal)));
}

/// The pitch point for these teeth on the side where `at` lies, at its size.
std::optional<Vector3> fittingPoint(const GearPair<double>& pair, const Vector3& at, int sign) {
  if (positionOf(pair) == LinePosition::parallel) {
    const bool internal = sign * dot(pair.tailDirection, pair.headDirection) > 0;
    if (internal && pair.tailTeeth == pair.headTeeth) return std::nullopt;
    return parallelPitchPoint(pair, internal, at);
  }
  const Vector3 apex = apexOf(pair);
  BevelSides sides;
  sides.tail = dot(at - apex, pair.tailDirection) < 0 ? -1 : 1;
  sides.head = -sign * sides.tail;
  const Vector3 unitPoint = bevelPitchPoint(pair, sides, 1);
  const double size = length(at - apex) / length(unitPoint - apex);
  return apex + size * (unitPoint - apex);
}

std::string fit(const GearPair<double>& pair, const Vector3& at, int sign) {
  const auto point = fittingPoint(pair, at, sign);
  return point ? "the pitch point " + text(*point) : "another tooth count";
}

Diagnostic onAxis(const Mechanism& mechanism, int mesh, const Vector3& point, bool ofTail) {
  return finding(mechanism, mesh, Code::pitchPointOnAxis,
                 "the pitch point " + text(point) + " lies on the axis of the " + (ofTail ? "tail" : "head") +
                     " gear, so its pitch radius is 0. What fits: a point off both axes, in their plane.");
}

Diagnostic offPlane(const Mechanism& mechanism, int mesh, const GearPair<double>& pair,
                    const Vector3& point) {
  const bool parallel = positionOf(pair) == LinePosition::parallel;
  const Vector3 normal = parallel ? cross(pair.tailDirection, pair.headPoint - pair.tailPoint)
                                  : cross(pair.tailDirection, pair.headDirection);
  if (length(normal) == 0) {
    return finding(mechanism, mesh, Detail::coincidentAxes,
                   "its two axes are the same line in the reference pose.");
  }
  const double off = std::abs(dot(point - pair.tailPoint, unit(normal)));
  const int sign = dot(cross(pair.tailDirection, point - pair.tailPoint),
                       cross(pair.headDirection, point - pair.headPoint)) < 0
                       ? -1
                       : 1;
  return finding(mechanism, mesh, Detail::pitchPointOffPlane,
                 "the pitch point " + text(point) + " lies " + text(off) +
                     " off the plane of the two axes, so the teeth would lock. What fits: " +
                     fit(pair, point, sign) + ", or none (then it follows from the axes).");
}

Diagnostic wrongKind(const Mechanism& mechanism, int mesh, MeshKind kind, LinePosition position) {
  return finding(mechanism, mesh, Detail::kindAgainstAxes,
                 "it says " + std::string(meshKindName(kind)) + ", but its axes " +
                     (position == LinePosition::parallel ? "are parallel. What fits: external or internal."
                                                         : "meet. What fits: bevel."));
}

Diagnostic wrongSign(const Mechanism& mechanism, int mesh, const GearPair<double>& pair,
                     const MeshGeometry& found) {
  const bool saysInternal = found.kind != MeshKind::internal;  // what it is, is the other one
  std::string message = "it says " +
                        std::string(meshKindName(saysInternal ? MeshKind::internal : MeshKind::external)) +
                        ", but the pitch point " + text(found.pitchPoint) + " lies " +
                        (saysInternal ? "between the axes, which is an external pair."
                                      : "on one side of both axes, which is an internal pair.");
  const int fittingSign = -found.sign;
  message += " What fits: " + std::string(meshKindName(found.kind)) + ", or " +
             fit(pair, found.pitchPoint, fittingSign) + ".";
  return finding(mechanism, mesh, Detail::kindAgainstSides, message);
}

Diagnostic wrongTeeth(const Mechanism& mechanism, int mesh, const GearPair<double>& pair,
                      const MeshGeometry& found) {
  const double tail = std::abs(found.tailRadius);
  const double head = std::abs(found.headRadius);
  const double fitting = pair.tailTeeth * head / tail;
  return finding(mechanism, mesh, Detail::teethAgainstRadii,
                 "the pitch radii are " + text(tail) + " and " + text(head) + " (ratio " + text(tail / head) +
                     "), but the teeth are " + std::to_string(pair.tailTeeth) + " and " +
                     std::to_string(pair.headTeeth) + " (ratio " +
                     text(static_cast<double>(pair.tailTeeth) / pair.headTeeth) +
                     "). What fits: " + text(fitting) + " teeth on the head, or " +
                     fit(pair, found.pitchPoint, found.sign) + ".");
}

/// The unit vector or its opposite: the one whose first component that is not 0 is positive.
Vector3 oriented(const Vector3& direction) {
  for (const double component : direction) {
    if (std::abs(component) > kSameLine) return component > 0 ? direction : -1.0 * direction;
  }
  return direction;
}

}  // namespace

LinePosition positionOf(const GearPair<double>& pair) {
  const Vector3 normal = cross(pair.tailDirection, pair.headDirection);
  if (dot(normal, normal) < kSameLine * kSameLine) return LinePosition::parallel;
  const Vector3 between = pair.headPoint - pair.tailPoint;
  const double size = length(between) + length(pair.tailPoint) + length(pair.headPoint);
  return axisDistance(pair) <= kGeometryFits * size ? LinePosition::meeting : LinePosition::skew;
}

Diagnostic skewAxes(const Mechanism& mechanism, int mesh, const GearPair<double>& pair) {
  return finding(
      mechanism, mesh, Detail::skewAxes,
      "its axes are skew, " + text(axisDistance(pair)) +
          " apart: there is no point where the gears could roll. What fits: axes that are parallel or meet.");
}

Diagnostic equalInternalTeeth(const Mechanism& mechanism, int mesh) {
  return finding(mechanism, mesh, Detail::equalInternalTeeth,
                 "an internal pair needs different tooth counts, the ring the larger one; both have " +
                     std::to_string(mechanism.gearMeshes[mesh].tailTeeth) + ".");
}

bool checkGeometry(const Mechanism& mechanism, int mesh, const GearPair<double>& pair, LinePosition position,
                   MeshGeometry& geometry, Diagnostics& diagnostics) {
  const auto refuse = [&](Diagnostic why) {
    diagnostics.push_back(std::move(why));
    return false;
  };
  const Vector3 tail = cross(pair.tailDirection, geometry.pitchPoint - pair.tailPoint);
  const Vector3 head = cross(pair.headDirection, geometry.pitchPoint - pair.headPoint);
  const double tailLength = length(tail);
  const double headLength = length(head);
  const double larger = std::max(tailLength, headLength);
  if (std::min(tailLength, headLength) <= kSameLine * larger) {
    return refuse(onAxis(mechanism, mesh, geometry.pitchPoint, tailLength <= headLength));
  }
  const Vector3 off = cross(tail, head);
  const double slack = kGeometryFits * tailLength * headLength;
  if (dot(off, off) > slack * slack) {
    return refuse(offPlane(mechanism, mesh, pair, geometry.pitchPoint));
  }

  geometry.normal = oriented((1 / tailLength) * tail);
  geometry.tailRadius = dot(geometry.normal, tail);
  geometry.headRadius = dot(geometry.normal, head);
  geometry.sign = geometry.tailRadius * geometry.headRadius < 0 ? -1 : 1;
  geometry.kind = position == LinePosition::meeting                                 ? MeshKind::bevel
                  : geometry.sign * dot(pair.tailDirection, pair.headDirection) < 0 ? MeshKind::external
                                                                                    : MeshKind::internal;
  const std::optional<MeshKind> said = mechanism.gearMeshes[mesh].kind;
  if (said && (*said == MeshKind::bevel) != (geometry.kind == MeshKind::bevel)) {
    return refuse(wrongKind(mechanism, mesh, *said, position));
  }
  if (said && *said != geometry.kind) return refuse(wrongSign(mechanism, mesh, pair, geometry));
  const double a = tailLength * pair.headTeeth;
  const double b = headLength * pair.tailTeeth;
  if (std::abs(a - b) <= kGeometryFits * std::max(a, b)) return true;
  return refuse(wrongTeeth(mechanism, mesh, pair, geometry));
}

}  // namespace geargraph
