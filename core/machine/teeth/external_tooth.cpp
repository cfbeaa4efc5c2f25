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

struct Plane {
  double x = 0;
  double y = 0;
};

/// Everything of the tooth that the sampling needs, lengths in modules. Symbols as in README.md, section 1.
struct Generation {
  double rp, rb, psiB;        ///< pitch and base radius, half angle of the tooth at the base circle
  double alpha, ra;           ///< pressure angle, tip
  double etaC, xiC, rho, rf;  ///< centre and radius of the rack's tip corner, root radius
  int teeth;
  explicit Generation(const GearSpec& spec);

  /// Half angle of the involute at t = tan of its pressure angle.
  [[nodiscard]] double flankAngle(double t) const { return psiB - (t - std::atan(t)); }
  [[nodiscard]] double rollOf(double rad) const {
    return std::sqrt(std::max(rad * rad / (rb * rb) - 1, 0.0));
  }
};

/// At the pitch circle, in modules.
double toothThickness(const GearSpec& spec) {
  return pi / 2 + 2 * spec.profileShift * std::tan(spec.pressureAngle) - spec.backlashAllowance;
}

/// Distance of the centre of the rack's tip corner from the tooth's centre line, along the pitch line.
double cornerCentre(double thickness, double depth, double rho, double alpha) {
  return thickness / 2 + (rho - (rho - depth) * std::sin(alpha)) / std::cos(alpha);
}

Generation::Generation(const GearSpec& spec) {
  teeth = spec.teeth;
  alpha = spec.pressureAngle;
  rp = teeth / 2.0;
  rb = rp * std::cos(alpha);
  const double s = toothThickness(spec);
  psiB = s / teeth + involute(alpha);
  ra = spec.tipRadius > 0 ? spec.tipRadius : rp + spec.addendum + spec.profileShift;
  rho = rackCornerRadius(spec);
  const double depth = spec.dedendum - spec.profileShift;  // of the rack's tip below the pitch line
  etaC = rho - depth;
  xiC = std::min(cornerCentre(s, depth, rho, alpha), pi / 2);
  rf = rp - depth;
}

/// The trochoid of the rounded corner at w, the direction from the pitch point to the corner's centre.
ProfilePoint trochoid(const Generation& g, double w) {
  const double d = -g.etaC / std::sin(w);
  const double reach = d + g.rho;
  const double px = -reach * std::cos(w);
  const double py = g.rp - reach * std::sin(w);
  const double rad = std::hypot(px, py);
  const double roll = (-d * std::cos(w) - g.xiC) / g.rp;
  // Outward normal (cos w, sin w), towards the pitch point, split along (px, py) and across it.
  return {rad, std::atan2(px, py) - roll, (px * std::cos(w) + py * std::sin(w)) / rad,
          (py * std::cos(w) - px * std::sin(w)) / rad};
}

ProfilePoint flankPoint(const Generation& g, double t) {
  const double h = std::sqrt(1 + t * t);
  return {g.rb * h, g.flankAngle(t), t / h, 1 / h};
}

/// The trochoid's parameter at which it crosses the involute of an undercut tooth.
double undercutParameter(const Generation& g) {
  const double onBase = bisect(g.alpha, pi / 2, [&](double w) { return trochoid(g, w).rad - g.rb; });
  return bisect(g.alpha, onBase, [&](double w) {
    const ProfilePoint p = trochoid(g, w);
    return p.gam - g.flankAngle(g.rollOf(p.rad));
  });
}

/// Lowers the tip until the land is wide enough. The land shrinks as the tip rises.
bool shortenTip(Generation& g, double formRad) {
  const auto land = [&](double rad) { return 2 * rad * g.flankAngle(g.rollOf(rad)) - kNarrowestLand; };
  if (land(g.ra) >= 0) return false;
  if (land(formRad) > 0) g.ra = bisect(formRad, g.ra, land);
  return true;
}

