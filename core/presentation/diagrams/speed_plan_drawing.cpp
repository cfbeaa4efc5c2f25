#include "core/presentation/diagrams/speed_plan_drawing.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/readable.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/diagrams/lever_marks.h"
#include "core/presentation/diagrams/lever_words.h"
#include "core/presentation/drawing/curve_chart.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kVelocityReach = 240;  ///< px of the greatest velocity
constexpr double kSectionGap = 70;      ///< from the section to the plan
constexpr double kSheetWithoutSection = 260;
constexpr double kLineBeyond = 16;    ///< px that a line goes on beyond its last point
constexpr double kPlanLabelGap = 30;  ///< between the discs at the ends of lines

class SpeedPlanDrawer {
 public:
  SpeedPlanDrawer(const Mechanism& mechanism, const Placement& placement, const SpeedPlan& plan,
                  const SchematicGeometry& section, const Emphases& emphases)
      : m_mechanism(mechanism),
        m_placement(placement),
        m_plan(plan),
        m_section(section),
        m_emphases(emphases),
        m_sheet(schematicDrawing(section, emphases)),
        m_painter(mechanism, emphases, area()) {}

  DisplayList drawn() {
    if (const std::string why = whyNoSpeedPlan(m_plan); !why.empty()) {
      m_painter.fixedText({}, {0, 0}, why, 13, false, ColorRole::secondary);
      return m_painter.take();
    }
    measure();
    drawScale();
    drawLines();
    drawCrossings();
    drawCarriedAxes();
    drawEnds();
    drawNotes();
    DisplayList list = m_painter.take();
    list.append(std::move(m_sheet));
    list.sortByDepth();
    return list;
  }

 private:
  [[nodiscard]] Extent area() const {
    const Extent sheet = extentOf(m_sheet);
    return Extent::spanning({sheet.left() - 50, sheet.top() - 300},
                            {sheet.right() + kSectionGap + 4 * kVelocityReach, sheet.bottom() + 300});
  }

  /// The scale of the section, and where the plan begins.
  void measure() {
    double low = 0;
    double high = 0;
    for (const SpeedPlan::Line& line : m_plan.lines) {
      low = std::min(low, line.low);
      high = std::max(high, line.high);
      for (const double height : {line.low, line.high}) {
        const double velocity = line.velocityAt(height);
        if (!std::isfinite(velocity)) continue;
        m_least = std::min(m_least, velocity);
        m_most = std::max(m_most, velocity);
      }
    }
    const CanvasFrame::Line* const main = sectionAxis(m_plan.mainAxis);
    m_scale = main != nullptr ? m_section.frame.scale : kSheetWithoutSection / std::max(high - low, 1e-9);
    m_zeroHeight = main != nullptr ? main->at.y : 0;
    const double size = std::max(m_most, -m_least);
    m_perVelocity = size > 0 ? kVelocityReach / size : 0;
    const double right = m_section.isEmpty() ? 0 : extentOf(m_sheet).right();
    m_zero = right + kSectionGap - m_perVelocity * m_least;
    m_top = yOf(high);
    m_bottom = yOf(low);
  }
  [[nodiscard]] const CanvasFrame::Line* sectionAxis(AxisGroupOrdinal axis) const {
    if (m_section.isEmpty()) return nullptr;
    return m_section.frame.line(m_mechanism.axes[m_placement.classes->classes[axis].axis].id);
  }
  [[nodiscard]] double yOf(double height) const { return m_zeroHeight - m_scale * height; }
  [[nodiscard]] double xOf(double velocity) const { return m_zero + m_perVelocity * velocity; }
  [[nodiscard]] CanvasPoint at(double height, double velocity) const { return {xOf(velocity), yOf(height)}; }
  /// Is the axis drawn in the section at the height that it has in the plan?
  [[nodiscard]] bool isLevel(AxisGroupOrdinal axis) const {
    const CanvasFrame::Line* const line = sectionAxis(axis);
    return line != nullptr && std::abs(line->at.y - yOf(m_plan.axes[axis].height)) < 1.5;
  }
  [[nodiscard]] Tint tintOf(LinkOrdinal link) const {
    return Tint::ofLink(m_mechanism.linkLabel(link), m_mechanism.colorNumber(link));
  }

