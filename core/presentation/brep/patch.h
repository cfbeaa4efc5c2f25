#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/presentation/brep/brep.h"

namespace geargraph {

/// Rows of poles along u at some places along v, and the surface through them.
struct PatchRows {
  std::vector<double> uKnots;
  std::vector<double> places;           ///< along v; two without slopes: straight between them
  std::vector<Eigen::MatrixXd> rows;    ///< 3 x poles, by place
  std::vector<Eigen::MatrixXd> slopes;  ///< of the first and the last row along v; empty: estimated
};
[[nodiscard]] SplineSurface patchThrough(const PatchRows& rows);

/// The borders of a patch: along u at its first and last v, along v at its first and last u.
[[nodiscard]] SplineCurve borderAlongU(const SplineSurface& patch, bool isLast);
[[nodiscard]] SplineCurve borderAlongV(const SplineSurface& patch, bool isLast);

/// The poles of a curve as columns.
[[nodiscard]] Eigen::MatrixXd polesOf(const SplineCurve& curve);

}  // namespace geargraph
