#include "core/presentation/diagrams/lever_marks.h"

#include <algorithm>
#include <utility>

#include "core/presentation/diagrams/lever_words.h"
#include "core/presentation/drawing/arrow_marks.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kRing = 3;
constexpr double kHalo = 5;
constexpr double kLabelEm = 12;
constexpr double kTextGap = 3;

CanvasPoint wayOf(LetterSide side) {
  switch (side) {
    case LetterSide::above:
      return {0, -1};
    case LetterSide::below:
      return {0, 1};
    case LetterSide::right:
      return {1, 0};
    case LetterSide::left:
      return {-1, 0};
  }
  return {1, 0};
}

}  // namespace

LeverPainter::LeverPainter(const Mechanism& mechanism, const Emphases& emphases, const Extent& area)
    : m_mechanism(mechanism), m_emphases(emphases), m_taken(area) {}

void LeverPainter::put(const ElementId& element, MarkRole role, int z,
                       std::variant<Stroke, Fill, Text> what) {
  Pen(m_list, element).put(role, z, std::move(what));
}

void LeverPainter::line(const ElementId& element, std::vector<CanvasPoint> points, const Tint& tint,
                        double width, Dash dash, int z) {
  put(element, MarkRole::line, z, Stroke{Polyline{std::move(points), false}, tint, width, dash});
}

void LeverPainter::arrow(const ElementId& element, CanvasPoint from, CanvasPoint to, const Tint& tint,
                         double width) {
  if (distance(from, to) < 1) return;
  Pen pen(m_list, element);
  drawArrow(pen, Curve::straight(from, to), tint, width, Dash::solid);
  blockLine(from, to);
}

double LeverPainter::halfWidthOf(const std::vector<LinkOrdinal>& links) {
  return std::max(kDiscRadius, textWidth(labelsOf(links), kLabelEm, true) / 2 + (links.size() > 1 ? 8 : 3));
}

void LeverPainter::disc(const std::vector<LinkOrdinal>& links, CanvasPoint center, bool isFilled) {
  const Link& link = m_mechanism.links[links.front()];
  const Extent extent{center, halfWidthOf(links), kDiscRadius};
  const Box box{extent, kDiscRadius};
  Emphasis emphasis;
  for (const LinkOrdinal each : links) {
    const Emphasis other = emphasisOf(m_emphases, m_mechanism.links[each].id);
    emphasis.selected |= other.selected;
    emphasis.hovered |= other.hovered;
  }
  if (emphasis.any())
    put(link.id, MarkRole::halo, kHaloDepth,
        Fill{Box{extent.grown(kHalo), kDiscRadius + kHalo}, ColorRole::halo});
  const Tint ring = emphasis.selected ? Tint(ColorRole::accent)
                                      : Tint::ofLink(m_mechanism.linkLabel(links.front()),
                                                     m_mechanism.colorNumber(links.front()));
  put(link.id, MarkRole::node, kNodeDepth, Fill{box, isFilled ? ColorRole::ink : ColorRole::sheet});
  put(link.id, MarkRole::node, kNodeDepth, Stroke{box, ring, kRing, Dash::solid});
  put(link.id, MarkRole::label, kNodeDepth,
      Text{labelsOf(links), center, kLabelEm, true, isFilled ? ColorRole::sheet : ColorRole::ink});
  m_list.outlines.push_back({link.id, kNodeDepth, box, 0});
  block(extent.grown(kRing / 2));
}

void LeverPainter::chip(ShiftElementId coupling, CanvasPoint center, bool isEngaged) {
  const std::string& name = coupling.text();
  const Extent extent{center, std::max(kChipRadius, textWidth(name, kSmallSize, true) / 2 + 4), kChipRadius};
  const Box box{extent, kChipRadius};
  put(coupling, MarkRole::node, kBadgeDepth, Fill{box, isEngaged ? ColorRole::ink : ColorRole::sheet});
  if (!isEngaged)
    put(coupling, MarkRole::node, kBadgeDepth, Stroke{box, ColorRole::secondary, 1.4, Dash::solid});
  put(coupling, MarkRole::label, kBadgeDepth,
      Text{name, center, kSmallSize, true, isEngaged ? ColorRole::sheet : ColorRole::secondary});
  m_list.outlines.push_back({coupling, kBadgeDepth, box, 0});
  block(extent);
}

void LeverPainter::point(const ElementId& element, CanvasPoint center, bool isFilled) {
  constexpr double kRadius = 4.5;
  const Circle circle{center, kRadius};
  if (emphasisOf(m_emphases, element).any())
    put(element, MarkRole::halo, kHaloDepth, Fill{Circle{center, kRadius + kHalo}, ColorRole::halo});
  put(element, MarkRole::node, kNodeDepth, Fill{circle, isFilled ? ColorRole::ink : ColorRole::sheet});
  put(element, MarkRole::node, kNodeDepth, Stroke{circle, ColorRole::ink, 1.6, Dash::solid});
  m_list.outlines.push_back({element, kNodeDepth, circle, 0});
  block({center, kRadius, kRadius});
}

