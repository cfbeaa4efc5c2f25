#include "core/presentation/schematic/section_labels.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/pins.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kLabelDiscRadius = 9.5;
constexpr double kNumberSize = 11;
constexpr double kGap = 2.5;        ///< that a label keeps from everything
constexpr double kLeaderFrom = 12;  ///< a label farther away than this has a leader
/// A drawing of this size can be read in a small window (1366 x 768). One that is larger is shown smaller, so
/// that its labels are larger by as much, up to kLargestType.
constexpr double kReadWidth = 700;
constexpr double kReadHeight = 320;
constexpr double kLargestType = 2.4;

double typeScale(const Section& section) {
  const Extent all = extentOf(section);
  const double over = std::max(2 * all.halfWidth / kReadWidth, 2 * all.halfHeight / kReadHeight);
  return std::clamp(over, 1.0, kLargestType);
}

constexpr int kDirections = 24;

/// Unit vectors all round, in the order in which they are tried.
const std::array<CanvasPoint, kDirections>& directions() {
  static const auto all = [] {
    std::array<CanvasPoint, kDirections> ways;
    for (int k = 0; k < kDirections; ++k) {
      const double angle = 2 * std::numbers::pi * (k * 7 % kDirections) / kDirections;
      ways[static_cast<std::size_t>(k)] = {std::cos(angle), -std::sin(angle)};
    }
    return ways;
  }();
  return all;
}

/// Finds places that are free and takes them.
class LabelPlacer {
 public:
  LabelPlacer(const Section& section, double scale)
      : m_scale(scale), m_taken(obstaclesOf(section, 60 * scale)) {}

  struct Place {
    CanvasPoint center;
    CanvasPoint anchor;
    double away = 0;  ///< from the anchor to the label's edge
  };

  /// The free place nearest to one of the anchors, the first ones preferred. Where there is none it lies on
  /// the first.
  Place take(const std::vector<CanvasPoint>& anchors, double halfWidth, double halfHeight, bool mayCover) {
    const std::optional<Place> place = find(anchors, halfWidth, halfHeight, mayCover);
    m_found = m_found && place;
    const Place taken = place.value_or(Place{anchors.front(), anchors.front(), 0});
    take({taken.center, halfWidth, halfHeight});
    return taken;
  }
  /// Has every label found a free place?
  [[nodiscard]] bool found() const { return m_found; }

  void take(const Extent& box) {
    m_taken.addBox(box);
    m_labels.push_back(box);
  }
  void line(CanvasPoint from, CanvasPoint to) { m_taken.addCurve(Curve::straight(from, to)); }

