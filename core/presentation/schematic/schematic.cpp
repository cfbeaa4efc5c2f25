#include "core/presentation/schematic/schematic.h"

#include <algorithm>
#include <optional>

#include "core/machine/bodies/derived_geometry.h"
#include "core/presentation/schematic/coupling_symbols.h"
#include "core/presentation/schematic/stacker.h"

namespace geargraph::inline schematic {
namespace {

constexpr double kHaloBeyond = 7;  ///< a halo is wider than its line by this

Emphasis joined(const Emphasis& a, const Emphasis& b) {
  return {a.hovered || b.hovered, a.selected || b.selected, a.walk != 0 ? a.walk : b.walk};
}

/// Emphases with those of equal planets on the one that is drawn.
Emphases onDrawn(const SchematicGeometry& geometry, Emphases emphases) {
  for (const DrawnPart::Alike& alike : geometry.alike) {
    const auto found = emphases.find(alike.like);
    if (found == emphases.end()) continue;
    const Emphasis emphasis = found->second;
    emphases[alike.drawn] = joined(emphases[alike.drawn], emphasis);
  }
  return emphases;
}

Mark haloOf(const Mark& mark) {
  Mark halo{mark.element, MarkRole::halo, kHaloDepth, mark.what};
  if (auto* stroke = std::get_if<Stroke>(&halo.what)) {
    stroke->tint = ColorRole::halo;
    stroke->width += kHaloBeyond;
    stroke->dash = Dash::solid;
  }
  return halo;
}

/// Bearings whose arms would cross other links are tried elsewhere on their axes.
class SectionSearch {
 public:
  SectionSearch(const DrawnPart& part, const Placement& placement, SheetLayout& layout)
      : m_part(part), m_placement(placement), m_layout(layout), m_stacker(part, placement, layout) {}

  Section best(const std::stop_token& stop) {
    constexpr std::size_t kMostMoved = 4;
    constexpr std::size_t kMostLines = 160;  ///< a larger drawing is not done several times
    m_stacker.search(stop);
    if (m_layout.parallel) m_stacker.squeeze();
    if (stop.stop_requested()) return {};
    Section section = sectionOf(m_part, m_placement, m_layout, m_stacker.plan(), stop);
    if (m_layout.parallel || section.crossing.size() > kMostMoved || section.lines.size() > kMostLines) {
      return section;
    }
    for (const int joint : std::vector<int>(section.crossing)) {
      if (!stop.stop_requested()) move(joint, section, stop);
    }
    return section;
  }

 private:
  [[nodiscard]] static double costOf(const Section& section) {
    return 300 * section.crossings + 0.2 * section.armLength;
  }

  /// The places that cost least by themselves.
  [[nodiscard]] std::vector<std::pair<double, double>> places(int joint) {
    constexpr std::size_t kMostTried = 8;
    const double now = m_stacker.placeOf(joint);
    std::vector<std::pair<double, double>> places;
    for (const double place : m_stacker.placesOf(joint)) {
      m_stacker.move(joint, place);
      places.emplace_back(m_stacker.costOf(joint), place);
    }
    m_stacker.move(joint, now);
    std::sort(places.begin(), places.end());
    if (places.size() > kMostTried) places.resize(kMostTried);
    return places;
  }

  void move(int joint, Section& section, const std::stop_token& stop) {
    double kept = m_stacker.placeOf(joint);
    double least = costOf(section) + m_stacker.costOf(joint);
    for (const auto& [alone, place] : places(joint)) {
      if (alone >= least) continue;
      m_stacker.move(joint, place);
      Section other = sectionOf(m_part, m_placement, m_layout, m_stacker.plan(), stop);
      if (stop.stop_requested()) return;
      if (other.crossings >= section.crossings || costOf(other) + alone >= least) continue;
      least = costOf(other) + alone;
      kept = place;
      section = std::move(other);
    }
    m_stacker.move(joint, kept);
  }

  const DrawnPart& m_part;
  const Placement& m_placement;
  SheetLayout& m_layout;
  Stacker m_stacker;
};

}  // namespace

SchematicGeometry schematicGeometry(const Mechanism& mechanism, const std::stop_token& stop) {
  return schematicGeometry(DerivedGeometry(mechanism), stop);
}

SchematicGeometry schematicGeometry(const DerivedGeometry& document, const std::stop_token& stop) {
  SchematicGeometry geometry;
  geometry.isTooLarge = document.mechanism().links.size() > kMostDrawnLinks;
  if (geometry.isTooLarge) return geometry;
  const DrawnPart part = drawnPart(document.placed());
  std::optional<DerivedGeometry> ofPart;  // where that is another mechanism than the document's
  if (!part.isWhole()) ofPart.emplace(part.mechanism);
  const DerivedGeometry& derived = ofPart ? *ofPart : document;
  const Placement& placement = derived.placement();
  if (!placement.tree || stop.stop_requested()) return geometry;
  const auto wheels = derived.wheels(stop);
  if (!wheels) return geometry;
  SheetLayout layout = sheetLayout(part, placement, *wheels, stop);
  if (stop.stop_requested()) return geometry;
  if (layout.axes.empty()) return geometry;
  Section section = SectionSearch(part, placement, layout).best(stop);
  if (stop.stop_requested()) return geometry;
  addCouplings(part, layout, section, stop);
  if (stop.stop_requested()) return geometry;
  geometry.frame = sheetFrame(part, layout);
  geometry.notes = sectionNotes(part, layout);
  SectionLabels labels = sectionLabels(part, section, geometry.notes);
  geometry.alike = part.alike;
  geometry.marks = std::move(section.marks);
  geometry.marks.insert(geometry.marks.end(), labels.marks.begin(), labels.marks.end());
  std::stable_sort(geometry.marks.begin(), geometry.marks.end(),
                   [](const Mark& a, const Mark& b) { return a.z < b.z; });
  geometry.highlights = std::move(section.highlights);
  geometry.outlines = std::move(section.outlines);
  geometry.outlines.insert(geometry.outlines.end(), labels.outlines.begin(), labels.outlines.end());
  return geometry;
}

DisplayList schematicDrawing(const SchematicGeometry& geometry, const Emphases& emphases) {
  const Emphases all = onDrawn(geometry, emphases);
  const auto emphasisOf = [&](const ElementId& element) {
    const auto found = all.find(element);
    return found == all.end() ? Emphasis{} : found->second;
  };
  DisplayList list;
  list.outlines = geometry.outlines;
  for (const Mark& mark : geometry.marks) {
    const Emphasis emphasis = emphasisOf(mark.element);
    const bool isLine = std::holds_alternative<Stroke>(mark.what);
    if (emphasis.any() && isLine) list.marks.push_back(haloOf(mark));
    list.marks.push_back(mark);
    if (!emphasis.selected) continue;
    std::visit(
        [](auto& what) {
          const bool sheet = what.tint == Tint(ColorRole::sheet);
          if (!sheet) what.tint = ColorRole::accent;
        },
        list.marks.back().what);
  }
  for (const Mark& mark : geometry.highlights) {
    const Emphasis emphasis = emphasisOf(mark.element);
    if (!emphasis.any()) continue;
    list.marks.push_back(haloOf(mark));
    list.marks.push_back(mark);
  }
  list.sortByDepth();
  return list;
}

}  // namespace geargraph::inline schematic
