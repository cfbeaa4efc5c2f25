#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/foundations/base/translation.h"
#include "core/machine/solids/part_solids.h"
#include "core/machine/solids/wheel_form.h"

// A bevel: its teeth on a pitch cone, its body behind them.

namespace geargraph {
namespace {

using std::numbers::pi;

/// Thickness of the body below the roots of bevel teeth, in modules.
constexpr double kBevelBody = 1.2;

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

std::vector<ProfileVertex> coneBody(const GearSpec& s) {
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

std::optional<WebWindows> coneWindows(const GearSpec& /*spec*/) {
  return std::nullopt;
}

/// The tips at the small end and at the large one.
std::array<ProfileVertex, 2> coneTips(const GearSpec& spec) {
  const double large = coneDistance(spec);
  const double small = large - spec.faceWidth;
  const double tip = -(spec.addendum + spec.profileShift) * spec.module;
  return {belowCone(small, tip * small / large, spec.coneAngle), belowCone(large, tip, spec.coneAngle)};
}

std::vector<ProfileVertex> coneOutline(const GearSpec& spec) {
  std::vector<ProfileVertex> outline = coneBody(spec);
  for (const ProfileVertex& tip : coneTips(spec)) outline.push_back(tip);
  return outline;
}

AxialSpan coneSpan(const GearSpec& spec) {
  return spanOf(coneOutline(spec));
}

double largestConeBore(const GearSpec& spec) {
  const double large = coneDistance(spec);
  const double small = large - spec.faceWidth;
  const double root =
      (spec.dedendum - spec.profileShift) * spec.module * small / large + frontMargin(spec, small);
  return 2 * (belowCone(small, root, spec.coneAngle).radius - 0.1 * spec.module);
}

/// The rays of the tooth from the apex, cut by the back cone and the front cone.
std::vector<OutlinePoint> coneFaces(const HalfTooth& tooth, const GearSpec& spec) {
  using Eigen::Vector3d;
  const double large = coneDistance(spec);
  const double small = large - spec.faceWidth;
  std::vector<OutlinePoint> outline;
  outline.reserve(tooth.points.size());
  for (std::size_t i = 0; i < tooth.points.size(); ++i) {
    const ProfilePoint& p = tooth.points[i];
    const double c = std::cos(p.gam);
    const double s = std::sin(p.gam);
    const double sc = std::sin(p.rad);
    const double cc = std::cos(p.rad);
    const Vector3d ray = Vector3d(sc * c, sc * s, cc) / std::cos(p.rad - spec.coneAngle);
    const Vector3d alongRad(cc * c, cc * s, -sc);
    const Vector3d alongGam(-s, c, 0);
    const Vector3d back(std::sin(spec.coneAngle) * c, std::sin(spec.coneAngle) * s, std::cos(spec.coneAngle));
    outline.push_back({ray * small, ray * large, alongRad * p.normalRad + alongGam * p.normalGam, -back, back,
                       isSameCorner(tooth, i)});
  }
  return outline;
}

/// Sections of spiral teeth: at equal turns, so near that no chord along the tips is off by more than
/// `chord`. A point is turned by what its own distance from the apex asks, because each sphere about the apex
/// has its own pair of conjugate profiles.
std::vector<std::vector<WallPoint>> spiralSections(const std::vector<OutlinePoint>& half,
                                                   const GearSpec& spec, double chord) {
  if (spec.helixAngle == 0) return {};
  const double large = coneDistance(spec), small = large - spec.faceWidth;
  const double reach = std::max(nominalTipRadius(spec), nominalRootRadius(spec));
  const double bend = 1 / reach + 1 / (large * std::sin(std::abs(spec.helixAngle)));
  const double turn = std::abs(spiralOf(spec, small));
  const int steps = std::max(1, static_cast<int>(std::ceil(turn * reach * std::sqrt(bend / (8 * chord)))));
  std::vector<std::vector<WallPoint>> sections;
  for (int i = 0; i <= steps; ++i) {
    const double distance = small * std::pow(large / small, static_cast<double>(i) / steps);
    const double part = (distance - small) / (large - small);
    std::vector<WallPoint>& section = sections.emplace_back();
    section.reserve(half.size());
    for (const OutlinePoint& p : half) {
      const Eigen::Vector3d at = i == steps ? p.top : Eigen::Vector3d(p.bottom + part * (p.top - p.bottom));
      const double sphere = at.norm();
      const double slope = std::tan(spec.helixAngle) / std::sin(spec.coneAngle) / (sphere * sphere);
      section.push_back({at, p.wallNormal, spiralOf(spec, sphere), slope * at});
    }
  }
  return sections;
}

/// The measures of a cone without teeth: its pitch cone.
GearSpec smooth(GearSpec spec) {
  spec.addendum = 0;
  spec.dedendum = 0;
  spec.profileShift = 0;
  return spec;
}

std::vector<ProfileVertex> smoothConeBody(const GearSpec& spec) {
  return coneBody(smooth(spec));
}

std::vector<ProfileVertex> smoothConeOutline(const GearSpec& spec) {
  return coneOutline(smooth(spec));
}

AxialSpan smoothConeSpan(const GearSpec& spec) {
  return coneSpan(smooth(spec));
}

double largestSmoothBore(const GearSpec& spec) {
  return largestConeBore(smooth(spec));
}

Solid smoothCone(const GearSpec& spec, double chord) {
  return revolved(smoothConeOutline(spec), chord);
}

Solid toothlessCone(const GearSpec& spec, double chord) {
  return revolved(coneOutline(spec), chord);
}

void checkCone(const GearSpec& spec, Diagnostics& found) {
  if (!(spec.coneAngle > 0.01 && spec.coneAngle < pi - 0.3)) {
    found.push_back(specRejection(
        translated("The pitch cone of a bevel gear must be between %1 and 163 degrees.", {oneDecimal(0.6)})));
  } else if (spec.faceWidth > 0.7 * coneDistance(spec)) {
    found.push_back(specRejection(translated(
        "The face of %1 runs into the apex: make it shorter than %2, a third of the cone distance.",
        {oneDecimal(spec.faceWidth), oneDecimal(coneDistance(spec) / 3)})));
  }
}

}  // namespace

constexpr WheelForm kConeForm{.body = coneBody,
                              .windows = coneWindows,
                              .outline = coneOutline,
                              .span = coneSpan,
                              .largestBore = largestConeBore,
                              .toothFaces = coneFaces,
                              .sections = spiralSections,
                              .toothless = toothlessCone,
                              .check = checkCone,
                              .checkBody = checkBore,
                              .tooFewTeeth = tooFewForRack};

constexpr WheelForm kSmoothConeForm{.body = smoothConeBody,
                                    .windows = coneWindows,
                                    .outline = smoothConeOutline,
                                    .span = smoothConeSpan,
                                    .largestBore = largestSmoothBore,
                                    .toothless = smoothCone,
                                    .check = checkCone,
                                    .checkBody = checkBore,
                                    .tooFewTeeth = tooFewForRack};

}  // namespace geargraph
