#pragma once

#include <optional>
#include <vector>

#include "core/mechanism/placement/axis_line.h"
#include "core/mechanism/placement/mesh_word.h"

namespace geargraph::inline placement {

/// The module (pitch diameter / teeth) of trains that say no size anywhere.
constexpr int kDefaultModule = 2;

struct PlacedAxes {
  std::vector<AxisLine> lines;    ///< by axis of the document
  std::vector<ExactLine> chosen;  ///< of the automatic ones
  Rational module = kDefaultModule;
  std::vector<int> bevelSizes;  ///< by mesh: the module of a derived bevel pair, in halves of `module`;
                                ///< empty: of the usual size
};

/// Places the axes that the file leaves open.
///
/// 1. Axes with point and direction stay. Where a mesh between two parallel ones of them has a centre
///    distance, that gives the module; else kDefaultModule.
/// 2. From placed axes outward, along meshes: an axis of an external or internal mesh lies parallel to its
///    neighbour at the distance that the teeth ask for; several of one neighbour on one carrier are spread
///    evenly round it; an axis that two placed ones hold lies where both distances meet, if they do.
/// 3. An axis of a bevel mesh lies at right angles to its neighbour and meets it (z's partner is y, y's is z,
///    x's is y), where there is room for the wheels (bevel_arranger.h); several on one carrier are spread
///    round the same apex.
/// 4. Axes that no mesh ties to these start a new group beside them, along z.
///
/// `given` (givenLines()) tells which ones those are. `words`, by mesh: none where a mesh has no carrier; no
/// tree: no words.
[[nodiscard]] PlacedAxes placedAxes(const Mechanism& mechanism, std::vector<AxisLine> given,
                                    const JointTree* tree, const AxisClasses& classes,
                                    const std::vector<std::optional<MeshWord>>& words);

}  // namespace geargraph::inline placement
