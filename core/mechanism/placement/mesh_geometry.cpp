#include "core/mechanism/placement/mesh_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

std::string text(double value, int digits = 6) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.*g", digits, value == 0 ? 0.0 : value);  // no -0
  return buffer;
}

/// A place, with digits enough to see lengths of this size; what rounding leaves of a 0 is written as 0.
std::string text(const Vector3& place, double size) {
  constexpr int kDigits = 6;
  constexpr int kAllDigits = 17;
  const double reach = std::max(reachOf(place), size);
  const double ratio = size > 0 ? reach / size : 1;
  const int digits = std::clamp(kDigits + static_cast<int>(std::log10(ratio)), kDigits, kAllDigits);
  std::string result;
  for (const double component : place) {
    const bool isRounding = std::abs(component) <= roundingOf(reach);
    result += (result.empty() ? "(" : ", ") + text(isRounding ? 0 : component, digits);
  }
  return result + ")";
}

std::string pitchPointText(const MeshGeometry& found) {
  return text(found.pitchPoint, reachOf(found.tailToPitch));
}

Diagnostic makeDiagnostic(const Mechanism& mechanism, MeshOrdinal mesh, Code code,
                          const std::string& message) {
  const GearMesh& element = mechanism.gearMeshes[mesh];
  Diagnostic result;
  result.code = code;
  result.message = translated("Mesh %1: %2", {std::to_string(mechanism.meshLabel(mesh)), message});
  result.elements = {element.id, element.tail, element.head};
  return result;
}

Diagnostic makeDiagnostic(const Mechanism& mechanism, MeshOrdinal mesh, Detail detail,
                          const std::string& message) {
  Diagnostic result = makeDiagnostic(mechanism, mesh, codeOf(detail), message);
  result.detail = detail;
  return result;
}

double axisDistance(const GearPair<double>& pair) {
  const Vector3 normal = cross(pair.tailDirection, pair.headDirection);
  const Vector3 between = pair.headPoint - pair.tailPoint;
  if (areParallel(pair.tailDirection, pair.headDirection)) return length(cross(pair.tailDirection, between));
  return std::abs(dot(between, unit(normal)));
}

