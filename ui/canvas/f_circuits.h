#pragma once

#include <QStringList>

#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/drawing/palette.h"
#include "core/theory/ttgraph/tt_graph.h"

namespace geargraph {

/// The two fundamental circuits of a mesh as highlighted walks in the T-T graph [AU, Fig. 6], and its
/// equations as text: each walk along its chord from the gear to the carrier and back through the branches.
struct FCircuits {
  Emphases emphases;
  QStringList caption;
  std::vector<ColorRole> colors;  ///< by line
};

/// std::nullopt if the mesh has no transfer vertex. @pre the mesh is in the graph
[[nodiscard]] std::optional<FCircuits> fCircuits(const TtGraph& graph, int mesh);

}  // namespace geargraph
