#include "core/machine/teeth/gear_spec.h"

#include <cmath>

namespace geargraph::inline teeth {

GearSpec standardGear(GearKind kind, int teeth, double module, double faceWidth) {
  GearSpec spec;
  spec.kind = kind;
  spec.teeth = teeth;
  spec.module = module;
  spec.faceWidth = faceWidth;
  if (kind == GearKind::internal) spec.rootRadius = 0.25;
  if (kind == GearKind::bevel) spec.rootRadius = 0.30;
  return spec;
}

double pitchRadius(const GearSpec& spec) {
  return spec.module * spec.teeth / 2;
}

double coneDistance(const GearSpec& spec) {
  return pitchRadius(spec) / std::sin(spec.coneAngle);
}

double nominalTipRadius(const GearSpec& spec) {
  const double height = (spec.addendum + spec.profileShift) * spec.module;
  if (spec.kind == GearKind::bevel) return pitchRadius(spec) + height * std::cos(spec.coneAngle);
  if (spec.tipRadius > 0) return spec.tipRadius * spec.module;
  if (spec.kind == GearKind::internal)
    return pitchRadius(spec) - (spec.addendum - spec.profileShift) * spec.module;
  return pitchRadius(spec) + height;
}

double nominalRootRadius(const GearSpec& spec) {
  const double depth = (spec.dedendum - spec.profileShift) * spec.module;
  if (spec.kind == GearKind::bevel) return pitchRadius(spec) - depth * std::cos(spec.coneAngle);
  if (spec.kind == GearKind::internal)
    return pitchRadius(spec) + (spec.dedendum + spec.profileShift) * spec.module;
  return pitchRadius(spec) - depth;
}

}  // namespace geargraph::inline teeth
