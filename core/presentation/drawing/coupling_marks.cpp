#include "core/presentation/drawing/coupling_marks.h"

#include <algorithm>
#include <numbers>

#include "core/mechanism/model/shift_edits.h"
#include "core/presentation/drawing/arrow_marks.h"
#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/edge_routing.h"
#include "core/presentation/drawing/label_placement.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kRim = kNodeRadius + kRingWidth / 2;
constexpr double kStub = 13;      ///< from the rim to the first plate of a brake
constexpr double kPlateGap = 4;   ///< between the plates
constexpr double kPlateHalf = 8;  ///< of their length
constexpr double kNameSizeOf = 11;
constexpr double kLineWidth = 1.5;
constexpr double kPlateWidth = 2.2;
constexpr std::size_t kMaxMarkName = 10;

double halfWidthOf(const std::string& name) {
  return textWidth(name, kNameSizeOf, true) / 2;
}

Extent labelExtentOf(const ShiftElementPlace& place) {
  return {place.labelCenter, halfWidthOf(place.name), kNameSizeOf * 0.45};
}

/// Both plates, with the hatching behind a brake's second one.
Extent platesExtent(const ShiftElementPlace& place) {
  const CanvasPoint across = kPlateHalf * turned(place.way);
  const double behind = place.kind == ShiftElementKind::brake ? kPlateGap / 2 + kHatchDepth : kPlateGap / 2;
  const CanvasPoint from = place.plates - (kPlateGap / 2) * place.way;
  const CanvasPoint to = place.plates + behind * place.way;
  return Extent::spanning(from - across, from + across).united(Extent::spanning(to - across, to + across));
}

/// The place of a brake that leaves its node in a direction.
ShiftElementPlace brakeAt(ShiftElementPlace place, CanvasPoint center, double angle, double stub) {
  const CanvasPoint way{std::cos(angle), std::sin(angle)};
  place.way = way;
  place.plates = center + (kRim + stub + kPlateGap / 2) * way;
  place.line = Curve::straight(center + kRim * way, center + (kRim + stub) * way);
  const double half = std::abs(way.x) * halfWidthOf(place.name) + std::abs(way.y) * kNameSizeOf * 0.45;
  place.labelCenter = place.plates + (kPlateGap / 2 + kHatchDepth + 3 + half) * way;
  return place;
}

/// Round the node where nothing stands yet, to the right of its foot first; where arrows leave no way for the
/// line, it crosses one rather than its plates or its name.
ShiftElementPlace placedBrake(const ShiftElementPlace& place, CanvasPoint center, int node,
                              const ObstacleGrid& taken) {
  constexpr double kGap = 2;
  constexpr int kTurns = 32;
  constexpr int kFirst = 4;  ///< of them: to the lower right
  for (const bool mayCross : {false, true}) {
    for (const double stub : {kStub, 2 * kStub, 3 * kStub, 5 * kStub}) {
      for (int k = 0; k < kTurns; ++k) {
        const int turn = kFirst + 8 * k + k / 4;  // the diagonals first, then what lies beside them
        const ShiftElementPlace tried = brakeAt(place, center, 2 * std::numbers::pi * turn / kTurns, stub);
        const Extent stem = Extent::spanning(center + (kRim + 3) * tried.way, tried.plates);
        const bool isFree = !taken.touches(platesExtent(tried), kGap, node) &&
                            !taken.touches(labelExtentOf(tried), kGap, node) &&
                            (mayCross || !taken.touches(stem, kGap, node));
        if (isFree) return tried;
      }
    }
  }
  return brakeAt(place, center, 2 * std::numbers::pi * kFirst / kTurns, kStub);
}

/// How much of a line runs along or across what stands already: the share of its chords that touch.
double touched(const Curve& line, const ObstacleGrid& taken) {
  constexpr int kChords = 24;
  int touching = 0;
  for (int i = 1; i < kChords - 1; ++i) {
    const CanvasPoint from = line.at(static_cast<double>(i) / kChords);
    const CanvasPoint to = line.at(static_cast<double>(i + 1) / kChords);
    if (taken.touches(Extent::spanning(from, to), 2)) ++touching;
  }
  return static_cast<double>(touching) / kChords;
}

/// Between both nodes, bent aside as far as it runs along nothing else and its plates stand free.
ShiftElementPlace placedClutch(const ShiftElementPlace& place, const DigraphEdge& between,
                               const Centers& centers, const ObstacleGrid& nodes, const ObstacleGrid& badges,
                               const ObstacleGrid& taken) {
  constexpr double kCrowded = 2;  ///< costs as much as a line that touches all the way, twice
  constexpr double kBadge = 20;   ///< a line may cross lines, but not through a word
  ShiftElementPlace best = place;
  double least = 1e300;
  for (const double offset : {0.0, 22.0, -22.0, 40.0, -40.0, 60.0, -60.0, 85.0, -85.0, 120.0, -120.0}) {
    const Courses courses = routedEdges(std::span(&between, 1), {offset}, centers, nodes);
    if (!courses.front()) continue;
    ShiftElementPlace tried = place;
    tried.line = courses.front()->curve;
    const double cost =
        touched(tried.line, taken) + kBadge * touched(tried.line, badges) + 0.004 * std::abs(offset);
    for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8}) {
      tried.plates = tried.line.at(share);
      tried.way = tried.line.direction(share);
      const bool crowded = taken.touches(platesExtent(tried), 4);
      if (cost + (crowded ? kCrowded : 0) >= least) continue;
      least = cost + (crowded ? kCrowded : 0);
      best = tried;
    }
  }
  return best;
}

}  // namespace

