#pragma once

#include <QString>

#include "core/presentation/drawing/digraph_drawing.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// A row of the cycle-basis matrix as a highlighted walk in the drawing [AU, Eq. (5)].
struct CycleWalk {
  Emphases emphases;  ///< +1 or -1 for every arrow on the cycle, as in the row
  QString caption;    ///< "Cycle C16: 5 ···16··· 2 –12– 1 –10– 0 –9– 5"
};

/// The fundamental cycle of a mesh: along the mesh from tail to head, and back through the tree. std::nullopt
/// if there is no such mesh or no tree.
[[nodiscard]] std::optional<CycleWalk> cycleWalk(const AnalysisSnapshot& snapshot, MeshId mesh);

}  // namespace geargraph
