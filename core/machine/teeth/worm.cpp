#include "core/machine/teeth/worm.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/machine/teeth/sampling.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

using std::numbers::pi;

/// Half of the flat between two fillets, in axial modules: less would leave no room for points.
constexpr double kNarrowestRoot = 0.01;

/// The axial section of a thread, lengths in axial modules.
struct ThreadSection {
  double pitch, tip, root;  ///< radii
  double slope;             ///< tangent of the axial pressure angle
  double half;              ///< of the thickness at the pitch radius
  double fillet;            ///< its radius
  explicit ThreadSection(const GearSpec& worm) {
    const double share = 1 / std::tan(leadAngle(worm));  // axial modules in one transverse module
    pitch = worm.teeth / 2.0 * share;
    tip = nominalTipRadius(worm) / axialModule(worm);
    root = pitch - worm.dedendum * share;
    slope = std::tan(worm.pressureAngle) / share;
    half = pi / 4 - worm.backlashAllowance / 2;
    root = std::max(root, pitch - (pi / 2 - kNarrowestRoot - half) / slope);  // where threads would meet
    const double angle = std::atan(slope);
    const double room = pi / 2 - kNarrowestRoot - halfWidth(root);
    fillet = std::clamp(worm.rootRadius * share, 0.0,
                        std::max(room, 0.0) / ((1 - std::sin(angle)) / std::cos(angle)));
  }
  [[nodiscard]] double halfWidth(double rad) const { return half - (rad - pitch) * slope; }
};

}  // namespace

GearSpec wormSpec(int starts, double axialModule, double pitchRadius, int hand, double normalPressureAngle,
                  double faceWidth) {
  const double share = starts * axialModule / (2 * pitchRadius);  // tangent of the lead angle
  GearSpec spec = standardGear(GearKind::worm, starts, axialModule / share, faceWidth);
  const double lead = std::atan(share);
  spec.helixAngle = (hand < 0 ? -1 : 1) * (pi / 2 - lead);
  spec.pressureAngle = std::atan(std::tan(normalPressureAngle) / std::sin(lead));
  for (double GearSpec::*proportion : {&GearSpec::addendum, &GearSpec::dedendum, &GearSpec::rootRadius})
    spec.*proportion *= share;
  return spec;
}

GearSpec wormWheelSpec(int teeth, int starts, double axialModule, double wormPitchRadius, int hand,
                       double normalPressureAngle, double faceWidth) {
  const double lead = std::atan(starts * axialModule / (2 * wormPitchRadius));
  GearSpec spec = standardGear(GearKind::wormWheel, teeth, axialModule, faceWidth);
  spec.helixAngle = (hand < 0 ? -1 : 1) * lead;
  spec.pressureAngle = std::atan(std::tan(normalPressureAngle) / std::cos(lead));
  spec.mateTeeth = starts;
  spec.mateRadius = wormPitchRadius;
  return spec;
}

GearSpec wormWithHelix(GearSpec normal, double helixAngle) {
  const double lead = pi / 2 - std::abs(helixAngle);
  normal.helixAngle = helixAngle;
  normal.pressureAngle = std::atan(std::tan(normal.pressureAngle) / std::sin(lead));
  normal.module /= std::sin(lead);
  for (double GearSpec::*proportion : {&GearSpec::addendum, &GearSpec::dedendum, &GearSpec::rootRadius})
    normal.*proportion *= std::tan(lead);
  return normal;
}

GearSpec wormWheelWithHelix(GearSpec normal, double helixAngle) {
  normal.helixAngle = helixAngle;
  normal.pressureAngle = std::atan(std::tan(normal.pressureAngle) / std::cos(helixAngle));
  normal.module /= std::cos(helixAngle);
  return normal;
}

double leadAngle(const GearSpec& worm) {
  return pi / 2 - std::abs(worm.helixAngle);
}

double axialModule(const GearSpec& worm) {
  return worm.module * std::tan(leadAngle(worm));
}

double leadOf(const GearSpec& worm) {
  return pi * worm.teeth * axialModule(worm);
}

double wormDistance(const GearSpec& wheel) {
  return wheel.mateRadius + pitchRadius(wheel) + wheel.profileShift * wheel.module;
}

double usualWheelFace(const GearSpec& wheel) {
  return 1.4 * (wheel.mateRadius + wheel.addendum * wheel.module);
}

double usualWormLength(const GearSpec& wheel) {
  const double reach = pitchRadius(wheel) + (kWormRim + wheel.profileShift) * wheel.module;
  const double nearest = wormDistance(wheel) - wheel.mateRadius - wheel.addendum * wheel.module;
  return 2 * std::sqrt(std::max(reach * reach - nearest * nearest, 0.0));
}

