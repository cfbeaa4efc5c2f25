#include "core/presentation/diagrams/band_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/diagrams/power_legend.h"
#include "core/presentation/diagrams/sheet_obstacles.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kHairline = 1;
constexpr double kLeastShown = kLeastShownPower;
constexpr double kBandLabelSize = 11;
constexpr double kLabelGap = 3;  ///< between a label and all else
constexpr double kRoomAround = 120;

double lengthOf(const std::vector<CanvasPoint>& course) {
  double length = 0;
  for (std::size_t i = 1; i < course.size(); ++i) length += distance(course[i - 1], course[i]);
  return length;
}

/// A course without its last `by` px, and the direction in which it ends.
struct Shortened {
  std::vector<CanvasPoint> course;
  CanvasPoint end;
  CanvasPoint way;
};
Shortened shortened(std::vector<CanvasPoint> course, double by) {
  Shortened result;
  result.end = course.back();
  double left = by;
  while (course.size() > 2 && distance(course[course.size() - 2], course.back()) <= left) {
    left -= distance(course[course.size() - 2], course.back());
    course.pop_back();
  }
  const CanvasPoint from = course[course.size() - 2];
  const double last = distance(from, course.back());
  course.back() = last > left ? between(course.back(), from, left / last) : from;
  result.way = unit(result.end - course.back());
  result.course = std::move(course);
  return result;
}

Polyline arrowOf(CanvasPoint base, CanvasPoint tip, double halfWidth) {
  const CanvasPoint wing = halfWidth * turned(unit(tip - base));
  return {{tip, base + wing, base - wing}, true};
}

std::string decimal(const char* format, double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return localizedNumber(buffer.data());
}

}  // namespace

std::string powerText(double power) {
  struct Unit {
    double watts;
    const char* name;
  };
  for (const Unit& unit : {Unit{1e6, " MW"}, Unit{1e4, " kW"}, Unit{0.01, " W"}, Unit{1e-5, " mW"}}) {
    if (power < unit.watts * 0.99995) continue;
    const double in = unit.watts == 1e4 ? 1e3 : unit.watts == 0.01 ? 1 : unit.watts == 1e-5 ? 1e-3 : 1e6;
    return decimal("%.4g", power / in) + unit.name;
  }
  return decimal("%.3g W", power);
}

std::vector<CanvasPoint> courseOf(const Curve& curve) {
  std::vector<CanvasPoint> course{curve.from};
  forEachChord(curve, [&](CanvasPoint, CanvasPoint to) { course.push_back(to); });
  return course;
}

BandPainter::BandPainter(const PowerPicture& picture, const DisplayList& drawing)
    : m_picture(picture),
      m_largest(picture.largest),
      m_drawn(extentOf(drawing)),
      m_taken(m_drawn.grown(kRoomAround)) {
  addObstacles(m_taken, drawing);
  for (const Mark& mark : drawing.marks)
    if (std::holds_alternative<Text>(mark.what)) m_texts.push_back(extentOf(mark));
}

void BandPainter::add(Band band) {
  if (band.course.size() < 2 || lengthOf(band.course) <= 1e-3) return;
  // Flows that share a line add up.
  if (band.isKnown) m_largest = std::max(m_largest, band.power);
  m_bands.push_back(std::move(band));
}

void BandPainter::add(LossStub stub) {
  if (stub.power > kLeastShown * kLeastShown * m_largest) m_stubs.push_back(std::move(stub));
}

double BandPainter::widthOf(double power) const {
  const double part = power / m_largest;
  return part < kLeastShown ? kHairline : std::max(kHairline, kWidestBand * part);
}

void BandPainter::put(const ElementId& element, std::variant<Stroke, Fill, Text> what, int z) {
  const MarkRole role = std::holds_alternative<Text>(what) ? MarkRole::label : MarkRole::line;
  m_list.marks.push_back({element, role, z, std::move(what)});
}

