#include "core/presentation/brep/tooth_ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/machine/solids/wheel_form.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// The half of a tooth with y >= 0, from the root to the tip.
struct Half {
  std::optional<SplineCurve> fillet;
  SplineCurve flank;
  Vector3d rootStart, form, tip;  ///< where the fillet, the flank and the land begin
  Vector3d middle;                ///< of the space
  bool hasRoot = false;           ///< an arc between the middle of the space and the fillet
  double deviation = 0;
};

/// Dense points from one index to another, with the directions at both ends.
ExactCurve curveOf(const std::vector<OutlinePoint>& outline, std::size_t from, std::size_t to) {
  ExactCurve curve;
  for (std::size_t i = from; i <= to; ++i) {
    if (i > from && outline[i].corner) continue;
    curve.points.push_back(outline[i].top);
  }
  const auto tangent = [&](std::size_t i, const Vector3d& way) -> Vector3d {
    const Vector3d along = outline[i].wallNormal.cross(outline[i].topNormal).normalized();
    return along.dot(way) < 0 ? Vector3d(-along) : along;
  };
  curve.firstTangent = tangent(from, curve.points[1] - curve.points[0]);
  curve.lastTangent = tangent(to, curve.points.back() - curve.points[curve.points.size() - 2]);
  return curve;
}

Half halfOf(const GearSpec& spec, double deviation) {
  constexpr double kDense = 0.01;  // share of the deviation that chords between checked points have
  const HalfTooth tooth = toothOf(spec, kDense * deviation / spec.module);
  const auto faces = wheelForm(spec).toothFaces;
  const std::vector<OutlinePoint> outline = (faces != nullptr ? faces : cylinderFaces)(tooth, spec);
  const auto& points = tooth.points;
  std::size_t root = 0, tip = points.size() - 1;
  while (root + 1 < points.size() && std::abs(points[root + 1].rad - tooth.rootRad) <= 1e-9 * tooth.rootRad)
    ++root;
  while (tip > 0 && points[tip - 1].rad == points.back().rad) --tip;
  std::size_t form = root;
  for (std::size_t i = root; i <= tip; ++i) {
    if (std::abs(points[i].rad - tooth.formRad) < std::abs(points[form].rad - tooth.formRad)) form = i;
  }
  // A corner is two points; the fillet ends at the first, the flank begins at the second.
  const bool isCorner = form < tip && outline[form + 1].corner;
  Half half;
  const auto fit = [&](std::size_t from, std::size_t to) {
    const ExactCurve curve = curveOf(outline, from, to);
    const FittedSpline fitted = fittedSpline(curve, 0.8 * deviation);
    half.deviation = std::max(half.deviation, fitted.deviation + kDense * deviation);
    return fitted.curve;
  };
  if (form > root) half.fillet = fit(root, form);
  half.flank = fit(isCorner ? form + 1 : form, tip);
  half.rootStart = outline[root].top;
  half.form = outline[form].top;
  half.tip = outline[tip].top;
  half.middle = outline.front().top;
  half.hasRoot = (half.middle - half.rootStart).norm() > 1e-6 * spec.module;
  if (!half.hasRoot) half.rootStart = half.middle;
  if (half.fillet) half.fillet->poles.front() = half.rootStart;
  return half;
}

SplineCurve reversed(SplineCurve curve) {
  const double sum = curve.knots.front() + curve.knots.back();
  std::reverse(curve.knots.begin(), curve.knots.end());
  for (double& knot : curve.knots) knot = sum - knot;
  std::reverse(curve.poles.begin(), curve.poles.end());
  return curve;
}

/// Turned about z, mirrored at y = 0 before for the other half.
struct Side {
  double c, s, sense;
  Side(double angle, bool isMirrored) : c(std::cos(angle)), s(std::sin(angle)), sense(isMirrored ? -1 : 1) {}
  Vector3d operator()(const Vector3d& p) const {
    const double y = sense * p.y();
    return {c * p.x() - s * y, s * p.x() + c * y, p.z()};
  }
  SplineCurve operator()(SplineCurve curve) const {
    for (Vector3d& pole : curve.poles) pole = (*this)(pole);
    return curve;
  }
};

}  // namespace

ToothRing toothRing(const GearSpec& spec, double deviation, const std::vector<int>& splitSpaces) {
  const Half half = halfOf(spec, deviation);
  ToothRing ring;
  ring.deviation = half.deviation;
  const auto add = [&](const Vector3d& to, std::optional<SplineCurve> spline, bool isTip = false) {
    ring.pieces.push_back({ring.stations.size() - 1, ring.stations.size(), std::move(spline), isTip});
    ring.stations.push_back(to);
  };
  const auto isSplit = [&](int space) {
    return std::find(splitSpaces.begin(), splitSpaces.end(), space) != splitSpaces.end();
  };
  for (int k = 0; k < spec.teeth; ++k) {
    const Side low(2 * pi * k / spec.teeth, true), high(2 * pi * k / spec.teeth, false);
    if (k == 0) ring.stations.push_back(low(isSplit(0) ? half.middle : half.rootStart));
    if (isSplit(k)) {
      ring.splits.push_back(ring.stations.size() - 1);
      if (half.hasRoot) add(low(half.rootStart), std::nullopt);
    }
    if (half.fillet) add(low(half.form), low(*half.fillet));
    add(low(half.tip), low(half.flank));
    add(high(half.tip), std::nullopt, true);
    add(high(half.form), reversed(high(half.flank)));
    if (half.fillet) add(high(half.rootStart), reversed(high(*half.fillet)));
    if (!half.hasRoot) continue;
    const int next = (k + 1) % spec.teeth;
    const Side after(2 * pi * (k + 1) / spec.teeth, true);
    add(after(isSplit(next) ? half.middle : half.rootStart), std::nullopt);
  }
  // The last station is the first one again.
  ring.stations.pop_back();
  ring.pieces.back().to = 0;
  for (ToothRing::Piece& piece : ring.pieces) {
    if (!piece.spline) continue;
    piece.spline->poles.front() = ring.stations[piece.from];
    piece.spline->poles.back() = ring.stations[piece.to];
  }
  return ring;
}

}  // namespace geargraph
