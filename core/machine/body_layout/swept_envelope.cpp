#include "core/machine/body_layout/swept_envelope.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace geargraph {
namespace {

using Eigen::Vector3d;

Vector3d wideOf(const Vector3& v) {
  return {v[0], v[1], v[2]};
}

/// What discs sweep about an axis.
SweptEnvelope sweptAbout(const AxisLayout& axis, const DiscHull& discs) {
  SweptEnvelope swept;
  swept.point = axis.point;
  swept.direction = axis.direction;
  swept.low = 1e300;
  swept.high = -1e300;
  const auto away = [&](const Disc& disc) {
    const Vector3d apart = wideOf(disc.centre) - axis.point;
    return (apart - apart.dot(axis.direction) * axis.direction).norm();
  };
  double nearest = 1e300;
  bool isOneLine = true;  // do all discs lie about one parallel line?
  for (const Disc& disc : discs) {
    const Vector3d k = wideOf(disc.axis);
    const double tilt = k.cross(axis.direction).norm();
    const double along = axis.coordinate(wideOf(disc.centre));
    swept.low = std::min(swept.low, along - disc.radius * tilt);
    swept.high = std::max(swept.high, along + disc.radius * tilt);
    swept.outer = std::max(swept.outer, away(disc) + disc.radius);
    nearest = std::min(nearest, away(disc) - disc.radius);
    const Vector3d apart = wideOf(disc.centre) - wideOf(discs.front().centre);
    isOneLine = isOneLine && tilt < 1e-6 && apart.cross(axis.direction).norm() < 1e-6 * axis.module;
  }
  swept.inner = isOneLine ? std::max(nearest, 0.0) : 0;
  return swept;
}

/// Its ends, as discs whose hull holds it.
DiscHull endsOf(const SweptEnvelope& swept) {
  DiscHull discs;
  for (const double z : {swept.low, swept.high}) {
    const Vector3d centre = swept.point + z * swept.direction;
    const Vector3d& k = swept.direction;
    discs.push_back({{centre.x(), centre.y(), centre.z()}, {k.x(), k.y(), k.z()}, swept.outer});
  }
  return discs;
}

}  // namespace

bool SweptEnvelope::isNear(const Vector3d& a, const Vector3d& b, double margin) const {
  const double from = (a - point).dot(direction), to = (b - point).dot(direction);
  // The part of the line between the planes of the ends.
  double first = 0, last = 1;
  for (const double sense : {1.0, -1.0}) {
    const double most = sense > 0 ? high + margin : margin - low;
    const double start = sense * from, slope = sense * (to - from);
    if (slope > 0) last = std::min(last, (most - start) / slope);
    if (slope < 0) first = std::max(first, (most - start) / slope);
    if (slope == 0 && start > most) return false;
  }
  if (first > last) return false;
  const auto across = [&](double part) {
    const Vector3d apart = a + part * (b - a) - point;
    return (apart - apart.dot(direction) * direction).eval();
  };
  const Vector3d start = across(first), way = across(last) - start;
  const double square = way.squaredNorm();
  const double part = square > 0 ? std::clamp(-start.dot(way) / square, 0.0, 1.0) : 0;
  const double nearest = (start + part * way).norm(), farthest = std::max(start.norm(), (start + way).norm());
  return nearest < outer + margin && inner - margin < farthest;
}

double SweptEnvelope::lowestAlong(const Vector3d& up) const {
  const double start = point.dot(up), slope = direction.dot(up);
  return start + std::min(low * slope, high * slope) - outer * direction.cross(up).norm();
}

std::vector<SweptEnvelope> sweptEnvelopes(const Arrangement& plan, const GearTrain& train,
                                          const Placement& placement) {
  const AxisGroups& classes = *placement.classes;
  std::vector<SweptEnvelope> envelopes;
  for (const BodyHull& hull : bodyHulls(plan, train, {0, true})) {
    if (hull.link == 0) continue;
    DiscHull discs = hull.discs;
    LinkOrdinal link = hull.link;
    while (true) {
      const int c = classes.classOfLink(link);
      SweptEnvelope swept = sweptAbout(plan.axes[c], discs);
      link = classes.classes[c].rootLink;
      if (link != 0) {
        discs = endsOf(swept);
        continue;
      }
      swept.kind = hull.kind;
      swept.link = hull.link;
      swept.axisGroup = c;
      swept.isOnAxis = hull.axisGroup == c;
      envelopes.push_back(std::move(swept));
      break;
    }
  }
  return envelopes;
}

}  // namespace geargraph
