#include "core/presentation/diagrams/torque_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <unordered_map>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/load_edits.h"
#include "core/presentation/diagrams/band_marks.h"
#include "core/presentation/diagrams/sheet_obstacles.h"
#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kTextSize = 11;
constexpr double kTorqueTextSize = 9;
constexpr double kArcRoom = 20;  ///< of a chip, for its arc
constexpr double kArcRadius = 6;
constexpr double kDiscRoom = 27;  ///< of a chip, for a motor and the arc about it
constexpr double kTorqueDiscRadius = 7;
constexpr double kDiscArcRadius = 10.2;
constexpr int kChipDepth = kBadgeDepth;

/// Four digits, with a true minus sign.
std::string numberText(double number) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.4g", std::abs(number));
  return (number < 0 ? "\xE2\x88\x92" : "") + localizedNumber(buffer.data());
}

int signOf(double number) {
  return number > 0 ? 1 : number < 0 ? -1 : 0;
}

std::string rateText(const StaticsReport& report, const Mechanism& mechanism, const ElementId& element) {
  if (element.kind != ElementKind::turningJoint) return {};
  for (std::size_t joint = 0; joint < mechanism.turningJoints.size(); ++joint) {
    if (ElementId(mechanism.turningJoints[joint].id) != element) continue;
    const auto rate = report.rateOf(joint);
    return rate ? numberText(rate->toDouble()) + " rad/s" : std::string();
  }
  return {};
}

/// "Balance in joint 7: found, it holds the loads with 24 N m. It feeds 2401 W into the train."
std::string balanceTip(const Mechanism& mechanism, const TorquePlace& place, std::optional<double> torque,
                       double watts) {
  const std::string where =
      place.inJoint() ? translated("Balance in joint %1", {std::to_string(mechanism.jointLabel(place.joint))})
                      : translated("Balance on link %1", {std::to_string(mechanism.linkLabel(place.link))});
  if (!torque) return translated("%1: not determined, it shares the loads in unknown parts.", {where});
  std::string tip = translated("%1: found, it holds the loads with %2 N m.", {where, numberText(*torque)});
  const std::string power = powerText(std::abs(watts));
  if (watts > 0) tip += ' ' + translated("It feeds %1 into the train.", {power});
  if (watts < 0) tip += ' ' + translated("It takes %1 out of the train.", {power});
  return tip;
}

ShownTorque givenTorque(const Load& load) {
  ShownTorque shown;
  if (const auto* force = std::get_if<LinkForce>(&load.action)) {
    double square = 0;
    for (const Number& component : force->force) square += std::pow(component.exact().toDouble(), 2);
    shown.element = force->link;
    shown.torque = "F " + numberText(std::sqrt(square)) + " N";
    return shown;
  }
  double torque = 0;
  if (const auto* inJoint = std::get_if<JointTorque>(&load.action)) {
    shown.element = inJoint->joint;
    torque = inJoint->torque.exact().toDouble();
  } else if (const auto* onLink = std::get_if<LinkTorque>(&load.action)) {
    shown.element = onLink->link;
    torque = onLink->torque.exact().toDouble();
  }
  shown.sense = signOf(torque);
  shown.torque = "T " + numberText(torque) + " N m";
  return shown;
}

/// Where the chips of an element belong.
using Anchors = std::unordered_map<ElementId, CanvasPoint>;

class ChipDrawer {
 public:
  ChipDrawer(const DisplayList& drawing, const DisplayList& under)
      : m_taken(
            extentOf(drawing).united(under.marks.empty() ? extentOf(drawing) : extentOf(under)).grown(160)) {
    addObstacles(m_taken, drawing);
    addObstacles(m_taken, under);
    constexpr double kHalfGap = 3;  // a line between the two parts of one label crosses it, too
    for (const DisplayList* list : {&drawing, &under})
      for (const Mark& mark : list->marks)
        if (std::holds_alternative<Text>(mark.what)) m_texts.push_back(extentOf(mark).grown(kHalfGap));
  }

