#include "core/machine/teeth/gear_spec.h"

#include <cmath>

#include "core/machine/teeth/wheel_kind.h"

namespace geargraph::inline teeth {

GearSpec standardGear(GearKind kind, int teeth, double module, double faceWidth) {
  GearSpec spec;
  spec.kind = kind;
  spec.teeth = teeth;
  spec.module = module;
  spec.faceWidth = faceWidth;
  spec.rootRadius = wheelKind(kind).cornerRadius;
  return spec;
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

}  // namespace geargraph::inline teeth
