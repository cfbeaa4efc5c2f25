#include "core/machine/solids/spec_diagnostics.h"

#include <cmath>
#include <string>

#include "core/foundations/base/translation.h"
#include "core/machine/solids/wheel_form.h"

namespace geargraph {
namespace {

/// Numbers that no formula below survives; checked first.
bool numbersAreSane(const GearSpec& s) {
  const auto positive = [](double v) { return std::isfinite(v) && v > 0; };
  const auto notNegative = [](double v) { return std::isfinite(v) && v >= 0; };
  return positive(s.module) && positive(s.faceWidth) && normalPressureAngle(s) > 0.08 &&
         normalPressureAngle(s) < 0.62 && s.pressureAngle < wheelForm(s).steepest &&
         std::isfinite(s.profileShift) && notNegative(s.backlashAllowance) && s.backlashAllowance < 0.5 &&
         positive(s.addendum) && positive(s.dedendum) && notNegative(s.rootRadius) &&
         notNegative(s.tipRadius) && notNegative(s.bore) && notNegative(s.rim) && notNegative(s.hub) &&
         std::abs(s.profileShift) <= 3 && s.addendum <= 3 && s.dedendum <= 3;
}

}  // namespace

Diagnostics specDiagnostics(const GearSpec& spec) {
  const WheelForm& form = wheelForm(spec);
  const int fewest = wheelKind(spec.kind).fewestTeeth;
  if (spec.teeth < fewest)  // whatever its other numbers are
    return {specRejection(form.tooFewTeeth(spec, fewest))};
  if (!numbersAreSane(spec)) {
    return {specRejection(
        translated("A gear of %1 teeth has a measure that no tooth can have; module and face width must be "
                   "positive, the pressure angle between 5 and 35 degrees, shift and heights at most 3 "
                   "modules.",
                   {std::to_string(spec.teeth)}))};
  }
  Diagnostics found;
  form.check(spec, found);
  if (found.empty()) form.checkBody(spec, found);
  return found;
}

}  // namespace geargraph
