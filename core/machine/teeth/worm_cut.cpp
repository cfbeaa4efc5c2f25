#include "core/machine/teeth/worm_cut.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/sampling.h"
#include "core/machine/teeth/worm.h"

namespace geargraph {
namespace {

using std::numbers::pi;

/// Least depth of the groove at the edges of a wide rim, which the worm does not reach, and the overlap in
/// which its root blends into the worm's reach, in modules.
constexpr double kLeastGroove = 0.2;
constexpr double kGrooveBlend = 0.4;
/// Half the land between the rounded corners of the cutter's tip, and their least radius, in modules.
constexpr double kHalfCutterLand = 0.02;
constexpr double kLeastRound = 0.05;

/// The radius at which the throat's arc about the worm's axis ends in a tip circle's height.
double throatRadius(const GearSpec& wheel) {
  const double tip = wheel.tipRadius > 0
                         ? wheel.tipRadius * wheel.module
                         : pitchRadius(wheel) + (wheel.addendum + wheel.profileShift) * wheel.module;
  return wormDistance(wheel) - tip;
}

double rimRadius(const GearSpec& wheel) {
  const double lowest = wormDistance(wheel) - throatRadius(wheel);
  return std::max(pitchRadius(wheel) + (kWormRim + wheel.profileShift) * wheel.module, lowest);
}

}  // namespace

double wormWheelReach(const GearSpec& wheel) {
  const double throat = throatRadius(wheel), edge = wheel.faceWidth / 2;
  const double rim = rimRadius(wheel);
  if (edge >= throat) return rim;
  return std::min(rim, wormDistance(wheel) - std::sqrt(throat * throat - edge * edge));
}

WormCut::WormCut(const GearSpec& wheel)
    : m_distance(wormDistance(wheel)),
      m_pitch(pitchRadius(wheel)),
      m_module(wheel.module),
      m_pitchAngle(2 * pi / wheel.teeth),
      m_wormPitch(wheel.mateRadius),
      m_wormTip(wheel.mateRadius + wheel.dedendum * wheel.module),
      m_half((pi / 4 + wheel.backlashAllowance / 2) * wheel.module),
      m_slope(std::tan(wheel.pressureAngle)),
      m_advance((wheel.helixAngle < 0 ? -0.5 : 0.5) * wheel.mateTeeth * wheel.module),
      m_throat(throatRadius(wheel)),
      m_rim(rimRadius(wheel)) {
  // The corner's centre lies at m_half - (tip - round - pitch) slope - round / cos from the thread's middle.
  const double cosine = 1 / std::hypot(1.0, m_slope);
  const double atTip = m_half - (m_wormTip - m_wormPitch) * m_slope;
  const double room = (atTip - kHalfCutterLand * m_module) / (1 / cosine - m_slope);
  m_round = std::max(std::min(wheel.rootRadius * m_module, room), kLeastRound * m_module);
  m_roundCentre = atTip + m_round * m_slope - m_round / cosine;
  const double over = m_distance - m_rim;  // depth at which the rim begins
  m_throatEnd = std::min(std::sqrt(std::max(m_throat * m_throat - over * over, 0.0)), wheel.faceWidth / 2);
}

double WormCut::bend() const {
  const double depth = m_distance - m_rim;
  return (0.65 * std::abs(m_advance) / depth + m_slope) / depth;
}

WormCut::Circle WormCut::blank(double height) const {
  if (std::abs(height) > m_throatEnd * (1 + 1e-9)) return {m_rim, 0};
  const double depth = std::sqrt(m_throat * m_throat - height * height);
  return {m_distance - depth, height / depth};
}

/// The larger of the worm's reach and of what the groove needs, blended so that the root has no edge.
WormCut::Corner WormCut::cornerAt(double height) const {
  const double deepest = m_distance - blank(height).radius + kLeastGroove * m_module;
  const double needed = std::hypot(deepest, height);
  const double perHeight = (height - deepest * blank(height).perHeight) / needed;
  const double blend = kGrooveBlend * m_module, over = needed - m_wormTip;
  if (over <= -blend) return {0, 0, m_wormTip};
  if (over >= blend) return {over, perHeight, needed};
  const double part = (over + blend) / (2 * blend);
  return {part * part * blend, part * perHeight, m_wormTip + part * part * blend};
}

WormCut::Circle WormCut::root(double height) const {
  const Corner corner = cornerAt(height);
  const double depth = std::sqrt(corner.reach * corner.reach - height * height);
  return {m_distance - depth, (height - corner.reach * corner.raisePerHeight) / depth};
}

WormCut::Edge WormCut::edgeAt(double depth, double height, const Corner& corner) const {
  const double square = depth * depth + height * height;
  const double rad = std::sqrt(square);
  const double cutter = rad - corner.raise;  // the radius in the section of the cutter that is not raised
  const double sine = m_slope / std::hypot(1.0, m_slope);
  double half = m_half - (cutter - m_wormPitch) * m_slope;
  double perRad = -m_slope;
  const double over = cutter - (m_wormTip - m_round);
  if (over > m_round * sine) {
    const double across = std::sqrt(std::max(m_round * m_round - over * over, 1e-12 * m_round * m_round));
    half = m_roundCentre + across;
    perRad = -over / across;
  }
  return {half + m_advance * std::atan2(height, depth), perRad * depth / rad - m_advance * height / square,
          perRad * (height / rad - corner.raisePerHeight) + m_advance * depth / square};
}

/// The edge of the cutter is at (x, y) = (distance - depth, along + U) when the worm has gone on by U and the
/// wheel has turned by U / pitch radius: a point of radius r is cut away up to the largest of
/// asin(y / r) - (y - along) / pitch radius, x^2 + y^2 = r^2, over all y that the cutter reaches. Where that
/// is largest its slopes are those at the y, whichever that is.
WormCut::FlankPoint WormCut::flank(double radius, double height) const {
  const Corner corner = cornerAt(height);
  const double deepest = std::sqrt(corner.reach * corner.reach - height * height);
  const double nearest = m_distance - deepest;
  const double end = std::sqrt(std::max(radius * radius - nearest * nearest, 0.0));
  struct Cut {
    double x, y;
    Edge edge;
    double angle;
    double slope;  ///< of the angle with y
  };
  const auto cutAt = [&](double phase) {
    const double y = end * std::sin(phase);
    const double x = std::sqrt(radius * radius - y * y);
    const Edge edge = edgeAt(m_distance - x, height, corner);
    return Cut{x, y, edge, std::atan2(y, x) - (y - edge.along) / m_pitch,
               1 / x - 1 / m_pitch + edge.perDepth * y / (x * m_pitch)};
  };
  constexpr int kProbes = 24;  // from -pi/2 to pi/2
  int best = 0;
  double most = -1e300;
  for (int i = 0; i <= kProbes; ++i) {
    const double angle = cutAt(pi * (i - kProbes / 2) / kProbes).angle;
    if (angle > most) {
      most = angle;
      best = i;
    }
  }
  double low = pi * (std::max(best - 1, 0) - kProbes / 2) / kProbes;
  double high = pi * (std::min(best + 1, kProbes) - kProbes / 2) / kProbes;
  for (int step = 0; step < 26; ++step) {
    const double middle = 0.5 * (low + high);
    (cutAt(middle).slope > 0 ? low : high) = middle;
  }
  const Cut cut = cutAt(0.5 * (low + high));
  return {cut.angle, -(cut.y / radius + cut.edge.perDepth * radius / m_pitch) / cut.x,
          cut.edge.perHeight / m_pitch};
}

double WormCut::landAt(double radius, double height) const {
  return radius * (m_pitchAngle - flank(radius, height).angle - flank(radius, -height).angle);
}

WormCut::Circle WormCut::tip(double height) const {
  const Circle circle = blank(height);
  const double least = kNarrowestLand * m_module;
  if (landAt(circle.radius, height) >= least) return circle;
  const double lowest = root(height).radius + 0.05 * m_module;
  double low = lowest, high = circle.radius;
  for (int step = 0; step < 20; ++step) {
    const double middle = 0.5 * (low + high);
    (landAt(middle, height) > least ? low : high) = middle;
  }
  return {low, 0};
}

}  // namespace geargraph
