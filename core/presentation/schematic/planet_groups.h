#pragma once

#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::inline schematic {

/// Planets of one carrier that hang together by their meshes: one axis, or the two of a Ravigneaux pair.
struct PlanetGroup {
  std::vector<int> links;   ///< positions; equal groups list them in corresponding order
  std::vector<int> joints;  //
  std::vector<int> meshes;  //
};

/// Groups that differ in nothing but where they stand round their carrier's axis: same carrier, same wheels,
/// same partners. Only sets of two and more; the first of each set comes first in the document.
///
/// Planets that are driven themselves, and those that carry others, are nobody's like.
/// @pre the placement is the mechanism's and has a tree
[[nodiscard]] std::vector<std::vector<PlanetGroup>> equalPlanets(const Mechanism& mechanism,
                                                                 const Placement& placement);

}  // namespace geargraph::inline schematic
