#pragma once

#include <cstdint>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// Planets of one carrier that are connected by meshes: a single planet, or the two of a Ravigneaux pair.
struct PlanetGroup {
  std::vector<LinkOrdinal> links;    ///< positions; equal groups list them in corresponding order
  std::vector<JointOrdinal> joints;  //
  std::vector<MeshOrdinal> meshes;   //
};

/// Which planets are compared.
enum class PlanetScope : std::uint8_t {
  drawn,  ///< on moving carriers and not driven: one of them stands for all in a drawing
  all     ///< also driven ones, and single ones round an axis of the ground (a train whose carrier is held)
};

/// Sets of equal groups, which differ only in their position around their carrier's axis: same carrier, same
/// wheels, same partners. Only sets of two or more, each in the document's order. Planets that carry others
/// are in no set.
/// Cost: O(n + c log c).
/// @pre the placement is the mechanism's and has a tree
[[nodiscard]] std::vector<std::vector<PlanetGroup>> equalPlanets(const Mechanism& mechanism,
                                                                 const Placement& placement,
                                                                 PlanetScope scope);

/// The same, also of planets of which one is drawn: every group, alone or with those that equal it. On axes
/// of the ground a single one has two meshes or more.
[[nodiscard]] std::vector<std::vector<PlanetGroup>> planetSets(const Mechanism& mechanism,
                                                               const Placement& placement, PlanetScope scope);

}  // namespace geargraph
