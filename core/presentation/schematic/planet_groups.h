#pragma once

#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::inline schematic {

/// Planets of one carrier that are connected by meshes: a single planet, or the two of a Ravigneaux pair.
struct PlanetGroup {
  std::vector<LinkOrdinal> links;    ///< positions; equal groups list them in corresponding order
  std::vector<JointOrdinal> joints;  //
  std::vector<MeshOrdinal> meshes;   //
};

/// Sets of equal groups, which differ only in their position around their carrier's axis: same carrier, same
/// wheels, same partners. Only sets of two or more, each in the document's order.
///
/// Planets that are driven themselves, and those that carry others, are in no set.
/// @pre the placement is the mechanism's and has a tree
[[nodiscard]] std::vector<std::vector<PlanetGroup>> equalPlanets(const Mechanism& mechanism,
                                                                 const Placement& placement);

}  // namespace geargraph::inline schematic
