#include "core/presentation/schematic/coupling_symbols.h"

#include <algorithm>
#include <array>

#include "core/mechanism/model/shift_edits.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/schematic/arm_router.h"
#include "core/presentation/schematic/section_symbols.h"

namespace geargraph {
namespace {

constexpr double kPlateHalf = 8;
constexpr double kPlateGap = 4.5;
constexpr double kPlateWidth = 2.8;
constexpr double kClear = 3;  ///< that a symbol keeps from everything else
constexpr double kSample = 6;
constexpr double kBeyondPlate = 7;  ///< from a clutch's second plate to where its arm may turn
constexpr int kDepth = kLineDepth + 2;

/// Two plates that face each other: the first on a stem from `foot`, which lies on a line of its link.
struct Plates {
  CanvasPoint foot;
  CanvasPoint way;  ///< from the foot to the plates, a unit vector
  double stem = 0;  ///< from the foot to the first plate
  double cost = 1e300;
  [[nodiscard]] CanvasPoint at(double beyond) const { return foot + (stem + beyond) * way; }
};

Extent boxOf(CanvasPoint from, CanvasPoint to, double half, CanvasPoint way) {
  const CanvasPoint across = half * turned(way);
  return Extent::spanning(from - across, from + across).united(Extent::spanning(to - across, to + across));
}

class CouplingPlacer {
 public:
  CouplingPlacer(const DrawnPart& part, const SheetLayout& layout, Section& section,
                 const std::stop_token& stop)
      : m_part(part),
        m_layout(layout),
        m_section(section),
        m_stop(stop),
        m_taken(obstaclesOf(section, 120)) {}

  void add(const ShiftElement& coupling) {
    std::vector<int> links;
    for (const LinkId id : coupling.links) {
      const auto& all = m_part.mechanism.links;
      const auto found =
          std::find_if(all.begin(), all.end(), [id](const Link& link) { return link.id == id; });
      if (found == all.end()) return;
      links.push_back(static_cast<int>(found - all.begin()));
    }
    m_coupling = coupling.id;
    m_isEngaged = isEngaged(m_part.mechanism, coupling.id);
    if (coupling.kind == ShiftElementKind::brake) {
      addBrake(links[0]);
    } else if (!addFacing(links[0], links[1])) {
      addRoundabout(links[0], links[1]);
    }
  }

 private:
  /// Does a half section leave this side of the axis empty?
  [[nodiscard]] bool isLeftOut(CanvasPoint p) const {
    return std::any_of(m_layout.axes.begin(), m_layout.axes.end(),
                       [&](const SheetAxis& axis) { return axis.half && axis.heightOf(p) < -1; });
  }

  /// What plates at a foot cost: their stem, and a side of the axis that is left out. `beyond`: what stands
  /// behind the second plate.
  [[nodiscard]] bool isFree(const Plates& plates, double beyond) const {
    const CanvasPoint behind = plates.at(kPlateGap + beyond);
    return !m_taken.touches(boxOf(plates.at(0), behind, kPlateHalf, plates.way), kClear) &&
           !m_taken.touches(boxOf(plates.foot + 4.0 * plates.way, plates.at(0), 1, plates.way), 1.5);
  }

  /// The free places beside the lines of a link, the cheapest first.
  [[nodiscard]] std::vector<Plates> placesAt(int link, double beyond, std::size_t most) const {
    constexpr std::array<double, 9> kStems{9, 14, 20, 28, 40, 56, 80, 120, 180};
    std::vector<Plates> places;
    for (const double stem : kStems) {
      for (const LinkLine& line : m_section.lines) {
        if (line.link != link || line.penalty < 0 || distance(line.from, line.to) < 2 * kSample) continue;
        const CanvasPoint along = unit(line.to - line.from);
        const double whole = distance(line.from, line.to);
        for (double at = kSample; at <= whole - kSample / 2; at += kSample) {
          for (const double side : {1.0, -1.0}) {
            Plates plates{line.from + at * along, side * turned(along), stem, stem};
            if (isLeftOut(plates.at(kPlateGap))) plates.cost += 60;
            plates.cost += 0.1 * std::abs(at - whole / 2);
            if (isFree(plates, beyond)) places.push_back(plates);
          }
        }
      }
      if (!places.empty() && places.size() >= most) break;
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const Plates& a, const Plates& b) { return a.cost < b.cost; });
    if (places.size() > most) places.resize(most);
    return places;
  }

  // --- what is drawn ---

