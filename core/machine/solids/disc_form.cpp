#include <algorithm>
#include <cmath>
#include <string>

#include "core/foundations/base/translation.h"
#include "core/machine/solids/part_solids.h"
#include "core/machine/solids/wheel_form.h"

// A wheel with its teeth outside, on parallel axes.

namespace geargraph {
namespace {

/// Radii of a dressed wheel's web; none where hub and rim leave no room for one.
struct Web {
  double hub = 0;
  double rim = 0;
  double half = 0;  ///< of its thickness
};

std::optional<Web> webOf(const GearSpec& s) {
  if (s.body != GearBody::dressed) return std::nullopt;
  const double rim = nominalRootRadius(s) - 2 * s.module;
  const double bore = s.bore / 2;
  const double hub =
      s.hub > 0 ? s.hub / 2 : (bore > 0 ? std::max(1.6 * bore, bore + 1.2 * s.module) : 0.25 * rim);
  if (rim - hub < 2.5 * s.module) return std::nullopt;
  return Web{hub, rim, 0.2 * s.faceWidth};
}

std::vector<ProfileVertex> webbedProfile(const GearSpec& s, const Web& web) {
  const double face = s.faceWidth / 2;
  const double bore = s.bore / 2;
  return {{web.rim, face}, {web.rim, web.half}, {web.hub, web.half},  {web.hub, face},      {bore, face},
          {bore, -face},   {web.hub, -face},    {web.hub, -web.half}, {web.rim, -web.half}, {web.rim, -face}};
}

void checkDisc(const GearSpec& spec, Diagnostics& found) {
  if (nominalRootRadius(spec) >= 0.2 * spec.module) return;
  found.push_back(
      specRejection(translated("%1 teeth leave no body below the roots; use more, or a larger profile shift.",
                               {std::to_string(spec.teeth)})));
}

Solid smoothDisc(const GearSpec& spec, double chord) {
  const double surface = nominalTipRadius(spec), half = spec.faceWidth / 2;
  std::vector<ProfileVertex> outline = bodyProfile(spec);
  outline.push_back({surface, -half});
  outline.push_back({surface, half});
  return revolved(outline, chord);
}

void checkNothing(const GearSpec& /*spec*/, Diagnostics& /*found*/) {}

}  // namespace

std::vector<ProfileVertex> discBody(const GearSpec& spec) {
  const std::optional<Web> web = webOf(spec);
  return web ? webbedProfile(spec, *web) : discProfile(spec.bore, spec.faceWidth);
}

std::optional<WebWindows> discWindows(const GearSpec& spec) {
  const std::optional<Web> web = webOf(spec);
  return web ? windowsFor(web->hub, web->rim, web->half, spec.module) : std::nullopt;
}

AxialSpan discSpan(const GearSpec& spec) {
  return spanOf(discBody(spec));
}

double largestDiscBore(const GearSpec& spec) {
  return 2 * (nominalRootRadius(spec) - 0.2 * spec.module);
}

Solid toothlessDisc(const GearSpec& spec, double chord) {
  const double pitch = spec.teeth * spec.module / 2, half = spec.faceWidth / 2;
  std::vector<ProfileVertex> outline = bodyProfile(spec);
  outline.push_back({pitch, -half});
  outline.push_back({pitch, half});
  return revolved(outline, chord);
}

constexpr WheelForm kPulleyForm{.body = discBody,
                                .windows = discWindows,
                                .outline = discOutline,
                                .span = discSpan,
                                .largestBore = largestDiscBore,
                                .toothless = smoothDisc,
                                .check = checkNothing,
                                .checkBody = checkBore,
                                .tooFewTeeth = tooFewForRack};

constexpr WheelForm kDiscForm{.body = discBody,
                              .windows = discWindows,
                              .outline = discOutline,
                              .span = discSpan,
                              .largestBore = largestDiscBore,
                              .toothFaces = cylinderFaces,
                              .toothless = toothlessDisc,
                              .check = checkDisc,
                              .checkBody = checkBore,
                              .tooFewTeeth = tooFewForRack};

}  // namespace geargraph
