#include "core/machine/solids/spec_findings.h"

#include <cmath>
#include <numbers>
#include <string>

#include "core/machine/solids/gear_body.h"

namespace geargraph::inline solids {
namespace {

using std::numbers::pi;

std::string oneDecimal(double value) {
  const auto tenths = static_cast<long long>(std::llround(value * 10));
  return std::string(tenths < 0 ? "-" : "") + std::to_string(std::abs(tenths) / 10) + "." +
         std::to_string(std::abs(tenths) % 10);
}

Diagnostic refused(std::string message) {
  return {Code::teethGeometry, std::move(message), {}, {}, 0, 0};
}

/// Numbers that no formula below survives; checked first.
bool numbersAreSane(const GearSpec& s) {
  const auto positive = [](double v) { return std::isfinite(v) && v > 0; };
  const auto notNegative = [](double v) { return std::isfinite(v) && v >= 0; };
  return positive(s.module) && positive(s.faceWidth) && s.pressureAngle > 0.08 && s.pressureAngle < 0.62 &&
         std::isfinite(s.profileShift) && notNegative(s.thinning) && s.thinning < 0.5 &&
         positive(s.addendum) && positive(s.dedendum) && notNegative(s.rootRadius) &&
         notNegative(s.tipRadius) && notNegative(s.bore) && notNegative(s.rim) && notNegative(s.hub) &&
         std::abs(s.profileShift) <= 3 && s.addendum <= 3 && s.dedendum <= 3;
}

void checkBody(const GearSpec& s, Diagnostics& found) {
  if (s.kind == GearKind::internal) {
    if (s.rim > 0 && s.rim / 2 < nominalRootRadius(s) + 0.1 * s.module) {
      found.push_back(refused("The rim of " + oneDecimal(s.rim) +
                              " does not reach past the roots of the ring's " + std::to_string(s.teeth) +
                              " teeth: make it larger than " +
                              oneDecimal(2 * (nominalRootRadius(s) + 0.5 * s.module)) + "."));
    }
    return;
  }
  if (s.bore > largestBore(s)) {
    found.push_back(refused("The bore of " + oneDecimal(s.bore) + " leaves no body below the roots of " +
                            std::to_string(s.teeth) + " teeth: make it smaller than " +
                            oneDecimal(largestBore(s)) + "."));
  }
}

}  // namespace

Diagnostics specDiagnostics(const GearSpec& spec) {
  if (!numbersAreSane(spec)) {
    return {
        refused("A gear of " + std::to_string(spec.teeth) +
                " teeth has a measure that no tooth can have; module and face width must be positive, the "
                "pressure angle between 5 and 35 degrees, shift and heights at most 3 modules.")};
  }
  Diagnostics found;
  const bool ring = spec.kind == GearKind::internal;
  const int fewest = ring ? kFewestRingTeeth : kFewestGearTeeth;
  if (spec.teeth < fewest) {
    found.push_back(refused(std::to_string(spec.teeth) + " teeth are too few for " +
                            (ring ? "a ring" : "a gear") + " that a rack can generate; use at least " +
                            std::to_string(fewest) + "."));
  } else if (spec.kind == GearKind::bevel) {
    if (!(spec.coneAngle > 0.01 && spec.coneAngle < pi - 0.3)) {
      found.push_back(refused("The pitch cone of a bevel gear must be between 0.6 and 163 degrees."));
    } else if (spec.faceWidth > 0.7 * coneDistance(spec)) {
      found.push_back(refused("The face of " + oneDecimal(spec.faceWidth) +
                              " runs into the apex: make it shorter than " +
                              oneDecimal(coneDistance(spec) / 3) + ", a third of the cone distance."));
    }
  } else if (spec.kind == GearKind::external && nominalRootRadius(spec) < 0.2 * spec.module) {
    found.push_back(refused(std::to_string(spec.teeth) +
                            " teeth leave no body below the roots; use more, or a larger "
                            "profile shift."));
  }
  if (found.empty()) checkBody(spec, found);
  return found;
}

}  // namespace geargraph::inline solids
