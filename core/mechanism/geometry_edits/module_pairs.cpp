#include "core/mechanism/geometry_edits/module_pairs.h"

#include <set>

#include "core/mechanism/geometry_edits/teeth_fit.h"

namespace geargraph {

std::vector<int> meshesOfOneModule(const Mechanism& mechanism, const Placement& placement,
                                   const std::function<bool(MeshOrdinal mesh)>& starts) {
  const WheelMap wheels(mechanism, placement);
  ByMesh<bool> isReached(static_cast<std::size_t>(mechanism.c()), false);
  std::set<AxisPair> pairs;                // of parallel axes
  std::set<std::pair<int, bool>> reached;  // wheels, and whether as bevels
  for (bool grows = true; grows;) {
    grows = false;
    for (MeshOrdinal mesh = 0; mesh < mechanism.c(); ++mesh) {
      if (isReached[mesh]) continue;
      const MeshGeometry& geometry = *placement.meshes[mesh];
      if (!touches(geometry.kind) || hasSkewAxes(geometry.kind)) {  // its wheels have sizes of their own
        isReached[mesh] = starts(mesh);
        continue;
      }
      const bool isBevel = !hasParallelAxes(geometry.kind);
      const std::pair tail(wheels.wheelOf(2 * mesh), isBevel), head(wheels.wheelOf(2 * mesh + 1), isBevel);
      if (!starts(mesh) && !reached.contains(tail) && !reached.contains(head) &&
          (isBevel || !pairs.contains(axisPairOf(geometry))))
        continue;
      grows = isReached[mesh] = true;
      reached.insert({tail, head});
      if (!isBevel) pairs.insert(axisPairOf(geometry));
    }
  }
  std::vector<int> meshes;
  for (MeshOrdinal mesh = 0; mesh < mechanism.c(); ++mesh) {
    if (isReached[mesh]) meshes.push_back(mesh);
  }
  return meshes;
}

}  // namespace geargraph
