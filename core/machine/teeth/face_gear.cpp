#include "core/machine/teeth/face_gear.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/foundations/base/contract.h"
#include "core/machine/teeth/sampling.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

using std::numbers::pi;

/// Beyond the innermost radius, where flanks are undercut.
constexpr double kInnerMargin = 1.02;
/// Of the outline of the cutter's fillet, modules.
constexpr double kCutterTolerance = 1e-5;

/// The pinion with the space between its tip and the gear's root filled, and as thick as the gear's play
/// asks.
GearSpec cutterOf(const GearSpec& gear) {
  GearSpec cutter = standardGear(GearKind::external, gear.mateTeeth, 1, 1);
  cutter.pressureAngle = gear.pressureAngle;
  cutter.profileShift = -gear.profileShift;
  cutter.backlashAllowance = -gear.backlashAllowance;
  cutter.addendum = gear.dedendum;
  return cutter;
}

}  // namespace

FaceCut::FaceCut(const GearSpec& spec)
    : m_cutter(cutterOf(spec)),
      m_tooth(externalTooth(m_cutter, kCutterTolerance)),
      m_share(static_cast<double>(spec.mateTeeth) / spec.teeth),
      m_halfPitch(pi / spec.teeth),
      m_tip(spec.mateTeeth / 2.0 - spec.addendum - spec.profileShift),
      m_root(m_tooth.tipRad) {}

double FaceCut::flankAt(double radius) const {
  if (radius >= m_tooth.formRad) return involuteHalfAngle(m_cutter, std::min(radius, m_tooth.tipRad));
  const auto& points = m_tooth.points;
  const auto above =
      std::lower_bound(points.begin(), points.end(), radius,
                       [](const ProfilePoint& point, double wanted) { return point.rad < wanted; });
  if (above == points.begin() || above == points.end()) return m_halfPitch / m_share;
  const ProfilePoint& low = *(above - 1);
  const double part = (radius - low.rad) / std::max(above->rad - low.rad, 1e-300);
  return low.gam + part * (above->gam - low.gam);
}

double FaceCut::halfSpace(double rho, double depth) const {
  const double reach = std::sqrt(std::max(m_root * m_root - depth * depth, 0.0));
  // The cutter's point at this depth and `aside` of its middle plane, and the turn that brings it there.
  const auto cut = [&](double aside) {
    const double turn = std::atan2(aside, depth) - flankAt(std::hypot(aside, depth));
    return std::asin(std::clamp(aside / rho, -1.0, 1.0)) - turn * m_share;
  };
  constexpr int kProbes = 48;
  int best = 0;
  double most = -1e300;
  for (int i = -kProbes; i <= kProbes; ++i) {
    const double value = cut(reach * i / kProbes);
    if (value > most) {
      most = value;
      best = i;
    }
  }
  double low = reach * std::max(best - 1, -kProbes) / kProbes;
  double high = reach * std::min(best + 1, kProbes) / kProbes;
  constexpr double kGolden = 0.6180339887498949;
  double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
  double atLeft = cut(left), atRight = cut(right);
  constexpr int kSteps = 32;
  for (int step = 0; step < kSteps; ++step) {
    if (atLeft > atRight) {
      high = right;
      right = left;
      atRight = atLeft;
      left = high - kGolden * (high - low);
      atLeft = cut(left);
    } else {
      low = left;
      left = right;
      atLeft = atRight;
      right = low + kGolden * (high - low);
      atRight = cut(right);
    }
  }
  return std::max({most, atLeft, atRight});
}

double FaceCut::halfTooth(double rho, double depth) const {
  return m_halfPitch - halfSpace(rho, depth);
}

double faceInner(const GearSpec& spec) {
  return kInnerMargin * pitchRadius(spec) * std::cos(spec.pressureAngle);
}

double faceOuter(const GearSpec& spec) {
  const FaceCut cut(spec);
  const auto land = [&](double rho) { return 2 * rho * cut.halfTooth(rho, cut.tipDepth()) - kNarrowestLand; };
  const double inner = faceInner(spec) / spec.module;
  double outer = inner;
  constexpr double kStep = 1.02;
  constexpr double kFarthest = 1.6;
  while (outer < kFarthest * inner && land(outer * kStep) > 0) outer *= kStep;
  return spec.module * bisect(outer, outer * kStep, land);
}

double usualFaceGearFace(const GearSpec& spec) {
  return faceOuter(spec) - faceInner(spec);
}

HalfTooth faceTooth(const GearSpec& spec, double tolerance) {
  GearSpec flat = standardGear(GearKind::external, spec.teeth, 1, 1);
  flat.pressureAngle = spec.pressureAngle;
  flat.profileShift = spec.profileShift;
  flat.backlashAllowance = spec.backlashAllowance;
  return externalTooth(flat, tolerance);
}

double faceContactRatio(const GearSpec& a, const HalfTooth& /*toothA*/, const GearSpec& b,
                        const HalfTooth& toothB, double /*distance*/) {
  const double radius = b.teeth / 2.0;
  const double base = radius * std::cos(b.pressureAngle);
  const double atPitchPoint = radius * std::sin(b.pressureAngle);
  const auto roll = [&](double rad) { return std::sqrt(std::max(rad * rad - base * base, 0.0)); };
  const double toTip = (a.addendum + a.profileShift) / std::sin(b.pressureAngle);
  const double recess = roll(toothB.tipRad) - atPitchPoint;
  const double approach = std::min(toTip, atPitchPoint - roll(toothB.formRad));
  return (recess + approach) / (pi * std::cos(b.pressureAngle));
}

}  // namespace geargraph