  /// Velocities along the foot, zero as a line over the whole height.
  void drawScale() {
    constexpr int kParts = 5;
    const double foot = m_bottom + 34;
    m_painter.line({}, {{m_zero, m_top - 24}, {m_zero, foot}}, ColorRole::secondary, 1, Dash::solid,
                   kHaloDepth + 1);
    if (m_perVelocity == 0) return;
    const double left = std::min(m_zero, xOf(m_least));
    const double right = std::max(m_zero, xOf(m_most));
    m_painter.line({}, {{left, foot}, {right, foot}}, ColorRole::secondary, 1);
    const double step = tickStep(m_most - m_least, kParts);
    for (double tick = std::ceil(m_least / step) * step; tick <= m_most + 1e-9 * step; tick += step) {
      const double velocity = std::abs(tick) < 1e-9 * step ? 0 : tick;
      m_painter.line({}, {{xOf(velocity), foot - 3}, {xOf(velocity), foot + 3}}, ColorRole::secondary, 1);
      m_painter.fixedText({}, {xOf(velocity), foot + 13}, readableNumber(velocity), kSmallSize, false,
                          ColorRole::secondary);
    }
    m_painter.text({}, {(left + right) / 2, foot + 22}, {LetterSide::below},
                   translated("peripheral velocity in %1/s", {m_mechanism.unit}), kSmallSize, false,
                   ColorRole::secondary);
  }

  [[nodiscard]] static bool isPoint(const SpeedPlan::Line& line) { return line.high - line.low <= 0; }

  void drawLines() {
    for (const SpeedPlan::Line& line : m_plan.lines) {
      if (line.link == 0 || isPoint(line)) continue;
      const ElementId element = m_mechanism.links[line.link].id;
      const double end = line.high + kLineBeyond / m_scale;
      const CanvasPoint from = at(line.low, line.velocityAt(line.low));
      const CanvasPoint to = at(end, line.velocityAt(end));
      if (emphasisOf(m_emphases, element).any())
        m_painter.line(element, {from, to}, ColorRole::halo, 9, Dash::solid, kHaloDepth);
      m_painter.line(element, {from, to}, tintOf(line.link), 2.4);
      m_painter.pickLine(element, from, to);
      m_painter.blockLine(from, to);
    }
  }

  void drawCrossings() {
    for (const SpeedPlan::Crossing& crossing : m_plan.crossings) {
      const MeshGeometry& geometry = *m_placement.meshes[crossing.mesh];
      const ElementId element = m_mechanism.gearMeshes[crossing.mesh].id;
      const CanvasPoint place = at(crossing.height, crossing.velocity);
      if (isLevel(geometry.tailClass) && isLevel(geometry.headClass))
        m_painter.line(element, {{extentOf(m_sheet).right() + 8, place.y}, place}, ColorRole::secondary, 1.2,
                       Dash::dotted);
      m_painter.point(element, place, true);
    }
  }

  /// Where a link carries the axis of another one, both have one velocity.
  void drawCarriedAxes() {
    for (const AxisGroupOrdinal axis : m_plan.axes.ordinals()) {
      const LinkOrdinal carrier = m_placement.classes->classes[axis].rootLink;
      const SpeedPlan::Axis& place = m_plan.axes[axis];
      m_painter.point(m_mechanism.links[carrier].id, at(place.height, place.velocity), false);
    }
  }

