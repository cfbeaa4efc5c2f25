#include "core/machine/solids/toothless_gear.h"

#include "core/machine/solids/wheel_form.h"

namespace geargraph {

Solid toothlessGear(const GearSpec& spec, double tolerance) {
  return wheelForm(spec).toothless(spec, tolerance * spec.module);
}

}  // namespace geargraph
