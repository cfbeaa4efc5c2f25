#include "core/presentation/lever_drawing/point_plan.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/foundations/base/position_index.h"
#include "core/foundations/base/words.h"
#include "core/presentation/drawing/text_metrics.h"
#include "core/presentation/lever_drawing/lever_marks.h"
#include "core/presentation/lever_drawing/lever_words.h"

namespace geargraph::inline lever_drawing {
namespace {

constexpr double kPlanWidth = 460;
constexpr double kPlanHeight = 340;
constexpr double kPlanDiscGap = 40;  ///< between centres of discs

class PointPlanDrawer {
 public:
  PointPlanDrawer(const Mechanism& mechanism, const LeverPlan& plan, const Emphases& emphases)
      : m_mechanism(mechanism),
        m_plan(plan),
        m_painter(mechanism, emphases,
                  Extent::spanning({-200, -200}, {kPlanWidth + 200, kPlanHeight + 200})) {}

  DisplayList drawn() {
    if (const std::string why = whyNoPointPlan(m_mechanism, m_plan); !why.empty()) {
      m_painter.fixedText({}, {0, 0}, why, 13, false, ColorRole::secondary);
      return m_painter.take();
    }
    placePoints();
    for (const Lever& lever : m_plan.levers) drawLever(lever);
    for (const auto& place : m_places) {
      if (distance(place.center, place.at) > 1)
        m_painter.line(m_mechanism.links[place.links.front()].id, {place.at, place.center},
                       ColorRole::secondary, 0.8);
      m_painter.disc(place.links, place.center, place.links.front() == 0);
    }
    drawCouplings();
    for (const Lever& lever : m_plan.levers) {
      const SheetPoint end = endOf(lever);
      m_painter.text({}, end, {Side::right, Side::below, Side::above, Side::left}, setsOf(lever), kValueSize,
                     true, ColorRole::ink);
    }
    return m_painter.take();
  }

 private:
  struct Place {
    std::vector<LinkOrdinal> links;
    SheetPoint at;
    SheetPoint center;
  };

  void placePoints() {
    std::map<std::pair<Rational, Rational>, std::vector<LinkOrdinal>> links;
    for (std::size_t i = 0; i < m_plan.links.size(); ++i)
      links[{m_plan.points[i][0], m_plan.points[i][1]}].push_back(m_plan.links[i]);
    std::pair<Rational, Rational> least = links.begin()->first;
    std::pair<Rational, Rational> most = least;
    for (const auto& [point, all] : links) {
      least = {std::min(least.first, point.first), std::min(least.second, point.second)};
      most = {std::max(most.first, point.first), std::max(most.second, point.second)};
    }
    for (auto& [point, all] : links) {
      const double x = ((point.first - least.first) / (most.first - least.first)).toDouble();
      const double y = ((point.second - least.second) / (most.second - least.second)).toDouble();
      const SheetPoint at{kPlanWidth * x, kPlanHeight * (1 - y)};
      m_places.push_back({std::move(all), at, at});
    }
    std::sort(m_places.begin(), m_places.end(),
              [](const Place& a, const Place& b) { return a.links.front() < b.links.front(); });
    for (std::size_t i = 1; i < m_places.size(); ++i) moveApart(i);
  }

  /// A disc that has no room at its point goes up to the right of it, then further.
  void moveApart(std::size_t i) {
    const auto isFree = [&] {
      return std::none_of(
          m_places.begin(), m_places.begin() + static_cast<std::ptrdiff_t>(i),
          [&](const Place& other) { return extentOf(other).grown(4).meets(extentOf(m_places[i])); });
    };
    for (double off = kPlanDiscGap; !isFree(); off += kPlanDiscGap / 2)
      m_places[i].center = m_places[i].at + off * SheetPoint{0.6, -0.8};
  }

