#include "core/presentation/diagrams/point_plan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/foundations/base/position_index.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/diagrams/lever_marks.h"
#include "core/presentation/diagrams/lever_words.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kPlanWidth = 460;
constexpr double kPlanHeight = 340;
constexpr double kPlanDiscGap = 40;    ///< between centres of discs
constexpr double kProjectionGap = 70;  ///< from the plane to the line that it is projected onto

class PointPlanDrawer {
 public:
  PointPlanDrawer(const Mechanism& mechanism, const LeverPlan& plan,
                  const std::optional<PlanProjection>& projection, const Emphases& emphases)
      : m_mechanism(mechanism),
        m_plan(plan),
        m_linkAt(mechanism.links),
        m_projection(projection),
        m_painter(mechanism, emphases,
                  Extent::spanning({-kPlanWidth, -kPlanWidth}, {2 * kPlanWidth, 2 * kPlanWidth})) {}

  PointPlanSheet drawn() {
    if (const std::string why = whyNoPointPlan(m_mechanism, m_plan); !why.empty()) {
      m_painter.fixedText({}, {0, 0}, why, 13, false, ColorRole::secondary);
      return {m_painter.take(), {}};
    }
    placePoints();
    m_projection ? drawProjection() : drawPlane();
    return {m_painter.take(), std::move(m_spots)};
  }

 private:
  struct Place {
    std::vector<LinkOrdinal> links;
    std::pair<Rational, Rational> point;
    CanvasPoint at;
    CanvasPoint center;
  };

  void drawPlane() {
    for (std::size_t i = 1; i < m_places.size(); ++i) moveApart(i);
    for (const Lever& lever : m_plan.levers) drawLever(lever);
    for (const auto& place : m_places) drawDisc(place.links, place.at, place.center);
    drawCouplings();
    for (const Lever& lever : m_plan.levers) {
      const CanvasPoint end = endOf(lever);
      m_painter.text({}, end, {LetterSide::right, LetterSide::below, LetterSide::above, LetterSide::left},
                     setsOf(lever), kValueSize, true, ColorRole::ink);
    }
  }

  void drawDisc(const std::vector<LinkOrdinal>& links, CanvasPoint at, CanvasPoint center) {
    if (distance(center, at) > 1)
      m_painter.line(m_mechanism.links[links.front()].id, {at, center}, ColorRole::secondary, 0.8);
    m_painter.disc(links, center, links.front() == 0);
    m_spots.push_back({links, center});
  }

  /// The other side of a brake is the ground.
  [[nodiscard]] std::pair<LinkOrdinal, LinkOrdinal> endsOf(const ShiftElement& coupling) const {
    return {m_linkAt.at(coupling.links[0]), coupling.kind == ShiftElementKind::brake
                                                ? LinkOrdinal(0)
                                                : LinkOrdinal(m_linkAt.at(coupling.links[1]))};
  }

  /// Points that one line in the direction of the coupling joins become one.
  struct Image {
    Rational across;  ///< the same for all of them
    std::vector<LinkOrdinal> links;
    CanvasPoint at;
  };

  void drawProjection() {
    const ShiftElement& coupling = m_mechanism.couplings[m_projection->coupling];
    const auto [one, other] = endsOf(coupling);
    const Place& from = placeOf(one);
    const Place& to = placeOf(other);
    const CanvasPoint along = unit(to.at - from.at);
    double end = 0;
    for (const Place& place : m_places) end = std::max(end, dot(place.at, along));
    end += kProjectionGap;
    std::vector<Image> images;
    for (const Place& place : m_places) {
      const CanvasPoint image = place.at + (end - dot(place.at, along)) * along;
      m_painter.line({}, {place.at, image}, ColorRole::secondary, 1, Dash::dotted);
      const Rational across = place.point.first * (to.point.second - from.point.second) -
                              place.point.second * (to.point.first - from.point.first);
      const auto same = std::find_if(images.begin(), images.end(),
                                     [&](const Image& each) { return each.across == across; });
      if (same == images.end()) {
        images.push_back({across, place.links, image});
      } else {
        same->links.insert(same->links.end(), place.links.begin(), place.links.end());
        std::sort(same->links.begin(), same->links.end());
      }
    }
    for (const Lever& lever : m_plan.levers) {
      m_painter.line(
          {}, {placeOf(lever.points.front().links.front()).at, placeOf(lever.points.back().links.front()).at},
          ColorRole::secondary, 1.2);
    }
    m_painter.line(coupling.id, {from.at, to.at}, ColorRole::ink, 2);
    for (const Place& place : m_places)
      m_painter.point(m_mechanism.links[place.links.front()].id, place.at, place.links.front() == 0);
    m_painter.chip(coupling.id, letterPlace(coupling.id.text(), from.at, to.at), true);
    m_projection->progress < 1 ? drawMoving(along, end) : drawImages(std::move(images), along);
  }

