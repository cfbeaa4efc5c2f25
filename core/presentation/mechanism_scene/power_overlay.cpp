#include "core/presentation/mechanism_scene/power_overlay.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/foundations/base/translation.h"
#include "core/presentation/diagrams/band_marks.h"
#include "core/presentation/diagrams/power_legend.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kWidest = 15;  // px, of the greatest power
constexpr double kHairline = 1.6;
constexpr double kCasing = 1.4;  // on each side, in the sheet's colour: sets an arrow off from its own part
constexpr double kLeastLength = 4;  // px: what points along the line of sight is a disc
constexpr double kTextSize = 12;
constexpr double kLine = 20;  // of the legend
constexpr double kFromEdge = 16;
constexpr std::size_t kMaxLabels = 40;

CanvasPoint sheetPoint(const Eigen::Vector2d& point) {
  return {point.x(), point.y()};
}

Box boxAbout(CanvasPoint middle, double halfWidth, double halfHeight) {
  const CanvasPoint half{halfWidth, halfHeight};
  return {Extent::spanning(middle - half, middle + half), 0};
}

/// "1→3: 495.7 W 49.6 %, 10.2 W lost"; without a link where power comes from a mesh or from outside.
std::string textOf(const ScenePower& power, const PowerArrow& arrow) {
  const auto label = [](const std::optional<int>& link) {
    return link ? std::to_string(*link) : std::string();
  };
  std::string text = label(arrow.giver) + (arrow.isKnown ? "\u2192" : "\u2013") + label(arrow.taker) + ": " +
                     flowText(arrow.power(), arrow.isKnown, arrow.isAssumed);
  if (!arrow.isKnown) return text;
  const std::string share = shareText(power.picture, arrow.power());
  if (!share.empty()) text += ' ' + share;
  if (arrow.lost > kLeastShownPower * kLeastShownPower * power.picture.largest)
    text += ", " + translated("%1 lost", {powerText(arrow.lost)});
  return text;
}

/// Where an arrow is in space, as a force: what places labels reads these.
struct Placed {
  std::vector<SceneForce> forces;
  std::vector<ForceArrow> arrows;
};

Placed placed(const ScenePower& power, const LabelGround& ground, const Pose& base) {
  Placed all;
  for (std::size_t i = 0; i < power.arrows.size(); ++i) {
    const PowerArrow& arrow = power.arrows[i];
    const MechanismScene& stage = ground.stage;
    const auto instance = instanceOf(stage, arrow.movesWith);
    const Pose moved =
        instance ? Pose(ground.poses[*instance] * stage.scene.instances[*instance].pose.inverse()) : base;
    SceneForce force;
    force.element = arrow.element;
    force.text = textOf(power, arrow);
    force.force = std::max(arrow.power(), 1e-300) * (arrow.to - arrow.from).normalized();
    all.forces.push_back(std::move(force));
    all.arrows.push_back({i, moved * arrow.from, moved * arrow.to});
  }
  return all;
}

class Painter {
 public:
  Painter(const ScenePower& power, const LabelGround& ground, const Pose& base)
      : m_power(power), m_ground(ground), m_largest(power.largest()), m_placed(placed(power, ground, base)) {}