std::vector<ThreadPoint> threadProfile(const GearSpec& worm, double tolerance) {
  const ThreadSection s(worm);
  const double angle = std::atan(s.slope);
  const double flankRoot = s.root + s.fillet * (1 - std::sin(angle));
  std::vector<ThreadPoint> points;
  if (s.fillet > kShortestArc) {
    const double centre = s.halfWidth(s.root + s.fillet) + s.fillet / std::cos(angle);
    const int n = chordsOfArc(pi / 2 - angle, s.fillet, tolerance);
    for (int i = 0; i < n; ++i) {
      const double w = pi / 2 - (pi / 2 - angle) * i / n;
      points.push_back(
          {centre - s.fillet * std::cos(w), s.root + s.fillet * (1 - std::sin(w)), std::cos(w), std::sin(w)});
    }
  }
  for (const double rad : {flankRoot, s.tip})
    points.push_back({s.halfWidth(rad), rad, std::cos(angle), std::sin(angle)});
  return points;
}

/// The point `along` of the axial section is turned by 2 pi along / lead, and so is the normal: a step along
/// the thread is one round the axis.
HalfTooth wormTooth(const GearSpec& worm, double tolerance) {
  const double share = std::tan(leadAngle(worm));  // transverse modules in one axial module
  const double turn = 2.0 / worm.teeth;            // for an axial module
  std::vector<ThreadPoint> section = threadProfile(worm, tolerance / share);
  const ThreadPoint formPoint = section[section.size() - 2];
  const ThreadPoint tipPoint = section.back();
  section.pop_back();
  const int flanks =
      chordsOfArc((formPoint.along - tipPoint.along) * turn, tipPoint.rad * share, tolerance * kFlankShare);
  for (int i = 1; i <= flanks; ++i) {
    ThreadPoint p = tipPoint;
    p.along = formPoint.along + (tipPoint.along - formPoint.along) * i / flanks;
    p.rad = formPoint.rad + (tipPoint.rad - formPoint.rad) * i / flanks;
    section.push_back(p);
  }
  HalfTooth tooth;
  const auto addArc = [&](double rad, double from, double to, bool last) {
    const int n = chordsOfArc(from - to, rad, tolerance);
    for (int i = 0; i < n + (last ? 1 : 0); ++i)
      tooth.points.push_back({rad, from + (to - from) * i / n, 1, 0});
  };
  const double root = section.front().rad * share;
  addArc(root, pi / worm.teeth, section.front().along * turn, section.front().normalRad < 1);
  for (const ThreadPoint& p : section) {
    const double round = p.normalAlong / (turn * p.rad);  // the part of the normal across the radius
    const double length = std::hypot(p.normalRad, round);
    tooth.points.push_back({p.rad * share, p.along * turn, p.normalRad / length, round / length});
  }
  tooth.rootRad = root;
  tooth.formRad = formPoint.rad * share;
  tooth.tipRad = tipPoint.rad * share;
  tooth.tipHalfAngle = tipPoint.along * turn;
  addArc(tooth.tipRad, tooth.tipHalfAngle, 0, true);
  return tooth;
}

/// From where the worm's tip line cuts the line of action, or where the wheel's flank begins, to the wheel's
/// tip.
double wormContactRatio(const GearSpec& worm, const HalfTooth& /*thread*/, const GearSpec& wheel,
                        const HalfTooth& tooth, double /*distance*/) {
  const double sine = std::sin(wheel.pressureAngle), cosine = std::cos(wheel.pressureAngle);
  const double base = wheel.teeth / 2.0 * cosine;
  const auto roll = [&](double rad) { return std::sqrt(std::max(rad * rad - base * base, 0.0)); };
  const double atPitch = wheel.teeth / 2.0 * sine;
  const double height = worm.addendum * worm.module / wheel.module - wheel.profileShift;
  const double begin = std::max(roll(tooth.formRad), atPitch - height / sine);
  return (roll(tooth.tipRad) - begin) / (pi * cosine);
}

double wormWheelContactRatio(const GearSpec& wheel, const HalfTooth& tooth, const GearSpec& worm,
                             const HalfTooth& thread, double distance) {
  return wormContactRatio(worm, thread, wheel, tooth, distance);
}

double usualWormFace(const GearSpec& worm) {
  return usualWormLength(wormWheelSpec(worm.mateTeeth, worm.teeth, axialModule(worm), pitchRadius(worm),
                                       worm.helixAngle < 0 ? -1 : 1, normalPressureAngle(worm), 1));
}

}  // namespace geargraph