  void drawMoving(CanvasPoint along, double end) {
    for (const Place& place : m_places) {
      const CanvasPoint now = place.at + m_projection->progress * (end - dot(place.at, along)) * along;
      m_painter.disc(place.links, now, place.links.front() == 0);
    }
  }

  /// The lever that is left.
  void drawImages(std::vector<Image> images, CanvasPoint along) {
    const CanvasPoint across = turned(along);
    std::sort(images.begin(), images.end(),
              [&](const Image& a, const Image& b) { return dot(a.at, across) < dot(b.at, across); });
    m_painter.line({}, {images.front().at, images.back().at}, ColorRole::ink, 2.4);
    m_painter.blockLine(images.front().at, images.back().at);
    std::vector<double> places;
    for (const Image& image : images) places.push_back(dot(image.at, across));
    spread(places, kPlanDiscGap);
    for (std::size_t i = 0; i < images.size(); ++i) {
      const double moved = places[i] - dot(images[i].at, across);
      const CanvasPoint aside = std::abs(moved) > 1 ? 26 * along : CanvasPoint{};
      drawDisc(images[i].links, images[i].at, images[i].at + moved * across + aside);
    }
    m_painter.text({}, images.back().at, {LetterSide::below, LetterSide::right, LetterSide::above},
                   translated("%1 is engaged: the plane projected along its line",
                              {m_mechanism.couplings[m_projection->coupling].id.text()}),
                   kSmallSize, false, ColorRole::secondary);
  }

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
      const CanvasPoint at{kPlanWidth * x, kPlanHeight * (1 - y)};
      m_places.push_back({std::move(all), point, at, at});
    }
    std::sort(m_places.begin(), m_places.end(),
              [](const Place& a, const Place& b) { return a.links.front() < b.links.front(); });
  }

  /// A disc that has no room at its point goes up to the right of it, then further.
  void moveApart(std::size_t i) {
    const auto isFree = [&] {
      return std::none_of(
          m_places.begin(), m_places.begin() + static_cast<std::ptrdiff_t>(i),
          [&](const Place& other) { return extentOf(other).grown(4).meets(extentOf(m_places[i])); });
    };
    for (double off = kPlanDiscGap; !isFree(); off += kPlanDiscGap / 2)
      m_places[i].center = m_places[i].at + off * CanvasPoint{0.6, -0.8};
  }

  [[nodiscard]] static Extent extentOf(const Place& place) {
    return {place.center, LeverPainter::halfWidthOf(place.links), kDiscRadius};
  }
  /// A place for a letter on the way between two points, as near its middle as discs and letters allow;
  /// beside it where they leave none.
  [[nodiscard]] CanvasPoint letterPlace(const std::string& name, CanvasPoint from, CanvasPoint to) const {
    const double half = std::max(kChipRadius, textWidth(name, kSmallSize, true) / 2 + 4);
    const auto isFree = [&](CanvasPoint center) {
      const Extent box{center, half, kChipRadius};
      return std::none_of(m_places.begin(), m_places.end(),
                          [&](const Place& place) { return extentOf(place).grown(3).meets(box); }) &&
             std::none_of(m_letters.begin(), m_letters.end(),
                          [&](const Extent& other) { return other.grown(2).meets(box); });
    };
    for (int step = 0; step <= 8; ++step) {
      for (const double side : {1.0, -1.0}) {
        const CanvasPoint center = between(from, to, 0.5 + side * 0.05 * step);
        if (isFree(center)) return center;
      }
    }
    const CanvasPoint across = turned(unit(to - from));
    double off = kChipRadius;
    while (!isFree(between(from, to, 0.5) + off * across)) off += kChipRadius;
    return between(from, to, 0.5) + off * across;
  }

  [[nodiscard]] const Place& placeOf(LinkOrdinal link) const {
    return *std::find_if(m_places.begin(), m_places.end(), [&](const Place& place) {
      return std::find(place.links.begin(), place.links.end(), link) != place.links.end();
    });
  }
  [[nodiscard]] CanvasPoint endOf(const Lever& lever) const {
    const CanvasPoint first = placeOf(lever.points.front().links.front()).at;
    const CanvasPoint last = placeOf(lever.points.back().links.front()).at;
    return last + 0.12 * (last - first);
  }

  void drawLever(const Lever& lever) {
    const CanvasPoint first = placeOf(lever.points.front().links.front()).at;
    const CanvasPoint last = placeOf(lever.points.back().links.front()).at;
    const CanvasPoint beyond = 0.12 * (last - first);
    m_painter.line({}, {first - beyond, last + beyond}, ColorRole::ink, lever.isByMeshes ? 2.4 : 1.4,
                   lever.isByMeshes ? Dash::solid : Dash::dashed);
    m_painter.blockLine(first - beyond, last + beyond);
  }

  void drawCouplings() {
    for (const ShiftElement& coupling : m_mechanism.couplings) {
      const auto [one, other] = endsOf(coupling);
      if (m_plan.positionOf(one) < 0 || m_plan.positionOf(other) < 0) continue;
      const Place& from = placeOf(one);
      const Place& to = placeOf(other);
      if (&from == &to) continue;  // engaged already
      m_painter.line(coupling.id, {from.at, to.at}, ColorRole::secondary, 1.6, Dash::dotted);
      const CanvasPoint center = letterPlace(coupling.id.text(), from.at, to.at);
      m_letters.push_back({center,
                           std::max(kChipRadius, textWidth(coupling.id.text(), kSmallSize, true) / 2 + 4),
                           kChipRadius});
      m_painter.chip(coupling.id, center, false);
    }
  }

  const Mechanism& m_mechanism;
  const LeverPlan& m_plan;
  PositionIndex<LinkTag> m_linkAt;
  std::optional<PlanProjection> m_projection;
  LeverPainter m_painter;
  std::vector<Place> m_places;  ///< by their first links
  std::vector<PointPlanSheet::Spot> m_spots;
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

