#include "core/presentation/brep/patch.h"

#include "core/foundations/base/contract.h"
#include "core/presentation/brep/cubic_spline.h"

namespace geargraph {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

/// The same as one long column, so that a whole row is interpolated like a point.
Eigen::VectorXd flat(const MatrixXd& row) {
  return row.reshaped();
}

void addRow(SplineSurface& patch, const MatrixXd& row) {
  for (Index i = 0; i < row.cols(); ++i) patch.poles.emplace_back(row.col(i));
}

}  // namespace

SplineSurface patchThrough(const PatchRows& from) {
  SplineSurface patch{from.uKnots, from.places, false, {}};
  if (from.places.size() == 2 && from.slopes.empty()) {
    patch.isRuled = true;
    for (const MatrixXd& row : from.rows) addRow(patch, row);
    return patch;
  }
  MatrixXd through(from.rows.front().size(), static_cast<Index>(from.rows.size()));
  for (std::size_t i = 0; i < from.rows.size(); ++i) through.col(static_cast<Index>(i)) = flat(from.rows[i]);
  EndSlopes slopes;
  if (from.slopes.empty()) {
    slopes = estimatedSlopes(from.places, through);
  } else {
    GEARGRAPH_REQUIRE(from.slopes.size() == 2);
    slopes = {flat(from.slopes[0]), flat(from.slopes[1])};
  }
  const MatrixXd poles = splinePoles(from.places, through, slopes.first, slopes.last);
  for (Index v = 0; v < poles.cols(); ++v) addRow(patch, poles.col(v).reshaped(3, poles.rows() / 3));
  return patch;
}

SplineCurve borderAlongU(const SplineSurface& patch, bool isLast) {
  const std::size_t width = patch.uKnots.size() + 2;
  const auto start = isLast ? patch.poles.end() - static_cast<std::ptrdiff_t>(width) : patch.poles.begin();
  return {patch.uKnots, {start, start + static_cast<std::ptrdiff_t>(width)}};
}

SplineCurve borderAlongV(const SplineSurface& patch, bool isLast) {
  const std::size_t width = patch.uKnots.size() + 2;
  SplineCurve border{patch.vKnots, {}};
  for (std::size_t i = isLast ? width - 1 : 0; i < patch.poles.size(); i += width)
    border.poles.push_back(patch.poles[i]);
  return border;
}

MatrixXd polesOf(const SplineCurve& curve) {
  MatrixXd poles(3, static_cast<Index>(curve.poles.size()));
  for (std::size_t i = 0; i < curve.poles.size(); ++i) poles.col(static_cast<Index>(i)) = curve.poles[i];
  return poles;
}

}  // namespace geargraph
