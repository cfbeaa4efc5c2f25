#include "core/machine/train/wheel_backlash.h"

namespace geargraph {

Rational backlashOf(const Mechanism& mechanism, const std::optional<WheelId>& wheel) {
  const Wheel* const drawn = wheel ? mechanism.find(*wheel) : nullptr;
  if (drawn != nullptr && drawn->backlash) return drawn->backlash->exact();
  const std::optional<GearDefaults>& defaults = mechanism.gearDefaults;
  if (defaults && defaults->backlash) return defaults->backlash->exact();
  return {1, 25};
}

}  // namespace geargraph
