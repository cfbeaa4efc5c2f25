#include "core/machine/solids/toothless_gear.h"

#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/part_solids.h"

namespace geargraph::inline solids {

Solid toothlessGear(const GearSpec& spec, double tolerance) {
  const double chord = tolerance * spec.module;
  const double pitch = spec.teeth * spec.module / 2, half = spec.faceWidth / 2;
  if (spec.kind == GearKind::bevel) return revolved(bevelOutline(spec), chord);
  if (spec.kind == GearKind::internal) return tube(rimDiameter(spec) / 2, pitch, -half, half, chord);
  std::vector<ProfileVertex> outline = bodyProfile(spec);
  outline.push_back({pitch, -half});
  outline.push_back({pitch, half});
  return revolved(outline, chord);
}

}  // namespace geargraph::inline solids