/// The pitch point for these teeth on the side where `at` lies, at its size. Places relative to the tail's.
std::optional<Vector3> fittingPoint(const GearPair<double>& pair, LinePosition position, const Vector3& at,
                                    int sign) {
  if (position == LinePosition::parallel) {
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

/// `found` tells where the pair is.
std::string fit(const GearPair<double>& pair, LinePosition position, const MeshGeometry& found, int sign) {
  const auto point = fittingPoint(pair, position, found.tailToPitch, sign);
  if (!point) return translated("another tooth count");
  return translated("the pitch point %1",
                    {text(found.pitchPoint + (*point - found.tailToPitch), reachOf(found.tailToPitch))});
}

Diagnostic onAxis(const Mechanism& mechanism, MeshOrdinal mesh, const MeshGeometry& found, bool ofTail) {
  return makeDiagnostic(mechanism, mesh, Code::pitchPointOnAxis,
                        ofTail
                            ? translated("the pitch point %1 lies on the axis of the tail gear, so its pitch "
                                         "radius is 0. What fits: a point off both axes, in their plane.",
                                         {pitchPointText(found)})
                            : translated("the pitch point %1 lies on the axis of the head gear, so its pitch "
                                         "radius is 0. What fits: a point off both axes, in their plane.",
                                         {pitchPointText(found)}));
}

Diagnostic offPlane(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                    LinePosition position, const MeshGeometry& found) {
  const bool parallel = position == LinePosition::parallel;
  const Vector3 normal = parallel ? cross(pair.tailDirection, pair.headPoint - pair.tailPoint)
                                  : cross(pair.tailDirection, pair.headDirection);
  if (length(normal) <= roundingOf(length(pair.headPoint))) {
    return makeDiagnostic(mechanism, mesh, Detail::coincidentAxes,
                          translated("its two axes are the same line in the reference pose."));
  }
  const Vector3& point = found.tailToPitch;
  const double off = std::abs(dot(point - pair.tailPoint, unit(normal)));
  const int sign = dot(cross(pair.tailDirection, point - pair.tailPoint),
                       cross(pair.headDirection, point - pair.headPoint)) < 0
                       ? -1
                       : 1;
  return makeDiagnostic(
      mechanism, mesh, Detail::pitchPointOffPlane,
      translated("the pitch point %1 lies %2 off the plane of the two axes, so the teeth would "
                 "lock. What fits: %3, or none (then it follows from the axes).",
                 {pitchPointText(found), text(off), fit(pair, position, found, sign)}));
}

Diagnostic wrongKind(const Mechanism& mechanism, MeshOrdinal mesh, MeshKind kind, LinePosition position) {
  return makeDiagnostic(
      mechanism, mesh, Detail::kindAgainstAxes,
      position == LinePosition::parallel
          ? translated("it says %1, but its axes are parallel. What fits: external or internal.",
                       {kindWord(kind)})
          : translated("it says %1, but its axes meet. What fits: bevel.", {kindWord(kind)}));
}

Diagnostic wrongSign(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                     LinePosition position, const MeshGeometry& found) {
  const bool saysInternal = !turnsAlike(found.kind);  // what it is, is the other one
  std::string message =
      saysInternal
          ? translated(
                "it says internal, but the pitch point %1 lies between the axes, which is an external pair.",
                {pitchPointText(found)})
          : translated(
                "it says external, but the pitch point %1 lies on one side of both axes, which is an "
                "internal pair.",
                {pitchPointText(found)});
  const int fittingSign = -found.sign;
  message += ' ' + translated("What fits: %1, or %2.",
                              {kindWord(found.kind), fit(pair, position, found, fittingSign)});
  return makeDiagnostic(mechanism, mesh, Detail::kindAgainstSides, message);
}

Diagnostic wrongTeeth(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                      LinePosition position, const MeshGeometry& found) {
  const double tail = std::abs(found.tailRadius);
  const double head = std::abs(found.headRadius);
  const double fitting = pair.tailTeeth * head / tail;
  return makeDiagnostic(
      mechanism, mesh, Detail::teethAgainstRadii,
      translated("the pitch radii are %1 and %2 (ratio %3), but the teeth are %4 and %5 (ratio %6). What "
                 "fits: %7 teeth on the head, or %8.",
                 {text(tail), text(head), text(tail / head), std::to_string(pair.tailTeeth),
                  std::to_string(pair.headTeeth), text(static_cast<double>(pair.tailTeeth) / pair.headTeeth),
                  text(fitting), fit(pair, position, found, found.sign)}));
}

/// A stated helix where the kind leaves no choice.
std::optional<Diagnostic> helixOnMeetingAxes(const Mechanism& mechanism, MeshOrdinal mesh, MeshKind kind) {
  const GearMesh& element = mechanism.gearMeshes[mesh];
  if (element.herringbone) {
    return makeDiagnostic(
        mechanism, mesh, Detail::helixAgainstTeeth,
        translated("it has herringbone teeth, but its axes meet. What fits: a helix angle alone, or none."));
  }
  if (helixOf(element) == 0 || pairKind(kind).statesHelix) return std::nullopt;
  return makeDiagnostic(mechanism, mesh, Detail::helixAgainstTeeth,
                        translated("it has a helix angle, but the pinion of a face gear has straight teeth "
                                   "here. What fits: none."));
}

Diagnostic wrongAngle(const Mechanism& mechanism, MeshOrdinal mesh, MeshKind kind, double cosine) {
  const double degrees = std::acos(std::min(std::abs(cosine), 1.0)) * 180 / std::numbers::pi;
  return makeDiagnostic(mechanism, mesh, Detail::kindAgainstAxes,
                        translated("it says %1, but its axes meet at %2 degrees. What fits: bevel, or axes "
                                   "that meet at 90 degrees.",
                                   {kindWord(kind), text(std::round(degrees * 1e4) / 1e4)}));
}

Diagnostic noFace(const Mechanism& mechanism, MeshOrdinal mesh) {
  return makeDiagnostic(mechanism, mesh, Detail::teethAgainstRadii,
                        translated("a face gear has more teeth than its pinion; both have %1. What fits: "
                                   "other numbers, or bevel.",
                                   {std::to_string(mechanism.gearMeshes[mesh].tailTeeth)}));
}

/// `module` with teeth that no sum of profile shifts brings to the distance of the axes.
Diagnostic moduleAgainstDistance(const Mechanism& mechanism, MeshOrdinal mesh, double distance,
                                 double standard, double fitting) {
  return makeDiagnostic(
      mechanism, mesh, Detail::teethAgainstRadii,
      translated(
          "its module %1 makes a centre distance of %2, and the axes are %3 apart: profile shifts make "
          "up for two modules at most. What fits: the module %4.",
          {text(mechanism.gearMeshes[mesh].module->value()), text(standard), text(distance), text(fitting)}));
}

/// The helices of both gears, and what the stated module says of the distance of parallel axes.
std::optional<Diagnostic> checkHelix(const Mechanism& mechanism, MeshOrdinal mesh, LinePosition position,
                                     MeshGeometry& geometry) {
  const GearMesh& element = mechanism.gearMeshes[mesh];
  if (position != LinePosition::parallel) {
    if (auto wrong = helixOnMeetingAxes(mechanism, mesh, geometry.kind)) return wrong;
    geometry.tailHelix = helixOf(element);
    geometry.headHelix = -geometry.tailHelix;
    return std::nullopt;
  }
  geometry.tailHelix = helixOf(element);
  geometry.headHelix = turnsAlike(geometry.kind) ? geometry.tailHelix : -geometry.tailHelix;
  if (!element.module) return std::nullopt;
  constexpr double kMaxShift = 2;  // modules, of both wheels
  const double distance =
      pairKind(geometry.kind).distance(std::abs(geometry.tailRadius), std::abs(geometry.headRadius));
  const double share =
      distanceTeeth(geometry.kind, element.tailTeeth, element.headTeeth) / (2 * std::cos(geometry.tailHelix));
  const double module = element.module->value();
  if (std::abs(distance - share * module) <= kMaxShift * module) return std::nullopt;
  return moduleAgainstDistance(mechanism, mesh, distance, share * module, distance / share);
}

double pitchRadiusOf(MeshKind kind, double moment, double helix) {
  return std::abs(moment) / (hasSkewAxes(kind) ? std::cos(helix) : 1);
}

}  // namespace

double MeshGeometry::tailPitchRadius() const {
  return pitchRadiusOf(kind, tailRadius, tailHelix);
}

double MeshGeometry::headPitchRadius() const {
  return pitchRadiusOf(kind, headRadius, headHelix);
}

int tailHalfAxis(const MeshGeometry& geometry, const Vector3& tailDirection, const Vector3& headDirection) {
  const Vector3 apex = apexOf<double>({{0, 0, 0}, tailDirection, geometry.tailToHead, headDirection, 1, 1});
  const Vector3 line = geometry.tailToPitch - apex;
  constexpr double kCrown = 1e-9;
  const auto isCrown = [&](const Vector3& k) { return std::abs(dot(k, line)) < kCrown * length(line); };
  const Vector3 head = dot(headDirection, line) < 0 ? -1.0 * headDirection : headDirection;
  int side = dot(tailDirection, line) < 0 ? -1 : 1;
  const Vector3 tail = static_cast<double>(side) * tailDirection;
  if (isCrown(tail)) return dot(tail, head) > 0 ? -side : side;
  const bool isBetween = dot(cross(tail, line), cross(line, head)) > 0;
  if (!isBetween && !isCrown(head) && std::abs(geometry.tailRadius) > std::abs(geometry.headRadius))
    side = -side;
  return side;
}

Vector3 orientedNormal(const Vector3& direction) {
  for (const double component : direction) {
    if (std::abs(component) > kSameLine) return component > 0 ? direction : -1.0 * direction;
  }
  return direction;
}

LinePosition positionOf(const GearPair<double>& pair, const LineComparison& train) {
  if (areParallel(pair.tailDirection, pair.headDirection)) return LinePosition::parallel;
  const double distance = axisDistance(pair);
  const bool meet = distance <= kGeometryFits * length(pair.headPoint - pair.tailPoint) ||
                    distance <= kGeometryFits * train.size();
  return meet ? LinePosition::intersecting : LinePosition::skew;
}

Diagnostic skewAxes(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair) {
  return makeDiagnostic(
      mechanism, mesh, Detail::skewAxes,
      translated("its axes are skew, %1 apart: there is no point where the gears could roll. What "
                 "fits: axes that are parallel or meet, or the kind worm or crossed helical.",
                 {text(axisDistance(pair))}));
}

Diagnostic equalInternalTeeth(const Mechanism& mechanism, MeshOrdinal mesh) {
  return makeDiagnostic(
      mechanism, mesh, Detail::equalInternalTeeth,
      translated("an internal pair needs different tooth counts, the ring the larger one; both have %1.",
                 {std::to_string(mechanism.gearMeshes[mesh].tailTeeth)}));
}

bool checkGeometry(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                   LinePosition position, MeshGeometry& geometry, Diagnostics& diagnostics) {
  const auto reject = [&](Diagnostic why) {
    diagnostics.push_back(std::move(why));
    return false;
  };
  const Vector3 tail = cross(pair.tailDirection, geometry.tailToPitch);
  const Vector3 head = cross(pair.headDirection, geometry.tailToPitch - pair.headPoint);
  const double tailLength = length(tail);
  const double headLength = length(head);
  const double larger = std::max(tailLength, headLength);
  if (std::min(tailLength, headLength) <= kSameLine * larger) {
    return reject(onAxis(mechanism, mesh, geometry, tailLength <= headLength));
  }
  const Vector3 off = cross(tail, head);
  const double slack = kGeometryFits * tailLength * headLength;
  if (dot(off, off) > slack * slack) {
    return reject(offPlane(mechanism, mesh, pair, position, geometry));
  }

  geometry.normal = orientedNormal((1 / tailLength) * tail);
  geometry.tailRadius = dot(geometry.normal, tail);
  geometry.headRadius = dot(geometry.normal, head);
  geometry.sign = geometry.tailRadius * geometry.headRadius < 0 ? -1 : 1;
  const int sense = geometry.sign * dot(pair.tailDirection, pair.headDirection) < 0 ? -1 : 1;
  geometry.kind = usualKind(position, sense);
  if (const std::optional<MeshKind> said = mechanism.gearMeshes[mesh].kind) {
    const PairKind& kind = pairKind(*said);
    if (kind.axes != position) return reject(wrongKind(mechanism, mesh, *said, position));
    const double cosine = dot(pair.tailDirection, pair.headDirection);
    if (kind.isSquare && std::abs(cosine) > kGeometryFits)
      return reject(wrongAngle(mechanism, mesh, *said, cosine));
    if (kind.hasFace && pair.tailTeeth == pair.headTeeth) return reject(noFace(mechanism, mesh));
    if (kind.sense == -sense) return reject(wrongSign(mechanism, mesh, pair, position, geometry));
    geometry.kind = *said;
  }
  // Radii of nearly coincident axes fit equal teeth, but no such gears lie in each other.
  if (distanceTeeth(geometry.kind, pair.tailTeeth, pair.headTeeth) == 0)
    return reject(equalInternalTeeth(mechanism, mesh));
  const double a = tailLength * pair.headTeeth;
  const double b = headLength * pair.tailTeeth;
  if (std::abs(a - b) > kGeometryFits * std::max(a, b))
    return reject(wrongTeeth(mechanism, mesh, pair, position, geometry));
  if (auto wrong = checkHelix(mechanism, mesh, position, geometry)) return reject(*std::move(wrong));
  return true;
}

}  // namespace geargraph
