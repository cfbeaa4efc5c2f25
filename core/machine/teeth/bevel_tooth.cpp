#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "core/foundations/base/contract.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/sampling.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

struct Flat {
  double x = 0;
  double y = 0;
};

/// The crown rack in the fixed frame of README.md, section 3: pitch point on X, crown axis Z, gear axis
/// k = (cos d, 0, -sin d). Angles in radians on the unit sphere; mu is one module.
struct CrownRack {
  double delta, alpha, mu;
  double cosDelta, sinDelta, cosAlpha, sinAlpha;
  double psiB;       ///< the flank touches the base cone at psi = -psiB
  double amplitude;  ///< cos(colatitude) = amplitude * cos(psi + psiB) along the flank
  double lam0;       ///< half tooth on the crown's equator
  double tip, root;  ///< colatitudes
  double etaC, rho;  ///< latitude and radius of the rack's rounded tip corner
  double lamC = 0;   ///< its longitude
  double psiF = 0;   ///< where its circle leaves the rack's flank
  double halfPitch;  ///< pi / z
  explicit CrownRack(const GearSpec& spec);

  [[nodiscard]] ProfilePoint flank(double psi) const;
  [[nodiscard]] ProfilePoint trochoid(double w) const;
  [[nodiscard]] double psiAt(double colatitude) const {
    const double cosine = std::cos(colatitude);
    return std::atan2(std::sqrt(std::max(amplitude * amplitude - cosine * cosine, 0.0)), cosine) - psiB;
  }
  void placeCorner(double radius);

  /// Colatitude and azimuth of the point at `reach` on the line of action, rolled by what brings psi into
  /// contact.
  [[nodiscard]] ProfilePoint onLineOfAction(double reach, double psi) const {
    const double c = std::cos(reach);
    const double s = std::sin(reach);
    return inGear({c, cosAlpha * s, sinAlpha * s}, {-s, cosAlpha * c, sinAlpha * c},
                  (psi / cosAlpha - lam0) / sinDelta);
  }

 private:
  [[nodiscard]] ProfilePoint inGear(const Vector3d& point, const Vector3d& normal, double roll) const;
};

CrownRack::CrownRack(const GearSpec& spec) {
  delta = spec.coneAngle;
  alpha = spec.pressureAngle;
  mu = 2 * std::sin(delta) / spec.teeth;
  cosDelta = std::cos(delta);
  sinDelta = std::sin(delta);
  cosAlpha = std::cos(alpha);
  sinAlpha = std::sin(alpha);
  psiB = std::atan2(sinAlpha * sinDelta, cosDelta);
  amplitude = std::hypot(sinAlpha * sinDelta, cosDelta);
  lam0 = (pi / 4 + spec.profileShift * std::tan(alpha) - spec.backlashAllowance / 2) * mu;
  tip = delta + std::atan((spec.addendum + spec.profileShift) * mu);
  halfPitch = pi / spec.teeth;
  const double depth = std::atan((spec.dedendum - spec.profileShift) * mu);
  root = delta - depth;
  const auto excess = [&](double radius) {
    etaC = -depth + radius;
    placeCorner(radius);
    return lamC - pi / 2 * mu;  // beyond the middle of the space
  };
  const double wanted = spec.rootRadius * mu;
  if (excess(wanted) > 0) static_cast<void>(excess(bisect(0, wanted, excess)));
  lamC = std::min(lamC, pi / 2 * mu);
}

void CrownRack::placeCorner(double radius) {
  rho = radius;
  psiF = std::asin(std::clamp(std::sin(etaC) / sinAlpha, -1.0, 1.0)) - rho;
  lamC = std::atan2(cosAlpha * std::sin(psiF + rho), std::cos(psiF + rho)) - psiF / cosAlpha + lam0;
}

/// Turns a contact point of the fixed frame back into the gear. `normal` points out of the tooth.
ProfilePoint CrownRack::inGear(const Vector3d& point, const Vector3d& normal, double roll) const {
  const double along = point.x() * cosDelta - point.z() * sinDelta;   // on the gear's axis
  const double across = point.x() * sinDelta + point.z() * cosDelta;  // towards the pitch point
  const double radius = std::hypot(point.y(), across);
  ProfilePoint p;
  p.rad = std::atan2(radius, along);
  // Turning by roll about k moves e towards -Y, hence against gam.
  p.gam = std::atan2(point.y(), across) - roll;
  const double normalAlong = normal.x() * cosDelta - normal.z() * sinDelta;
  const double normalAcross = normal.x() * sinDelta + normal.z() * cosDelta;
  const double outward = (normalAcross * across + normal.y() * point.y()) / radius;
  p.normalRad =
      outward * along - normalAlong * radius;  // growing colatitude: (cos c, -sin c) in (outward, along)
  p.normalGam = (normal.y() * across - normalAcross * point.y()) / radius;
  return p;
}

