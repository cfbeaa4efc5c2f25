#include "core/presentation/diagrams/nomogram.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/foundations/base/position_index.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/diagrams/lever_marks.h"
#include "core/presentation/diagrams/lever_words.h"
#include "core/presentation/drawing/curve_chart.h"
#include "core/presentation/drawing/text_metrics.h"
#include "core/theory/levers/lever_motion.h"

namespace geargraph {
namespace {

constexpr double kPlotHeight = 330;  ///< px of all speeds
constexpr double kAxisBeyond = 14;   ///< of an axis beyond the speeds
constexpr double kHeadGap = 34;      ///< between the centres of discs above the axes
constexpr double kPanelGap = 150;
constexpr double kTagGap = 20;
constexpr double kTagAside = 34;

/// The speeds of a state that are drawn.
struct StateLine {
  int state = 0;
  std::vector<Rational> speeds;  ///< by position in the links of the plan
  std::vector<Rational> idle;    ///< not 0 for links that turn freely; or empty
};

class NomogramDrawer {
 public:
  NomogramDrawer(const Mechanism& mechanism, const LeverPlan& plan, const Placement& placement,
                 std::span<const StateSolution> states, std::optional<int> current, const Emphases& emphases)
      : m_mechanism(mechanism),
        m_plan(plan),
        m_current(current),
        m_linkAt(mechanism.links),
        m_painter(
            mechanism, emphases,
            Extent::spanning({-200, -200}, {600.0 * static_cast<double>(plan.levers.size() + 1), 700})) {
    if (plan.mainAxis < 0) return;
    for (const StateSolution& state : states) {
      if (!state.isSolved()) continue;
      StateLine& line = m_lines.emplace_back();
      line.state = state.state;
      line.speeds = leverSpeeds(plan, placement, state.rates);
      if (!state.idleRates.empty()) line.idle = leverSpeeds(plan, placement, state.idleRates);
    }
  }

  NomogramSheet drawn() {
    if (m_plan.levers.empty()) return sentence(absenceSentence(m_mechanism, m_plan));
    if (m_mechanism.states.empty())
      return sentence(translated("No states yet: a state engages brakes and clutches and names its drive."));
    if (m_lines.empty()) return sentence(translated("No state has one motion: each is locked or free."));
    measure();
    std::vector<Panel> panels;
    double left = 0;
    for (const Lever& lever : m_plan.levers) {
      panels.push_back(panelOf(lever, left));
      left = panels.back().axes.back() + kPanelGap;
    }
    drawScale(panels.back().axes.back() + 60);
    for (const Panel& panel : panels) drawAxes(panel);
    for (const Panel& panel : panels) drawLines(panel);
    for (const Panel& panel : panels) drawElements(panel);
    for (const Panel& panel : panels) drawTags(panel);
    for (const Panel& panel : panels) drawWords(panel);
    m_sheet.drawing = m_painter.take();
    return std::move(m_sheet);
  }

 private:
  /// A lever with an axis a point.
  struct Panel {
    const Lever* lever = nullptr;
    std::vector<double> axes;  ///< x, by point
  };

  NomogramSheet sentence(const std::string& words) {
    m_painter.fixedText({}, {0, 0}, words, 13, false, ColorRole::secondary);
    return {m_painter.take(), {}, {}, words};
  }

  [[nodiscard]] const Rational& speedOf(const StateLine& line, LinkOrdinal link) const {
    return line.speeds[static_cast<std::size_t>(m_plan.positionOf(link))];
  }
  [[nodiscard]] bool isKnown(const StateLine& line, LinkOrdinal link) const {
    return line.idle.empty() || line.idle[static_cast<std::size_t>(m_plan.positionOf(link))].isZero();
  }
  [[nodiscard]] bool isKnownOn(const StateLine& line, const Lever& lever) const {
    return std::all_of(lever.points.begin(), lever.points.end(),
                       [&](const LeverPoint& point) { return isKnown(line, point.links.front()); });
  }

