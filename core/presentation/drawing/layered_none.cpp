// Stands in for Graphviz (GEARGRAPH_GRAPHVIZ).

#include "core/presentation/drawing/layered_places.h"

namespace geargraph {

std::optional<std::vector<CanvasPoint>> layeredPlaces(int /*count*/, std::span<const LayeredEdge> /*edges*/) {
  return std::nullopt;
}

}  // namespace geargraph