std::optional<ShiftElementOrdinal> projectingCoupling(const Mechanism& mechanism, const LeverPlan& plan) {
  if (mechanism.engaged.empty() || !whyNoPointPlan(mechanism, plan).empty()) return std::nullopt;
  const PositionIndex<LinkTag> linkAt(mechanism.links);
  for (const ShiftElementOrdinal each : mechanism.couplings.ordinals()) {
    const ShiftElement& coupling = mechanism.couplings[each];
    if (coupling.id != mechanism.engaged.back()) continue;
    const int one = plan.positionOf(linkAt.at(coupling.links[0]));
    const int other =
        coupling.kind == ShiftElementKind::brake ? 0 : plan.positionOf(linkAt.at(coupling.links[1]));
    if (one < 0 || other < 0) return std::nullopt;
    const auto& points = plan.points;
    if (points[static_cast<std::size_t>(one)] == points[static_cast<std::size_t>(other)]) return std::nullopt;
    return each;
  }
  return std::nullopt;
}

PointPlanSheet pointPlanSheet(const Mechanism& mechanism, const LeverPlan& plan,
                              const std::optional<PlanProjection>& projection, const Emphases& emphases) {
  return PointPlanDrawer(mechanism, plan, projection, emphases).drawn();
}

DisplayList pointPlanDrawing(const Mechanism& mechanism, const LeverPlan& plan, const Emphases& emphases) {
  std::optional<PlanProjection> projection;
  if (const auto coupling = projectingCoupling(mechanism, plan)) projection = PlanProjection{*coupling, 1};
  return pointPlanSheet(mechanism, plan, projection, emphases).drawing;
}

}  // namespace geargraph