/// With its arrowhead in the direction of the flow, as long as the band is.
void BandPainter::drawBand(const Band& band) {
  if (!band.isKnown) {
    put(band.element, Stroke{Polyline{band.course, false}, ColorRole::secondary, kHairline, Dash::dashed});
    return;
  }
  const double width = widthOf(band.power);
  const double head = std::min(width / 2 + 6, 0.6 * lengthOf(band.course));
  const Shortened body = shortened(band.course, head);
  put(band.element, Stroke{Polyline{body.course, false}, band.tint.softened(), width, Dash::solid});
  const bool circulates = 2 * band.circulating > band.power;
  put(band.element, Fill{arrowOf(body.course.back(), body.end, width / 2 + 4),
                         (circulates ? Tint(ColorRole::accent) : band.tint).softened()});
  if (band.circulating > kLeastShown * m_largest) {
    const double core = std::max(2.0, kWidestBand * band.circulating / m_largest);
    put(band.element,
        Stroke{Polyline{body.course, false}, Tint(ColorRole::accent).softened(), core, Dash::solid},
        kBandDepth + 1);
  }
  for (std::size_t i = 1; i < band.course.size(); ++i) {
    m_list.outlines.push_back(
        {band.element, kBandDepth, Curve::straight(band.course[i - 1], band.course[i]), width / 2});
    if (width < 3) continue;
    const CanvasPoint aside = width / 2 * turned(unit(band.course[i] - band.course[i - 1]));
    for (const double side : {1.0, -1.0})
      m_taken.addCurve(Curve::straight(band.course[i - 1] + side * aside, band.course[i] + side * aside));
  }
}

/// Both words side by side, beside a place of a band; false where there is no room.
bool BandPainter::place(const ElementId& element, CanvasPoint at, CanvasPoint way, double gap,
                        const std::string& bold, const std::string& plain) {
  const double boldWidth = textWidth(bold, kBandLabelSize, true);
  const double plainWidth = plain.empty() ? 0 : textWidth(plain, kBandLabelSize, false);
  const double space = plain.empty() ? 0 : 5;
  const double halfWidth = (boldWidth + space + plainWidth) / 2;
  const double halfHeight = kBandLabelSize / 2;
  const CanvasPoint across = turned(way);
  for (const double farther : {0.0, 6.0, 14.0, 24.0}) {
    for (const double side : {1.0, -1.0}) {
      const CanvasPoint out = side * across;
      const double reach = halfWidth * std::abs(out.x) + halfHeight * std::abs(out.y) + gap + farther;
      const Extent box{at + reach * out, halfWidth, halfHeight};
      if (m_taken.touches(box, kLabelGap)) continue;
      const double left = box.left();
      put(element,
          Text{bold, {left + boldWidth / 2, box.center.y}, kBandLabelSize, true, Tint(ColorRole::ink)},
          kBandDepth + 2);
      if (!plain.empty())
        put(element,
            Text{plain,
                 {left + boldWidth + space + plainWidth / 2, box.center.y},
                 kBandLabelSize,
                 false,
                 Tint(ColorRole::secondary)},
            kBandDepth + 2);
      m_taken.addBox(box);
      m_texts.push_back(box);
      return true;
    }
  }
  return false;
}

/// Beside its longest straight piece first. Of an element whose part is unknown one band has the label.
void BandPainter::label(const Band& band) {
  if (!band.hasLabel) return;
  if (band.isKnown ? band.power < kLeastShown * m_largest : !m_marked.insert(band.element).second) return;
  struct Piece {
    CanvasPoint from;
    CanvasPoint to;
  };
  std::vector<Piece> pieces;
  for (std::size_t i = 1; i < band.course.size(); ++i) pieces.push_back({band.course[i - 1], band.course[i]});
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return distance(a.from, a.to) > distance(b.from, b.to) + 1e-6;
  });
  const std::string part = band.isKnown ? shareText(m_picture, band.power) : std::string();
  const std::string value = flowText(band.power, band.isKnown, band.isAssumed);
  const double gap = (band.isKnown ? widthOf(band.power) : kHairline) / 2 + 4;
  constexpr std::size_t kMaxPieces = 14;
  for (std::size_t i = 0; i < std::min(pieces.size(), kMaxPieces); ++i) {
    const CanvasPoint way = unit(pieces[i].to - pieces[i].from);
    for (const double t : {0.5, 0.3, 0.7, 0.15, 0.85})
      if (place(band.element, between(pieces[i].from, pieces[i].to, t), way, gap, value, part)) return;
  }
}

/// A short arrow first, then a longer one; none where each of them would cross a text.
void BandPainter::drawStub(const LossStub& stub) {
  for (const double length : {26.0, 40.0, 56.0})
    for (const double turn :
         {2.6, 0.5, -2.6, -0.5, 3.14, 0.0, 1.57, -1.57, 2.1, -2.1, 1.05, -1.05, 2.9, -2.9, 0.25, -0.25})
      if (tryStub(stub, {std::cos(turn), std::sin(turn)}, length)) return;
}