  void draw(const ShownTorque& torque, CanvasPoint anchor) {
    const double words =
        std::max(textWidth(torque.torque, kTextSize, true), textWidth(torque.rate, kTorqueTextSize, false));
    const double room = torque.isGiven ? kArcRoom : kDiscRoom;
    const double halfHeight = torque.rate.empty() ? 9.0 : 14.0;  // what is found has a second line
    const Extent size{{}, (words + room + 12) / 2, halfHeight};
    const Extent box = freePlace(anchor, size);
    const Tint border = torque.isGiven ? ColorRole::input : ColorRole::control;
    const Tint fill = torque.isGiven ? ColorRole::inputFill : ColorRole::sheet;
    const Tint ink = torque.isGiven ? ColorRole::inputInk : ColorRole::ink;
    m_element = torque.element;
    put(MarkRole::line, kLineDepth,
        Stroke{Polyline{{anchor, edgeTowards(box, anchor)}, false}, border, 1, Dash::dotted});
    put(MarkRole::input, kChipDepth, Fill{Box{box, 5}, fill});
    put(MarkRole::input, kChipDepth,
        Stroke{Box{box, 5}, border, 1.2, torque.isGiven ? Dash::solid : Dash::dashed});
    const CanvasPoint arc{box.left() + room / 2 + 3, box.center.y};
    if (!torque.isGiven) drawMotor(arc);
    drawArc(arc, torque.sense, torque.isGiven ? border : ink, torque.isGiven ? kArcRadius : kDiscArcRadius);
    const double middle = box.left() + room + 4 + words / 2;
    const double line = torque.rate.empty() ? box.center.y : box.center.y - 5;
    put(MarkRole::input, kChipDepth, Text{torque.torque, {middle, line}, kTextSize, true, ink});
    if (!torque.rate.empty())
      put(MarkRole::input, kChipDepth,
          Text{torque.rate, {middle, box.center.y + 8}, kTorqueTextSize, false, ColorRole::secondary});
    m_list.outlines.push_back({torque.element, kChipDepth, Box{box, 0}, 0});
    m_taken.addBox(box);
    m_texts.push_back(box);
  }

  DisplayList finish() && { return std::move(m_list); }

 private:
  void put(MarkRole role, int z, std::variant<Stroke, Fill, Text> what) {
    m_list.marks.push_back({m_element, role, z, std::move(what)});
  }

  /// The nearest place round the anchor that touches nothing. A line to it that crosses a text is better than
  /// one across half the sheet.
  [[nodiscard]] Extent freePlace(CanvasPoint anchor, Extent size) const {
    constexpr int kDirections = 48;
    constexpr double kGap = 4;
    constexpr double kStep = 6;
    constexpr double kNearest = 18;
    constexpr double kMaxDistance = 400;
    constexpr double kCrossing = 60;  // px of way that a crossed text is worth
    Extent best = size;
    best.center = anchor - CanvasPoint{0, kMaxDistance + size.halfHeight};
    double least = kMaxDistance;
    for (double away = kNearest; away < least; away += kStep) {
      for (int i = 0; i < kDirections; ++i) {
        const double angle = 2 * M_PI * i / kDirections - M_PI / 2;
        const CanvasPoint out{std::cos(angle), std::sin(angle)};
        size.center = anchor + away * out +
                      CanvasPoint{std::copysign(size.halfWidth, out.x) * std::min(1.0, 2 * std::abs(out.x)),
                                  std::copysign(size.halfHeight, out.y) * std::min(1.0, 2 * std::abs(out.y))};
        if (m_taken.touches(size, kGap)) continue;
        const double cost = away + (isClear(anchor, edgeTowards(size, anchor)) ? 0 : kCrossing);
        if (cost >= least) continue;
        least = cost;
        best = size;
      }
    }
    return best;
  }
  /// The line to the chip crosses no text.
  [[nodiscard]] bool isClear(CanvasPoint from, CanvasPoint to) const {
    return std::none_of(m_texts.begin(), m_texts.end(),
                        [&](const Extent& text) { return text.meetsSegment(from, to); });
  }
  static CanvasPoint edgeTowards(const Extent& box, CanvasPoint from) {
    return {std::clamp(from.x, box.left(), box.right()), std::clamp(from.y, box.top(), box.bottom())};
  }

  /// The machine that holds the loads: a disc with an M, as the sign of electric motors is.
  void drawMotor(CanvasPoint middle) {
    const Circle disc{middle, kTorqueDiscRadius};
    put(MarkRole::input, kChipDepth, Fill{disc, ColorRole::inputFill});
    put(MarkRole::input, kChipDepth, Stroke{disc, ColorRole::input, 1.4, Dash::solid});
    put(MarkRole::input, kChipDepth, Text{"M", middle, kTorqueTextSize, true, ColorRole::inputInk});
  }

