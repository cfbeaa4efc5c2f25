#include "core/presentation/diagrams/lever_drawing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/foundations/base/translation.h"
#include "core/presentation/diagrams/lever_marks.h"
#include "core/presentation/diagrams/lever_words.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kBarWidth = 5;
constexpr double kBand = 9;
constexpr double kSpeedReach = 96;  ///< px of the greatest speed
constexpr double kTorqueReach = 60;
constexpr double kDiscGap = 32;    ///< between the centres of discs on one bar
constexpr double kPartedOff = 46;  ///< from the bar to discs that have no room on it

/// A point of a bar on the sheet.
struct Spot {
  const LeverPoint* point = nullptr;
  CanvasPoint at;      ///< exact, on the bar
  CanvasPoint center;  ///< of the disc: there, or beside the bar where points nearly coincide
};

class LeverDrawer {
 public:
  LeverDrawer(const Mechanism& mechanism, const LeverPicture& picture, const LeverLayout& layout,
              const Emphases& emphases, const LeverLook& look)
      : m_mechanism(mechanism),
        m_picture(picture),
        m_layout(layout),
        m_look(look),
        m_hasTorques(look.torques && std::any_of(picture.torques.begin(), picture.torques.end(),
                                                 [](const auto& lever) { return !lever.empty(); })),
        m_spacing(m_hasTorques ? 300 : 220),
        m_unit(unit()),
        m_painter(mechanism, emphases,
                  Extent::spanning({-200, -m_unit * m_layout.height.toDouble() - 100},
                                   {m_spacing * static_cast<double>(m_layout.bars.size()) + 200, 160})) {}

  LeverSheet drawn() {
    if (m_layout.bars.empty()) {
      m_painter.fixedText({}, {0, 0}, absenceSentence(m_mechanism, m_picture.plan), 13, false,
                          ColorRole::secondary);
      return {m_painter.take(), {}, 0};
    }
    for (std::size_t bar = 0; bar < m_layout.bars.size(); ++bar) placeSpots(bar);
    for (const BarTie& tie : m_layout.ties) drawTie(tie);
    for (std::size_t bar = 0; bar < m_layout.bars.size(); ++bar) drawBar(bar);
    for (std::size_t bar = 0; bar < m_layout.bars.size(); ++bar) drawSpeeds(bar);
    for (std::size_t bar = 0; bar < m_layout.bars.size(); ++bar) drawTorques(bar);
    for (std::size_t bar = 0; bar < m_layout.bars.size(); ++bar) drawValues(bar);
    drawRoles();
    drawFoot();
    const double scale = speedScale();
    return {m_painter.take(), spotsWith(scale), scale};
  }

 private:
  [[nodiscard]] std::vector<LeverSpot> spotsWith(double scale) const {
    std::vector<LeverSpot> spots;
    for (std::size_t bar = 0; bar < m_spots.size(); ++bar) {
      for (const Spot& spot : m_spots[bar]) {
        spots.push_back({m_layout.bars[bar].lever, static_cast<int>(spot.point - leverOf(bar).points.data()),
                         static_cast<int>(bar), spot.at, spot.center, tipOf(spot, scale)});
      }
    }
    return spots;
  }
  [[nodiscard]] const Lever& leverOf(std::size_t bar) const {
    return m_picture.plan.levers[static_cast<std::size_t>(m_layout.bars[bar].lever)];
  }
  [[nodiscard]] double xOf(std::size_t bar) const { return m_spacing * static_cast<double>(bar); }

  /// px of a bar of length 1: discs have room on it where that does not take too much.
  [[nodiscard]] double unit() const {
    constexpr double kLeast = 150;
    constexpr double kMost = 300;
    constexpr double kSheetHeight = 420;
    double gap = 1;
    for (const BarPlace& bar : m_layout.bars) {
      const auto& points = m_picture.plan.levers[static_cast<std::size_t>(bar.lever)].points;
      for (std::size_t i = 1; i < points.size(); ++i)
        gap = std::min(gap, bar.length.toDouble() * std::abs((points[i].at - points[i - 1].at).toDouble()));
    }
    const double height = std::max(1.0, m_layout.height.toDouble());
    return std::clamp(kDiscGap / gap, kLeast, std::max(kLeast, std::min(kMost, kSheetHeight / height)));
  }

  void placeSpots(std::size_t bar) {
    std::vector<Spot>& spots = m_spots.emplace_back();
    for (const LeverPoint& point : leverOf(bar).points) {
      const CanvasPoint at{xOf(bar), -m_unit * m_layout.bars[bar].heightOf(point).toDouble()};
      spots.push_back({&point, at, at});
    }
    std::sort(spots.begin(), spots.end(), [](const Spot& a, const Spot& b) { return a.at.y < b.at.y; });
    std::vector<double> heights;
    for (const Spot& spot : spots) heights.push_back(spot.at.y);
    spread(heights, kDiscGap);
    for (std::size_t i = 0; i < spots.size(); ++i) {
      if (std::abs(heights[i] - spots[i].at.y) < 0.5) continue;
      spots[i].center = {xOf(bar) - kPartedOff, heights[i]};
    }
  }

