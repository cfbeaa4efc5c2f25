#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// An edge as the layered layout sees it: its tail is in a column left of its head.
struct LayeredEdge {
  int tail = 0;
  int head = 0;
  bool isMesh = false;  ///< drawn wherever it falls: only joints keep the order of the columns
};

/// Nodes 0 to count - 1 in columns, with few crossings: x counts halves of columns,
/// y those of rows, upwards. By Graphviz (layered_graphviz.cpp), serialised by a lock; std::nullopt where its
/// plugins are missing, or in a build without it (layered_none.cpp).
[[nodiscard]] std::optional<std::vector<CanvasPoint>> layeredPlaces(int count,
                                                                    std::span<const LayeredEdge> edges);

}  // namespace geargraph