  /// Three quarters of a turn, its tip where the torque turns to; positive is anticlockwise, as about an axis
  /// that points at the reader.
  void drawArc(CanvasPoint middle, int sense, const Tint& tint, double radius) {
    if (sense == 0) return;
    constexpr int kChords = 12;
    const auto at = [&](double turn) {
      const double angle = -sense * turn;  // the sheet's y points down
      return middle + radius * CanvasPoint{std::cos(angle), std::sin(angle)};
    };
    Polyline arc;
    for (int i = 0; i <= kChords; ++i) arc.points.push_back(at(-0.6 + 4.3 * i / kChords));
    const CanvasPoint tip = at(4.4);
    const CanvasPoint back = at(3.6);
    const CanvasPoint wing = 3.2 * turned(unit(tip - back));
    put(MarkRole::input, kChipDepth, Stroke{std::move(arc), tint, 1.6, Dash::solid});
    put(MarkRole::input, kChipDepth, Fill{Polyline{{tip, back + wing, back - wing}, true}, tint});
  }

  ObstacleGrid m_taken;
  std::vector<Extent> m_texts;
  ElementId m_element;
  DisplayList m_list;
};

DisplayList drawn(const std::vector<ShownTorque>& torques, const Anchors& anchors, const DisplayList& drawing,
                  const DisplayList& under) {
  ChipDrawer drawer(drawing, under);
  for (const ShownTorque& each : torques)
    if (const auto anchor = anchors.find(each.element); anchor != anchors.end())
      drawer.draw(each, anchor->second);
  return std::move(drawer).finish();
}

}  // namespace

std::vector<ShownTorque> shownTorques(const Mechanism& mechanism, const StaticsReport& report) {
  std::vector<ShownTorque> shown;
  for (const LoadReport& load : report.loads) {
    shown.push_back(givenTorque(load.load));
    shown.back().rate = rateText(report, mechanism, shown.back().element);
  }
  if (!report.isAnswered()) return shown;
  const StaticsSolution& solution = report.solution();
  const auto meshes = static_cast<std::size_t>(mechanism.c());
  for (std::size_t part = 0; part < report.held.size(); ++part) {
    if (report.held[part].balance < 0) continue;
    const TorquePlace& place = report.problem.balances[static_cast<std::size_t>(report.held[part].balance)];
    const double torque = solution.values[meshes + part].number();
    const bool isKnown = solution.isDetermined(static_cast<int>(meshes + part));
    if (isKnown && torque == 0) continue;
    ShownTorque& found = shown.emplace_back();
    if (place.inJoint()) {
      found.element = mechanism.turningJoints[place.joint].id;
    } else {
      found.element = mechanism.links[place.link].id;
    }
    found.isGiven = false;
    found.sense = isKnown ? signOf(torque) : 0;
    found.torque = isKnown ? "T " + numberText(torque) + " N m" : translated("T shared");
    const std::string rate = rateText(report, mechanism, found.element);
    found.rate = (rate.empty() ? "" : rate + " \xC2\xB7 ") + translated("found");
    const double watts = part < report.powers.held.size() ? report.powers.held[part].number() : 0;
    found.tip = balanceTip(mechanism, place, isKnown ? std::optional(torque) : std::nullopt, watts);
  }
  return shown;
}

DisplayList digraphTorques(const std::vector<ShownTorque>& torques, const DigraphGeometry& geometry,
                           const DisplayList& under) {
  if (torques.empty()) return {};
  Anchors anchors;
  for (const EdgePlace& edge : geometry.edges) anchors[edge.element] = edge.curve.at(0.5);
  for (const NodePlace& node : geometry.nodes) anchors[node.link] = node.center;
  return drawn(torques, anchors, digraphDrawing(geometry, {}), under);
}

DisplayList schematicTorques(const std::vector<ShownTorque>& torques, const SchematicGeometry& geometry,
                             const DisplayList& under) {
  if (torques.empty() || geometry.isEmpty()) return {};
  Anchors anchors;
  for (const Mark& mark : geometry.marks) {
    const auto* stroke = std::get_if<Stroke>(&mark.what);
    const auto* line = stroke == nullptr ? nullptr : std::get_if<Polyline>(&stroke->shape);
    if (line == nullptr || mark.role != MarkRole::line || line->points.size() < 2) continue;
    anchors.try_emplace(mark.element, between(line->points.front(), line->points.back(), 0.5));
  }
  for (const DrawnPart::Represented& represented : geometry.represented)
    if (const auto drawnOne = anchors.find(represented.drawn); drawnOne != anchors.end())
      anchors.try_emplace(represented.omitted, drawnOne->second);
  return drawn(torques, anchors, schematicDrawing(geometry, {}), under);
}

}  // namespace geargraph
