#include "core/presentation/drawing/label_placement.h"

#include <array>

#include "core/presentation/drawing/digraph_geometry.h"

namespace geargraph {
namespace {

constexpr double kLabelGap = 2.5;  ///< that a label keeps from everything
constexpr double kNearLine = 7;    ///< between a label and its own line
constexpr double kRim = kNodeRadius + kRingWidth / 2;

/// The box beside the curve at t, on the left (+1) or right (-1) side, `gap` away from the tangent.
Extent beside(const Curve& curve, double t, int side, double gap, double halfWidth, double halfHeight) {
  const CanvasPoint out = -1.0 * side * turned(curve.direction(t));
  const double support = halfWidth * std::abs(out.x) + halfHeight * std::abs(out.y);
  return {curve.at(t) + (support + gap) * out, halfWidth, halfHeight};
}

constexpr std::array<double, 3> kRoominess{5, 10, 18};  ///< gaps that are tried around a free place
constexpr std::array<double, 5> kDistances{kNearLine, kNearLine + 7, kNearLine + 16, kNearLine + 27,
                                           kNearLine + 40};
constexpr std::array<double, 21> kPlaces{0.5,  0.46, 0.54, 0.42, 0.58, 0.38, 0.62, 0.34, 0.66, 0.3, 0.7,
                                         0.26, 0.74, 0.22, 0.78, 0.18, 0.82, 0.14, 0.86, 0.1,  0.9};

/// How many steps a free box can grow until it touches something.
int roominess(const Extent& box, const ObstacleGrid& taken) {
  int steps = 0;
  for (const double gap : kRoominess) {
    if (taken.touches(box, gap)) break;
    ++steps;
  }
  return steps;
}

}  // namespace

LabelPlace placeBeside(const Curve& curve, double halfWidth, double halfHeight, const ObstacleGrid& taken) {
  for (const double gap : kDistances) {
    for (const double t : kPlaces) {
      std::optional<CanvasPoint> best;
      int most = -1;
      for (const int side : {1, -1}) {
        const Extent box = beside(curve, t, side, gap, halfWidth, halfHeight);
        if (taken.touches(box, kLabelGap)) continue;
        const int room = roominess(box, taken);
        if (room <= most) continue;
        most = room;
        best = box.center;
      }
      if (best) return {*best, false};
    }
  }
  return {beside(curve, 0.5, 1, kNearLine, halfWidth, halfHeight).center, true};
}

bool isStillBeside(const Curve& curve, double halfWidth, double halfHeight, const LabelPlace& former,
                   const ObstacleGrid& changed) {
  for (const double gap : kDistances) {
    for (const double t : kPlaces) {
      bool found = false;
      for (const int side : {1, -1}) {
        const Extent box = beside(curve, t, side, gap, halfWidth, halfHeight);
        if (changed.touches(box, kRoominess.back())) return false;
        found = found || box.center == former.center;
      }
      // All that was looked at before the place was chosen is as it was. A crowded label looked at
      // everything.
      if (found && !former.crowded) return true;
    }
  }
  return former.crowded;
}

LabelPlace placeAtCorner(CanvasPoint center, int node, const ObstacleGrid& taken) {
  constexpr std::array<CanvasPoint, 34> kOffsets{{{-34, -22},
                                                  {34, -22},
                                                  {-34, 22},
                                                  {34, 22},
                                                  {0, -33},
                                                  {0, 33},
                                                  {-44, 0},
                                                  {44, 0},
                                                  // Between these, where arrows take all of them.
                                                  {-42, -11},
                                                  {42, -11},
                                                  {-42, 11},
                                                  {42, 11},
                                                  {-18, -31},
                                                  {18, -31},
                                                  {-18, 31},
                                                  {18, 31},
                                                  // And farther out, where arrows bend round the node.
                                                  {-40, -32},
                                                  {40, -32},
                                                  {-40, 32},
                                                  {40, 32},
                                                  {-50, -14},
                                                  {50, -14},
                                                  {-50, 14},
                                                  {50, 14},
                                                  // Beyond the heads of many arrows, as a last resort.
                                                  {-30, -46},
                                                  {30, -46},
                                                  {-30, 46},
                                                  {30, 46},
                                                  {-56, -30},
                                                  {56, -30},
                                                  {-56, 30},
                                                  {56, 30},
                                                  {0, -46},
                                                  {0, 46}}};
  for (const CanvasPoint offset : kOffsets) {
    if (!taken.touches(badgeExtent(center + offset), kLabelGap, node)) return {center + offset, false};
  }
  return {center + kOffsets.front(), true};
}

std::optional<CanvasPoint> placeAround(CanvasPoint center, double halfWidth, double halfHeight,
                                       const ObstacleGrid& taken) {
  const double beyond = kRim + 3 + halfHeight;
  const double aside = kRim + 4 + halfWidth;
  for (const CanvasPoint offset :
       {CanvasPoint{0, beyond}, CanvasPoint{0, -beyond}, CanvasPoint{aside, 0}, CanvasPoint{-aside, 0}}) {
    const Extent box{center + offset, halfWidth, halfHeight};
    if (!taken.touches(box, kLabelGap)) return box.center;
  }
  return std::nullopt;
}

}  // namespace geargraph