ProfilePoint CrownRack::flank(double psi) const {
  return onLineOfAction(psi, psi);
}

ProfilePoint CrownRack::trochoid(double w) const {
  const double sine =
      -std::sin(etaC) / std::sin(w);  // of the distance from pitch point to corner centre, signed
  const double cosine = std::sqrt(1 - sine * sine);
  const double reach = std::asin(sine) + rho;
  const double c = std::cos(reach);
  const double s = std::sin(reach);
  const double roll = (-std::atan2(sine * std::cos(w), cosine) - lamC) / sinDelta;
  return inGear({c, -s * std::cos(w), -s * std::sin(w)}, {s, c * std::cos(w), c * std::sin(w)}, roll);
}

/// The trochoid's parameter at which it crosses the flank of an undercut tooth.
double undercutParameter(const CrownRack& r) {
  const double base = std::acos(r.amplitude);
  const double onBase = bisect(r.alpha, pi / 2, [&](double w) { return r.trochoid(w).rad - base; });
  return bisect(r.alpha, onBase, [&](double w) {
    const ProfilePoint p = r.trochoid(w);
    return p.gam - r.flank(r.psiAt(p.rad)).gam;
  });
}

/// Lowers the tip until the land is wide enough; length of a land at the large end in modules.
bool shortenTip(CrownRack& r, double formRad) {
  const auto land = [&](double colatitude) {
    return 2 * r.flank(r.psiAt(colatitude)).gam * std::sin(colatitude) / r.mu - kNarrowestLand;
  };
  if (land(r.tip) >= 0) return false;
  if (land(formRad) > 0) r.tip = bisect(formRad, r.tip, land);
  return true;
}

/// Outline rolled out flat with the back cone, where equal sagitta is measured. Written so that a crown's
/// back cone, a cylinder, needs no case of its own.
template <class PointAt>
auto developed(const CrownRack& r, const PointAt& pointAt) {
  const double apex = std::tan(r.delta);  // distance of the back cone's apex from the pitch circle
  return [&r, apex, &pointAt](double parameter) {
    const ProfilePoint p = pointAt(parameter);
    const double up = std::tan(p.rad - r.delta);
    const double turn = p.gam * r.cosDelta;
    const double sink = 2 * (up + apex) * std::sin(turn / 2) * std::sin(turn / 2);
    return Flat{up - sink, (up + apex) * std::sin(turn)};
  };
}

/// Angle by which the plane of the involute has rolled on the base cone when it reaches a colatitude. As a
/// tangent, because near the base cone a cosine would lose half of the digits.
double rolledTo(double colatitude, double base) {
  return std::sqrt(std::max(std::sin(colatitude - base) * std::sin(colatitude + base), 0.0));
}

}  // namespace

double sphericalInvoluteHalfAngle(const GearSpec& spec, double colatitude) {
  const CrownRack r(spec);
  const double base = std::asin(r.sinDelta * r.cosAlpha);
  const auto azimuth = [&](double c) {
    const double reach = rolledTo(c, base);
    return std::atan2(reach, std::cos(c)) / std::sin(base) - std::atan2(reach, std::sin(base) * std::cos(c));
  };
  if (r.delta > pi / 2) {  // an internal cone: mirror at the equator
    return r.lam0 / r.sinDelta - azimuth(pi - r.delta) + azimuth(pi - colatitude);
  }
  return r.lam0 / r.sinDelta + azimuth(r.delta) - azimuth(colatitude);
}

namespace {

/// Cones beyond a crown are rings: a rack cannot reach their roots, so flank and root are joined by a circle,
/// as in ring gears. The parallel of a spherical involute is the same involute turned, so that the circle's
/// centre lies on the line of action.
class RingFillet {
 public:
  explicit RingFillet(const CrownRack& rack, double radius) : m_rack(rack) {
    const auto excess = [&](double rho) {
      place(rho);
      return m_centre.gam - rack.halfPitch;
    };
    if (excess(radius) > 0) static_cast<void>(excess(bisect(0, radius, excess)));
  }

  [[nodiscard]] double flankBegin() const { return m_psi; }

  void addTo(HalfTooth& tooth, double tolerance) const {
    const double gap = m_rack.halfPitch - m_centre.gam;
    const int roots = gap * std::sin(m_rack.root) > kShortestArc * m_rack.mu
                          ? chordsOfArc(gap, std::sin(m_rack.root), tolerance)
                          : 0;
    for (int i = 0; i < roots; ++i)
      tooth.points.push_back({m_rack.root, m_rack.halfPitch - gap * i / roots, 1, 0});
    const ProfilePoint end = m_rack.flank(m_psi);
    // The outward normal of the flank at the joint points to the centre, that of the root along growing rad.
    const double turn = std::atan2(end.normalGam, end.normalRad);
    const int n = chordsOfArc(turn, m_rho, tolerance);
    for (int i = 0; i < n; ++i) tooth.points.push_back(pointAt(turn * i / n));
  }