std::vector<ShiftElementPlace> placedCouplings(const Mechanism& mechanism, const Digraph& graph,
                                               const Centers& centers, const std::vector<NodePlace>& nodes,
                                               ObstacleGrid& taken) {
  std::vector<ShiftElementPlace> places;
  if (mechanism.couplings.empty()) return places;
  const ObstacleGrid discs = gridWithNodes(centers);
  ObstacleGrid badges(areaOf(centers));
  for (const NodePlace& node : nodes) {
    if (node.input) badges.addBox(badgeExtent(node.badgeCenter));
    if (node.groundSide) badges.addBox(hatchingExtent(node));
  }
  for (const ShiftElement& coupling : mechanism.couplings) {
    std::vector<int> ends;
    for (const LinkId link : coupling.links) ends.push_back(graph.nodeOf(link));
    const bool known = std::all_of(ends.begin(), ends.end(),
                                   [&](int v) { return centers[static_cast<std::size_t>(v)].has_value(); });
    if (!known) continue;
    ShiftElementPlace place;
    place.coupling = coupling.id;
    place.kind = coupling.kind;
    place.name = elided(coupling.id.text(), kMaxMarkName);
    place.isEngaged = isEngaged(mechanism, coupling.id);
    if (coupling.kind == ShiftElementKind::brake) {
      place = placedBrake(place, *centers[static_cast<std::size_t>(ends[0])], ends[0], taken);
    } else {
      place = placedClutch(place, {ends[0], ends[1]}, centers, discs, badges, taken);
      taken.addBox(platesExtent(place));
      taken.addCurve(place.line);
      const Extent size = labelExtentOf(place);
      const Curve near = Curve::straight(place.plates - 14 * place.way, place.plates + 14 * place.way);
      LabelPlace label = placeBeside(near, size.halfWidth, size.halfHeight, taken);
      if (label.crowded) label = placeBeside(place.line, size.halfWidth, size.halfHeight, taken);
      place.labelCenter = label.center;
    }
    taken.addCurve(place.line);
    taken.addBox(platesExtent(place));
    taken.addBox(labelExtentOf(place));
    places.push_back(std::move(place));
  }
  return places;
}

Extent couplingExtent(const ShiftElementPlace& place) {
  return platesExtent(place).united(labelExtentOf(place));
}

DisplayList couplingDrawing(const ShiftElementPlace& place, const Emphasis& emphasis) {
  DisplayList list;
  Pen pen(list, place.coupling);
  const Tint tint = emphasis.selected ? ColorRole::accent
                    : place.isEngaged ? ColorRole::ink
                                      : ColorRole::secondary;
  const double gap = place.isEngaged ? kPlateWidth : kPlateGap;  // the plates touch
  if (emphasis.any()) {
    pen.put(MarkRole::halo, kHaloDepth, Stroke{place.line, ColorRole::halo, 9, Dash::solid});
    pen.put(MarkRole::halo, kHaloDepth, Fill{Box{platesExtent(place).grown(4), 4}, ColorRole::halo});
  }
  pen.put(MarkRole::line, kLineDepth,
          Stroke{place.line, tint, kLineWidth, place.isEngaged ? Dash::solid : Dash::dashed});
  const CanvasPoint across = kPlateHalf * turned(place.way);
  if (!place.isEngaged) {  // the dashed line does not run through between the plates
    const CanvasPoint half = (kPlateGap / 2) * place.way;
    pen.put(MarkRole::line, kLineDepth + 1,
            Stroke{Polyline{{place.plates - half, place.plates + half}, false}, ColorRole::sheet, 4,
                   Dash::solid});
  }
  for (const double side : {-0.5, 0.5}) {
    const CanvasPoint middle = place.plates + side * gap * place.way;
    pen.put(MarkRole::line, kLineDepth + 2,
            Stroke{Polyline{{middle - across, middle + across}, false}, tint, kPlateWidth, Dash::solid});
  }
  if (place.kind == ShiftElementKind::brake) {
    const CanvasPoint base = place.plates + (gap / 2) * place.way;
    for (const double share : {-0.8, -0.25, 0.3, 0.85}) {
      const CanvasPoint foot = base + share * across;
      pen.put(MarkRole::hatching, kLineDepth + 2,
              Stroke{Polyline{{foot, foot + kHatchDepth * place.way - 0.6 * across}, false}, tint, 1.2,
                     Dash::solid});
    }
  }
  if (place.isEngaged) {
    const Extent label = labelExtentOf(place);
    pen.put(MarkRole::label, kLabelDepth, Fill{Box{label.grown(3), 7}, tint});
  }
  pen.put(MarkRole::label, kLabelDepth + (place.isEngaged ? 1 : 0),
          Text{place.name, place.labelCenter, kNameSizeOf, true,
               place.isEngaged ? Tint(ColorRole::sheet) : tint});
  list.outlines.push_back({place.coupling, kLineDepth, place.line, 5});
  list.outlines.push_back({place.coupling, kLabelDepth, Box{couplingExtent(place), 0}, 0});
  return list;
}

}  // namespace geargraph