  [[nodiscard]] const Spot& spotOf(int bar, LinkOrdinal link) const {
    const auto& spots = m_spots[static_cast<std::size_t>(bar)];
    return *std::find_if(spots.begin(), spots.end(),
                         [&](const Spot& spot) { return spot.point->links.front() == link; });
  }
  [[nodiscard]] ElementId elementOf(const LeverPoint& point) const {
    return m_mechanism.links[point.links.front()].id;
  }
  [[nodiscard]] Tint tintOf(const LeverPoint& point) const {
    return Tint::ofLink(m_mechanism.linkLabel(point.links.front()),
                        m_mechanism.colorNumber(point.links.front()));
  }

  void drawTie(const BarTie& tie) {
    const Spot& from = spotOf(tie.from, tie.link);
    const Spot& to = spotOf(tie.to, tie.link);
    const Tint band = tintOf(*from.point).softened();
    if (tie.isLevel) {
      m_painter.line(elementOf(*from.point), {from.at, to.at}, band, kBand, Dash::solid, kHaloDepth + 1);
      return;
    }
    // Beside the bars, and over all of them; each such tie has a channel of its own.
    const double beside = 24 + 7 * m_dogLegs;
    const double top = -m_unit * m_layout.height.toDouble() - 34 - 10 * m_dogLegs++;
    const double left = from.at.x + m_spacing - kPartedOff - beside - 30;
    const double right = to.at.x - kPartedOff - beside;
    m_painter.line(elementOf(*from.point),
                   {from.at, {left, from.at.y}, {left, top}, {right, top}, {right, to.at.y}, to.at}, band,
                   kBand / 2, Dash::solid, kHaloDepth + 1);
  }

  void drawBar(std::size_t bar) {
    const auto& spots = m_spots[bar];
    for (std::size_t i = 1; i < spots.size(); ++i) {
      const bool isByMeshes = spots[i - 1].point->isByMeshes && spots[i].point->isByMeshes;
      m_painter.line({}, {spots[i - 1].at, spots[i].at}, ColorRole::secondary,
                     isByMeshes ? kBarWidth : kBarWidth / 2, isByMeshes ? Dash::solid : Dash::dashed,
                     kLineDepth + 1);
      m_painter.blockLine(spots[i - 1].at, spots[i].at);
    }
    for (const Spot& spot : spots) {
      if (spot.center.x != spot.at.x) {
        m_painter.line(elementOf(*spot.point),
                       {{spot.at.x + 6, spot.at.y}, {spot.at.x - 8, spot.at.y}, spot.center},
                       tintOf(*spot.point), 1.4, Dash::solid, kLineDepth + 2);
      }
      m_painter.disc(spot.point->links, spot.center, isHeld(*spot.point));
      if (isHeld(*spot.point)) drawPivot(spot);
    }
    for (const Spot& spot : spots) drawLetters(spot);
  }

  [[nodiscard]] bool isHeld(const LeverPoint& point) const {
    if (point.links.front() == 0) return true;
    return std::any_of(m_picture.engaged.begin(), m_picture.engaged.end(), [&](ShiftElementOrdinal each) {
      return m_mechanism.couplings[each].kind == ShiftElementKind::brake && touches(each, point);
    });
  }
  [[nodiscard]] bool touches(ShiftElementOrdinal coupling, const LeverPoint& point) const {
    const auto& links = m_mechanism.couplings[coupling].links;
    return std::any_of(point.links.begin(), point.links.end(), [&](LinkOrdinal link) {
      return std::find(links.begin(), links.end(), m_mechanism.links[link].id) != links.end();
    });
  }
  [[nodiscard]] bool isEngaged(ShiftElementOrdinal coupling) const {
    return std::find(m_picture.engaged.begin(), m_picture.engaged.end(), coupling) != m_picture.engaged.end();
  }

  void drawPivot(const Spot& spot) {
    const double side = spot.center.x + LeverPainter::halfWidthOf(spot.point->links) + 4;
    m_painter.ground(elementOf(*spot.point), {side, spot.center.y});
  }