  void measure() {
    double least = 0;
    double most = 0;
    for (const StateLine& line : m_lines) {
      for (const Lever& lever : m_plan.levers) {
        if (!isKnownOn(line, lever)) continue;
        for (const LeverPoint& point : lever.points) {
          const double speed = speedOf(line, point.links.front()).toDouble();
          if (!std::isfinite(speed)) continue;
          least = std::min(least, speed);
          most = std::max(most, speed);
        }
      }
    }
    m_least = least;
    m_most = most > least ? most : least + 1;
  }
  [[nodiscard]] double yOf(double speed) const { return kPlotHeight * (m_most - speed) / (m_most - m_least); }

  [[nodiscard]] static Rational leastGap(const Lever& lever) {
    Rational least = 1;
    for (std::size_t i = 1; i < lever.points.size(); ++i)
      least = std::min(least, (lever.points[i].at - lever.points[i - 1].at).abs());
    return least;
  }

  [[nodiscard]] static Panel panelOf(const Lever& lever, double left) {
    constexpr double kLeastWidth = 190;
    constexpr double kMaxWidth = 430;
    constexpr double kWishedGap = 90;
    const double width = std::clamp(kWishedGap / leastGap(lever).toDouble(), kLeastWidth, kMaxWidth);
    Panel panel;
    panel.lever = &lever;
    for (const LeverPoint& point : lever.points) panel.axes.push_back(left + width * point.at.toDouble());
    return panel;
  }

  void drawScale(double right) {
    constexpr int kParts = 8;
    const double step = tickStep(m_most - m_least, kParts);
    for (double tick = std::ceil(m_least / step) * step; tick <= m_most + 1e-9 * step; tick += step) {
      const double speed = std::abs(tick) < 1e-9 * step ? 0 : tick;
      const double y = yOf(speed);
      m_painter.line({}, {{-30, y}, {right, y}}, speed == 0 ? ColorRole::secondary : ColorRole::hairline, 1,
                     Dash::solid, kHaloDepth + 1);
      const std::string number = readableNumber(speed);
      m_painter.fixedText({}, {-36 - textWidth(number, kSmallSize, false) / 2, y}, number, kSmallSize, false,
                          ColorRole::secondary);
    }
  }

  void drawAxes(const Panel& panel) {
    std::vector<double> heads = panel.axes;
    spread(heads, kHeadGap);
    for (std::size_t i = 0; i < heads.size(); ++i) {
      const LeverPoint& point = panel.lever->points[i];
      const ElementId element = m_mechanism.links[point.links.front()].id;
      const double x = panel.axes[i];
      m_painter.line(element, {{heads[i], -48}, {x, -kAxisBeyond - 14}, {x, kPlotHeight + kAxisBeyond}},
                     ColorRole::secondary, 1.6, point.isByMeshes ? Dash::solid : Dash::dashed);
      m_painter.disc(point.links, {heads[i], -48}, point.links.front() == 0);
    }
  }

  void drawLines(const Panel& panel) {
    for (const StateLine& line : m_lines) {
      if (!isKnownOn(line, *panel.lever)) continue;
      const bool isCurrent = m_current && *m_current == line.state;
      const CanvasPoint from{panel.axes.front(), yOn(line, panel, 0)};
      const CanvasPoint to{panel.axes.back(), yOn(line, panel, panel.axes.size() - 1)};
      m_painter.blockLine(from, to);
      m_sheet.lines.push_back({line.state, from, to});
      if (isCurrent) m_painter.line({}, {from, to}, ColorRole::halo, 8, Dash::solid, kLineDepth + 1);
      m_painter.line({}, {from, to}, isCurrent ? ColorRole::accent : ColorRole::secondary,
                     isCurrent ? 3 : 1.5, Dash::solid, kLineDepth + (isCurrent ? 2 : 1));
    }
  }
  [[nodiscard]] double yOn(const StateLine& line, const Panel& panel, std::size_t point) const {
    return yOf(speedOf(line, panel.lever->points[point].links.front()).toDouble());
  }

  /// The speed of a coupling's other side, if it is one in all states that engage the coupling.
  [[nodiscard]] std::optional<Rational> speedBeyond(const ShiftElement& coupling, LinkId link) const {
    std::optional<Rational> speed;
    for (const StateLine& line : m_lines) {
      const ShiftState& state = m_mechanism.states[static_cast<std::size_t>(line.state)];
      if (std::find(state.engaged.begin(), state.engaged.end(), coupling.id) == state.engaged.end()) continue;
      Rational beyond;
      if (coupling.kind != ShiftElementKind::brake) {
        const LinkOrdinal other = m_linkAt.at(coupling.links[coupling.links[0] == link ? 1 : 0]);
        if (m_plan.positionOf(other) < 0 || !isKnown(line, other)) return std::nullopt;
        beyond = speedOf(line, other);
      }
      if (speed && *speed != beyond) return std::nullopt;
      speed = beyond;
    }
    return speed;
  }

