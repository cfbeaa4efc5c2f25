// Wheels whose teeth are a section that turns along the axis: spur, helical and herringbone wheels, rings,
// and worms.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/machine/solids/gear_body.h"
#include "core/presentation/brep/brep_builder.h"
#include "core/presentation/brep/patch.h"
#include "core/presentation/brep/tooth_ring.h"
#include "core/presentation/brep/wheel_brep.h"

namespace geargraph {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using std::numbers::pi;

/// A part of the width with one twist, less than half a turn, so that no face goes round the axis.
struct Stage {
  double from = 0, to = 0;  ///< heights
  double startTurn = 0;     ///< of the section at `from`
  double slope = 0;         ///< turn per height
  [[nodiscard]] double turnAt(double height) const { return startTurn + slope * (height - from); }
};

std::vector<Stage> stagesOf(const GearSpec& spec) {
  const double half = spec.faceWidth / 2;
  std::vector<double> ends{-half, half};
  if (spec.helixAngle != 0) {
    const double slope = std::abs(std::tan(spec.helixAngle)) / pitchRadius(spec);
    const int parts = std::max(1, static_cast<int>(std::ceil(slope * spec.faceWidth / (pi / 2))));
    const int even = spec.herringbone ? parts + parts % 2 : parts;  // the middle is an edge
    ends.clear();
    const int count = spec.herringbone ? std::max(even, 2) : even;
    for (int i = 0; i <= count; ++i) ends.push_back(half * (2 * i - count) / count);
  }
  std::vector<Stage> stages;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double turn = twistOf(spec, ends[i]);
    stages.push_back(
        {ends[i], ends[i + 1], turn, (twistOf(spec, ends[i + 1]) - turn) / (ends[i + 1] - ends[i])});
  }
  return stages;
}

/// A pole or point of the section at a height, and how it goes on along the axis.
Vector3d sectionPoint(const Vector3d& p, const Stage& stage, double height) {
  const double turn = stage.turnAt(height), c = std::cos(turn), s = std::sin(turn);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y(), height};
}

MatrixXd sectionRow(const SplineCurve& curve, const Stage& stage, double height) {
  MatrixXd row(3, static_cast<Eigen::Index>(curve.poles.size()));
  for (std::size_t i = 0; i < curve.poles.size(); ++i)
    row.col(static_cast<Eigen::Index>(i)) = sectionPoint(curve.poles[i], stage, height);
  return row;
}

MatrixXd alongAxis(MatrixXd row, const Stage& stage) {
  for (Eigen::Index i = 0; i < row.cols(); ++i)
    row.col(i) = Vector3d(-stage.slope * row(1, i), stage.slope * row(0, i), 1);
  return row;
}

/// The teeth, from the lower face to the upper one.
class Teeth {
 public:
  Teeth(BrepBuilder& builder, const GearSpec& spec, ToothRing ring, double deviation)
      : m_builder(builder), m_ring(std::move(ring)), m_isRing(isRing(spec)) {
    const std::vector<Stage> stages = stagesOf(spec);
    std::vector<int> below = pointsAt(stages.front(), stages.front().from);
    bottom = sectionEdges(stages.front(), stages.front().from, below);
    top = bottom;
    for (const Stage& stage : stages) {
      const std::vector<int> above = pointsAt(stage, stage.to);
      const std::vector<LoopEdge> before = top;
      top = sectionEdges(stage, stage.to, above);
      addStage(stage, deviation, below, above, before);
      below = above;
    }
  }

  std::vector<LoopEdge> bottom, top;  ///< the outline there, counter-clockwise from above

 private:
  std::vector<int> pointsAt(const Stage& stage, double height) {
    std::vector<int> points;
    for (const Vector3d& station : m_ring.stations)
      points.push_back(m_builder.addPoint(sectionPoint(station, stage, height)));
    return points;
  }
  std::vector<LoopEdge> sectionEdges(const Stage& stage, double height, const std::vector<int>& points);
  void addStage(const Stage& stage, double deviation, const std::vector<int>& below,
                const std::vector<int>& above, const std::vector<LoopEdge>& before);

  BrepBuilder& m_builder;
  ToothRing m_ring;
  bool m_isRing;
};

