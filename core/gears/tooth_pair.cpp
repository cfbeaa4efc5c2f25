#include "core/gears/tooth_pair.h"

#include <algorithm>
#include <cmath>

#include "core/gears/half_tooth.h"
#include "core/gears/involute.h"

namespace geargraph {
namespace {

double squareOfSine(const GearSpec& spec) {
  return std::sin(spec.pressureAngle) * std::sin(spec.pressureAngle);
}

/// Pressure angle of the involute at a radius in modules.
double angleAt(const GearSpec& spec, double rad) {
  return std::acos(std::min(spec.teeth / 2.0 * std::cos(spec.pressureAngle) / rad, 1.0));
}

}  // namespace

double fewestTeethWithoutUndercut(const GearSpec& spec) {
  const double flat = 2 * (spec.addendum - spec.profileShift) / squareOfSine(spec);
  return spec.kind == GearKind::bevel ? flat * std::cos(spec.coneAngle) : flat;
}

double leastShiftWithoutUndercut(const GearSpec& spec) {
  const double teeth = spec.kind == GearKind::bevel ? spec.teeth / std::cos(spec.coneAngle) : spec.teeth;
  return spec.addendum - teeth * squareOfSine(spec) / 2;
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

}  // namespace geargraph