  void drawElements(const Panel& panel) {
    for (const ShiftElement& coupling : m_mechanism.couplings) {
      const auto isOn = [&](LinkId link) { return panel.lever->pointOf(m_linkAt.at(link)) != nullptr; };
      if (std::all_of(coupling.links.begin(), coupling.links.end(), isOn) && coupling.links.size() > 1)
        continue;  // both sides on one lever: its lines are level, and pass through no point
      for (const LinkId link : coupling.links) {
        if (!isOn(link)) continue;
        const auto speed = speedBeyond(coupling, link);
        if (!speed) continue;
        const auto point = panel.lever->pointOf(m_linkAt.at(link)) - panel.lever->points.data();
        const CanvasPoint at{panel.axes[static_cast<std::size_t>(point)], yOf(speed->toDouble())};
        CanvasPoint center = at;
        const double half = std::max(kChipRadius, textWidth(coupling.id.text(), kSmallSize, true) / 2 + 4);
        while (overlapsTag({center, half, kChipRadius})) center.x += kChipRadius;
        m_tags.push_back({center, half, kChipRadius});
        if (center.x != at.x) m_painter.line(coupling.id, {at, center}, ColorRole::secondary, 0.8);
        m_painter.chip(coupling.id, center, isEngaged(coupling.id));
      }
    }
  }
  [[nodiscard]] bool overlapsTag(const Extent& box) const {
    return std::any_of(m_tags.begin(), m_tags.end(),
                       [&](const Extent& tag) { return tag.grown(1).meets(box); });
  }
  [[nodiscard]] bool isEngaged(ShiftElementId coupling) const {
    if (!m_current) return false;
    const auto& engaged = m_mechanism.states[static_cast<std::size_t>(*m_current)].engaged;
    return std::find(engaged.begin(), engaged.end(), coupling) != engaged.end();
  }

  /// The x of a state's tag: the axis of its driven link, else beside the last one.
  [[nodiscard]] double tagAxis(const StateLine& line, const Panel& panel, double& y) const {
    const ShiftState& state = m_mechanism.states[static_cast<std::size_t>(line.state)];
    const LeverPoint* const point = state.driven ? panel.lever->pointOf(m_linkAt.at(*state.driven)) : nullptr;
    const std::size_t at = point == nullptr ? panel.axes.size() - 1
                                            : static_cast<std::size_t>(point - panel.lever->points.data());
    y = yOn(line, panel, at);
    return panel.axes[at];
  }

  void drawTags(const Panel& panel) {
    struct Tag {
      double y = 0;
      std::string names;
      bool isCurrent = false;
      std::vector<int> states;
    };
    std::map<double, std::vector<Tag>> byAxis;
    for (const StateLine& line : m_lines) {
      if (!isKnownOn(line, *panel.lever)) continue;
      double y = 0;
      const double x = tagAxis(line, panel, y);
      const std::string& name = m_mechanism.states[static_cast<std::size_t>(line.state)].name;
      const bool isCurrent = m_current && *m_current == line.state;
      auto& tags = byAxis[x];
      const auto same = std::find_if(tags.begin(), tags.end(), [&](const Tag& tag) { return tag.y == y; });
      if (same == tags.end()) {
        tags.push_back({y, name, isCurrent, {line.state}});
      } else {
        same->names += ", " + name;
        same->isCurrent |= isCurrent;
        same->states.push_back(line.state);
      }
    }
    for (auto& [x, tags] : byAxis) {
      std::sort(tags.begin(), tags.end(), [](const Tag& a, const Tag& b) { return a.y < b.y; });
      std::vector<double> places;
      for (const Tag& tag : tags) places.push_back(tag.y);
      spread(places, kTagGap);
      for (std::size_t i = 0; i < tags.size(); ++i)
        m_sheet.tags.push_back(
            {tags[i].states, drawTag(x, tags[i].y, places[i], tags[i].names, tags[i].isCurrent)});
    }
  }