bool BandPainter::tryStub(const LossStub& stub, CanvasPoint way, double length) {
  constexpr double kHead = 7;
  const CanvasPoint from = stub.at + 8 * way;
  const CanvasPoint to = from + length * way;
  const std::string text = translated("%1 lost", {powerText(stub.power)});
  const double halfWidth = textWidth(text, kBandLabelSize - 1, false) / 2;
  // The text begins where the arrow ends.
  const double reach = std::min(halfWidth / std::max(std::abs(way.x), 1e-9),
                                kBandLabelSize / 2 / std::max(std::abs(way.y), 1e-9));
  const Extent box{to + (reach + 4) * way, halfWidth, kBandLabelSize / 2};
  const bool crossesText = std::any_of(m_texts.begin(), m_texts.end(), [&](const Extent& each) {
    return each.grown(1).meetsSegment(from, to);
  });
  if (crossesText || m_taken.touches(box, kLabelGap)) return false;
  put(stub.element, Stroke{Polyline{{from, to - kHead * way}, false}, ColorRole::secondary, 1.6, Dash::solid},
      kBandDepth + 2);
  put(stub.element, Fill{arrowOf(to - kHead * way, to, 3.4), ColorRole::secondary}, kBandDepth + 2);
  put(stub.element, Text{text, box.center, kBandLabelSize - 1, false, ColorRole::secondary}, kBandDepth + 2);
  m_taken.addBox(box);
  m_texts.push_back(box);
  return true;
}

/// Above the drawing: the scale, who sees these powers, what the marks mean, and what circulates.
void BandPainter::drawLegend() {
  const Extent all = m_drawn.united(extentOf(m_list));
  double line = all.top() - 16;
  const double left = all.left();
  const auto write = [&](const std::string& text, double from, bool bold, const Tint& tint) {
    const double width = textWidth(text, kBandLabelSize, bold);
    put({}, Text{text, {from + width / 2, line}, kBandLabelSize, bold, tint}, kBandDepth + 2);
    return from + width;
  };
  const auto any = [&](auto is) { return std::any_of(m_bands.begin(), m_bands.end(), is); };
  std::vector<LegendLine> lines =
      powerLegend(m_picture, m_largest, any([](const Band& b) { return !b.isKnown; }),
                  any([](const Band& b) { return b.isAssumed; }));
  std::reverse(lines.begin(), lines.end());
  for (const LegendLine& each : lines) {
    const Polyline mark{{{left, line}, {left + 26, line}}, false};
    if (each.mark == LegendLine::Mark::none) {
      write(each.plain, left, false, ColorRole::secondary);
    } else if (each.mark == LegendLine::Mark::unknown) {
      put({}, Stroke{mark, ColorRole::secondary, kHairline, Dash::dashed});
      write(each.plain, left + 34, false, ColorRole::secondary);
    } else if (each.mark == LegendLine::Mark::circulating) {
      put({}, Stroke{mark, Tint(ColorRole::accent).softened(), 8, Dash::solid});
      const double next = write(each.bold, left + 34, true, ColorRole::accent);
      write(each.plain, next + 5, false, ColorRole::ink);
    } else {
      put({}, Stroke{Polyline{{{left, line - 4}, {left + 20, line - 4}}, false},
                     Tint(ColorRole::secondary).softened(), kWidestBand, Dash::solid});
      put({}, Fill{arrowOf({left + 20, line - 4}, {left + 34, line - 4}, kWidestBand / 2 + 4),
                   Tint(ColorRole::secondary).softened()});
      const double next = write(each.bold, left + 42, true, ColorRole::ink);
      write(each.plain, next + 10, false, ColorRole::secondary);
    }
    line -= 18;
  }
}

DisplayList BandPainter::finish() && {
  // Thin bands are painted over wide ones, and all are there before the first label looks for room.
  std::stable_sort(m_bands.begin(), m_bands.end(),
                   [](const Band& a, const Band& b) { return a.power > b.power; });
  for (const Band& band : m_bands) drawBand(band);
  for (const Band& band : m_bands) label(band);
  for (const LossStub& stub : m_stubs) drawStub(stub);
  drawLegend();
  m_list.sortByDepth();
  return std::move(m_list);
}

}  // namespace geargraph
