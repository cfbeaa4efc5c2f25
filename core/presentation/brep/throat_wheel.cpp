// The wheel of a worm. Its teeth have no surface in closed form but the worm's cut in every section
// (WormCut): splines through points of it, as many as the deviation wants.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/worm_cut.h"
#include "core/presentation/brep/brep_builder.h"
#include "core/presentation/brep/cubic_spline.h"
#include "core/presentation/brep/patch.h"
#include "core/presentation/brep/wheel_brep.h"

namespace geargraph {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using std::numbers::pi;

/// The pieces of one tooth's outline in a section, counter-clockwise: flank, land, flank, and the root after
/// them.
enum Piece { low, land, high, root, pieces };

Vector3d around(double radius, double angle, double height) {
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

/// Exact points of tooth 0.
class Tooth {
 public:
  Tooth(const GearSpec& spec, double deviation) : m_cut(spec), m_half(pi / spec.teeth) {
    // Shares of the way from root to tip, dense at the root, as the mid section has its points.
    const HalfTooth middle = externalTooth(spec, 0.1 * deviation / spec.module);
    m_shares = {0};
    for (const ProfilePoint& p : middle.points) {
      const double share = (p.rad - middle.rootRad) / (middle.tipRad - middle.rootRad);
      if (share > m_shares.back() + 1e-4 && share < 1 - 1e-4) m_shares.push_back(share);
    }
    m_shares.push_back(1);
  }

  [[nodiscard]] std::size_t dense(Piece piece) const {
    return piece == low || piece == high ? m_shares.size() : kRound;
  }
  /// The dense points of a piece in the section at a height, in its direction. Kept.
  [[nodiscard]] const MatrixXd& section(Piece piece, double height) {
    MatrixXd& points = m_sections[{piece, height}];
    if (points.size() == 0) points = cut(piece, height);
    return points;
  }
  [[nodiscard]] double throatEnd() const { return m_cut.throatEnd(); }

 private:
  [[nodiscard]] MatrixXd cut(Piece piece, double height) const {
    MatrixXd points(3, static_cast<Index>(dense(piece)));
    const WormCut::Circle bottom = m_cut.root(height), top = m_cut.tip(height);
    const auto flank = [&](double share, double side) {
      const double radius = share == 1 ? top.radius : bottom.radius + share * (top.radius - bottom.radius);
      return std::pair(radius, m_cut.flank(radius, side * height).angle);
    };
    if (piece == low || piece == high) {
      const Index last = points.cols() - 1;
      for (Index i = 0; i <= last; ++i) {
        const double share = m_shares[static_cast<std::size_t>(piece == low ? i : last - i)];
        const auto [radius, angle] = flank(share, piece == low ? 1 : -1);
        points.col(i) = around(radius, piece == low ? angle - m_half : m_half - angle, height);
      }
      return points;
    }
    const bool isLand = piece == land;
    const double share = isLand ? 1 : 0;
    const double below = flank(share, 1).second - m_half, above = m_half - flank(share, -1).second;
    const double from = isLand ? below : above, to = isLand ? above : below + 2 * m_half;
    for (Index i = 0; i < points.cols(); ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(points.cols() - 1);
      points.col(i) = around(isLand ? top.radius : bottom.radius, from + part * (to - from), height);
    }
    return points;
  }
  static constexpr std::size_t kRound = 17;
  WormCut m_cut;
  double m_half;
  std::vector<double> m_shares;
  std::map<std::pair<Piece, double>, MatrixXd> m_sections;
};

/// A piece of the tooth between two heights.
struct Patch {
  SplineSurface surface;
  double deviation = 0;
};

/// Every how many of the dense points are kept, and heights between.
struct Grid {
  std::size_t points = 4;   ///< intervals along the section
  std::size_t heights = 3;  ///< intervals along the axis
};

std::vector<double> evenly(double from, double to, std::size_t parts) {
  std::vector<double> all;
  for (std::size_t i = 0; i <= parts; ++i)
    all.push_back(i == parts ? to : from + (to - from) * static_cast<double>(i) / static_cast<double>(parts));
  return all;
}

/// The parameters of dense points: lengths along their chords in one section.
std::vector<double> lengthsAlong(const MatrixXd& section) {
  std::vector<double> at{0};
  for (Index i = 0; i + 1 < section.cols(); ++i)
    at.push_back(at.back() + (section.col(i + 1) - section.col(i)).norm());
  return at;
}

Patch patchOf(Tooth& tooth, Piece piece, double from, double to, const Grid& grid) {
  const std::vector<double> at = lengthsAlong(tooth.section(piece, 0.5 * (from + to)));
  const std::size_t last = at.size() - 1, parts = std::min(grid.points, last);
  PatchRows rows{{}, evenly(from, to, grid.heights), {}, {}};
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i <= parts; ++i) {
    kept.push_back(i * last / parts);
    rows.uKnots.push_back(at[kept.back()]);
  }
  for (const double height : rows.places) {
    const MatrixXd section = tooth.section(piece, height);
    MatrixXd through(3, static_cast<Index>(kept.size()));
    for (std::size_t i = 0; i < kept.size(); ++i)
      through.col(static_cast<Index>(i)) = section.col(static_cast<Index>(kept[i]));
    const EndSlopes slopes = estimatedSlopes(rows.uKnots, through);
    rows.rows.push_back(splinePoles(rows.uKnots, through, slopes.first, slopes.last));
  }
  Patch patch{patchThrough(rows), 0};
  const auto width = static_cast<Index>(rows.uKnots.size() + 2);
  const MatrixXd poles = polesOf(SplineCurve{{}, patch.surface.poles})
                             .reshaped(3 * width, static_cast<Index>(patch.surface.poles.size()) / width);
  for (const double height : evenly(from, to, 2 * grid.heights + 1)) {
    const MatrixXd row = splinePoint(rows.places, poles, height).reshaped(3, width);
    const MatrixXd exact = tooth.section(piece, height);
    for (std::size_t i = 0; i <= last; ++i) {
      const double off = (splinePoint(rows.uKnots, row, at[i]) - exact.col(static_cast<Index>(i))).norm();
      patch.deviation = std::max(patch.deviation, off);
    }
  }
  return patch;
}

/// All pieces between two heights, on one grid of heights, so that their borders agree. More points are taken
/// along the section where that helps, else more heights.
std::array<Patch, pieces> patchesOf(Tooth& tooth, double from, double to, double deviation) {
  constexpr int kRounds = 20;
  constexpr double kHelps = 0.9;
  std::array<Patch, pieces> best;
  std::array<Grid, pieces> grids;
  std::size_t heights = 3;
  for (int round = 0; round < kRounds; ++round) {
    bool wantsHeights = false, isNear = true;
    for (const Piece piece : {low, land, high, root}) {
      Grid& grid = grids[piece];
      grid.heights = heights;
      best[piece] = patchOf(tooth, piece, from, to, grid);
      if (best[piece].deviation <= deviation) continue;
      isNear = false;
      Grid finer = grid;
      finer.points += 2 + grid.points / 2;
      Patch tried = patchOf(tooth, piece, from, to, finer);
      if (tried.deviation < kHelps * best[piece].deviation) {
        grid = finer;
        best[piece] = std::move(tried);
      } else {
        wantsHeights = true;
      }
    }
    if (isNear) break;
    if (wantsHeights) heights += 1 + heights / 3;
  }
  return best;
}

class Throat {
 public:
  Throat(const GearSpec& spec, double deviation) : m_spec(spec) {
    Tooth tooth(spec, deviation);
    const double half = spec.faceWidth / 2, end = tooth.throatEnd();
    std::vector<double> ends{-half, half};
    if (half - end > 0.01 * spec.module) ends = {-half, -end, end, half};
    std::vector<std::array<Patch, pieces>> stages;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      stages.push_back(patchesOf(tooth, ends[i], ends[i + 1], deviation));
      for (const Patch& patch : stages.back()) m_deviation = std::max(m_deviation, patch.deviation);
    }
    addTeeth(stages);
    addBodyBelow(m_builder, spec, m_top, m_bottom);
  }

