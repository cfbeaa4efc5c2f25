#include "core/presentation/drawing/curve_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/foundations/base/contract.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

// px
constexpr double kWidth = 190;  ///< of the room between the axes
constexpr double kHeight = 150;
constexpr double kGap = 62;  ///< between two charts, for the numbers of the right one
constexpr double kTextSize = 11;
constexpr double kTick = 4;
constexpr double kMark = 3.2;
constexpr double kLegendLine = 26;
constexpr int kMaxXParts = 5;
constexpr int kMaxYParts = 5;

constexpr std::array<Dash, kMaxChartCurves> kDashes = {Dash::solid, Dash::dashed, Dash::dotted,
                                                       Dash::dashDotted};

Tint tintOf(std::size_t curve) {
  const int number = static_cast<int>(curve) + 1;
  return Tint::ofLink(number, number);
}

std::string numberText(double value) {
  return std::to_string(std::llround(value));
}

class ChartMaker {
 public:
  DisplayList make(const std::vector<CurveChart>& charts) {
    for (std::size_t i = 0; i < charts.size(); ++i) {
      GEARGRAPH_REQUIRE(charts[i].curves.size() <= kMaxChartCurves);
      m_left = static_cast<double>(i) * (kWidth + kGap);
      addChart(charts[i]);
    }
    if (!charts.empty()) addLegend(charts.front());
    return std::move(m_list);
  }

 private:
  void add(MarkRole role, int z, std::variant<Stroke, Fill, Text> what) {
    m_list.marks.push_back({ElementId(), role, z, std::move(what)});
  }
  void addLine(std::vector<CanvasPoint> points, Tint tint, double width, Dash dash = Dash::solid, int z = 0) {
    add(MarkRole::line, z, Stroke{Polyline{std::move(points), false}, tint, width, dash});
  }
  void addText(const std::string& text, CanvasPoint center, bool bold = false,
               ColorRole role = ColorRole::secondary) {
    add(MarkRole::label, 2, Text{text, center, kTextSize, bold, role});
  }

  /// Filled and hollow, round and square: told apart in print, too.
  void addMark(CanvasPoint at, std::size_t curve) {
    const Shape shape = curve < 2 ? Shape(Circle{at, kMark}) : Shape(Box{{at, kMark, kMark}, 0});
    add(MarkRole::node, 1, Fill{shape, curve % 2 == 0 ? tintOf(curve) : Tint(ColorRole::sheet)});
    if (curve % 2 != 0) add(MarkRole::node, 1, Stroke{shape, tintOf(curve), 1.4, Dash::solid});
  }

  void addChart(const CurveChart& chart) {
    double mostX = 1;
    double mostY = 1;
    for (const ChartCurve& curve : chart.curves) {
      for (const CanvasPoint point : curve.points) {
        mostX = std::max(mostX, point.x);
        mostY = std::max(mostY, point.y);
      }
    }
    addAxes(chart, mostX, mostY);
    for (std::size_t i = 0; i < chart.curves.size(); ++i) {
      std::vector<CanvasPoint> points;
      for (const CanvasPoint point : chart.curves[i].points)
        points.push_back({m_left + kWidth * point.x / mostX, -kHeight * point.y / mostY});
      for (const CanvasPoint at : points) addMark(at, i);
      addLine(std::move(points), tintOf(i), 1.6, kDashes[i], 1);
    }
  }

  void addAxes(const CurveChart& chart, double mostX, double mostY) {
    const double stepX = tickStep(mostX, kMaxXParts);
    for (double x = 0; x <= mostX; x += stepX) {
      const double at = m_left + kWidth * x / mostX;
      addLine({{at, 0}, {at, kTick}}, ColorRole::secondary, 1);
      addText(numberText(x), {at, kTick + kTextSize});
    }
    const double stepY = tickStep(mostY, kMaxYParts);
    for (double y = 0; y <= mostY; y += stepY) {
      const double at = -kHeight * y / mostY;
      addLine({{m_left, at}, {m_left + kWidth, at}}, ColorRole::hairline, 1);
      const std::string number = numberText(y);
      addText(number, {m_left - 6 - textWidth(number, kTextSize, false) / 2, at});
    }
    addLine({{m_left, -kHeight}, {m_left, 0}, {m_left + kWidth, 0}}, ColorRole::secondary, 1);
    addText(chart.title, {m_left + kWidth / 2, -kHeight - 16}, true, ColorRole::ink);
    addText(chart.xTitle, {m_left + kWidth / 2, kTick + 2.4 * kTextSize});
  }

  void addLegend(const CurveChart& chart) {
    const double y = kTick + 4.4 * kTextSize;
    double x = 0;
    for (std::size_t i = 0; i < chart.curves.size(); ++i) {
      addLine({{x, y}, {x + kLegendLine, y}}, tintOf(i), 1.6, kDashes[i]);
      addMark({x + kLegendLine / 2, y}, i);
      const double width = textWidth(chart.curves[i].name, kTextSize, false);
      addText(chart.curves[i].name, {x + kLegendLine + 6 + width / 2, y}, false, ColorRole::ink);
      x += kLegendLine + width + 28;
    }
  }

  DisplayList m_list;
  double m_left = 0;
};

}  // namespace

DisplayList chartDrawing(const std::vector<CurveChart>& charts) {
  return ChartMaker().make(charts);
}

double tickStep(double most, int parts) {
  GEARGRAPH_REQUIRE(most > 0 && parts > 0);
  double step = std::pow(10, std::floor(std::log10(most / parts)));
  for (const double factor : {2.0, 2.5, 2.0}) {  // 1, 2, 5, 10
    if (most / step <= parts) break;
    step *= factor;
  }
  return step;
}

}  // namespace geargraph