  Extent drawTag(double axis, double y, double place, const std::string& names, bool isCurrent) {
    constexpr double kHalfHeight = 8.5;
    const double half = std::max(10.0, textWidth(names, kSmallSize, true) / 2 + 5);
    CanvasPoint center{axis + kTagAside - 10 + half, place};
    while (overlapsTag({center, half, kHalfHeight})) center.x += kHalfHeight;
    m_tags.push_back({center, half, kHalfHeight});
    m_painter.line({}, {{axis, y}, {center.x - half, place}}, ColorRole::secondary, 0.8, Dash::solid,
                   kLineDepth + 3);
    const Box box{{center, half, kHalfHeight}, 4};
    m_painter.box(box, isCurrent ? ColorRole::accent : ColorRole::sheet,
                  isCurrent ? ColorRole::accent : ColorRole::secondary);
    m_painter.fixedText({}, center, names, kSmallSize, true, isCurrent ? ColorRole::sheet : ColorRole::ink);
    return box.extent;
  }

  void drawWords(const Panel& panel) {
    const Lever& lever = *panel.lever;
    for (const StateLine& line : m_lines) {
      if (!m_current || *m_current != line.state || !isKnownOn(line, lever)) continue;
      for (std::size_t i = 0; i < panel.axes.size(); ++i)
        m_painter.text({}, {panel.axes[i] - 8, yOn(line, panel, i)},
                       {LetterSide::left, LetterSide::above, LetterSide::below},
                       threeDecimals(speedOf(line, lever.points[i].links.front())), kValueSize, true,
                       ColorRole::accent);
    }
    for (std::size_t i = 0; i < panel.axes.size(); ++i) {
      const LinkOrdinal link = lever.points[i].links.front();
      std::vector<double> heads = panel.axes;
      spread(heads, kHeadGap);
      m_painter.text(m_mechanism.links[link].id, {heads[i], -48 - kDiscRadius - 2}, {LetterSide::above},
                     elided(m_mechanism.links[link].name, 18), kSmallSize, false, ColorRole::secondary);
    }
    const double foot = kPlotHeight + kAxisBeyond + 14;
    const Rational unit = leastGap(lever);
    for (std::size_t i = 1; i < panel.axes.size(); ++i) {
      const double from = panel.axes[i - 1];
      const double to = panel.axes[i];
      m_painter.line({}, {{from + 2, foot}, {to - 2, foot}}, ColorRole::secondary, 1);
      m_painter.text({}, {(from + to) / 2, foot}, {LetterSide::below},
                     readableNumber((lever.points[i].at - lever.points[i - 1].at).abs() / unit), kSmallSize,
                     false, ColorRole::ink);
    }
    const double middle = (panel.axes.front() + panel.axes.back()) / 2;
    m_painter.text({}, {middle, foot + 22}, {LetterSide::below}, setsOf(lever), kValueSize, true,
                   ColorRole::ink);
    m_painter.text({}, {middle, foot + 38}, {LetterSide::below}, teethOf(m_plan, lever), kSmallSize, false,
                   ColorRole::secondary);
  }

  const Mechanism& m_mechanism;
  const LeverPlan& m_plan;
  std::optional<int> m_current;
  PositionIndex<LinkTag> m_linkAt;
  std::vector<StateLine> m_lines;
  LeverPainter m_painter;
  NomogramSheet m_sheet;
  std::vector<Extent> m_tags;  ///< letters and tags so far, which may be on lines but not on each other
  double m_least = 0;
  double m_most = 1;
};

}  // namespace

NomogramSheet nomogramSheet(const Mechanism& mechanism, const LeverPlan& plan, const Placement& placement,
                            std::span<const StateSolution> states, std::optional<int> current,
                            const Emphases& emphases) {
  return NomogramDrawer(mechanism, plan, placement, states, current, emphases).drawn();
}

DisplayList nomogramDrawing(const Mechanism& mechanism, const LeverPlan& plan, const Placement& placement,
                            std::span<const StateSolution> states, std::optional<int> current,
                            const Emphases& emphases) {
  return nomogramSheet(mechanism, plan, placement, states, current, emphases).drawing;
}

}  // namespace geargraph
