#pragma once

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/power_drawing/power_picture.h"
#include "core/presentation/schematic/schematic.h"

namespace geargraph::inline power_drawing {

/// What is laid under a digraph: along its arrows bands from the link that delivers to the one that takes;
/// from the middle of a mesh another one to its carrier. A band is as wide as its power, the greatest
/// kWidestBand; its arrowhead points with the flow. What circulates is drawn within it in accent, what is
/// lost as a grey arrow. Cost: near linear in links + joints + meshes. @pre all of one mechanism
[[nodiscard]] DisplayList digraphPower(const PowerPicture& picture, const Mechanism& mechanism,
                                       const DigraphGeometry& geometry);

/// The same under a functional schematic, where power goes along the lines of each link from where it enters
/// to where it leaves. The drawn one of several equal planets carries the sum.
/// Cost: O(lines^2) a link. @pre the same
[[nodiscard]] DisplayList schematicPower(const PowerPicture& picture, const Mechanism& mechanism,
                                         const SchematicGeometry& geometry);

}  // namespace geargraph::inline power_drawing
