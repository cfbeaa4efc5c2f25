#include "core/presentation/schematic/schematic.h"

#include <algorithm>
#include <optional>

#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/presentation/schematic/coupling_symbols.h"
#include "core/presentation/schematic/drawn_train.h"
#include "core/presentation/schematic/section.h"
#include "core/presentation/schematic/shaft_plan.h"

namespace geargraph {
namespace {

constexpr double kHaloBeyond = 7;  ///< a halo is wider than its line by this

Emphasis joined(const Emphasis& a, const Emphasis& b) {
  return {a.hovered || b.hovered, a.selected || b.selected, a.walk != 0 ? a.walk : b.walk};
}

/// Emphases with those of equal planets on the one that is drawn.
Emphases onDrawn(const SchematicGeometry& geometry, Emphases emphases) {
  for (const DrawnPart::Represented& represented : geometry.represented) {
    const auto found = emphases.find(represented.omitted);
    if (found == emphases.end()) continue;
    const Emphasis emphasis = found->second;
    emphases[represented.drawn] = joined(emphases[represented.drawn], emphasis);
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

}  // namespace

SchematicGeometry schematicGeometry(const Mechanism& mechanism, const std::stop_token& stop) {
  return schematicGeometry(DerivedGeometry(mechanism), stop);
}

SchematicGeometry schematicGeometry(const DerivedGeometry& document, const std::stop_token& stop) {
  SchematicGeometry geometry;
  geometry.isTooLarge = document.mechanism().links.size() > kMaxDrawnLinks;
  if (geometry.isTooLarge) return geometry;
  if (hasSlides(document.mechanism())) {
    geometry.notes.push_back(translated("Sliding joints, racks and screws have no symbols here."));
    return geometry;
  }
  const DrawnPart part = drawnPart(document.placed());
  const std::optional<DrawnTrain> train = drawnTrain(part, document, stop);
  if (!train || stop.stop_requested()) return geometry;
  SheetLayout layout = sheetLayout(part, train->placement, train->wheels, stop);
  if (stop.stop_requested() || layout.axes.empty()) return geometry;
  const ShaftPlan plan = shaftPlan(part, *train, layout);
  Section section = sectionOf(part, train->placement, layout, plan, stop);
  if (stop.stop_requested()) return geometry;
  addCouplings(part, layout, section, stop);
  if (stop.stop_requested()) return geometry;
  geometry.frame = sheetFrame(part, layout);
  geometry.rims = sheetRims(part, layout);
  geometry.notes = sectionNotes(part, layout);
  SectionLabels labels = sectionLabels(part, section, geometry.notes);
  geometry.represented = part.represented;
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

}  // namespace geargraph