  /// A disc with the label and the speed at the upper end of each line; one for lines with one end.
  void drawEnds() {
    struct End {
      std::vector<LinkOrdinal> links;
      CanvasPoint place;
      Rational speed;
    };
    std::vector<End> ends;
    for (const SpeedPlan::Line& line : m_plan.lines) {
      if (line.link != 0 && isPoint(line)) continue;
      const double beyond = kLineBeyond / m_scale;
      const CanvasPoint place = line.link == 0 ? CanvasPoint{m_zero, m_top - 24}
                                               : at(line.high + beyond, line.velocityAt(line.high + beyond));
      const auto same = std::find_if(ends.begin(), ends.end(), [&](const End& end) {
        return distance(end.place, place) < 0.5 && end.speed == line.speed;
      });
      if (same != ends.end()) {
        same->links.push_back(line.link);
      } else {
        ends.push_back({{line.link}, place, line.speed});
      }
    }
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.place.y < b.place.y; });
    std::vector<double> heights;
    for (const End& end : ends) heights.push_back(end.place.y - kDiscRadius);
    spread(heights, kPlanLabelGap);
    double right = m_zero;
    for (const End& end : ends) right = std::max(right, end.place.x);
    right += 46;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const CanvasPoint center{right, heights[i]};
      const ElementId element = m_mechanism.links[ends[i].links.front()].id;
      const double near = center.x - LeverPainter::halfWidthOf(ends[i].links) - 4;
      m_painter.line(element, {ends[i].place, {near, center.y}}, ColorRole::secondary, 0.8);
      m_painter.disc(ends[i].links, center, ends[i].links.front() == 0);
      m_painter.text(element, {center.x + LeverPainter::halfWidthOf(ends[i].links) + 2, center.y},
                     {LetterSide::right, LetterSide::below}, threeDecimals(ends[i].speed), kValueSize, true,
                     ColorRole::ink);
    }
  }

  void drawNotes() {
    std::vector<std::string> notes{
        translated("A line for each link; its slope is the speed in rad/s. Filled points: teeth; others: "
                   "carried axes.")};
    std::vector<std::string> apart;
    for (const MeshOrdinal mesh : m_plan.apart) apart.push_back(std::to_string(m_mechanism.meshLabel(mesh)));
    if (apart.size() == 1)
      notes.push_back(translated(
          "Mesh %1 joins axes that are not in one plane with that of their carrier: its lines do not meet.",
          {apart.front()}));
    if (apart.size() > 1)
      notes.push_back(
          translated("Meshes %1 join axes that are not in one plane with that of their carrier: their lines "
                     "do not meet.",
                     {listed(apart, kAllNames)}));
    std::vector<std::string> alike;
    for (const MeshOrdinal mesh : m_plan.alike) alike.push_back(std::to_string(m_mechanism.meshLabel(mesh)));
    if (!alike.empty())
      notes.push_back(
          translated("Parallel lines, as both links turn alike: %1.", {listed(alike, kAllNames)}));
    bool isLevelThroughout = true;
    for (const AxisGroupOrdinal axis : m_plan.axes.ordinals())
      isLevelThroughout = isLevelThroughout && isLevel(axis);
    if (!isLevelThroughout && !m_section.isEmpty())
      notes.push_back(translated(
          "The section is unrolled in another way: not all teeth are at the heights of the plan."));
    double y = std::max(m_bottom + 80, extentOf(m_sheet).bottom() + 30);
    const double middle = (extentOf(m_sheet).left() + xOf(m_most) + 46) / 2;
    for (const std::string& note : notes) {
      m_painter.fixedText({}, {middle, y}, note, kSmallSize, false, ColorRole::secondary);
      y += 18;
    }
  }

  const Mechanism& m_mechanism;
  const Placement& m_placement;
  const SpeedPlan& m_plan;
  const SchematicGeometry& m_section;
  const Emphases& m_emphases;
  DisplayList m_sheet;
  LeverPainter m_painter;
  double m_scale = 1;        ///< px for the document's unit
  double m_zeroHeight = 0;   ///< y of the main axis
  double m_perVelocity = 0;  ///< px for a velocity of 1
  double m_zero = 0;         ///< x of velocity 0
  double m_least = 0;        ///< velocities
  double m_most = 0;
  double m_top = 0;
  double m_bottom = 0;
};

}  // namespace

std::string whyNoSpeedPlan(const SpeedPlan& plan) {
  switch (plan.absence) {
    case SpeedPlanAbsence::none:
      return {};
    case SpeedPlanAbsence::unfinished:
      return translated("No speed plan: the train is not finished, see Problems.");
    case SpeedPlanAbsence::noMotion:
      return translated("No speed plan: the speeds are not determined, see Problems.");
    case SpeedPlanAbsence::directions:
      return translated("No speed plan: it needs axes that are all parallel.");
  }
  return {};
}

DisplayList speedPlanDrawing(const Mechanism& mechanism, const Placement& placement, const SpeedPlan& plan,
                             const SchematicGeometry& section, const Emphases& emphases) {
  return SpeedPlanDrawer(mechanism, placement, plan, section, emphases).drawn();
}

}  // namespace geargraph