 private:
  [[nodiscard]] std::optional<Place> find(const std::vector<CanvasPoint>& anchors, double halfWidth,
                                          double halfHeight, bool mayCover) const {
    constexpr double kStep = 4;
    constexpr double kMaxDistance = 400;
    for (double away = 5 * m_scale; away < kMaxDistance * m_scale; away += kStep) {
      for (const CanvasPoint anchor : anchors) {
        for (const CanvasPoint way : directions()) {
          const double support = std::min(halfWidth / std::max(std::abs(way.x), 1e-9),
                                          halfHeight / std::max(std::abs(way.y), 1e-9));
          const Extent box{anchor + (away + support) * way, halfWidth, halfHeight};
          const bool free =
              !m_taken.touches(box, kGap * m_scale) && (mayCover || !leaderHits(anchor, box.center));
          if (free) return Place{box.center, anchor, away};
        }
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] bool leaderHits(CanvasPoint from, CanvasPoint to) const {
    for (const Extent& label : m_labels) {
      if (label.grown(kGap).meetsSegment(from, to)) return true;
    }
    return false;
  }

  double m_scale;
  bool m_found = true;
  ObstacleGrid m_taken;
  std::vector<Extent> m_labels;
};

class Labeller {
 public:
  Labeller(const DrawnPart& part, const Section& section, double scale)
      : m_part(part),
        m_section(section),
        m_scale(scale),
        m_size(kNumberSize * m_scale),
        m_placer(section, m_scale) {}

  SectionLabels label(const std::vector<std::string>& notes) {
    for (std::size_t i = 0; i < m_section.links.size(); ++i) addDisc(i);
    for (const Section::Anchors& mesh : m_section.meshes) addNumber(mesh, numberOf(mesh.element), false);
    for (const Section::Anchors& joint : m_section.joints) addNumber(joint, numberOf(joint.element), true);
    for (const Section::Anchors& coupling : m_section.couplings)
      addNumber(coupling, elided(coupling.element.id.text(), 10), true);
    for (const Section::Anchors& axis : m_section.axes) addAxisName(axis);
    addNotes(notes);
    return std::move(m_labels);
  }
  [[nodiscard]] bool found() const { return m_placer.found(); }

 private:
  [[nodiscard]] std::string numberOf(const ElementId& element) const {
    const Mechanism& m = m_part.mechanism;
    for (std::size_t j = 0; j < m.turningJoints.size(); ++j) {
      if (element == ElementId(m.turningJoints[j].id)) return std::to_string(m_part.jointLabels[j]);
    }
    for (std::size_t c = 0; c < m.gearMeshes.size(); ++c) {
      if (element == ElementId(m.gearMeshes[c].id)) return std::to_string(m_part.meshLabels[c]);
    }
    return {};
  }

  void put(const ElementId& element, MarkRole role, std::variant<Stroke, Fill, Text> what, int z) {
    m_labels.marks.push_back({element, role, z, std::move(what)});
  }

  void leader(const ElementId& element, const LabelPlacer::Place& place, const Extent& box) {
    if (place.away < kLeaderFrom * m_scale) return;
    const CanvasPoint way = unit(place.anchor - box.center);
    const double support = std::min(box.halfWidth / std::max(std::abs(way.x), 1e-9),
                                    box.halfHeight / std::max(std::abs(way.y), 1e-9));
    const CanvasPoint edge = box.center + (support + 1) * way;
    put(element, MarkRole::line,
        Stroke{Polyline{{edge, place.anchor}, false}, ColorRole::secondary, 0.8 * m_scale, Dash::solid},
        kLineDepth - 1);
    m_placer.line(edge, place.anchor);
  }

  /// The ground needs no number: its hatching says what it is.
  void addDisc(std::size_t link) {
    const Section::Anchors& anchors = m_section.links[link];
    if (link == 0 || anchors.places.empty()) return;
    const int label = m_part.linkLabels[link];
    const std::string number = std::to_string(label);
    const double radius = kLabelDiscRadius * m_scale;
    const double half = std::max(radius, textWidth(number, m_size, true) / 2 + 3.5 * m_scale);
    const LabelPlacer::Place place = m_placer.take(anchors.places, half, radius, false);
    const Extent box{place.center, half, radius};
    leader(anchors.element, place, box);
    put(anchors.element, MarkRole::node, Fill{Box{box, radius}, ColorRole::sheet}, kNodeDepth);
    put(anchors.element, MarkRole::node,
        Stroke{Box{box, radius}, m_part.tintOf(static_cast<int>(link)), 2 * m_scale, Dash::solid},
        kNodeDepth);
    put(anchors.element, MarkRole::label, Text{number, place.center, m_size, true, ColorRole::ink},
        kNodeDepth);
    m_labels.outlines.push_back({anchors.element, kNodeDepth, Box{box, radius}, 0});
  }

  void addNumber(const Section::Anchors& anchors, const std::string& number, bool bold) {
    if (anchors.places.empty()) return;
    const double half = textWidth(number, m_size, bold) / 2;
    const LabelPlacer::Place place = m_placer.take(anchors.places, half, m_size / 2, false);
    const Extent box{place.center, half, m_size / 2};
    leader(anchors.element, place, box);
    put(anchors.element, MarkRole::label, Text{number, place.center, m_size, bold, ColorRole::ink},
        kLabelDepth);
    m_labels.outlines.push_back({anchors.element, kLabelDepth, Box{box, 0}, 0});
  }

  void addAxisName(const Section::Anchors& anchors) {
    const Axis* axis = m_part.mechanism.find(AxisId(anchors.element.id));
    const std::string pin = axis != nullptr && isPinned(*axis) ? ' ' + translated("(pinned)") : std::string();
    const std::string name = elided(anchors.element.id.text(), 12) + pin;
    const double half = textWidth(name, m_size, false) / 2;
    const LabelPlacer::Place place = m_placer.take(anchors.places, half, m_size / 2, true);
    put(anchors.element, MarkRole::label, Text{name, place.center, m_size, false, ColorRole::secondary},
        kLabelDepth);
    m_labels.outlines.push_back({anchors.element, kLabelDepth, Box{{place.center, half, m_size / 2}, 0}, 0});
  }

  /// Under all that is drawn, from its middle.
  void addNotes(const std::vector<std::string>& notes) {
    if (m_section.marks.empty() && m_labels.marks.empty()) return;
    Extent all = extentOf(m_section.marks.empty() ? m_labels.marks.front() : m_section.marks.front());
    for (const Mark& mark : m_section.marks) all = all.united(extentOf(mark));
    for (const Mark& mark : m_labels.marks) all = all.united(extentOf(mark));
    double y = all.bottom() + 26 * m_scale;
    for (const std::string& note : notes) {
      put(ElementId{}, MarkRole::name, Text{note, {all.center.x, y}, m_size, false, ColorRole::secondary},
          kLabelDepth);
      y += 1.5 * m_size;
    }
  }

  const DrawnPart& m_part;
  const Section& m_section;
  double m_scale;
  double m_size;
  LabelPlacer m_placer;
  SectionLabels m_labels;
};

std::string listedLabels(const std::vector<int>& labels) {
  std::vector<std::string> words;
  for (const int label : labels) words.push_back(std::to_string(label));
  return listed(words, kAllNames);
}

/// One set or planet of several is drawn: %1 how many there are, %2 the others, %3 those that are drawn.
const char* planetsText(bool arePlanets, bool isOneOther) {
  if (arePlanets)
    return isOneOther ? toTranslate("One of %1 equal planets is drawn: %2 is like %3.")
                      : toTranslate("One of %1 equal planets is drawn: %2 are like %3.");
  return isOneOther ? toTranslate("One of %1 equal sets of planets is drawn: %2 is like %3.")
                    : toTranslate("One of %1 equal sets of planets is drawn: %2 are like %3.");
}

}  // namespace

std::vector<std::string> sectionNotes(const DrawnPart& part, const SheetLayout& layout) {
  std::vector<std::string> notes;
  for (const DrawnPart::Planets& planets : part.planets) {
    notes.push_back(
        filled(translated(planetsText(planets.drawn.size() == 1, planets.others.size() == 1)),
               {std::to_string(planets.count), listedLabels(planets.others), listedLabels(planets.drawn)}));
  }
  std::vector<std::string> turned;
  for (const SheetAxis& axis : layout.axes) {
    if (axis.turned) turned.push_back(part.mechanism.axes[axis.axis].id.text());
  }
  if (layout.otherRadii) {
    notes.push_back(translated("Unfolded: the axes do not lie in one plane. Radii are not to scale."));
  } else if (!turned.empty() && turned.size() <= 8) {
    const std::string names = listed(turned, kAllNames);
    notes.push_back(
        turned.size() == 1
            ? translated("Unfolded: the axes do not lie in one plane. %1 is turned into the sheet.", {names})
            : translated("Unfolded: the axes do not lie in one plane. %1 are turned into the sheet.",
                         {names}));
  } else if (!turned.empty()) {
    notes.push_back(
        translated("Unfolded: the axes do not lie in one plane. %1 of them are turned into the sheet.",
                   {std::to_string(turned.size())}));
  }
  for (const SheetPair& pair : layout.pairs) {
    if (!pair.apart) continue;
    notes.push_back(translated("Wheels that a dashed line joins mesh, though they do not touch here."));
    break;
  }
  if (!part.loose.empty()) {
    const std::string names = listedLabels(part.loose);
    notes.push_back(
        part.loose.size() == 1
            ? translated("Link %1 is not drawn: no turning joint ties it to the ground.", {names})
            : translated("Links %1 are not drawn: no turning joint ties them to the ground.", {names}));
  }
  if (!part.closing.empty()) {
    const std::string names = listedLabels(part.closing);
    notes.push_back(part.closing.size() == 1
                        ? translated("Joint %1 closes a loop and is not drawn.", {names})
                        : translated("Joints %1 close a loop and are not drawn.", {names}));
  }
  return notes;
}

SectionLabels sectionLabels(const DrawnPart& part, const Section& section,
                            const std::vector<std::string>& notes) {
  constexpr double kSmaller = 0.8;
  for (double scale = typeScale(section);; scale = std::max(1.0, kSmaller * scale)) {
    Labeller labeller(part, section, scale);
    SectionLabels labels = labeller.label(notes);
    if (labeller.found() || scale <= 1) return labels;
  }
}

}  // namespace geargraph
