#include "core/mechanism/placement/slide.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/mechanism/placement/pair_rule.h"

namespace geargraph {
namespace {

std::string travelText(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

Diagnostic slideDiagnostic(const Mechanism& mechanism, MeshOrdinal mesh, Detail detail,
                           const std::string& message) {
  const GearMesh& element = mechanism.gearMeshes[mesh];
  Diagnostic result;
  result.code = codeOf(detail);
  result.detail = detail;
  result.message = translated("Mesh %1: %2", {std::to_string(mechanism.meshLabel(mesh)), message});
  result.elements = {element.id, element.tail, element.head};
  return result;
}

/// What is wrong with the joints of the two sides, seen from the carrier; nothing if the kind has such.
std::optional<std::string> jointsProblem(MeshKind kind, bool tailSlides, bool headSlides) {
  if (!slides(kind)) {
    return translated(
        "one of its gears slides in their carrier, and gears of the kind %1 turn. What fits: a rack or a "
        "screw, or turning joints.",
        {kindWord(kind)});
  }
  if (tailSlides == headSlides) {
    return tailSlides ? translated("it says %1, but both of its sides slide. What fits: one side that turns.",
                                   {kindWord(kind)})
                      : translated("it says %1, but both of its sides turn. What fits: one side that slides.",
                                   {kindWord(kind)});
  }
  return std::nullopt;
}

/// From the axis of the turning side towards the pitch point, of length 1.
Vector3 slideSide(const Vector3& axis, const Vector3& slide, const Vector3& toSlide) {
  const Vector3 across = cross(axis, slide);
  if (length(across) <= kSameLine) {  // a thread: towards the slide's line, else anywhere
    const Vector3 off = toSlide - dot(toSlide, axis) * axis;
    if (length(off) > roundingOf(reachOf(toSlide))) return unit(off);
    return unit(std::abs(axis[0]) < 0.8 ? cross(axis, Vector3{1, 0, 0}) : cross(axis, Vector3{0, 1, 0}));
  }
  const Vector3 normal = unit(across);
  return dot(normal, toSlide) < 0 ? -1.0 * normal : normal;
}

}  // namespace

bool placeSlide(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair, bool tailSlides,
                bool headSlides, MeshGeometry& geometry, Diagnostics& diagnostics) {
  const GearMesh& element = mechanism.gearMeshes[mesh];
  const auto reject = [&](Detail detail, const std::string& message) {
    diagnostics.push_back(slideDiagnostic(mechanism, mesh, detail, message));
    return false;
  };
  geometry.kind = saidKind(element);
  geometry.derived = !element.pitchPoint;
  if (const auto problem = jointsProblem(geometry.kind, tailSlides, headSlides))
    return reject(Detail::kindAgainstAxes, *problem);
  const auto weights = weightsOf(element, tailSlides);
  if (!weights) {
    return reject(
        Detail::teethAgainstRadii,
        translated("the travel of a turn is not stated. What fits: a module or a pitch of the rack, the "
                   "lead of the screw."));
  }
  geometry.weights = *weights;

  // Places relative to the point of the tail's line.
  const Vector3& axis = tailSlides ? pair.headDirection : pair.tailDirection;
  const Vector3& slide = tailSlides ? pair.tailDirection : pair.headDirection;
  const Vector3 point = tailSlides ? pair.headPoint : pair.tailPoint;
  const Vector3 toSlide = (tailSlides ? pair.tailPoint : pair.headPoint) - point;
  const double ratio = static_cast<double>(tailSlides ? weights->head : weights->tail) /
                       (tailSlides ? weights->tail : weights->head) *
                       std::pow(std::numbers::pi, tailSlides ? weights->pi : -weights->pi);
  const bool isThread = !pairKind(geometry.kind).hasTeeth;
  if (isThread != areParallel(axis, slide)) {
    return reject(Detail::kindAgainstAxes,
                  isThread
                      ? translated("it says %1, but its side that slides does not slide along the axis of "
                                   "the other one. What fits: parallel directions, or a rack.",
                                   {kindWord(geometry.kind)})
                      : translated("it says %1, but it slides along the axis of its pinion. What fits: a "
                                   "direction across it, or a screw.",
                                   {kindWord(geometry.kind)}));
  }
  Vector3 outward = slideSide(axis, slide, toSlide);
  if (!isThread && element.pitchPoint && dot(geometry.tailToPitch - point, outward) < 0)
    outward = -1.0 * outward;
  const Vector3 around = cross(axis, outward);
  double helix = 0;
  Vector3 normal;
  double radius = 0;
  if (isThread) {
    constexpr double kLeads = 2;
    radius = kLeads * 2 * std::numbers::pi * ratio;
    const double slope = std::atan2(ratio, radius);
    helix = (element.hand == Hand::left ? -1 : 1) * (std::numbers::pi / 2 - slope);
    normal = std::cos(slope) * axis - ((helix < 0 ? -1 : 1) * std::sin(slope)) * around;
  } else {
    helix = helixOf(element);
    normal = std::cos(helix) * around - std::sin(helix) * axis;
    const double share = std::abs(dot(normal, slide));
    constexpr double kLeastShare = 0.02;  // teeth nearly along the slide push it aside
    if (share < kLeastShare) {
      return reject(Detail::helixAgainstTeeth,
                    translated("its teeth run along the slide and cannot push it. What fits: another helix "
                               "angle or hand."));
    }
    radius = ratio * share / std::cos(helix);
  }
  const Vector3 place = point + radius * outward + dot(toSlide, axis) * axis;
  if (!element.pitchPoint) {
    geometry.tailToPitch = place;
  } else {
    const Vector3 arm = geometry.tailToPitch - point;
    const Vector3 off = arm - dot(arm, axis) * axis - radius * outward;
    if (length(off) > kGeometryFits * radius) {
      return reject(Detail::teethAgainstRadii,
                    translated("its pitch point lies %1 off the place where a pinion of the pitch radius %2 "
                               "touches the rack. What fits: no pitch point.",
                               {travelText(length(off)), travelText(radius)}));
    }
  }
  geometry.normal = orientedNormal(normal);
  const double turning = dot(geometry.normal, cross(axis, geometry.tailToPitch - point));
  const double sliding = dot(geometry.normal, slide);
  geometry.tailRadius = tailSlides ? sliding : turning;
  geometry.headRadius = tailSlides ? turning : sliding;
  geometry.tailHelix = tailSlides ? 0 : helix;
  geometry.headHelix = tailSlides ? helix : 0;
  geometry.sign = geometry.tailRadius * geometry.headRadius < 0 ? -1 : 1;
  return true;
}

}  // namespace geargraph
