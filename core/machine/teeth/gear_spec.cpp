#include "core/machine/teeth/gear_spec.h"

#include <cmath>

#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {

GearSpec standardGear(GearKind kind, int teeth, double module, double faceWidth) {
  GearSpec spec;
  spec.kind = kind;
  spec.teeth = teeth;
  spec.module = module;
  spec.faceWidth = faceWidth;
  spec.rootRadius = wheelKind(kind).cornerRadius;
  return spec;
}

GearSpec helical(GearSpec spec, double helixAngle) {
  const double share = std::cos(helixAngle);
  spec.helixAngle = helixAngle;
  spec.pressureAngle = std::atan(std::tan(spec.pressureAngle) / share);
  spec.module /= share;
  for (double GearSpec::*proportion :
       {&GearSpec::profileShift, &GearSpec::addendum, &GearSpec::dedendum, &GearSpec::rootRadius})
    spec.*proportion *= share;
  return spec;
}

GearSpec spiral(GearSpec spec, double spiralAngle) {
  const double module = spec.module;
  spec = helical(spec, spiralAngle);
  spec.module = module;
  return spec;
}

double spiralOf(const GearSpec& spec, double distance) {
  if (spec.helixAngle == 0) return 0;
  return std::tan(spec.helixAngle) / std::sin(spec.coneAngle) * std::log(distance / coneDistance(spec));
}

double normalModule(const GearSpec& spec) {
  return spec.module * std::cos(spec.helixAngle);
}

double toothSize(const GearSpec& spec) {
  const auto own = wheelKind(spec.kind).toothSize;
  return own != nullptr ? own(spec) : spec.module;
}

double normalPressureAngle(const GearSpec& spec) {
  return std::atan(std::tan(spec.pressureAngle) * std::cos(spec.helixAngle));
}

double normalShift(const GearSpec& spec) {
  return spec.profileShift / std::cos(spec.helixAngle);
}

double twistOf(const GearSpec& spec, double height) {
  if (spec.helixAngle == 0 || isConical(spec)) return 0;
  return (spec.herringbone ? -std::abs(height) : height) * std::tan(spec.helixAngle) / pitchRadius(spec);
}

double pitchRadius(const GearSpec& spec) {
  return spec.module * spec.teeth / 2;
}

double coneDistance(const GearSpec& spec) {
  return pitchRadius(spec) / std::sin(spec.coneAngle);
}

double nominalTipRadius(const GearSpec& spec) {
  return wheelKind(spec.kind).tipRadius(spec);
}

double nominalRootRadius(const GearSpec& spec) {
  return wheelKind(spec.kind).rootRadius(spec);
}

}  // namespace geargraph
