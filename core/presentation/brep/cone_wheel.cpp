// Bevels. Every surface of their teeth is a cone with its top in the apex, so that the small end is the large
// one made smaller.

#include <cmath>
#include <numbers>

#include "core/foundations/base/translation.h"
#include "core/machine/solids/gear_body.h"
#include "core/presentation/brep/brep_builder.h"
#include "core/presentation/brep/patch.h"
#include "core/presentation/brep/tooth_ring.h"
#include "core/presentation/brep/wheel_brep.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// One end of the teeth.
struct End {
  double scale = 1;  ///< of the large end
  std::vector<int> points;
  std::vector<LoopEdge> edges;
};

class Cone {
 public:
  Cone(const GearSpec& spec, double deviation)
      : m_spec(spec), m_ring(toothRing(spec, 0.9 * deviation, {0, spec.teeth / 2})) {
    const double large = coneDistance(spec);
    const End front = addEnd((large - spec.faceWidth) / large), back = addEnd(1);
    addTeeth(front, back);
    addBody(front, back);
  }

  WheelBrep take() { return {m_builder.take(), m_ring.deviation}; }

 private:
  End addEnd(double scale);
  void addTeeth(const End& front, const End& back);
  void addBody(const End& front, const End& back);
  void addHalves(const End& end, const BrepBuilder::Circle& circle, bool isBack);

  const GearSpec& m_spec;
  ToothRing m_ring;
  BrepBuilder m_builder;
};

End Cone::addEnd(double scale) {
  End end{scale, {}, {}};
  for (const Vector3d& station : m_ring.stations) end.points.push_back(m_builder.addPoint(scale * station));
  for (const ToothRing::Piece& piece : m_ring.pieces) {
    const int from = end.points[piece.from], to = end.points[piece.to];
    if (piece.spline) {
      SplineCurve curve = *piece.spline;
      for (Vector3d& pole : curve.poles) pole *= scale;
      end.edges.push_back(m_builder.addSpline(from, to, std::move(curve)));
    } else {
      end.edges.push_back(m_builder.addArc(from, to, m_builder.point(from).z() * Vector3d::UnitZ()));
    }
  }
  return end;
}

void Cone::addTeeth(const End& front, const End& back) {
  std::vector<LoopEdge> along;
  for (std::size_t i = 0; i < m_ring.stations.size(); ++i)
    along.push_back(m_builder.addLine(front.points[i], back.points[i]));
  for (std::size_t i = 0; i < m_ring.pieces.size(); ++i) {
    const ToothRing::Piece& piece = m_ring.pieces[i];
    const std::vector<LoopEdge> loop{front.edges[i], along[piece.to], against(back.edges[i]),
                                     against(along[piece.from])};
    if (piece.spline) {
      const Eigen::MatrixXd poles = polesOf(*piece.spline);
      m_builder.addFace(patchThrough({piece.spline->knots, {0, 1}, {front.scale * poles, poles}, {}}),
                        {loop});
      continue;
    }
    const Vector3d& on = m_ring.stations[piece.from];
    const double radius = std::hypot(on.x(), on.y());
    if (std::abs(on.z()) < 1e-9 * radius) {
      m_builder.addFace(PlaneSurface{Vector3d::Zero(), -Vector3d::UnitZ()}, {loop});
    } else {
      // Teeth point away from the apex's own cone: outside is where the angle against the axis grows.
      m_builder.addFace(RoundSurface{on.z() * Vector3d::UnitZ(), Vector3d::UnitZ(), radius, radius / on.z()},
                        {loop}, on.z() < 0);
    }
  }
}

/// A face of back or front cone, between the teeth and a circle of the body, parted in the middle of two
/// spaces.
void Cone::addHalves(const End& end, const BrepBuilder::Circle& circle, bool isBack) {
  const double delta = m_spec.coneAngle;
  const double slope = -std::cos(delta) / std::sin(delta);
  const RoundSurface surface{end.scale * coneDistance(m_spec) * std::cos(delta) * Vector3d::UnitZ(),
                             Vector3d::UnitZ(), end.scale * coneDistance(m_spec) * std::sin(delta),
                             std::abs(slope) < 1e-9 ? 0 : slope};
  const std::size_t count = m_ring.pieces.size();
  std::array<LoopEdge, 2> joints;
  for (std::size_t i = 0; i < 2; ++i)
    joints[i] = m_builder.addLine(end.points[m_ring.splits[i]], m_builder.startOf(circle[i]));
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t first = m_ring.splits[i], last = m_ring.splits[1 - i];
    std::vector<LoopEdge> loop;
    for (std::size_t k = first; k != last; k = (k + 1) % count) loop.push_back(end.edges[k]);
    loop.push_back(joints[1 - i]);
    loop.push_back(against(circle[i]));
    loop.push_back(against(joints[i]));
    m_builder.addFace(surface, {isBack ? loop : against(loop)}, !isBack);
  }
}

void Cone::addBody(const End& front, const End& back) {
  const std::vector<ProfileVertex> body = bodyProfile(m_spec);
  const auto angleOf = [&](std::size_t split) {
    const Vector3d& at = m_ring.stations[m_ring.splits[split]];
    return std::atan2(at.y(), at.x());
  };
  std::vector<BrepBuilder::Circle> circles(body.size());
  circles.front() = m_builder.addSplitCircle(body.front(), angleOf(0), angleOf(1));
  circles.back() = m_builder.addSplitCircle(body.back(), angleOf(0), angleOf(1));
  if (body.size() > 2) {
    const auto inner = m_builder.addCircles(std::span(body).subspan(1, body.size() - 2));
    std::copy(inner.begin(), inner.end(), circles.begin() + 1);
  }
  m_builder.addRevolved(body, circles, false);
  addHalves(back, circles.front(), true);
  addHalves(front, circles.back(), false);
}

WheelBrep coneWheel(const GearSpec& spec, double deviation) {
  return Cone(spec, deviation).take();
}

/// Its surfaces would be no cones, but turned from section to section.
const char* refuseSpiral(const GearSpec& spec) {
  return spec.helixAngle == 0
             ? ""
             : toTranslate("The spiral teeth of gear %1 have no exact faces here; STL and GLB have them.");
}

const char* refuseFace(const GearSpec& /*spec*/) {
  return toTranslate("The teeth of face gear %1 have no exact faces here; STL and GLB have them.");
}

WheelBrep coneBlank(const GearSpec& spec, double /*deviation*/) {
  return {revolvedBrep(wheelOutline(spec)), 0};
}

}  // namespace

constexpr WheelCad kConeCad{coneWheel, refuseSpiral};
constexpr WheelCad kConeBlankCad{coneBlank};
constexpr WheelCad kNoCad{coneBlank, refuseFace};

}  // namespace geargraph