  DisplayList paint(double top, const std::set<ElementId>& highlighted) && {
    std::vector<std::size_t> order(m_power.arrows.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return m_power.arrows[a].power() > m_power.arrows[b].power();
    });
    for (const std::size_t at : order) addArrow(at);
    const Extent legend = addLegend(top);
    addLabels(order, highlighted, legend);
    return std::move(m_list);
  }

 private:
  template <class What>
  void put(const ElementId& element, MarkRole role, What what) {
    m_list.marks.push_back({element, role, 0, std::move(what)});
  }
  [[nodiscard]] double widthOf(double power) const {
    return std::max(kHairline, kWidest * power / m_largest);
  }

  void addArrow(std::size_t at) {
    const PowerArrow& arrow = m_power.arrows[at];
    const CanvasPoint from = sheetPoint(m_ground.project(m_placed.arrows[at].from));
    const CanvasPoint to = sheetPoint(m_ground.project(m_placed.arrows[at].to));
    if (!arrow.isKnown) {
      put(arrow.element, MarkRole::line,
          Stroke{Polyline{{from, to}, false}, ColorRole::sheet, kHairline + 2 * kCasing, Dash::solid});
      put(arrow.element, MarkRole::line,
          Stroke{Polyline{{from, to}, false}, ColorRole::secondary, kHairline, Dash::dashed});
      return;
    }
    const double width = widthOf(arrow.power());
    const double length = distance(from, to);
    if (length < kLeastLength) {
      put(arrow.element, MarkRole::line, Fill{Circle{to, width / 2 + 4 + kCasing}, ColorRole::sheet});
      put(arrow.element, MarkRole::line, Fill{Circle{to, width / 2 + 4}, arrow.tint});
      return;
    }
    const CanvasPoint way = unit(to - from);
    const CanvasPoint neck = to - std::min(width / 2 + 7, 0.6 * length) * way;
    const CanvasPoint wing = (width / 2 + 4) * turned(way);
    const Polyline head{{to, neck + wing, neck - wing}, true};
    const Polyline shaft{{from, neck}, false};
    const bool circulates = 2 * arrow.circulating > arrow.power();
    put(arrow.element, MarkRole::line, Stroke{shaft, ColorRole::sheet, width + 2 * kCasing, Dash::solid});
    put(arrow.element, MarkRole::line, Stroke{head, ColorRole::sheet, 2 * kCasing, Dash::solid});
    put(arrow.element, MarkRole::line, Stroke{shaft, arrow.tint, width, Dash::solid});
    put(arrow.element, MarkRole::arrowhead, Fill{head, circulates ? Tint(ColorRole::accent) : arrow.tint});
    if (arrow.circulating > kLeastShownPower * m_largest)
      put(arrow.element, MarkRole::line,
          Stroke{shaft, ColorRole::accent, std::max(2.0, widthOf(arrow.circulating) * 0.8), Dash::solid});
  }

  /// The words behind the mark of a line; returns the extent of all lines.
  Extent addLegend(double top) {
    const auto any = [&](auto is) { return std::any_of(m_power.arrows.begin(), m_power.arrows.end(), is); };
    std::vector<LegendLine> lines =
        powerLegend(m_power.picture, m_largest, any([](const PowerArrow& each) { return !each.isKnown; }),
                    any([](const PowerArrow& each) { return each.isAssumed; }));
    constexpr double kMarkRoom = 40;
    // In a small view the plate would hide the train.
    const std::string full =
        translated("2→3: from link 2 to link 3; in the colour of the link that delivers");
    const double room = m_ground.viewport.width / m_ground.pixelRatio / 2 - kFromEdge - kMarkRoom;
    const bool isRoomy = textWidth(full, kTextSize, false) <= room;
    lines.push_back({LegendLine::Mark::none, {}, isRoomy ? full : translated("2→3: from link 2 to link 3")});
    double widest = 0;
    const auto gapOf = [](const LegendLine& line) { return line.bold.empty() ? 0.0 : 8.0; };
    for (const LegendLine& line : lines)
      widest = std::max(widest, textWidth(line.bold, kTextSize, true) + gapOf(line) +
                                    textWidth(line.plain, kTextSize, false));
    const double height = kLine * static_cast<double>(lines.size());
    const Extent plate = Extent::spanning({kFromEdge - 4, top - kLine / 2},
                                          {kFromEdge + kMarkRoom + widest + 6, top - kLine / 2 + height});
    put({}, MarkRole::line, Fill{Box{plate, 0}, ColorRole::sheet});
    double y = top;
    for (const LegendLine& line : lines) {
      addLegendMark(line.mark, y);
      double x = kFromEdge + kMarkRoom;
      const auto write = [&](const std::string& text, bool bold, ColorRole role) {
        if (text.empty()) return;
        const double width = textWidth(text, kTextSize, bold);
        put({}, MarkRole::label, Text{text, {x + width / 2, y}, kTextSize, bold, role});
        x += width;
      };
      write(line.bold, true, line.mark == LegendLine::Mark::circulating ? ColorRole::accent : ColorRole::ink);
      x += gapOf(line);
      write(line.plain, false, ColorRole::ink);
      y += kLine;
    }
    return plate;
  }

  void addLegendMark(LegendLine::Mark mark, double y) {
    const Polyline line{{{kFromEdge, y}, {kFromEdge + 20, y}}, false};
    if (mark == LegendLine::Mark::unknown)
      return put({}, MarkRole::line, Stroke{line, ColorRole::secondary, kHairline, Dash::dashed});
    if (mark == LegendLine::Mark::circulating)
      return put({}, MarkRole::line, Stroke{line, ColorRole::accent, 6, Dash::solid});
    if (mark != LegendLine::Mark::widest) return;
    put({}, MarkRole::line, Stroke{line, ColorRole::secondary, kWidest - 3, Dash::solid});
    const CanvasPoint neck{kFromEdge + 20, y};
    put({}, MarkRole::arrowhead,
        Fill{Polyline{{neck + CanvasPoint{12, 0}, neck + CanvasPoint{0, 9}, neck - CanvasPoint{0, 9}}, true},
             ColorRole::secondary});
  }

  void addLabels(const std::vector<std::size_t>& order, const std::set<ElementId>& highlighted,
                 const Extent& legend) {
    std::vector<ForceArrow> arrows;
    std::set<ElementId> named = highlighted;
    for (const std::size_t at : order) {
      const PowerArrow& arrow = m_power.arrows[at];
      const bool isSmall = arrow.isKnown && arrow.power() < kLeastShownPower * m_largest;
      if ((isSmall || arrows.size() >= kMaxLabels) && !highlighted.contains(arrow.element)) continue;
      arrows.push_back(m_placed.arrows[at]);
      named.insert(arrow.element);
    }
    const auto roomOf = [](const std::string& text) { return textWidth(text, kTextSize, false); };
    for (const ForceLabel& label : placeForceLabels(m_placed.forces, arrows, named, m_ground, roomOf)) {
      const PowerArrow& arrow = m_power.arrows[label.force];
      const Box box = boxAbout(sheetPoint(label.middle), label.half.x(), label.half.y());
      const bool isOverLegend =
          std::abs(box.extent.center.x - legend.center.x) < box.extent.halfWidth + legend.halfWidth &&
          std::abs(box.extent.center.y - legend.center.y) < box.extent.halfHeight + legend.halfHeight;
      if (isOverLegend && !highlighted.contains(arrow.element)) continue;
      put(arrow.element, MarkRole::node, Fill{box, ColorRole::sheet});
      put(arrow.element, MarkRole::node,
          Stroke{box, arrow.isKnown ? arrow.tint : Tint(ColorRole::secondary), 1.2, Dash::solid});
      put(arrow.element, MarkRole::label,
          Text{m_placed.forces[label.force].text, box.extent.center, kTextSize, false, ColorRole::ink});
    }
  }

  const ScenePower& m_power;
  const LabelGround& m_ground;
  double m_largest;
  Placed m_placed;
  DisplayList m_list;
};

}  // namespace

DisplayList powerOver(const ScenePower& power, const LabelGround& ground, const Pose& base, double top,
                      const std::set<ElementId>& highlighted) {
  if (power.arrows.empty()) return {};
  return Painter(power, ground, base).paint(top, highlighted);
}

Pose basePose(const MechanismScene& stage, const SceneView& view) {
  if (!view.referenceLink) return Pose::Identity();
  SceneView together = view;
  together.explosion = 0;
  return seenPoses(stage, together, {}).ground;
}

}  // namespace geargraph