std::vector<LoopEdge> Teeth::sectionEdges(const Stage& stage, double height, const std::vector<int>& points) {
  std::vector<LoopEdge> edges;
  for (const ToothRing::Piece& piece : m_ring.pieces) {
    const int from = points[piece.from], to = points[piece.to];
    if (!piece.spline) {
      edges.push_back(m_builder.addArc(from, to, height * Vector3d::UnitZ()));
      continue;
    }
    SplineCurve curve = *piece.spline;
    for (Vector3d& pole : curve.poles) pole = sectionPoint(pole, stage, height);
    edges.push_back(m_builder.addSpline(from, to, std::move(curve)));
  }
  return edges;
}

void Teeth::addStage(const Stage& stage, double deviation, const std::vector<int>& below,
                     const std::vector<int>& above, const std::vector<LoopEdge>& before) {
  // A cubic with the slopes of a helix at its ends leaves it by r step^4 / 384.
  double reach = 0;
  for (const Vector3d& station : m_ring.stations)
    reach = std::max(reach, std::hypot(station.x(), station.y()));
  const double step = std::pow(384 * 0.1 * deviation / reach, 0.25);
  const double turn = std::abs(stage.slope * (stage.to - stage.from));
  const int parts = std::max(1, static_cast<int>(std::ceil(turn / step)));
  std::vector<double> heights;
  for (int i = 0; i <= parts; ++i) heights.push_back(stage.from + (stage.to - stage.from) * i / parts);
  const auto patchOf = [&](const SplineCurve& curve) {
    PatchRows rows{curve.knots, heights, {}, {}};
    for (const double height : heights) rows.rows.push_back(sectionRow(curve, stage, height));
    if (stage.slope != 0)
      rows.slopes = {alongAxis(rows.rows.front(), stage), alongAxis(rows.rows.back(), stage)};
    return patchThrough(rows);
  };
  std::vector<LoopEdge> along;  // by station
  for (std::size_t i = 0; i < m_ring.stations.size(); ++i) {
    if (stage.slope == 0) {
      along.push_back(m_builder.addLine(below[i], above[i]));
      continue;
    }
    const Vector3d& station = m_ring.stations[i];
    const SplineCurve point{{0, 1}, {station, station, station, station}};
    along.push_back(m_builder.addSpline(below[i], above[i], borderAlongV(patchOf(point), false)));
  }
  for (std::size_t i = 0; i < m_ring.pieces.size(); ++i) {
    const ToothRing::Piece& piece = m_ring.pieces[i];
    std::vector<LoopEdge> loop{before[i], along[piece.to], against(top[i]), against(along[piece.from])};
    if (m_isRing) loop = against(loop);
    if (piece.spline) {
      m_builder.addFace(patchOf(*piece.spline), {std::move(loop)}, m_isRing);
    } else {
      const Vector3d& on = m_ring.stations[piece.from];
      m_builder.addFace(
          RoundSurface{stage.from * Vector3d::UnitZ(), Vector3d::UnitZ(), std::hypot(on.x(), on.y()), 0},
          {std::move(loop)}, m_isRing);
    }
  }
}

}  // namespace

namespace {

WheelBrep twistedWheel(const GearSpec& spec, double deviation) {
  BrepBuilder builder;
  ToothRing ring = toothRing(spec, 0.8 * deviation);
  for (Vector3d& station : ring.stations) station.z() = 0;
  for (ToothRing::Piece& piece : ring.pieces) {
    if (!piece.spline) continue;
    for (Vector3d& pole : piece.spline->poles) pole.z() = 0;
  }
  WheelBrep made;
  made.deviation = ring.deviation + (spec.helixAngle != 0 ? 0.1 * deviation : 0);
  const Teeth teeth(builder, spec, std::move(ring), deviation);
  addBodyBelow(builder, spec, teeth.top, teeth.bottom);
  made.solid = builder.take();
  return made;
}

WheelBrep smoothWheel(const GearSpec& spec, double /*deviation*/) {
  const double half = spec.faceWidth / 2, radius = nominalTipRadius(spec);
  std::vector<ProfileVertex> outline = bodyProfile(spec);
  outline.push_back({radius, -half});
  outline.push_back({radius, half});
  return {revolvedBrep(outline), 0};
}

}  // namespace

constexpr WheelCad kTwistedCad{twistedWheel};
constexpr WheelCad kSmoothCad{smoothWheel};

}  // namespace geargraph