  [[nodiscard]] static Extent extentOf(const Place& place) {
    return {place.center, LeverPainter::halfWidthOf(place.links), kDiscRadius};
  }
  /// A place for a letter on the way between two points, as near its middle as discs and letters allow;
  /// beside it where they leave none.
  [[nodiscard]] SheetPoint letterPlace(const std::string& name, SheetPoint from, SheetPoint to) const {
    const double half = std::max(kChipRadius, textWidth(name, kSmallSize, true) / 2 + 4);
    const auto isFree = [&](SheetPoint center) {
      const Extent box{center, half, kChipRadius};
      return std::none_of(m_places.begin(), m_places.end(),
                          [&](const Place& place) { return extentOf(place).grown(3).meets(box); }) &&
             std::none_of(m_letters.begin(), m_letters.end(),
                          [&](const Extent& other) { return other.grown(2).meets(box); });
    };
    for (int step = 0; step <= 8; ++step) {
      for (const double side : {1.0, -1.0}) {
        const SheetPoint center = between(from, to, 0.5 + side * 0.05 * step);
        if (isFree(center)) return center;
      }
    }
    const SheetPoint across = turned(unit(to - from));
    double off = kChipRadius;
    while (!isFree(between(from, to, 0.5) + off * across)) off += kChipRadius;
    return between(from, to, 0.5) + off * across;
  }

  [[nodiscard]] const Place& placeOf(LinkOrdinal link) const {
    return *std::find_if(m_places.begin(), m_places.end(), [&](const Place& place) {
      return std::find(place.links.begin(), place.links.end(), link) != place.links.end();
    });
  }
  [[nodiscard]] SheetPoint endOf(const Lever& lever) const {
    const SheetPoint first = placeOf(lever.points.front().links.front()).at;
    const SheetPoint last = placeOf(lever.points.back().links.front()).at;
    return last + 0.12 * (last - first);
  }

  void drawLever(const Lever& lever) {
    const SheetPoint first = placeOf(lever.points.front().links.front()).at;
    const SheetPoint last = placeOf(lever.points.back().links.front()).at;
    const SheetPoint beyond = 0.12 * (last - first);
    m_painter.line({}, {first - beyond, last + beyond}, ColorRole::ink, lever.isByMeshes ? 2.4 : 1.4,
                   lever.isByMeshes ? Dash::solid : Dash::dashed);
    m_painter.blockLine(first - beyond, last + beyond);
  }

  void drawCouplings() {
    const PositionIndex<LinkTag> linkAt(m_mechanism.links);
    for (const Coupling& coupling : m_mechanism.couplings) {
      const LinkOrdinal one = linkAt.at(coupling.links[0]);
      const LinkOrdinal other =
          coupling.kind == CouplingKind::brake ? LinkOrdinal(0) : LinkOrdinal(linkAt.at(coupling.links[1]));
      if (m_plan.positionOf(one) < 0 || m_plan.positionOf(other) < 0) continue;
      const Place& from = placeOf(one);
      const Place& to = placeOf(other);
      if (&from == &to) continue;  // engaged already
      m_painter.line(coupling.id, {from.at, to.at}, ColorRole::secondary, 1.6, Dash::dotted);
      const SheetPoint center = letterPlace(coupling.id.text(), from.at, to.at);
      m_letters.push_back({center,
                           std::max(kChipRadius, textWidth(coupling.id.text(), kSmallSize, true) / 2 + 4),
                           kChipRadius});
      m_painter.chip(coupling.id, center, false);
    }
  }

  const Mechanism& m_mechanism;
  const LeverPlan& m_plan;
  LeverPainter m_painter;
  std::vector<Place> m_places;  ///< by their first links
  std::vector<Extent> m_letters;
};

}  // namespace

std::string whyNoPointPlan(const Mechanism& mechanism, const LeverPlan& plan) {
  if (plan.basis.size() == 2) return {};
  const bool isLocked = plan.absence == LeverAbsence::unsolvable || plan.absence == LeverAbsence::locked ||
                        plan.absence == LeverAbsence::tooLarge;
  return isLocked ? absenceSentence(mechanism, plan)
                  : translated("The plan shows two freedoms; the links on the ground's axis have %1.",
                               {std::to_string(plan.basis.size())});
}

DisplayList pointPlanDrawing(const Mechanism& mechanism, const LeverPlan& plan, const Emphases& emphases) {
  return PointPlanDrawer(mechanism, plan, emphases).drawn();
}

}  // namespace geargraph::inline lever_drawing
