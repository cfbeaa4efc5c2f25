#pragma once

#include "core/presentation/diagrams/power_picture.h"
#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/schematic/schematic.h"

namespace geargraph {

/// The power bands under a digraph: along its arrows from the delivering link to the receiving one, and from
/// the middle of a mesh to its carrier. The width is proportional to the power, kWidestBand for the greatest;
/// arrowheads point with the flow. Circulating power is drawn inside the band in the accent colour, lost
/// power as a grey arrow. Cost: near linear in links + joints + meshes. @pre all of one mechanism
[[nodiscard]] DisplayList digraphPower(const PowerPicture& picture, const Mechanism& mechanism,
                                       const DigraphGeometry& geometry);

/// The same under a functional schematic, where power follows the lines of each link from where it enters to
/// where it leaves. The one drawn of several equal planets has their sum. Cost: O(lines^2) per link.
/// @pre all of one mechanism
[[nodiscard]] DisplayList schematicPower(const PowerPicture& picture, const Mechanism& mechanism,
                                         const SchematicGeometry& geometry);

}  // namespace geargraph
