#include <string>

#include "core/foundations/base/translation.h"
#include "core/machine/solids/part_solids.h"
#include "core/machine/solids/wheel_form.h"

// A ring: its teeth inside, its body outside of them.

namespace geargraph {
namespace {

std::vector<ProfileVertex> ringBody(const GearSpec& spec) {
  return discProfile(rimDiameter(spec), spec.faceWidth);
}

std::optional<WebWindows> ringWindows(const GearSpec& /*spec*/) {
  return std::nullopt;
}

AxialSpan ringSpan(const GearSpec& spec) {
  return spanOf(ringBody(spec));
}

double largestRingBore(const GearSpec& spec) {
  return 2 * (nominalRootRadius(spec) - 0.2 * spec.module);
}

Solid toothlessRing(const GearSpec& spec, double chord) {
  const double pitch = spec.teeth * spec.module / 2, half = spec.faceWidth / 2;
  return tube(rimDiameter(spec) / 2, pitch, -half, half, chord);
}

void checkRing(const GearSpec& /*spec*/, Diagnostics& /*found*/) {}

void checkRim(const GearSpec& spec, Diagnostics& found) {
  if (spec.rim <= 0 || spec.rim / 2 >= nominalRootRadius(spec) + 0.1 * spec.module) return;
  found.push_back(specRejection(translated(
      "The rim of %1 does not reach past the roots of the ring's %2 teeth: make it larger than %3.",
      {oneDecimal(spec.rim), std::to_string(spec.teeth),
       oneDecimal(2 * (nominalRootRadius(spec) + 0.5 * spec.module))})));
}

std::string tooFewInRing(const GearSpec& spec, int fewest) {
  return translated("%1 teeth are too few for a ring that a rack can generate; use at least %2.",
                    {std::to_string(spec.teeth), std::to_string(fewest)});
}

}  // namespace

constexpr WheelForm kRingForm{.body = ringBody,
                              .windows = ringWindows,
                              .outline = discOutline,
                              .span = ringSpan,
                              .largestBore = largestRingBore,
                              .toothFaces = cylinderFaces,
                              .toothless = toothlessRing,
                              .check = checkRing,
                              .checkBody = checkRim,
                              .tooFewTeeth = tooFewInRing};

}  // namespace geargraph
