#include "core/mechanism/fitting/module_pairs.h"

#include <set>

#include "core/mechanism/fitting/teeth_fit.h"

namespace geargraph::inline fitting {

std::vector<int> meshesOfOneModule(const Mechanism& mechanism, const Placement& placement,
                                   const std::function<bool(int mesh)>& starts) {
  const WheelMap wheels(mechanism, placement);
  std::vector<bool> isReached(static_cast<std::size_t>(mechanism.c()), false);
  std::set<AxisPair> pairs;                // of parallel axes
  std::set<std::pair<int, bool>> reached;  // wheels, and whether as bevels
  for (bool grows = true; grows;) {
    grows = false;
    for (int mesh = 0; mesh < mechanism.c(); ++mesh) {
      if (isReached[static_cast<std::size_t>(mesh)]) continue;
      const MeshGeometry& geometry = *placement.meshes[static_cast<std::size_t>(mesh)];
      const bool isBevel = geometry.kind == MeshKind::bevel;
      const std::pair tail(wheels.wheelOf(2 * mesh), isBevel), head(wheels.wheelOf(2 * mesh + 1), isBevel);
      if (!starts(mesh) && !reached.contains(tail) && !reached.contains(head) &&
          (isBevel || !pairs.contains(axisPairOf(geometry))))
        continue;
      grows = isReached[static_cast<std::size_t>(mesh)] = true;
      reached.insert({tail, head});
      if (!isBevel) pairs.insert(axisPairOf(geometry));
    }
  }
  std::vector<int> meshes;
  for (int mesh = 0; mesh < mechanism.c(); ++mesh) {
    if (isReached[static_cast<std::size_t>(mesh)]) meshes.push_back(mesh);
  }
  return meshes;
}

}  // namespace geargraph::inline fitting
