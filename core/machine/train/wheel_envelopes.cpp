#include "core/machine/train/wheel_envelopes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/bevel_collision.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

Vector3 narrow(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// Beside wheels that go round, in modules: a carrier's arm or a ring's plate, which what lies across leaves
/// free.
constexpr double kArmAllowance = 4;

/// Flatter than a crown the body of a bevel is hollow, and no hull says where it is.
constexpr double kFlattest = 1.7;  // rad

DiscHull hullOf(const TrainWheel& wheel, double low, double high, double outer) {
  const GearSpec& spec = wheel.spec;
  DiscHull hull;
  const auto add = [&](double radius, double height) {
    hull.push_back({narrow(wheel.origin + height * wheel.axis), narrow(wheel.axis), radius});
  };
  if (!isConical(spec)) {
    add(outer, low);
    add(outer, high);
  } else if (spec.coneAngle < kFlattest) {
    for (const ProfileVertex& c : wheelOutline(spec)) add(std::max(c.radius, 0.0), c.height);
  }
  return hull;
}

Vector3d acrossPart(const Vector3d& v, const Vector3d& axis) {
  return v - v.dot(axis) * axis;
}

bool areParallel(const Vector3d& a, const Vector3d& b) {
  return a.cross(b).norm() < 1e-6;
}

}  // namespace

WheelOrbit orbitOf(AxisGroupOrdinal axisGroup, const Placement& placement) {
  const AxisGroups& classes = *placement.classes;
  const AxisLine& line = placement.lineOfClass(axisGroup);
  WheelOrbit orbit;
  orbit.at = wide(line.point);
  orbit.carrier = classes.classes[axisGroup].rootLink;
  const int about = classes.classOfLink(orbit.carrier);
  if (about < 0) return orbit;
  const AxisLine& centre = placement.lineOfClass(about);
  if (!areParallel(wide(line.direction), wide(centre.direction))) return orbit;
  orbit.about = about;
  orbit.radius = acrossPart(orbit.at - wide(centre.point), wide(centre.direction)).norm();
  return orbit;
}

double nearestAxes(const WheelOrbit& a, const WheelOrbit& b, const Vector3d& direction) {
  if (a.carrier != b.carrier && a.about >= 0 && a.about == b.about) return std::abs(a.radius - b.radius);
  return acrossPart(b.at - a.at, direction).norm();
}

WheelEnvelopes::WheelEnvelopes(const TrainWheels& train, const Placement& placement) : m_train(train) {
  const std::size_t classes = placement.classes->classes.size();
  for (std::size_t c = 0; c < classes; ++c) {
    m_orbits.push_back(orbitOf(static_cast<int>(c), placement));
    m_lines.push_back(wide(placement.lineOfClass(static_cast<int>(c)).direction));
  }
  const bool hasArms =
      std::any_of(m_orbits.begin(), m_orbits.end(), [](const WheelOrbit& orbit) { return orbit.about >= 0; });
  m_freeSide.assign(classes, Vector3d::Zero());
  m_envelopes.reserve(train.wheels.size());
  for (const TrainWheel& wheel : train.wheels) {
    const Envelope& envelope = m_envelopes.emplace_back(envelopeOf(wheel, hasArms));
    if (envelope.bevel) m_freeSide[wheel.axisGroup] += wheel.axis;
  }
}

WheelEnvelopes::Envelope WheelEnvelopes::envelopeOf(const TrainWheel& wheel, bool hasArms) const {
  const AxialSpan span = axialSpan(wheel.spec);
  Envelope envelope;
  envelope.origin = wheel.origin;
  envelope.axis = wheel.axis;
  envelope.axisGroup = wheel.axisGroup;
  envelope.low = span.low;
  envelope.high = span.high;
  envelope.bevel = isConical(wheel.spec);
  if (isRing(wheel.spec)) envelope.inner = nominalTipRadius(wheel.spec);
  envelope.outer = outerRadius(wheel.spec);
  envelope.orbit = m_orbits[wheel.axisGroup];
  envelope.hasArm = hasArms && !envelope.bevel;
  const double arm = envelope.hasArm ? kArmAllowance * toothSize(wheel.spec) : 0;
  envelope.hull = hullOf(wheel, envelope.low - arm, envelope.high + arm, envelope.outer);
  double low = envelope.low - arm, high = envelope.high + arm, outer = envelope.outer;
  if (envelope.bevel) {  // its body as well, in which the hollow ones of flat cones may collide
    for (const ProfileVertex& c : wheelOutline(wheel.spec)) {
      low = std::min(low, c.height);
      high = std::max(high, c.height);
      outer = std::max(outer, c.radius);
    }
  }
  envelope.middle = (low + high) / 2;
  envelope.reach = std::hypot((high - low) / 2, outer);
  return envelope;
}

void WheelEnvelopes::update(GearOrdinal wheel) {
  Envelope& known = m_envelopes[static_cast<std::size_t>(wheel)];
  known = envelopeOf(m_train.wheels[static_cast<std::size_t>(wheel)], known.hasArm);
}

