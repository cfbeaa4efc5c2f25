#pragma once

#include <unordered_map>
#include <vector>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/drawing/tt_graph_geometry.h"

namespace geargraph {

/// The colour of the second of two highlighted walks; the first has the accent colour.
constexpr ColorRole kSecondWalk = ColorRole::negativeInk;

/// The T-T graph in painting order [AU, Figs. 5 and 6]: the branches of the tree thick with the letters of
/// their levels, the chords of the meshes thin with their primes, a second ring in every transfer vertex.
/// Meshes that have none are dotted.
///
/// For a highlighted mesh its two f-circuits are shown: that of the tail gear in the accent, that of the head
/// gear in kSecondWalk.
[[nodiscard]] DisplayList ttGraphDrawing(const TtGraphGeometry& geometry, const Emphases& emphases);

/// An index of the elements of a geometry, to redraw a few of thousands.
class TtElements {
 public:
  explicit TtElements(const TtGraphGeometry& geometry);

  /// The marks of this element in ttGraphDrawing(), empty if it has none. Cost: that of its marks.
  /// @pre `geometry` is the one that this was made for
  [[nodiscard]] DisplayList drawing(const TtGraphGeometry& geometry, const ElementId& element,
                                    const Emphasis& emphasis) const;

 private:
  std::unordered_map<ElementId, std::vector<std::size_t>> m_places;  ///< in the list of the element's kind
};

}  // namespace geargraph
