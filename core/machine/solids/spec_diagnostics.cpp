#include "core/machine/solids/spec_diagnostics.h"

#include <cmath>
#include <numbers>
#include <string>

#include "core/foundations/base/spoken.h"
#include "core/foundations/base/words.h"
#include "core/machine/solids/gear_body.h"

namespace geargraph::inline solids {
namespace {

using std::numbers::pi;

std::string oneDecimal(double value) {
  const auto tenths = static_cast<long long>(std::llround(value * 10));
  return std::string(tenths < 0 ? "-" : "") + std::to_string(std::abs(tenths) / 10) + decimalSign() +
         std::to_string(std::abs(tenths) % 10);
}

Diagnostic rejected(std::string message) {
  return {Code::teethGeometry, std::move(message), {}, {}, 0, 0};
}

/// Numbers that no formula below survives; checked first.
bool numbersAreSane(const GearSpec& s) {
  const auto positive = [](double v) { return std::isfinite(v) && v > 0; };
  const auto notNegative = [](double v) { return std::isfinite(v) && v >= 0; };
  return positive(s.module) && positive(s.faceWidth) && s.pressureAngle > 0.08 && s.pressureAngle < 0.62 &&
         std::isfinite(s.profileShift) && notNegative(s.backlashAllowance) && s.backlashAllowance < 0.5 &&
         positive(s.addendum) && positive(s.dedendum) && notNegative(s.rootRadius) &&
         notNegative(s.tipRadius) && notNegative(s.bore) && notNegative(s.rim) && notNegative(s.hub) &&
         std::abs(s.profileShift) <= 3 && s.addendum <= 3 && s.dedendum <= 3;
}

void checkBody(const GearSpec& s, Diagnostics& found) {
  if (s.kind == GearKind::internal) {
    if (s.rim > 0 && s.rim / 2 < nominalRootRadius(s) + 0.1 * s.module) {
      found.push_back(rejected(translated(
          "The rim of %1 does not reach past the roots of the ring's %2 teeth: make it larger than %3.",
          {oneDecimal(s.rim), std::to_string(s.teeth),
           oneDecimal(2 * (nominalRootRadius(s) + 0.5 * s.module))})));
    }
    return;
  }
  if (s.bore > largestBore(s)) {
    found.push_back(rejected(
        translated("The bore of %1 leaves no body below the roots of %2 teeth: make it smaller than %3.",
                   {oneDecimal(s.bore), std::to_string(s.teeth), oneDecimal(largestBore(s))})));
  }
}

Diagnostic tooFew(const GearSpec& spec, int fewest) {
  const std::string teeth = std::to_string(spec.teeth);
  const std::string least = std::to_string(fewest);
  if (spec.kind == GearKind::internal)
    return rejected(translated("%1 teeth are too few for a ring that a rack can generate; use at least %2.",
                               {teeth, least}));
  if (spec.teeth == 1)
    return rejected(
        translated("One tooth is too few for a gear that a rack can generate; use at least %1.", {least}));
  return rejected(translated("%1 teeth are too few for a gear that a rack can generate; use at least %2.",
                             {teeth, least}));
}

}  // namespace

Diagnostics specDiagnostics(const GearSpec& spec) {
  const bool ring = spec.kind == GearKind::internal;
  const int fewest = ring ? kMinRingTeeth : kMinGearTeeth;
  if (spec.teeth < fewest) return {tooFew(spec, fewest)};  // whatever its other numbers are
  if (!numbersAreSane(spec)) {
    return {rejected(
        translated("A gear of %1 teeth has a measure that no tooth can have; module and face width must be "
                   "positive, the pressure angle between 5 and 35 degrees, shift and heights at most 3 "
                   "modules.",
                   {std::to_string(spec.teeth)}))};
  }
  Diagnostics found;
  if (spec.kind == GearKind::bevel) {
    if (!(spec.coneAngle > 0.01 && spec.coneAngle < pi - 0.3)) {
      found.push_back(rejected(translated(
          "The pitch cone of a bevel gear must be between %1 and 163 degrees.", {oneDecimal(0.6)})));
    } else if (spec.faceWidth > 0.7 * coneDistance(spec)) {
      found.push_back(rejected(translated(
          "The face of %1 runs into the apex: make it shorter than %2, a third of the cone distance.",
          {oneDecimal(spec.faceWidth), oneDecimal(coneDistance(spec) / 3)})));
    }
  } else if (spec.kind == GearKind::external && nominalRootRadius(spec) < 0.2 * spec.module) {
    found.push_back(
        rejected(translated("%1 teeth leave no body below the roots; use more, or a larger profile shift.",
                            {std::to_string(spec.teeth)})));
  }
  if (found.empty()) checkBody(spec, found);
  return found;
}

}  // namespace geargraph::inline solids