 private:
  void place(double rho) {
    m_rho = rho;
    m_psi = m_rack.psiAt(m_rack.root + rho) - rho;
    m_centre = m_rack.onLineOfAction(m_psi + rho, m_psi);
  }

  /// `beta` from the direction of the root towards the tooth.
  [[nodiscard]] ProfilePoint pointAt(double beta) const {
    using std::cos, std::sin;
    const double c = m_centre.rad;
    const double along = cos(m_rho) * cos(c) + sin(m_rho) * cos(beta) * sin(c);
    const double outward = cos(m_rho) * sin(c) - sin(m_rho) * cos(beta) * cos(c);
    const double across = sin(m_rho) * sin(beta);
    const double azimuth = std::atan2(across, outward);
    // The normal, towards the centre: its part along growing rad at the point, and across.
    const double normalOut = sin(m_rho) * sin(c) + cos(m_rho) * cos(beta) * cos(c);
    const double normalAlong = sin(m_rho) * cos(c) - cos(m_rho) * cos(beta) * sin(c);
    const double normalAcross = -cos(m_rho) * sin(beta);
    const double rad = std::atan2(std::hypot(outward, across), along);
    const double flat = normalOut * cos(azimuth) + normalAcross * sin(azimuth);
    return {rad, m_centre.gam - azimuth, flat * cos(rad) - normalAlong * sin(rad),
            normalOut * sin(azimuth) - normalAcross * cos(azimuth)};
  }

  const CrownRack& m_rack;
  ProfilePoint m_centre;
  double m_rho = 0;
  double m_psi = 0;
};

/// Root arc and trochoid, up to the flank that begins at psiF.
void addTrochoid(const CrownRack& r, double wF, double tolerance, HalfTooth& tooth) {
  const double arc = r.halfPitch - r.lamC / r.sinDelta;
  const int roots =
      arc * std::sin(r.root) > kShortestArc * r.mu ? chordsOfArc(arc, std::sin(r.root), tolerance) : 0;
  for (int i = 0; i < roots; ++i) tooth.points.push_back({r.root, r.halfPitch - arc * i / roots, 1, 0});
  const auto fillet = [&](double w) { return r.trochoid(w); };
  for (const double w : equalSagitta(pi / 2, wF, tolerance, developed(r, fillet))) {
    tooth.points.push_back(r.trochoid(w));
  }
}

}  // namespace

HalfTooth bevelTooth(const GearSpec& spec, double tolerance) {
  GEARGRAPH_REQUIRE(isConical(spec));
  CrownRack r(spec);
  const double chord = tolerance * r.mu;
  HalfTooth tooth;
  double psiF = r.psiF;
  if (r.delta > pi / 2 + 0.02) {
    const RingFillet fillet(r, spec.rootRadius * r.mu);
    psiF = fillet.flankBegin();
    fillet.addTo(tooth, chord);
  } else {
    tooth.undercut = psiF < -r.psiB;
    const double wF = tooth.undercut ? undercutParameter(r) : r.alpha;
    addTrochoid(r, wF, chord, tooth);
    if (tooth.undercut) psiF = r.psiAt(r.trochoid(wF).rad);
    const ProfilePoint joint = r.flank(psiF);
    if (tooth.undercut) {
      tooth.points.back().rad = joint.rad;  // one position for both sides of the corner
      tooth.points.back().gam = joint.gam;
    } else {
      tooth.points.pop_back();
    }
  }
  tooth.points.front().gam = r.halfPitch;
  tooth.formRad = r.flank(psiF).rad;
  tooth.shortened = shortenTip(r, tooth.formRad);
  const double psiA = std::max(r.psiAt(r.tip), psiF + 1e-6 * r.mu);
  const auto flank = [&](double psi) { return r.flank(psi); };
  for (const double psi : equalSagitta(psiF, psiA, kFlankShare * chord, developed(r, flank))) {
    tooth.points.push_back(r.flank(psi));
  }
  const ProfilePoint corner = tooth.points.back();
  const int tips = chordsOfArc(corner.gam, std::sin(corner.rad), chord);
  for (int i = 0; i <= tips; ++i)
    tooth.points.push_back({corner.rad, corner.gam * (static_cast<double>(tips - i) / tips), 1, 0});
  tooth.rootRad = r.root;
  tooth.tipRad = corner.rad;
  tooth.tipHalfAngle = corner.gam;
  return tooth;
}

}  // namespace geargraph
