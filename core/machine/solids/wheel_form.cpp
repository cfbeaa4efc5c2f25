#include "core/machine/solids/wheel_form.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/translation.h"

namespace geargraph {

KindTable<GearKind, WheelForm>& wheelForms() {
  static constinit KindTable<GearKind, WheelForm> table(&kDiscForm, &kRingForm, &kConeForm, &kPulleyForm,
                                                        &kWormForm, &kWormWheelForm, &kFaceForm,
                                                        &kSmoothConeForm);
  return table;
}

const WheelForm& wheelForm(const GearSpec& spec) {
  return wheelForms()[spec.kind];
}

bool isSameCorner(const HalfTooth& tooth, std::size_t i) {
  return i > 0 && tooth.points[i].rad == tooth.points[i - 1].rad &&
         tooth.points[i].gam == tooth.points[i - 1].gam;
}

std::vector<OutlinePoint> cylinderFaces(const HalfTooth& tooth, const GearSpec& spec) {
  std::vector<OutlinePoint> outline;
  outline.reserve(tooth.points.size());
  for (std::size_t i = 0; i < tooth.points.size(); ++i) {
    const ProfilePoint& p = tooth.points[i];
    const double c = std::cos(p.gam);
    const double s = std::sin(p.gam);
    const double r = p.rad * spec.module;
    const Eigen::Vector3d normal(p.normalRad * c - p.normalGam * s, p.normalRad * s + p.normalGam * c, 0);
    outline.push_back({{r * c, r * s, -spec.faceWidth / 2},
                       {r * c, r * s, spec.faceWidth / 2},
                       normal,
                       -Eigen::Vector3d::UnitZ(),
                       Eigen::Vector3d::UnitZ(),
                       isSameCorner(tooth, i)});
  }
  return outline;
}

std::vector<ProfileVertex> discProfile(double diameter, double width) {
  return {{diameter / 2, width / 2}, {diameter / 2, -width / 2}};
}

AxialSpan spanOf(std::span<const ProfileVertex> profile) {
  AxialSpan span{1e300, -1e300};
  for (const ProfileVertex& c : profile) {
    span.low = std::min(span.low, c.height);
    span.high = std::max(span.high, c.height);
  }
  return span;
}

std::vector<ProfileVertex> discOutline(const GearSpec& spec) {
  std::vector<ProfileVertex> outline = bodyProfile(spec);
  const double tip = nominalTipRadius(spec);
  outline.push_back({tip, outline.back().height});
  outline.push_back({tip, outline.front().height});
  return outline;
}

Diagnostic specRejection(std::string message) {
  return {Code::teethGeometry, std::move(message), {}, {}, 0, 0};
}

std::string oneDecimal(double value) {
  const auto tenths = static_cast<long long>(std::llround(value * 10));
  return std::string(tenths < 0 ? "-" : "") + std::to_string(std::abs(tenths) / 10) + decimalSign() +
         std::to_string(std::abs(tenths) % 10);
}

void checkBore(const GearSpec& spec, Diagnostics& found) {
  if (spec.bore <= largestBore(spec)) return;
  found.push_back(specRejection(
      translated("The bore of %1 leaves no body below the roots of %2 teeth: make it smaller than %3.",
                 {oneDecimal(spec.bore), std::to_string(spec.teeth), oneDecimal(largestBore(spec))})));
}

std::string tooFewForRack(const GearSpec& spec, int fewest) {
  const std::string least = std::to_string(fewest);
  if (spec.teeth == 1)
    return translated("One tooth is too few for a gear that a rack can generate; use at least %1.", {least});
  return translated("%1 teeth are too few for a gear that a rack can generate; use at least %2.",
                    {std::to_string(spec.teeth), least});
}

}  // namespace geargraph
