#pragma once

#include <unordered_map>
#include <vector>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/drawing/tt_graph_geometry.h"

namespace geargraph::inline drawing {

/// The colour of the second of two walks that are shown at once; the first has the accent.
constexpr ColorRole kSecondWalk = ColorRole::negativeInk;

/// The T-T graph in painting order [AU, Figs. 5 and 6]: the branches of the tree thick with the letters of
/// their levels, the chords of the meshes thin with their primes, a second ring in every transfer vertex.
/// Meshes that have none are dotted.
///
/// Of a mesh that is on a walk the two f-circuits are shown: that of the tail gear in the accent, that of the
/// head gear in kSecondWalk.
[[nodiscard]] DisplayList ttGraphDrawing(const TtGraphGeometry& geometry, const Emphases& emphases);

/// Where the elements are in a geometry, to draw a few of thousands again.
class TtElements {
 public:
  explicit TtElements(const TtGraphGeometry& geometry);

  /// What ttGraphDrawing() has of this element, empty for one that it has not. Cost: of its marks alone.
  /// @pre `geometry` is the one that this was made for
  [[nodiscard]] DisplayList drawing(const TtGraphGeometry& geometry, const ElementId& element,
                                    const Emphasis& emphasis) const;

 private:
  std::unordered_map<ElementId, std::vector<std::size_t>> m_places;  ///< in the list of the element's kind
};

}  // namespace geargraph::inline drawing
