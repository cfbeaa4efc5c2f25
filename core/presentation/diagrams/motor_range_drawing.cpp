#include "core/presentation/diagrams/motor_range_drawing.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/foundations/base/readable.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/drawing/curve_chart.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

// px
constexpr double kPlotSize = 360;  ///< of the longer side
constexpr double kRangeTextSize = 11;
constexpr double kAxisTick = 5;
constexpr double kBeyond = 26;  ///< of the axes beyond the range
constexpr double kTextDistance = 12;

class RangeMaker {
 public:
  RangeMaker(const Mechanism& mechanism, const MotorRange& range) : m_mechanism(mechanism), m_range(range) {
    for (const MotorCorner& corner : range.corners) {
      m_low = {std::min(m_low.x, corner.x.toDouble()), std::min(m_low.y, corner.y.toDouble())};
      m_high = {std::max(m_high.x, corner.x.toDouble()), std::max(m_high.y, corner.y.toDouble())};
    }
    const double longest = std::max({m_high.x - m_low.x, m_high.y - m_low.y, 1e-9});
    m_scale = kPlotSize / longest;
  }

  DisplayList make() {
    addAlone();
    addArea();
    addAxes();
    addSides();
    addCorners();
    addWords();
    m_list.sortByDepth();
    return std::move(m_list);
  }

 private:
  [[nodiscard]] CanvasPoint placeOf(double x, double y) const { return {x * m_scale, -y * m_scale}; }
  [[nodiscard]] CanvasPoint placeOf(const MotorCorner& corner) const {
    return placeOf(corner.x.toDouble(), corner.y.toDouble());
  }
  [[nodiscard]] std::string labelOf(JointOrdinal joint) const {
    return std::to_string(m_mechanism.jointLabel(joint));
  }
  [[nodiscard]] ElementId idOf(JointOrdinal joint) const { return m_mechanism.turningJoints[joint].id; }

  void add(ElementId element, MarkRole role, int z, std::variant<Stroke, Fill, Text> what) {
    m_list.marks.push_back({std::move(element), role, z, std::move(what)});
  }
  void addLine(ElementId element, std::vector<CanvasPoint> points, ColorRole role, double width, Dash dash,
               int z, bool isClosed = false) {
    add(std::move(element), MarkRole::line, z,
        Stroke{Polyline{std::move(points), isClosed}, role, width, dash});
  }
  /// A text that begins at `left`.
  void addTextFrom(ElementId element, const std::string& text, CanvasPoint left, ColorRole role) {
    add(std::move(element), MarkRole::label, 4,
        Text{text,
             {left.x + textWidth(text, kRangeTextSize, false) / 2, left.y},
             kRangeTextSize,
             false,
             role});
  }

  /// The box of both motors, each alone.
  void addAlone() {
    if (m_range.corners.size() < 2) return;
    addLine({},
            {placeOf(m_low.x, m_low.y), placeOf(m_high.x, m_low.y), placeOf(m_high.x, m_high.y),
             placeOf(m_low.x, m_high.y)},
            ColorRole::secondary, 1, Dash::dashed, 1, true);
  }

  void addArea() {
    if (m_range.corners.size() < 3) return;
    std::vector<CanvasPoint> points;
    for (const MotorCorner& corner : m_range.corners) points.push_back(placeOf(corner));
    add({}, MarkRole::halo, 0, Fill{Polyline{points, true}, Tint(ColorRole::accent).softened()});
  }

  void addAxes() {
    m_left = placeOf(m_low.x, 0).x - kBeyond;
    m_right = placeOf(m_high.x, 0).x + kBeyond;
    m_top = placeOf(0, m_high.y).y - kBeyond;
    m_bottom = placeOf(0, m_low.y).y + kBeyond;
    addLine({}, {{m_left, m_top}, {m_left, m_bottom}, {m_right, m_bottom}}, ColorRole::secondary, 1,
            Dash::solid, 2);
    addLine({}, {{m_left, 0}, {m_right, 0}}, ColorRole::hairline, 1, Dash::solid, 2);
    addLine({}, {{0, m_top}, {0, m_bottom}}, ColorRole::hairline, 1, Dash::solid, 2);
    const double longest = kPlotSize / m_scale;
    const double step = tickStep(longest, 6);
    const auto mark = [&](double at, bool isX) {
      const CanvasPoint tick =
          isX ? CanvasPoint{placeOf(at, 0).x, m_bottom} : CanvasPoint{m_left, placeOf(0, at).y};
      const CanvasPoint end =
          isX ? CanvasPoint{tick.x, tick.y - kAxisTick} : CanvasPoint{tick.x + kAxisTick, tick.y};
      addLine({}, {tick, end}, ColorRole::secondary, 1, Dash::solid, 2);
      const std::string text = readableNumber(at);
      const double half = textWidth(text, kRangeTextSize, false) / 2;
      add({}, MarkRole::label, 3,
          Text{text,
               isX ? CanvasPoint{tick.x, tick.y + kRangeTextSize} : CanvasPoint{tick.x - 5 - half, tick.y},
               kRangeTextSize, false, ColorRole::secondary});
    };
    const auto ticks = [&](double low, double high, bool isX) {
      for (double number = std::ceil(low / step); number * step <= high; ++number) {
        mark(number * step, isX);
      }
    };
    ticks(m_low.x, m_high.x, true);
    ticks(m_low.y, m_high.y, false);
    const auto title = [&](JointOrdinal motor) { return translated("motor %1, degrees", {labelOf(motor)}); };
    addTextFrom(idOf(m_range.motors[0]), title(m_range.motors[0]), {m_right + 6, m_bottom}, ColorRole::ink);
    addTextFrom(idOf(m_range.motors[1]), title(m_range.motors[1]), {m_left, m_top - kRangeTextSize},
                ColorRole::ink);
  }