std::vector<std::pair<int, int>> WheelEnvelopes::nearPairs(const std::stop_token& stop) const {
  std::vector<std::pair<int, int>> pairs;
  std::vector<std::pair<double, int>> starts;  // of the spheres along x, which sweeps over them
  std::map<int, std::vector<int>> orbiting;    // by the axis that the carriers go round
  std::size_t along = 0;
  Vector3d low = Vector3d::Constant(1e300), high = -low;
  for (const Envelope& each : m_envelopes) {
    low = low.cwiseMin(each.centre());
    high = high.cwiseMax(each.centre());
  }
  if (!m_envelopes.empty()) (high - low).maxCoeff(&along);
  for (const GearOrdinal w : m_envelopes.ordinals()) {
    const Envelope& each = m_envelopes[w];
    starts.emplace_back(each.centre()[static_cast<Eigen::Index>(along)] - each.reach, static_cast<int>(w));
    if (each.orbit.about >= 0) orbiting[each.orbit.about].push_back(static_cast<int>(w));
  }
  std::sort(starts.begin(), starts.end());
  for (auto first = starts.begin(); first != starts.end() && !stop.stop_requested(); ++first) {
    const Envelope& a = envelope(first->second);
    const Vector3d centre = a.centre();
    for (auto next = first + 1; next != starts.end() && next->first <= first->first + 2 * a.reach; ++next) {
      const Envelope& b = envelope(next->second);
      const double reach = a.reach + b.reach;
      if ((b.centre() - centre).squaredNorm() <= reach * reach)
        pairs.push_back(std::minmax(first->second, next->second));
    }
  }
  for (const auto& [about, wheels] : orbiting) {
    for (auto one = wheels.begin(); one != wheels.end() && !stop.stop_requested(); ++one) {
      for (auto other = one + 1; other != wheels.end(); ++other) {
        if (shareOrbit(envelope(*one), envelope(*other))) pairs.emplace_back(*one, *other);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

bool WheelEnvelopes::mayIntersect(GearOrdinal moving, GearOrdinal other) const {
  const Envelope& a = envelope(moving);
  const Envelope& b = envelope(other);
  if (shareOrbit(a, b)) return true;
  const double reach = a.reach + b.reach;
  return acrossPart(b.centre() - a.centre(), a.axis).squaredNorm() <= reach * reach;
}

bool WheelEnvelopes::covers(GearOrdinal wheel, AxisGroupOrdinal axisGroup) const {
  const Envelope& covering = envelope(wheel);
  const auto c = static_cast<std::size_t>(axisGroup);
  if (covering.bevel || covering.axisGroup == axisGroup || !areParallel(covering.axis, m_lines[c]))
    return false;
  const double shaft = 2 * toothSize(m_train.wheels[static_cast<std::size_t>(wheel)].spec);
  const double nearest = nearestAxes(covering.orbit, m_orbits[c], covering.axis);
  const double now = acrossPart(m_orbits[c].at - covering.orbit.at, covering.axis).norm();
  const double touch = kSameLine * covering.outer;
  return std::max(nearest, now) + shaft > covering.inner + touch && nearest < covering.outer + shaft - touch;
}

void WheelEnvelopes::move(GearOrdinal wheel, const Vector3d& by) {
  Envelope& moved = m_envelopes[static_cast<std::size_t>(wheel)];
  moved.origin += by;
  for (Disc& disc : moved.hull) disc.centre = disc.centre + narrow(by);
}

bool WheelEnvelopes::discsCollide(const Envelope& a, const Envelope& b) {
  const double along = (b.origin - a.origin).dot(a.axis);
  const double sense = a.axis.dot(b.axis);
  const double low = sense < 0 ? -b.high : b.low;
  const double high = sense < 0 ? -b.low : b.high;
  // Faces and rims that touch do not collide, however rounding has it.
  const double touch = kSameLine * std::min({a.high - a.low, b.high - b.low, a.outer, b.outer});
  if (a.high <= low + along + touch || high + along <= a.low + touch) return false;
  if (a.axisGroup == b.axisGroup) return !(b.outer <= a.inner + touch || a.outer <= b.inner + touch);
  const double distance = nearestAxes(a.orbit, b.orbit, a.axis);
  const double now = acrossPart(b.origin - a.origin, a.axis).norm();
  const double far = std::max(distance, now);
  const bool inside = far + b.outer <= a.inner + touch || far + a.outer <= b.inner + touch;
  return !inside && distance < a.outer + b.outer - touch;
}

bool WheelEnvelopes::hullsCollide(const Envelope& a, const Envelope& b) {
  return !a.hull.empty() && !b.hull.empty() && areNear(a.hull, b.hull);
}

bool WheelEnvelopes::collide(GearOrdinal one, GearOrdinal other) const {
  const Envelope& a = envelope(one);
  const Envelope& b = envelope(other);
  if (a.bevel && b.bevel && a.axisGroup == b.axisGroup)
    return bevelsCollide(m_train.wheels[static_cast<std::size_t>(one)],
                         m_train.wheels[static_cast<std::size_t>(other)]);
  const bool discs = !a.bevel && !b.bevel && areParallel(a.axis, b.axis);
  if (discs) return discsCollide(a, b);
  if (!hullsCollide(a, b)) return false;
  return !a.bevel || !b.bevel ||
         bevelsCross(m_train.wheels[static_cast<std::size_t>(one)],
                     m_train.wheels[static_cast<std::size_t>(other)]);
}

}  // namespace geargraph