void addRoot(const Generation& g, double wF, double tolerance, HalfTooth& tooth) {
  const double rootAngle = g.xiC / g.rp;
  const double arc = pi / g.teeth - rootAngle;
  if (arc * g.rf > kShortestArc) {
    const int n = chordsOfArc(arc, g.rf, tolerance);
    for (int i = 0; i < n; ++i) tooth.points.push_back({g.rf, pi / g.teeth - arc * i / n, 1, 0});
  }
  const auto curve = [&](double w) {
    const ProfilePoint p = trochoid(g, w);
    return Plane{p.rad * std::cos(p.gam), p.rad * std::sin(p.gam)};
  };
  for (const double w : equalSagitta(pi / 2, wF, tolerance, curve)) tooth.points.push_back(trochoid(g, w));
  tooth.points.front().gam = pi / g.teeth;  // exactly: the next tooth begins here
}

/// Equal sagitta: t uniform in t^1.5, because ds = rb t dt and dtheta = dt.
void addFlank(const Generation& g, double t0, double t1, double tolerance, bool joined, HalfTooth& tooth) {
  const double from = t0 * std::sqrt(t0);
  const double to = t1 * std::sqrt(t1);
  const int n =
      std::max(1, static_cast<int>(std::ceil(2.0 / 3 * std::sqrt(g.rb / (8 * tolerance)) * (to - from))));
  if (joined) tooth.points.pop_back();  // the trochoid's end is the flank's begin, with the same normal
  for (int i = 0; i < n; ++i) {
    const double power = from + (to - from) * i / n;
    tooth.points.push_back(flankPoint(g, i == 0 ? t0 : std::cbrt(power * power)));
  }
  tooth.points.push_back(flankPoint(g, t1));
}

}  // namespace

double rackCornerRadius(const GearSpec& spec) {
  const double depth = spec.dedendum - spec.profileShift, alpha = spec.pressureAngle;
  const double thickness = toothThickness(spec);
  // Both corners of the rack's tooth share half a pitch.
  if (cornerCentre(thickness, depth, spec.rootRadius, alpha) <= pi / 2) return spec.rootRadius;
  const double room =
      ((pi - thickness) / 2 * std::cos(alpha) - depth * std::sin(alpha)) / (1 - std::sin(alpha));
  return std::max(room, 0.0);
}

double involuteHalfAngle(const GearSpec& spec, double rad) {
  const Generation g(spec);
  return g.flankAngle(g.rollOf(rad));
}

HalfTooth externalTooth(const GearSpec& spec, double tolerance) {
  GEARGRAPH_REQUIRE(isDisc(spec));
  Generation g(spec);
  HalfTooth tooth;
  // Where the flank ends, measured along the line of action from the base circle; below it the rack
  // undercuts.
  double t0 = (g.rp * std::sin(g.alpha) + g.etaC / std::sin(g.alpha) - g.rho) / g.rb;
  double wF = g.alpha;
  tooth.undercut = t0 < 0;
  if (tooth.undercut) {
    wF = undercutParameter(g);
    t0 = g.rollOf(trochoid(g, wF).rad);
  }
  tooth.formRad = g.rb * std::sqrt(1 + t0 * t0);
  tooth.shortened = shortenTip(g, tooth.formRad);
  const double t1 = std::max(g.rollOf(g.ra), t0 + 1e-6);

  addRoot(g, wF, tolerance, tooth);
  if (tooth.undercut) {  // one position for both sides of the corner
    tooth.points.back().rad = tooth.formRad;
    tooth.points.back().gam = g.flankAngle(t0);
  }
  addFlank(g, t0, t1, tolerance * kFlankShare, !tooth.undercut, tooth);

  const ProfilePoint corner = tooth.points.back();
  const int n = chordsOfArc(corner.gam, corner.rad, tolerance);
  for (int i = 0; i <= n; ++i)
    tooth.points.push_back({corner.rad, corner.gam * (static_cast<double>(n - i) / n), 1, 0});
  tooth.rootRad = g.rf;
  tooth.tipRad = corner.rad;
  tooth.tipHalfAngle = corner.gam;
  return tooth;
}

}  // namespace geargraph