  /// Letters of the couplings at a point: engaged brakes beside the ground, others at the lower right of the
  /// disc. Without engaged couplings all of them are shown, as what could be held.
  void drawLetters(const Spot& spot) {
    const double half = LeverPainter::halfWidthOf(spot.point->links);
    double beside = spot.center.x + half + 4 + 14 + kChipRadius + 4;
    double below = spot.center.x + half + kChipRadius - 1;
    for (const ShiftElementOrdinal coupling : m_mechanism.couplings.ordinals()) {
      if (!touches(coupling, *spot.point)) continue;
      if (!m_picture.engaged.empty() && !isEngaged(coupling)) continue;
      const bool isPivot =
          isEngaged(coupling) && m_mechanism.couplings[coupling].kind == ShiftElementKind::brake;
      double& x = isPivot ? beside : below;
      m_painter.chip(m_mechanism.couplings[coupling].id, {x, spot.center.y + (isPivot ? 0 : kDiscRadius + 5)},
                     isEngaged(coupling));
      x += 2 * kChipRadius + 3 +
           std::max(0.0, textWidth(m_mechanism.couplings[coupling].id.text(), kSmallSize, true) + 8 -
                             2 * kChipRadius);
    }
  }

  [[nodiscard]] std::optional<Rational> speedOf(const LeverPoint& point) const {
    if (m_picture.speeds.empty() || !m_look.speeds) return std::nullopt;
    return m_picture.speeds[static_cast<std::size_t>(m_picture.plan.positionOf(point.links.front()))];
  }
  [[nodiscard]] double speedScale() const {
    if (m_look.speedScale && m_look.speeds && !m_picture.speeds.empty()) return *m_look.speedScale;
    double most = 0;
    for (const auto& spots : m_spots) {
      for (const Spot& spot : spots) {
        if (const auto speed = speedOf(*spot.point)) most = std::max(most, speed->abs().toDouble());
      }
    }
    return most > 0 && std::isfinite(most) ? kSpeedReach / most : 0;
  }
  [[nodiscard]] CanvasPoint tipOf(const Spot& spot, double scale) const {
    const auto speed = speedOf(*spot.point);
    return {spot.at.x + (speed ? scale * speed->toDouble() : 0), spot.at.y};
  }

  void drawSpeeds(std::size_t bar) {
    const double scale = speedScale();
    if (scale == 0) return;
    const auto& spots = m_spots[bar];
    for (const Spot& spot : spots)
      m_painter.arrow(elementOf(*spot.point), spot.at, tipOf(spot, scale), tintOf(*spot.point), 3);
    const CanvasPoint top = tipOf(spots.front(), scale);
    const CanvasPoint bottom = tipOf(spots.back(), scale);
    m_painter.line({}, {top, bottom}, ColorRole::ink, 1.4, Dash::solid, kLineDepth + 1);
    m_painter.blockLine(top, bottom);
  }

  void drawTorques(std::size_t bar) {
    const auto lever = static_cast<std::size_t>(m_layout.bars[bar].lever);
    if (!m_hasTorques || m_picture.torques[lever].empty()) return;
    double most = 0;
    for (const auto& each : m_picture.torques) {
      for (const Rational& torque : each) most = std::max(most, torque.abs().toDouble());
    }
    if (most <= 0 || !std::isfinite(most)) return;
    for (const Spot& spot : m_spots[bar]) {
      const auto place = static_cast<std::size_t>(spot.point - leverOf(bar).points.data());
      const Rational& torque = m_picture.torques[lever][place];
      if (torque.isZero()) continue;
      const double size = std::max(kTorqueReach * torque.abs().toDouble() / most, 12.0);
      const auto speed = speedOf(*spot.point);
      const double y = spot.center.y + (speed && speed->sign() < 0 ? 9 : 0);
      const double near = spot.center.x - LeverPainter::halfWidthOf(spot.point->links) - 4;
      const CanvasPoint inner{near, y};
      const CanvasPoint outer{near - size, y};
      const bool pushes = torque.sign() > 0;
      m_painter.arrow(elementOf(*spot.point), pushes ? outer : inner, pushes ? inner : outer, ColorRole::ink,
                      1.8);
      if (!m_look.numbers) continue;
      m_painter.text(elementOf(*spot.point), {near - size / 2, y + 3},
                     {LetterSide::below, LetterSide::above, LetterSide::left}, threeDecimals(torque),
                     kValueSize, false, ColorRole::secondary);
    }
  }