  void stroke(std::vector<CanvasPoint> points, const Tint& tint, double width) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Curve chord = Curve::straight(points[i - 1], points[i]);
      m_section.outlines.push_back({m_coupling, kDepth, chord, 4});
      m_taken.addCurve(chord);
    }
    m_section.marks.push_back({m_coupling, MarkRole::line, kDepth,
                               Stroke{Polyline{std::move(points), false}, tint, width, Dash::solid}});
  }
  [[nodiscard]] Tint tintOf(int link) const { return m_part.tintOf(link); }
  void plate(CanvasPoint middle, CanvasPoint way, const Tint& tint) {
    const CanvasPoint across = kPlateHalf * turned(way);
    stroke({middle - across, middle + across}, tint, kPlateWidth);
  }
  void anchor(const Plates& plates) {
    if (m_isEngaged) {  // closed: nothing is left between the plates
      m_section.marks.push_back({m_coupling, MarkRole::line, kDepth + 1,
                                 Stroke{Polyline{{plates.at(-1), plates.at(kPlateGap + 1)}, false},
                                        ColorRole::ink, 2 * kPlateHalf - 2, Dash::solid}});
    }
    Section::Anchors anchors{m_coupling, {}};
    const CanvasPoint middle = plates.at(kPlateGap / 2);
    const CanvasPoint across = kPlateHalf * turned(plates.way);
    anchors.places = {middle + across, middle - across, middle};
    m_section.couplings.push_back(std::move(anchors));
  }

  void addBrake(int link) {
    const std::vector<Plates> places = placesAt(link, kHatching, 1);
    if (places.empty()) return;
    const Plates& plates = places.front();
    stroke({plates.foot, plates.at(0)}, tintOf(link), kLinkWidth);
    plate(plates.at(0), plates.way, tintOf(link));
    const CanvasPoint base = plates.at(kPlateGap);
    plate(base, plates.way, tintOf(0));
    const CanvasPoint across = kPlateHalf * turned(plates.way);
    for (auto& points : hatching(base - across, base + across, plates.way)) {
      m_taken.addCurve(Curve::straight(points.front(), points.back()));
      m_section.marks.push_back(
          {m_coupling, MarkRole::hatching, kDepth,
           Stroke{Polyline{std::move(points), false}, ColorRole::secondary, 1.1, Dash::solid}});
    }
    anchor(plates);
  }

  /// Two parallel lines with nothing between them.
  bool addFacing(int one, int other) {
    constexpr double kNearest = 16;
    constexpr double kMaxDistance = 140;
    Plates best;
    double gap = 0;
    for (const LinkLine& a : m_section.lines) {
      if (a.link != one || distance(a.from, a.to) < kSample) continue;
      const CanvasPoint along = unit(a.to - a.from);
      for (const LinkLine& b : m_section.lines) {
        if (b.link != other || std::abs(dot(unit(b.to - b.from), turned(along))) > 1e-3) continue;
        const double away = dot(b.from - a.from, turned(along));
        if (std::abs(away) < kNearest || std::abs(away) > std::min(kMaxDistance, best.cost)) continue;
        const CanvasPoint way = (away < 0 ? -1.0 : 1.0) * turned(along);
        const double b0 = dot(b.from - a.from, along);
        const double b1 = dot(b.to - a.from, along);
        const double low = std::max(0.0, std::min(b0, b1)) + 2;
        const double high = std::min(distance(a.from, a.to), std::max(b0, b1)) - 2;
        for (double at = low; at <= high; at += kSample) {
          const Plates plates{a.from + at * along, way, (std::abs(away) - kPlateGap) / 2, std::abs(away)};
          const CanvasPoint end = plates.foot + (std::abs(away) - 4) * way;
          if (!isFree(plates, 0) || m_taken.touches(boxOf(plates.at(kPlateGap), end, 1, way), 1.5)) continue;
          if (plates.cost >= best.cost) continue;
          best = plates;
          gap = std::abs(away);
        }
      }
    }
    if (gap == 0) return false;
    drawClutch(one, other, best, {best.at(kPlateGap), best.foot + gap * best.way});
    return true;
  }

  /// The second plate of the cheapest place on an arm of its link.
  void addRoundabout(int one, int other) {
    constexpr std::size_t kMaxTried = 10;
    struct Found {
      int holder = 0;
      int reacher = 0;
      Plates plates;
      std::vector<CanvasPoint> course;
    };
    std::optional<Found> best;
    double least = 1e300;
    m_lanes.follow(m_section.lines);
    for (const auto& [holder, reacher] : {std::pair(one, other), std::pair(other, one)}) {
      const std::vector<Plates> places = placesAt(holder, kBeyondPlate, kMaxTried);
      std::vector<CanvasPoint> ends;
      std::vector<double> prices;
      for (const Plates& plates : places) {
        ends.push_back(plates.at(kPlateGap + kBeyondPlate));
        prices.push_back(plates.cost);
      }
      m_router.begin(m_lanes.gridWith(ends), m_section.lines);
      const auto course = m_router.route(reacher, {}, ends, prices, m_stop);
      if (!course) continue;
      const Plates& plates = places[course->target];
      const double cost = plates.cost + course->length + 300 * course->crossings;
      if (cost >= least) continue;
      least = cost;
      best = Found{holder, reacher, plates, course->points};
    }
    if (!best) return;
    std::vector<CanvasPoint> arm = std::move(best->course);
    const CanvasPoint end = best->plates.at(kPlateGap + kBeyondPlate);
    if (distance(arm.front(), end) < distance(arm.back(), end)) std::reverse(arm.begin(), arm.end());
    arm.push_back(best->plates.at(kPlateGap));
    drawClutch(best->holder, best->reacher, best->plates, std::move(arm));
  }

  void drawClutch(int one, int other, const Plates& plates, std::vector<CanvasPoint> arm) {
    stroke({plates.foot, plates.at(0)}, tintOf(one), kLinkWidth);
    plate(plates.at(0), plates.way, tintOf(one));
    plate(plates.at(kPlateGap), plates.way, tintOf(other));
    for (std::size_t i = 1; i < arm.size(); ++i) m_section.lines.push_back({arm[i - 1], arm[i], other, -1});
    stroke(std::move(arm), tintOf(other), kLinkWidth);
    anchor(plates);
  }

  const DrawnPart& m_part;
  const SheetLayout& m_layout;
  Section& m_section;
  const std::stop_token& m_stop;
  ObstacleGrid m_taken;
  ArmLanes m_lanes;
  ArmRouter m_router;
  ElementId m_coupling;
  bool m_isEngaged = false;
};

}  // namespace

void addCouplings(const DrawnPart& part, const SheetLayout& layout, Section& section,
                  const std::stop_token& stop) {
  if (part.mechanism.couplings.empty() || section.marks.empty()) return;
  CouplingPlacer placer(part, layout, section, stop);
  for (const ShiftElement& coupling : part.mechanism.couplings) {
    if (stop.stop_requested()) return;
    placer.add(coupling);
  }
}

}  // namespace geargraph
