#include <cmath>
#include <numbers>

#include "core/foundations/base/contract.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/involute.h"
#include "core/machine/teeth/sampling.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

using std::numbers::pi;

/// The ring's space, which is the tooth of an external gear; angles are measured from the space's centre
/// line.
struct RingSpace {
  double rb, psiB, rf, ra;
  double rho = 0;          ///< fillet radius
  double tangent = 0;      ///< roll parameter t at which the fillet meets the flank
  double filletAngle = 0;  ///< of the fillet's centre
  explicit RingSpace(const GearSpec& spec);

  [[nodiscard]] double angleAt(double t) const { return psiB - (t - std::atan(t)); }
  [[nodiscard]] double rollOf(double rad) const {
    return std::sqrt(std::max(rad * rad / (rb * rb) - 1, 0.0));
  }

 private:
  /// The parallel of an involute at distance rho is the same involute turned by rho/rb.
  [[nodiscard]] double centreAngle(double radius) const {
    const double t = rollOf(rf - radius);
    return psiB - radius / rb - (t - std::atan(t));
  }
};

RingSpace::RingSpace(const GearSpec& spec) {
  const double rp = spec.teeth / 2.0;
  rb = rp * std::cos(spec.pressureAngle);
  const double space = pi / 2 + 2 * spec.profileShift * std::tan(spec.pressureAngle) + spec.backlashAllowance;
  psiB = space / spec.teeth + involute(spec.pressureAngle);
  rf = rp + spec.dedendum + spec.profileShift;
  // A space that would close before the root circle is cut less deep.
  const auto width = [&](double rad) { return 2 * rad * angleAt(rollOf(rad)) - kNarrowestLand; };
  if (width(rf) < 0) rf = bisect(rp, rf, width);
  ra = std::max(spec.tipRadius > 0 ? spec.tipRadius : rp - spec.addendum + spec.profileShift, rb);
  rho = std::min(spec.rootRadius, 0.5 * (rf - ra));
  if (centreAngle(rho) < 0) rho = bisect(0, rho, [&](double r) { return centreAngle(r); });
  filletAngle = std::max(centreAngle(rho), 0.0);
  tangent = rollOf(rf - rho) + rho / rb;
}

void addFillet(const RingSpace& s, double halfPitch, double tolerance, HalfTooth& tooth) {
  const int roots = s.filletAngle * s.rf > kShortestArc ? chordsOfArc(s.filletAngle, s.rf, tolerance) : 0;
  for (int i = 0; i < roots; ++i) {
    tooth.points.push_back({s.rf, halfPitch - s.filletAngle * i / roots, -1, 0});
  }
  const double rc = s.rf - s.rho;
  const double rP = s.rb * std::sqrt(1 + s.tangent * s.tangent);
  const double turn = s.angleAt(s.tangent) - s.filletAngle;
  const double end = std::atan2(rP * std::sin(turn), rP * std::cos(turn) - rc);
  const int n = chordsOfArc(end, s.rho, tolerance);
  for (int i = 0; i < n; ++i) {
    const double beta = end * i / n;
    const double along = rc + s.rho * std::cos(beta);
    const double across = s.rho * std::sin(beta);
    const double angle = std::atan2(across, along);
    // The normal runs to the fillet's centre; space angles grow against gam.
    tooth.points.push_back({std::hypot(along, across), halfPitch - s.filletAngle - angle,
                            -std::cos(beta - angle), std::sin(beta - angle)});
  }
  if (!tooth.points.empty()) tooth.points.front().gam = halfPitch;
}

}  // namespace

HalfTooth ringTooth(const GearSpec& spec, double tolerance) {
  GEARGRAPH_REQUIRE(isRing(spec));
  const RingSpace s(spec);
  const double halfPitch = pi / spec.teeth;
  HalfTooth tooth;
  addFillet(s, halfPitch, tolerance, tooth);

  const double t0 = s.rollOf(s.ra);
  const double from = std::pow(s.tangent, 1.5);
  const double to = std::pow(t0, 1.5);
  const int n = std::max(
      1,
      static_cast<int>(std::ceil(2.0 / 3 * std::sqrt(s.rb / (8 * kFlankShare * tolerance)) * (from - to))));
  for (int i = 0; i <= n; ++i) {
    const double power = from + (to - from) * i / n;
    const double t = i == 0 ? s.tangent : i == n ? t0 : std::cbrt(power * power);
    const double h = std::sqrt(1 + t * t);
    tooth.points.push_back({s.rb * h, halfPitch - s.angleAt(t), -t / h, 1 / h});
  }
  const ProfilePoint corner = tooth.points.back();
  const int tips = chordsOfArc(corner.gam, corner.rad, tolerance);
  for (int i = 0; i <= tips; ++i)
    tooth.points.push_back({corner.rad, corner.gam * (static_cast<double>(tips - i) / tips), -1, 0});
  tooth.rootRad = s.rf;
  tooth.formRad = s.rb * std::sqrt(1 + s.tangent * s.tangent);
  tooth.tipRad = corner.rad;
  tooth.tipHalfAngle = corner.gam;
  return tooth;
}

}  // namespace geargraph
