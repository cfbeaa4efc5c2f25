#include "core/presentation/brep/cubic_spline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Index = Eigen::Index;

/// The knot with its repetitions at the ends: four of the first and of the last.
double knotAt(std::span<const double> knots, Index i) {
  const auto last = static_cast<Index>(knots.size()) - 1;
  return knots[static_cast<std::size_t>(std::clamp<Index>(i - 3, 0, last))];
}

/// The three functions that are not 0 at an inner knot.
std::array<double, 3> basisAtKnot(std::span<const double> knots, Index knot) {
  const auto t = [&](Index i) { return knotAt(knots, i + 3); };
  const double here = t(knot);
  const double before = here - t(knot - 1), after = t(knot + 1) - here;
  const double wide = t(knot + 1) - t(knot - 2), far = t(knot + 2) - t(knot - 1);
  const double near = t(knot + 1) - t(knot - 1);
  const double a = after * after / (near * wide);
  const double c = before * before / (near * far);
  return {a, 1 - a - c, c};
}

/// Lagrange's derivative at the first of some points.
VectorXd slopeAtFirst(std::span<const double> at, const MatrixXd& points) {
  const auto n = static_cast<Index>(at.size());
  VectorXd slope = VectorXd::Zero(points.rows());
  for (Index j = 0; j < n; ++j) {
    double weight = 0;
    for (Index k = 0; k < n; ++k) {
      if (k == j) continue;
      double term = 1 / (at[static_cast<std::size_t>(j)] - at[static_cast<std::size_t>(k)]);
      for (Index l = 0; l < n; ++l) {
        if (l == j || l == k) continue;
        term *= (at[0] - at[static_cast<std::size_t>(l)]) /
                (at[static_cast<std::size_t>(j)] - at[static_cast<std::size_t>(l)]);
      }
      weight += term;
    }
    slope += weight * points.col(j);
  }
  return slope;
}

}  // namespace

MatrixXd splinePoles(std::span<const double> knots, const MatrixXd& points, const VectorXd& firstSlope,
                     const VectorXd& lastSlope) {
  const auto n = static_cast<Index>(knots.size()) - 1;
  GEARGRAPH_REQUIRE(n >= 1 && points.cols() == n + 1);
  MatrixXd poles(points.rows(), n + 3);
  poles.col(0) = points.col(0);
  poles.col(1) = points.col(0) + firstSlope * (knots[1] - knots[0]) / 3;
  poles.col(n + 1) =
      points.col(n) -
      lastSlope * (knots[static_cast<std::size_t>(n)] - knots[static_cast<std::size_t>(n - 1)]) / 3;
  poles.col(n + 2) = points.col(n);
  // Poles 2 .. n from the points 1 .. n - 1, a tridiagonal system.
  std::vector<double> upper(static_cast<std::size_t>(n + 1), 0);
  for (Index i = 1; i < n; ++i) {
    const auto [a, b, c] = basisAtKnot(knots, i);
    VectorXd right = points.col(i) - a * poles.col(i);
    double middle = b;
    if (i > 1) middle -= a * upper[static_cast<std::size_t>(i - 1)];
    if (i == n - 1) right -= c * poles.col(n + 1);
    poles.col(i + 1) = right / middle;
    upper[static_cast<std::size_t>(i)] = c / middle;
  }
  for (Index i = n - 2; i >= 1; --i)
    poles.col(i + 1) -= upper[static_cast<std::size_t>(i)] * poles.col(i + 2);
  return poles;
}

EndSlopes estimatedSlopes(std::span<const double> knots, const MatrixXd& points) {
  const std::size_t count = std::min<std::size_t>(knots.size(), 4);
  const auto take = static_cast<Index>(count);
  std::vector<double> reversed(knots.end() - static_cast<std::ptrdiff_t>(count), knots.end());
  std::reverse(reversed.begin(), reversed.end());
  return {slopeAtFirst(knots.first(count), points.leftCols(take)),
          slopeAtFirst(reversed, points.rightCols(take).rowwise().reverse())};
}

VectorXd splinePoint(std::span<const double> knots, const MatrixXd& poles, double parameter) {
  const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, parameter);
  const Index span = after - knots.begin() - 1 + 3;
  MatrixXd d = poles.middleCols(span - 3, 4);
  for (Index r = 1; r <= 3; ++r) {
    for (Index j = 3; j >= r; --j) {
      const double low = knotAt(knots, j + span - 3), high = knotAt(knots, j + 1 + span - r);
      const double share = (parameter - low) / (high - low);
      d.col(j) = (1 - share) * d.col(j - 1) + share * d.col(j);
    }
  }
  return d.col(3);
}

FittedSpline fittedSpline(const ExactCurve& curve, double deviation) {
  const std::size_t last = curve.points.size() - 1;
  GEARGRAPH_REQUIRE(last >= 1);
  std::vector<double> at{0};
  for (std::size_t i = 0; i < last; ++i)
    at.push_back(at.back() + (curve.points[i + 1] - curve.points[i]).norm());
  for (std::size_t parts = std::min<std::size_t>(2, last);; parts = std::min(parts + 1 + parts / 4, last)) {
    SplineCurve spline;
    MatrixXd through(3, static_cast<Index>(parts + 1));
    for (std::size_t i = 0; i <= parts; ++i) {
      const std::size_t which = i * last / parts;
      spline.knots.push_back(at[which]);
      through.col(static_cast<Index>(i)) = curve.points[which];
    }
    const MatrixXd poles = splinePoles(spline.knots, through, curve.firstTangent, curve.lastTangent);
    double farthest = 0;
    for (std::size_t i = 0; i <= last; ++i)
      farthest = std::max(farthest, (splinePoint(spline.knots, poles, at[i]) - curve.points[i]).norm());
    if (farthest > deviation && parts < last) continue;
    for (Index i = 0; i < poles.cols(); ++i) spline.poles.emplace_back(poles.col(i));
    return {std::move(spline), farthest};
  }
}

}  // namespace geargraph
