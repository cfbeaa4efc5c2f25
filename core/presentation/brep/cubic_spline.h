#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "core/presentation/brep/brep.h"

namespace geargraph {

/// Poles of the cubic spline through `points` at `knots`, with these derivatives at its ends (L. Piegl,
/// W. Tiller, The NURBS Book, 9.2.3). Columns are points of any dimension: a row of a surface is
/// interpolated like a curve. @pre two points or more, as many as knots, which ascend. Cost: O(points)
[[nodiscard]] Eigen::MatrixXd splinePoles(std::span<const double> knots, const Eigen::MatrixXd& points,
                                          const Eigen::VectorXd& firstSlope,
                                          const Eigen::VectorXd& lastSlope);

/// The slopes at both ends of a curve of which only points are known: those of the cubic through the first
/// and last four, or of as many as there are.
struct EndSlopes {
  Eigen::VectorXd first;
  Eigen::VectorXd last;
};
[[nodiscard]] EndSlopes estimatedSlopes(std::span<const double> knots, const Eigen::MatrixXd& points);

/// The point of a spline at a parameter, by de Boor's algorithm. @pre within its knots
[[nodiscard]] Eigen::VectorXd splinePoint(std::span<const double> knots, const Eigen::MatrixXd& poles,
                                          double parameter);

/// A smooth piece of an outline: dense points on the exact curve, and the unit tangents at its ends.
struct ExactCurve {
  std::vector<Eigen::Vector3d> points;
  Eigen::Vector3d firstTangent = Eigen::Vector3d::UnitX();
  Eigen::Vector3d lastTangent = Eigen::Vector3d::UnitX();
};

struct FittedSpline {
  SplineCurve curve;
  double deviation = 0;  ///< of the dense points, bounded from above
};
/// The spline through as few of the points as leave none farther than `deviation` from it; through all of
/// them if that is not enough. Its parameter is the length along the chords of the dense points.
[[nodiscard]] FittedSpline fittedSpline(const ExactCurve& curve, double deviation);

}  // namespace geargraph
