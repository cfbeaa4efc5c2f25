#pragma once

#include <stop_token>
#include <vector>

#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/schematic/section_labels.h"
#include "core/presentation/schematic/sheet_rims.h"

namespace geargraph {
class DerivedGeometry;
}  // namespace geargraph

namespace geargraph {

/// The functional schematic of a mechanism [AU, Figs. 1 and 3] without highlights: the section drawing of
/// textbooks with the symbols of ISO 3952. Every mark has its element.
struct SchematicGeometry {
  std::vector<Mark> marks;       ///< in painting order
  std::vector<Mark> highlights;  ///< shown only while their element is highlighted
  std::vector<Outline> outlines;
  std::vector<DrawnPart::Represented> represented;  ///< elements represented by an equal one
  std::vector<std::string> notes;
  CanvasFrame frame;  ///< for editing on the sheet
  std::vector<SheetRim> rims;
  bool isTooLarge = false;  ///< more than kMaxDrawnLinks: everything else is empty

  [[nodiscard]] bool isEmpty() const { return marks.empty(); }
};

/// Draws the mechanism as far as it is complete: axes, and the links that turning joints connect to the
/// ground. Axes that are not in one plane are unfolded, with a note.
///
/// Bearings, arms and shafts are where the arrangement of the train has them
/// (DerivedGeometry::arrangement()), which is computed on demand.
///
/// Cost: milliseconds for 15 links, half a second for 60, a second to five for 200, half a minute if those
/// have 300 meshes: do not call it on the GUI thread. The result is meaningless if `stop` was requested
/// meanwhile.
/// @pre the mechanism is well formed
[[nodiscard]] SchematicGeometry schematicGeometry(const DerivedGeometry& document,
                                                  const std::stop_token& stop = {});
/// The same for a mechanism from which no geometry has been derived yet.
[[nodiscard]] SchematicGeometry schematicGeometry(const Mechanism& mechanism,
                                                  const std::stop_token& stop = {});
/// The most links, including the ground; with more, routing the arms takes too long.
constexpr std::size_t kMaxDrawnLinks = 201;

/// The drawing with highlights: halos behind hovered elements, accent colour on selected ones. Equal planets
/// are highlighted together.
[[nodiscard]] DisplayList schematicDrawing(const SchematicGeometry& geometry, const Emphases& emphases);

}  // namespace geargraph
