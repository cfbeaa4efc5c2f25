#include "core/mechanism/placement/strand.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/foundations/base/translation.h"
#include "core/mechanism/placement/pair_rule.h"

namespace geargraph {
namespace {

std::string lengthText(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

Diagnostic strandDiagnostic(const Mechanism& mechanism, MeshOrdinal mesh, Detail detail,
                            const std::string& message) {
  const GearMesh& element = mechanism.gearMeshes[mesh];
  Diagnostic result;
  result.code = codeOf(detail);
  result.detail = detail;
  result.message = translated("Mesh %1: %2", {std::to_string(mechanism.meshLabel(mesh)), message});
  result.elements = {element.id, element.tail, element.head};
  return result;
}

Diagnostic acrossEachOther(const Mechanism& mechanism, MeshOrdinal mesh, MeshKind kind,
                           LinePosition position) {
  return strandDiagnostic(
      mechanism, mesh, Detail::kindAgainstAxes,
      position == LinePosition::skew
          ? translated("it says %1, but its axes are skew. What fits: parallel axes.", {kindWord(kind)})
          : translated("it says %1, but its axes meet. What fits: bevel, or parallel axes.",
                       {kindWord(kind)}));
}

}  // namespace

bool placeStrand(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                 LinePosition position, const Vector3& level, MeshGeometry& geometry,
                 Diagnostics& diagnostics) {
  const auto reject = [&](Diagnostic why) {
    diagnostics.push_back(std::move(why));
    return false;
  };
  const GearMesh& element = mechanism.gearMeshes[mesh];
  geometry.kind = saidKind(element);
  geometry.derived = true;
  if (position != LinePosition::parallel)
    return reject(acrossEachOther(mechanism, mesh, geometry.kind, position));
  const Vector3& axis = pair.tailDirection;
  const auto footOn = [&](const Vector3& point) { return point + dot(level - point, axis) * axis; };
  const Vector3 from = footOn(pair.tailPoint);
  const Vector3 way = footOn(pair.headPoint) - from;
  const double distance = length(way);
  if (distance <= roundingOf(reachOf(pair.headPoint) + reachOf(level))) {
    return reject(strandDiagnostic(mechanism, mesh, Detail::coincidentAxes,
                                   translated("its two axes are the same line in the reference pose.")));
  }
  const auto [tailRadius, headRadius] = pairRule(geometry.kind).radii(element, distance);
  const double headSide = element.crossed ? -headRadius : headRadius;
  const bool hasRoom = !pairKind(geometry.kind).canCross || tailRadius + headRadius < distance;
  if (!hasRoom) {
    return reject(strandDiagnostic(
        mechanism, mesh, Detail::beltGeometry,
        translated("its pulleys overlap: the running radii %1 and %2 need more than the %3 between the axes. "
                   "What fits: smaller ones, or axes farther apart.",
                   {lengthText(tailRadius), lengthText(headRadius), lengthText(distance)})));
  }
  const Vector3 along = (1 / distance) * way;
  const double cosine = (tailRadius - headSide) / distance;
  const double sine = -std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const Vector3 outward = cosine * along + sine * cross(axis, along);  // nu
  const Vector3 strand = cross(axis, outward);                         // n
  const Vector3 tailEnd = from + tailRadius * outward;
  const Vector3 headEnd = from + way + headSide * outward;
  geometry.tailToPitch = 0.5 * (tailEnd + headEnd);
  const double headSense = dot(axis, pair.headDirection) < 0 ? -1 : 1;
  geometry.normal = orientedNormal(strand);
  const double turned = dot(geometry.normal, strand) < 0 ? -1 : 1;
  geometry.tailRadius = turned * tailRadius;
  geometry.headRadius = turned * headSense * headSide;
  geometry.sign = geometry.tailRadius * geometry.headRadius < 0 ? -1 : 1;
  return true;
}

}  // namespace geargraph