  void drawValues(std::size_t bar) {
    if (!m_look.numbers) return;
    const double scale = speedScale();
    for (const Spot& spot : m_spots[bar]) {
      const auto speed = speedOf(*spot.point);
      if (!speed || (speed->isZero() && isHeld(*spot.point))) continue;
      const CanvasPoint tip = tipOf(spot, scale);
      // Beyond the disc, where the arrow is hidden under it.
      const double clear = kDiscRadius + 4;
      if (spot.center.x != spot.at.x) {  // beside its disc, where it is clear whose speed it is
        m_painter.text(elementOf(*spot.point),
                       {spot.center.x - LeverPainter::halfWidthOf(spot.point->links), spot.center.y},
                       {LetterSide::left, LetterSide::below, LetterSide::above}, threeDecimals(*speed),
                       kValueSize, true, ColorRole::ink);
        continue;
      }
      const bool isNegative = speed->sign() < 0;
      const CanvasPoint anchor{
          isNegative ? std::min(tip.x, spot.at.x - clear) : std::max(tip.x, spot.at.x + clear),
          spot.at.y - 4};
      const LetterSide outward = isNegative ? LetterSide::left : LetterSide::right;
      m_painter.text(elementOf(*spot.point), anchor, {outward, LetterSide::above, LetterSide::below},
                     threeDecimals(*speed), kValueSize, true, ColorRole::ink);
    }
  }

  /// Which links the motors drive, and which is driven in the state: once each, at the first bar.
  void drawRoles() {
    const double scale = speedScale();
    std::set<int> said;
    for (std::size_t bar = 0; bar < m_layout.bars.size(); ++bar) {
      for (const Spot& spot : m_spots[bar]) {
        for (const LinkOrdinal link : spot.point->links) {
          const bool isInput =
              std::find(m_picture.inputs.begin(), m_picture.inputs.end(), link) != m_picture.inputs.end();
          const bool isOutput = m_picture.output && *m_picture.output == link;
          if ((!isInput && !isOutput) || !said.insert(link).second) continue;
          const CanvasPoint anchor{std::max(tipOf(spot, scale).x, spot.center.x + kDiscRadius) + 6,
                                   spot.at.y + 14};
          m_painter.pill(m_mechanism.links[link].id, anchor, LetterSide::right,
                         isInput ? translated("input") : translated("output"), isInput);
        }
      }
    }
  }

  void drawFoot() {
    double y = 46;
    for (const auto& spots : m_spots) y = std::max(y, spots.back().center.y + 46);
    for (std::size_t bar = 0; bar < m_layout.bars.size(); ++bar) {
      const Lever& lever = leverOf(bar);
      const std::string sets = setsOf(lever);
      if (!sets.empty()) m_painter.fixedText({}, {xOf(bar), y}, sets, kValueSize, true, ColorRole::ink);
      m_painter.text({}, {xOf(bar), y + 8}, {LetterSide::below}, teethOf(m_picture.plan, lever), kSmallSize,
                     false, ColorRole::secondary);
      const bool isWhole = std::all_of(lever.points.begin(), lever.points.end(),
                                       [](const LeverPoint& point) { return point.isByMeshes; });
      if (!isWhole)
        m_painter.text({}, {xOf(bar), y + 24}, {LetterSide::below},
                       translated("dashed: by these tooth counts only"), kSmallSize, false,
                       ColorRole::secondary);
    }
    std::vector<std::string> notes;
    std::set<int> said;
    for (const Lever& lever : m_picture.plan.levers) {
      for (const LeverPoint& point : lever.points) {
        if (point.links.size() > 1 && said.insert(point.links.front()).second)
          notes.push_back(turnsAsOne(point.links, point.isOneByMeshes));
      }
    }
    if (const double scale = speedScale(); scale > 0 && !m_hasTorques)
      notes.push_back(translated("Arrows: speeds in rad/s."));
    if (m_hasTorques)
      notes.push_back(translated(
          "Arrows to the right of the bars: speeds in rad/s; to the left: torques on the lever in N m."));
    y += 46;
    for (const std::string& note : notes) {
      m_painter.text({}, {xOf(0) + m_spacing * static_cast<double>(m_layout.bars.size() - 1) / 2, y},
                     {LetterSide::below}, note, kSmallSize, false, ColorRole::secondary);
      y += 18;
    }
  }

  const Mechanism& m_mechanism;
  const LeverPicture& m_picture;
  const LeverLayout& m_layout;
  const LeverLook& m_look;
  bool m_hasTorques = false;
  double m_spacing = 0;
  double m_unit = 0;
  LeverPainter m_painter;
  std::vector<std::vector<Spot>> m_spots;  ///< by bar, from the top
  int m_dogLegs = 0;
};

}  // namespace

LeverSheet leverSheet(const Mechanism& mechanism, const LeverPicture& picture, const LeverLayout& layout,
                      const Emphases& emphases, const LeverLook& look) {
  return LeverDrawer(mechanism, picture, layout, emphases, look).drawn();
}

DisplayList leverDrawing(const Mechanism& mechanism, const LeverPicture& picture, const Emphases& emphases) {
  return leverSheet(mechanism, picture, leverLayout(mechanism, picture.plan), emphases).drawing;
}

}  // namespace geargraph
