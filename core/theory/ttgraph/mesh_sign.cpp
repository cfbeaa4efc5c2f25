#include "core/theory/ttgraph/mesh_sign.h"

#include <algorithm>
#include <cmath>

#include "core/theory/ttgraph/terminal_rule.h"

namespace geargraph {
namespace {

/// From the line's foot to the point.
Vector3 armTo(const AxisLine& line, const Vector3& point) {
  const Vector3 from = point - line.point;
  return from - dot(from, line.direction) * line.direction;
}

/// As the kind says, where it is known and its gears' sense does not depend on the pitch point.
std::optional<int> signOfKind(const MeshPose& pose, int sense) {
  return pose.kind ? terminalRules()[*pose.kind].alongParallels(sense) : std::nullopt;
}

std::optional<int> signOfParallel(const MeshPose& pose, const AxisLine& tail, const AxisLine& head) {
  const int sense = dot(tail.direction, head.direction) > 0 ? 1 : -1;
  if (const std::optional<int> sign = signOfKind(pose, sense)) return sign;
  if (pose.pitchPoint == nullptr) return std::nullopt;
  const double between = dot(armTo(tail, *pose.pitchPoint), armTo(head, *pose.pitchPoint));
  if (between == 0) return std::nullopt;
  return between < 0 ? -sense : sense;
}

/// 1. The apex: the point of the tail's axis that is nearest to the head's; the axes have to meet there.
/// 2. The shares: pitch point - apex = tailShare * u_tail + headShare * u_head (least squares).
std::optional<int> signOfIntersecting(const MeshPose& pose, const AxisLine& tail, const AxisLine& head) {
  if (pose.pitchPoint == nullptr) return std::nullopt;
  const double cosine = dot(tail.direction, head.direction);
  const double sineSquared = 1 - cosine * cosine;
  const Vector3 apart = head.point - tail.point;
  const double toTail = dot(apart, tail.direction);
  const double toHead = dot(apart, head.direction);
  const Vector3 apex = tail.point + ((toTail - cosine * toHead) / sineSquared) * tail.direction;
  const Vector3 pitchLine = *pose.pitchPoint - apex;
  const double reach = std::max(length(apart), length(pitchLine));
  if (length(armTo(head, apex)) > kGeometryFits * reach) return std::nullopt;

  const double onTail = dot(pitchLine, tail.direction);
  const double onHead = dot(pitchLine, head.direction);
  const double tailShare = onTail - cosine * onHead;
  const double headShare = onHead - cosine * onTail;
  if (tailShare == 0 || headShare == 0) return std::nullopt;
  return (tailShare > 0) == (headShare > 0) ? -1 : 1;
}

/// On which side of the common perpendicular's foot the pitch point lies, along either axis.
std::optional<int> signOfHalfAxes(const MeshPose& pose, const AxisLine& tail, const AxisLine& head) {
  if (pose.pitchPoint == nullptr) return std::nullopt;
  const double cosine = dot(tail.direction, head.direction);
  const double sineSquared = 1 - cosine * cosine;
  const Vector3 apart = head.point - tail.point;
  const double toTail = dot(apart, tail.direction);
  const double toHead = dot(apart, head.direction);
  const double tailFoot = (toTail - cosine * toHead) / sineSquared;
  const double headFoot = (cosine * toTail - toHead) / sineSquared;
  const double onTail = dot(*pose.pitchPoint - tail.point, tail.direction) - tailFoot;
  const double onHead = dot(*pose.pitchPoint - head.point, head.direction) - headFoot;
  if (onTail == 0 || onHead == 0) return std::nullopt;
  return terminalRules()[*pose.kind].alongHalfAxes(onTail > 0 ? 1 : -1, onHead > 0 ? 1 : -1);
}

std::optional<int> signOfSkew(const MeshPose& pose, const AxisLine& tail, const AxisLine& head) {
  if (pose.kind && terminalRules()[*pose.kind].alongHalfAxes != nullptr)
    return signOfHalfAxes(pose, tail, head);
  if (!pose.kind || !pose.helices) return std::nullopt;
  const Vector3 across = cross(tail.direction, head.direction);
  const double sine = dot(across, head.point - tail.point) < 0 ? -length(across) : length(across);
  const double crossing = std::atan2(sine, dot(tail.direction, head.direction));
  return terminalRules()[*pose.kind].acrossSkew(pose.helices->first + pose.helices->second + crossing);
}

std::optional<int> signOfSlide(const MeshPose& pose) {
  const bool isOneOfEach = pose.tailSlides != pose.headSlides;
  if (!isOneOfEach || !pose.kind || !slides(*pose.kind) || !pose.helices || pose.pitchPoint == nullptr)
    return std::nullopt;
  const AxisLine& turning = pose.tailSlides ? *pose.headAxis : *pose.tailAxis;
  const AxisLine& sliding = pose.tailSlides ? *pose.tailAxis : *pose.headAxis;
  const double helix = pose.tailSlides ? pose.helices->second : pose.helices->first;
  return terminalRules()[*pose.kind].alongSlide(
      {turning.direction, sliding.direction, armTo(turning, *pose.pitchPoint), helix});
}

}  // namespace

std::optional<int> meshSign(const MeshPose& pose) {
  if (pose.tailSlides || pose.headSlides || (pose.kind && slides(*pose.kind))) {
    const bool isPlaced = pose.tailAxis != nullptr && pose.headAxis != nullptr;
    return isPlaced ? signOfSlide(pose) : std::nullopt;
  }
  if (pose.tailAxis != nullptr && pose.headAxis != nullptr) {
    if (pose.kind && hasSkewAxes(*pose.kind)) return signOfSkew(pose, *pose.tailAxis, *pose.headAxis);
    return areParallel(pose.tailAxis->direction, pose.headAxis->direction)
               ? signOfParallel(pose, *pose.tailAxis, *pose.headAxis)
               : signOfIntersecting(pose, *pose.tailAxis, *pose.headAxis);
  }
  if (pose.kind && hasSkewAxes(*pose.kind)) return std::nullopt;
  // Axes that nothing placed are parallel and point one way unless they carry bevel gears.
  return signOfKind(pose, 1);
}

}  // namespace geargraph
