#pragma once

#include <stop_token>
#include <vector>

#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/schematic/section_labels.h"
#include "core/presentation/schematic/sheet_rims.h"

namespace geargraph::inline bodies {
class DerivedGeometry;
}  // namespace geargraph::inline bodies

namespace geargraph::inline schematic {

/// The functional schematic of a mechanism [AU, Figs. 1 and 3] in its plain look: the section drawing of
/// textbooks with the symbols of ISO 3952. Everything in it names its element.
struct SchematicGeometry {
  std::vector<Mark> marks;       ///< in painting order
  std::vector<Mark> highlights;  ///< only seen while their element stands out
  std::vector<Outline> outlines;
  std::vector<DrawnPart::Alike> alike;  ///< elements that another one stands for
  std::vector<std::string> notes;
  SheetFrame frame;  ///< for drawing on it
  std::vector<SheetRim> rims;
  bool isTooLarge = false;  ///< more links than can be drawn: there is nothing else then

  [[nodiscard]] bool isEmpty() const { return marks.empty(); }
};

/// Draws what the mechanism has so far: axes, and the links that turning joints tie to the ground. Axes that
/// do not lie in one plane are unfolded, and a note says so.
///
/// Bearings, arms and shafts are where the arrangement of the train has them
/// (DerivedGeometry::arrangement()), which is computed if it is not known yet.
///
/// Cost: milliseconds for 15 links, half a second for 60, a second to five for 200, half a minute where those
/// have 300 meshes: not for the thread of the windows. When `stop` is requested meanwhile, what comes back is
/// of no use.
/// @pre the mechanism is well formed
[[nodiscard]] SchematicGeometry schematicGeometry(const DerivedGeometry& document,
                                                  const std::stop_token& stop = {});
/// The same of a mechanism of which nothing has been derived yet.
[[nodiscard]] SchematicGeometry schematicGeometry(const Mechanism& mechanism,
                                                  const std::stop_token& stop = {});
/// Links, the ground among them; the arms of more take too long to find their ways.
constexpr std::size_t kMostDrawnLinks = 201;

/// The drawing with what stands out: halos behind what is hovered, accent on what is selected. Equal planets
/// stand out together.
[[nodiscard]] DisplayList schematicDrawing(const SchematicGeometry& geometry, const Emphases& emphases);

}  // namespace geargraph::inline schematic
