#include "core/machine/teeth/tooth_pair.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/involute.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

double squareOfSine(const GearSpec& spec) {
  return std::sin(spec.pressureAngle) * std::sin(spec.pressureAngle);
}

/// How far the rack's straight flank reaches below its pitch line, in modules: as far as its rounded corner
/// leaves it, which is the addendum at 20 degrees.
double straightDepth(const GearSpec& spec) {
  return spec.dedendum - rackCornerRadius(spec) * (1 - std::sin(spec.pressureAngle));
}

/// Pressure angle of the involute at a radius in modules.
double angleAt(const GearSpec& spec, double rad) {
  return std::acos(std::min(spec.teeth / 2.0 * std::cos(spec.pressureAngle) / rad, 1.0));
}

/// Where a tooth's flank begins and ends, as lengths on the line of action from the base circle (bevels: arcs
/// of the great circle from the base cone).
struct ActiveFlank {
  double form = 0;
  double tip = 0;
};

ActiveFlank planeFlank(const GearSpec& spec, const HalfTooth& tooth) {
  const double base = spec.teeth / 2.0 * std::cos(spec.pressureAngle);
  const auto roll = [&](double rad) { return std::sqrt(std::max(rad * rad - base * base, 0.0)); };
  return {roll(tooth.formRad), roll(tooth.tipRad)};
}

}  // namespace

double fewestTeethWithoutUndercut(const GearSpec& spec) {
  const double flat = 2 * (straightDepth(spec) - spec.profileShift) / squareOfSine(spec);
  return flat * wheelKind(spec.kind).shareOfVirtual(spec);
}

double leastShiftWithoutUndercut(const GearSpec& spec) {
  const double teeth = spec.teeth / wheelKind(spec.kind).shareOfVirtual(spec);
  return straightDepth(spec) - teeth * squareOfSine(spec) / 2;
}

double tipShortening(const GearSpec& a, const GearSpec& b, double distance) {
  const double standard = (a.teeth + b.teeth) / 2.0;
  return std::min(distance - standard - a.profileShift - b.profileShift, 0.0);
}

double leastRingTip(const GearSpec& pinion, const GearSpec& ring, double distance) {
  const double cosine = std::cos(pinion.pressureAngle);
  const double pinionBase = pinion.teeth / 2.0 * cosine;
  const double ringBase = ring.teeth / 2.0 * cosine;
  const double working = workingPressureAngle(ring.teeth - pinion.teeth, distance, pinion.pressureAngle);
  const double form = externalTooth(pinion, 0.01).formRad;
  const double roll = std::sqrt(std::max(form * form - pinionBase * pinionBase, 0.0));
  return std::hypot(ringBase, distance * std::sin(working) + roll);
}

double trochoidMargin(const GearSpec& pinion, const GearSpec& ring, double distance) {
  const double tip1 = nominalTipRadius(pinion) / pinion.module;
  const double tip2 = nominalTipRadius(ring) / ring.module;
  if (tip2 - tip1 >= distance) return 1;  // the tip circles do not cross
  const double working = workingPressureAngle(ring.teeth - pinion.teeth, distance, pinion.pressureAngle);
  const double turn1 = std::acos((tip2 * tip2 - tip1 * tip1 - distance * distance) / (2 * distance * tip1)) +
                       involute(angleAt(pinion, tip1)) - involute(working);
  const double turn2 = std::acos((distance * distance + tip2 * tip2 - tip1 * tip1) / (2 * distance * tip2));
  return turn1 * pinion.teeth / ring.teeth + involute(working) - involute(angleAt(ring, tip2)) - turn2;
}

double contactRatio(const GearSpec& a, const HalfTooth& toothA, const GearSpec& b, const HalfTooth& toothB,
                    double distance) {
  return wheelKind(a.kind).contactRatio(a, toothA, b, toothB, distance);
}

/// On the great circle through the pitch point that makes the pressure angle with the pitch cones' common
/// plane a point has the colatitude c with cos c = cos(arc) cos(base cone): for crowns and internal cones,
/// too.
double bevelContactRatio(const GearSpec& a, const HalfTooth& toothA, const GearSpec& b,
                         const HalfTooth& toothB, double /*distance*/) {
  const auto baseCosine = [](const GearSpec& spec) {
    const double sine = std::sin(spec.coneAngle) * std::cos(spec.pressureAngle);
    return std::sqrt(1 - sine * sine);
  };
  const auto arc = [&](const GearSpec& spec, double colatitude) {
    return std::acos(std::clamp(std::cos(colatitude) / baseCosine(spec), -1.0, 1.0));
  };
  const double line = arc(a, a.coneAngle) + arc(b, b.coneAngle);
  const double begin = std::max(arc(a, toothA.formRad), line - arc(b, toothB.tipRad));
  const double end = std::min(arc(a, toothA.tipRad), line - arc(b, toothB.formRad));
  const double basePitch = 2 * std::numbers::pi * std::sin(a.coneAngle) * std::cos(a.pressureAngle) / a.teeth;
  return (end - begin) / basePitch;
}

double planeContactRatio(const GearSpec& a, const HalfTooth& toothA, const GearSpec& b,
                         const HalfTooth& toothB, double distance) {
  const bool inRing = isRing(b);
  const double working =
      workingPressureAngle(inRing ? b.teeth - a.teeth : a.teeth + b.teeth, distance, a.pressureAngle);
  const double line = distance * std::sin(working);  // between the points where it leaves the base circles
  const ActiveFlank pinion = planeFlank(a, toothA);
  const ActiveFlank wheel = planeFlank(b, toothB);
  const double begin = std::max(pinion.form, inRing ? wheel.tip - line : line - wheel.tip);
  const double end = std::min(pinion.tip, inRing ? wheel.form - line : line - wheel.form);
  return (end - begin) / (std::numbers::pi * std::cos(a.pressureAngle));
}

}  // namespace geargraph
