#include "core/machine/solids/gear_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace geargraph::inline solids {
namespace {

using std::numbers::pi;

/// Thickness of the body below the roots of bevel teeth, in modules.
constexpr double kBevelBody = 1.2;

/// The faces' planes between the teeth and the bore of a disc of one thickness.
std::vector<ProfileVertex> discProfile(double bore, double width) {
  return {{bore / 2, width / 2}, {bore / 2, -width / 2}};
}

/// Radii of a dressed wheel's web; none where hub and rim leave no room for one.
struct Web {
  double hub = 0;
  double rim = 0;
  double half = 0;  ///< of its thickness
};

std::optional<Web> webOf(const GearSpec& s) {
  if (s.kind != GearKind::external || s.body != GearBody::dressed) return std::nullopt;
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

/// A point of the profile plane at cone distance R, `depth` below the pitch cone measured on back or front
/// cone.
ProfileVertex belowCone(double R, double depth, double delta) {
  return {R * std::sin(delta) - depth * std::cos(delta), R * std::cos(delta) + depth * std::sin(delta)};
}

/// How far below the roots of the small end the body's circle must lie: the chord below a tooth bows towards
/// the axis, by its sagitta on the developed cone, and sinks below the conical face, by the rest of its
/// sagitta.
double frontMargin(const GearSpec& s, double small) {
  const double halfPitch = pi / s.teeth;
  const double sagitta =
      small * std::sin(s.coneAngle) * std::abs(std::cos(s.coneAngle)) * halfPitch * halfPitch / 2;
  return sagitta + 0.15 * s.module;
}

std::vector<ProfileVertex> bevelProfile(const GearSpec& s) {
  const double large = coneDistance(s);
  const double small = large - s.faceWidth;
  const double root = (s.dedendum - s.profileShift) * s.module;
  const double rootSmall = root * small / large;
  ProfileVertex back = belowCone(large, root + kBevelBody * s.module, s.coneAngle);
  ProfileVertex front = belowCone(small, rootSmall + frontMargin(s, small), s.coneAngle);
  if (s.coneAngle > 100 * pi / 180) {  // an internal cone is a ring: its body follows the teeth
    return {back, belowCone(small, rootSmall + kBevelBody * s.module, s.coneAngle)};
  }
  const double bore = s.bore / 2;
  // A steep pinion has no room below its roots for the full thickness.
  const double least = std::max(bore + 0.05 * s.module, 0.2 * s.module);
  if (back.radius < least)
    back = belowCone(large, (large * std::sin(s.coneAngle) - least) / std::cos(s.coneAngle), s.coneAngle);
  return {back, {bore, back.height}, {bore, front.height}, front};
}

}  // namespace

double rimDiameter(const GearSpec& spec) {
  return spec.rim > 0 ? spec.rim : 2 * (nominalRootRadius(spec) + 2 * spec.module);
}

double largestBore(const GearSpec& spec) {
  if (spec.kind != GearKind::bevel) return 2 * (nominalRootRadius(spec) - 0.2 * spec.module);
  const double large = coneDistance(spec);
  const double small = large - spec.faceWidth;
  const double root =
      (spec.dedendum - spec.profileShift) * spec.module * small / large + frontMargin(spec, small);
  return 2 * (belowCone(small, root, spec.coneAngle).radius - 0.1 * spec.module);
}

AxialSpan hubSpan(const GearSpec& spec) {
  AxialSpan span{1e300, -1e300};
  for (const ProfileVertex& c : bodyProfile(spec)) {
    span.low = std::min(span.low, c.height);
    span.high = std::max(span.high, c.height);
  }
  return span;
}

AxialSpan axialSpan(const GearSpec& spec) {
  AxialSpan span = hubSpan(spec);
  if (spec.kind != GearKind::bevel) return span;
  const double large = coneDistance(spec);
  const double small = large - spec.faceWidth;
  const double tip = -(spec.addendum + spec.profileShift) * spec.module;
  const auto include = [&](double height) {
    span.low = std::min(span.low, height);
    span.high = std::max(span.high, height);
  };
  include(belowCone(large, tip, spec.coneAngle).height);
  include(belowCone(small, tip * small / large, spec.coneAngle).height);
  return span;
}

std::vector<ProfileVertex> bevelOutline(const GearSpec& spec) {
  std::vector<ProfileVertex> outline = bodyProfile(spec);
  const double large = coneDistance(spec);
  const double small = large - spec.faceWidth;
  const double tip = -(spec.addendum + spec.profileShift) * spec.module;
  outline.push_back(belowCone(small, tip * small / large, spec.coneAngle));
  outline.push_back(belowCone(large, tip, spec.coneAngle));
  return outline;
}

std::vector<ProfileVertex> bodyProfile(const GearSpec& spec) {
  switch (spec.kind) {
    case GearKind::internal:
      return discProfile(rimDiameter(spec), spec.faceWidth);
    case GearKind::bevel:
      return bevelProfile(spec);
    case GearKind::external:
      break;
  }
  const std::optional<Web> web = webOf(spec);
  return web ? webbedProfile(spec, *web) : discProfile(spec.bore, spec.faceWidth);
}

std::optional<WebWindows> bodyWindows(const GearSpec& spec) {
  const std::optional<Web> web = webOf(spec);
  return web ? windowsFor(web->hub, web->rim, web->half, spec.module) : std::nullopt;
}

}  // namespace geargraph::inline solids