  /// Is it where limits meet, and not where an open range is cut off?
  [[nodiscard]] bool isReal(std::size_t corner) const {
    const std::vector<MotorCorner>& corners = m_range.corners;
    return corners.size() == 1 ||
           (corners[corner].side && corners[(corner + corners.size() - 1) % corners.size()].side);
  }

  void addSides() {
    const std::vector<MotorCorner>& corners = m_range.corners;
    for (std::size_t i = 0; i < corners.size() && corners.size() > 1; ++i) {
      const std::vector<CanvasPoint> ends{placeOf(corners[i]), placeOf(corners[(i + 1) % corners.size()])};
      if (!corners[i].side) {
        addLine({}, ends, ColorRole::secondary, 1, Dash::dotted, 3);
        continue;
      }
      const JointOrdinal joint = m_range.limits[*corners[i].side].joint;
      m_reached.insert(int{joint});
      addLine(idOf(joint), ends, ColorRole::accent, 2, Dash::solid, 3);
    }
  }

  /// Numbered, away from the middle of the range.
  void addCorners() {
    const CanvasPoint middle = placeOf((m_low.x + m_high.x) / 2, (m_low.y + m_high.y) / 2);
    m_numbers.assign(m_range.corners.size(), {});
    int number = 0;
    for (std::size_t i = 0; i < m_range.corners.size(); ++i) {
      if (!isReal(i)) continue;
      m_numbers[i] = std::to_string(++number);
      const CanvasPoint at = placeOf(m_range.corners[i]);
      const double x = at.x - middle.x, y = at.y - middle.y;
      const double away = std::max(std::hypot(x, y), 1e-9);
      add({}, MarkRole::node, 4, Fill{Circle{at, 3}, Tint(ColorRole::accent)});
      add({}, MarkRole::label, 4,
          Text{m_numbers[i],
               {at.x + x / away * kTextDistance, at.y + y / away * kTextDistance},
               kRangeTextSize,
               true,
               ColorRole::ink});
    }
  }

  /// Of each corner its angles, and what bounds the side after it.
  double addTable(double y) {
    const std::vector<MotorCorner>& corners = m_range.corners;
    double wide = 0;
    std::vector<std::string> places;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      places.push_back(isReal(i) ? m_numbers[i] + "  (" + readableNumber(corners[i].x) + "; " +
                                       readableNumber(corners[i].y) + ")"
                                 : std::string());
      wide = std::max(wide, textWidth(places.back(), kRangeTextSize, false));
    }
    const auto endOf = [&](std::size_t corner) {
      return isReal(corner) ? m_numbers[corner] : std::string("\u2026");
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const bool hasSide = corners[i].side && corners.size() > 1;
      if (places[i].empty() && !hasSide) continue;
      if (!places[i].empty()) addTextFrom({}, places[i], {m_left, y}, ColorRole::ink);
      if (hasSide) {
        const MotorLimit& limit = m_range.limits[*corners[i].side];
        const Rational end = limit.isUpper ? limit.bound : -limit.bound;
        addTextFrom(idOf(limit.joint),
                    endOf(i) + "\u2013" + endOf((i + 1) % corners.size()) + ": " +
                        translated("joint %1 at %2", {labelOf(limit.joint), readableNumber(end)}),
                    {m_left + (wide > 0 ? wide + 2 * kTextDistance : 0), y}, ColorRole::ink);
      }
      y += 1.5 * kRangeTextSize;
    }
    return y + 0.5 * kRangeTextSize;
  }

  void addWords() {
    std::vector<std::string> lines;
    if (m_range.limits.empty()) {
      lines.push_back(translated("No joint that turns with these motors has limits."));
    } else if (!m_range.isClosed()) {
      lines.push_back(translated("Dotted sides are open: nothing limits the motors there."));
    }
    std::set<int> idle;
    for (const MotorLimit& limit : m_range.limits) {
      if (!m_reached.contains(int{limit.joint})) idle.insert(int{limit.joint});
    }
    if (!idle.empty() && m_range.corners.size() > 2) {
      std::vector<std::string> labels;
      for (const int joint : idle) labels.push_back(labelOf(JointOrdinal(joint)));
      lines.push_back(
          translated("Limits that these motors never reach: those of joints %1.", {listed(labels, 12)}));
    }
    lines.push_back(translated("Degrees from the reference pose; all other motors stand in it."));
    if (m_range.corners.size() > 2)
      lines.push_back(translated("Dashed: what either motor may do alone, for some angle of the other."));
    double y = addTable(m_bottom + 3 * kRangeTextSize);
    for (const std::string& line : lines) {
      addTextFrom({}, line, {m_left, y}, ColorRole::secondary);
      y += 1.5 * kRangeTextSize;
    }
  }

  const Mechanism& m_mechanism;
  const MotorRange& m_range;
  CanvasPoint m_low, m_high;  ///< degrees; the reference pose is between them
  double m_scale = 1;         ///< px a degree
  double m_left = 0, m_right = 0, m_top = 0, m_bottom = 0;
  std::set<int> m_reached;             ///< joints whose limits bound a side
  std::vector<std::string> m_numbers;  ///< by corner; empty where an open range is cut off
  DisplayList m_list;
};

}  // namespace

DisplayList motorRangeDrawing(const Mechanism& mechanism, const MotorRange& range) {
  return RangeMaker(mechanism, range).make();
}

DisplayList motorRangeAbsence(const std::string& why) {
  DisplayList list;
  list.marks.push_back(
      {ElementId(), MarkRole::label, 0, Text{why, {0, 0}, kRangeTextSize, false, ColorRole::secondary}});
  return list;
}

}  // namespace geargraph