void LeverPainter::pickLine(const ElementId& element, CanvasPoint from, CanvasPoint to) {
  constexpr double kReach = 5;
  m_list.outlines.push_back({element, kLineDepth, Curve::straight(from, to), kReach});
}

void LeverPainter::box(const Box& shape, const Tint& fill, const Tint& border) {
  put({}, MarkRole::node, kLabelDepth, Fill{shape, fill});
  put({}, MarkRole::node, kLabelDepth, Stroke{shape, border, 1.2, Dash::solid});
  block(shape.extent);
}

void LeverPainter::ground(const ElementId& element, CanvasPoint tip) {
  constexpr double kWidth = 9;
  constexpr double kHalf = 9;
  const double x = tip.x + kWidth;
  line(element, {{x, tip.y - kHalf}, tip, {x, tip.y + kHalf}}, ColorRole::ink, 1.4);
  line(element, {{x, tip.y - kHalf - 3}, {x, tip.y + kHalf + 3}}, ColorRole::ink, 1.4);
  for (double y = tip.y - kHalf; y <= tip.y + kHalf + 1; y += 6)
    line(element, {{x, y + 3}, {x + 5, y - 3}}, ColorRole::secondary, 1.2);
  block(Extent::spanning({tip.x, tip.y - kHalf - 3}, {x + 5, tip.y + kHalf + 3}));
}

Extent LeverPainter::freePlace(CanvasPoint anchor, const std::vector<LetterSide>& sides, double halfWidth,
                               double halfHeight) const {
  constexpr int kSteps = 60;
  constexpr double kStep = 6;
  Extent place;
  for (int step = 0; step < kSteps; ++step) {
    for (const LetterSide side : sides) {
      const CanvasPoint way = wayOf(side);
      const CanvasPoint half{halfWidth * way.x, halfHeight * way.y};
      place = {anchor + half + (kTextGap + step * kStep) * way, halfWidth, halfHeight};
      if (!m_taken.touches(place, 1)) return place;
    }
  }
  return place;
}

void LeverPainter::text(const ElementId& element, CanvasPoint anchor, const std::vector<LetterSide>& sides,
                        const std::string& words, double size, bool bold, const Tint& tint) {
  if (words.empty()) return;
  const Extent place = freePlace(anchor, sides, textWidth(words, size, bold) / 2, 0.62 * size);
  put(element, MarkRole::label, kLabelDepth, Text{words, place.center, size, bold, tint});
  const CanvasPoint nearest{std::clamp(anchor.x, place.left(), place.right()),
                            std::clamp(anchor.y, place.top(), place.bottom())};
  constexpr double kLeader = 16;
  if (distance(anchor, nearest) > kLeader) line(element, {anchor, nearest}, ColorRole::secondary, 0.8);
  block(place);
}

void LeverPainter::fixedText(const ElementId& element, CanvasPoint center, const std::string& words,
                             double size, bool bold, const Tint& tint) {
  put(element, MarkRole::label, kLabelDepth, Text{words, center, size, bold, tint});
  block({center, textWidth(words, size, bold) / 2, 0.62 * size});
}

void LeverPainter::pill(const ElementId& element, CanvasPoint anchor, LetterSide side,
                        const std::string& word, bool isInput) {
  constexpr double kHalfHeight = 9;
  const Extent place =
      freePlace(anchor, {side, LetterSide::below}, textWidth(word, kSmallSize, false) / 2 + 8, kHalfHeight);
  const Box box{place, kHalfHeight};
  put(element, MarkRole::input, kBadgeDepth, Fill{box, isInput ? ColorRole::inputFill : ColorRole::sheet});
  put(element, MarkRole::input, kBadgeDepth,
      Stroke{box, isInput ? ColorRole::input : ColorRole::secondary, 1.2, Dash::solid});
  put(element, MarkRole::input, kBadgeDepth,
      Text{word, place.center, kSmallSize, false, isInput ? ColorRole::inputInk : ColorRole::ink});
  block(place.grown(1));
}

DisplayList LeverPainter::take() {
  m_list.sortByDepth();
  return std::move(m_list);
}

void spread(std::vector<double>& places, double gap) {
  struct Run {
    double wish = 0;  ///< mean of where the first would be
    int count = 0;
  };
  std::vector<Run> runs;
  for (const double place : places) {
    runs.push_back({place, 1});
    while (runs.size() > 1 &&
           runs.back().wish < runs[runs.size() - 2].wish + runs[runs.size() - 2].count * gap) {
      const Run last = runs.back();
      runs.pop_back();
      Run& before = runs.back();
      // The first of the joined run: each member wishes it at its own place less its offset.
      before.wish = (before.wish * before.count + (last.wish - before.count * gap) * last.count) /
                    (before.count + last.count);
      before.count += last.count;
    }
  }
  std::size_t i = 0;
  for (const Run& run : runs) {
    for (int k = 0; k < run.count; ++k) places[i++] = run.wish + k * gap;
  }
}

}  // namespace geargraph