  WheelBrep take() { return {m_builder.take(), m_deviation}; }

 private:
  void addTeeth(const std::vector<std::array<Patch, pieces>>& stages);

  const GearSpec& m_spec;
  BrepBuilder m_builder;
  std::vector<LoopEdge> m_top, m_bottom;
  double m_deviation = 0;
};

SplineSurface turned(SplineSurface surface, const Eigen::Matrix3d& turn) {
  for (Vector3d& pole : surface.poles) pole = turn * pole;
  return surface;
}

/// The borders of pieces that meet are told once: those of the flanks along the axis, and in sections between
/// stages those of the lower stage.
void Throat::addTeeth(const std::vector<std::array<Patch, pieces>>& stages) {
  const auto count = static_cast<std::size_t>(m_spec.teeth) * pieces;
  std::vector<SplineSurface> surfaces(count);
  const auto fill = [&](const std::array<Patch, pieces>& stage) {
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2 * pi * static_cast<double>(i / pieces) / m_spec.teeth;
      surfaces[i] =
          turned(stage[i % pieces].surface, Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix());
    }
  };
  const auto pointsOf = [&](bool isUpper) {
    std::vector<int> points;
    for (const SplineSurface& surface : surfaces)
      points.push_back(m_builder.addPoint(borderAlongU(surface, isUpper).poles.front()));
    return points;
  };
  const auto edgesOf = [&](const std::vector<int>& points, bool isUpper) {
    std::vector<LoopEdge> edges;
    for (std::size_t i = 0; i < count; ++i) {
      SplineCurve border = borderAlongU(surfaces[i], isUpper);
      border.poles.back() = m_builder.point(points[(i + 1) % count]);
      edges.push_back(m_builder.addSpline(points[i], points[(i + 1) % count], std::move(border)));
    }
    return edges;
  };
  fill(stages.front());
  std::vector<int> below = pointsOf(false);
  m_bottom = edgesOf(below, false);
  m_top = m_bottom;
  for (const auto& stage : stages) {
    fill(stage);
    const std::vector<int> above = pointsOf(true);
    const std::vector<LoopEdge> before = m_top;
    m_top = edgesOf(above, true);
    std::vector<LoopEdge> along;
    for (std::size_t i = 0; i < count; ++i) {
      SplineCurve border = borderAlongV(surfaces[i], false);
      border.poles.front() = m_builder.point(below[i]);
      border.poles.back() = m_builder.point(above[i]);
      along.push_back(m_builder.addSpline(below[i], above[i], std::move(border)));
    }
    for (std::size_t i = 0; i < count; ++i) {
      m_builder.addFace(std::move(surfaces[i]),
                        {{before[i], along[(i + 1) % count], against(m_top[i]), against(along[i])}});
    }
    below = above;
  }
}

WheelBrep throatWheel(const GearSpec& spec, double deviation) {
  return Throat(spec, deviation).take();
}

}  // namespace

constexpr WheelCad kThroatCad{throatWheel};

}  // namespace geargraph
