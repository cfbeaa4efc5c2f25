#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/gears/solid.h"

namespace geargraph {

/// The lines that a draughtsman would draw of a solid: edges whose two faces meet at more than `crease`
/// radians, as their normals tell, and edges of one face only. Vertices are told apart by their positions,
/// bit by bit, so doubled vertices of a crease are one point.
///
/// Shape    two vertex indices a line.
/// Cost     O(triangles), once a solid.
[[nodiscard]] std::vector<std::uint32_t> featureEdges(const Solid& solid, double crease = 0.4);

/// Feature edges of solids, kept as long as the solids are. Not for two threads at once.
class FeatureEdges {
 public:
  [[nodiscard]] std::shared_ptr<const std::vector<std::uint32_t>> find(
      const std::shared_ptr<const Solid>& solid);
  /// Drops those of solids that are gone.
  void forgetOthers();

 private:
  struct Known {
    std::weak_ptr<const Solid> solid;
    std::shared_ptr<const std::vector<std::uint32_t>> edges;
  };
  std::unordered_map<const Solid*, Known> m_known;
};

}  // namespace geargraph
