#pragma once

#include <span>
#include <vector>

#include "core/mechanism/placement/planet_groups.h"

namespace geargraph {

/// Whether n equal planets go in and clear each other, decided by turning them: the planet one place further
/// is the first one turned about its own axis by an angle that brings every gear into its central wheel, and
/// each pitch of one of its gears is tried.
class CheckedPlanets {
 public:
  /// `wheelOfEnd`: by end of a mesh, 2 * mesh for the tail.
  CheckedPlanets(const Mechanism& mechanism, const Placement& placement, const std::vector<PlanetGroup>& set,
                 std::span<const int> wheelOfEnd);

  [[nodiscard]] int drawn() const { return m_drawn; }
  [[nodiscard]] bool hasPlanetsInMesh() const { return !m_inMesh.empty(); }
  [[nodiscard]] bool clears(std::span<const int> teeth, int planets) const;
  /// Cost: the teeth of a gear.
  [[nodiscard]] bool assembles(std::span<const int> teeth, int planets) const;

 private:
  struct Gear {
    int wheel = 0;
    int central = -1;  ///< the wheel on the carrier's axis at the end of its chain of meshes; -1: none
    int sense = 1;     ///< the product of the signs along the chain
  };
  struct Distance {
    int tail = 0, head = 0;
    int tailFactor = 1, headFactor = 1;
  };
  struct PlanetLink {
    std::vector<Gear> gears;
    std::vector<Distance> distances;
    std::vector<int> external;
  };
  struct InMesh {
    std::size_t one = 0, other = 0;
    int oneWheel = 0, otherWheel = 0;
  };
  [[nodiscard]] static int distanceOf(const PlanetLink& link, std::span<const int> teeth);
  [[nodiscard]] static int largestOf(const PlanetLink& link, std::span<const int> teeth);

  int m_drawn = 1;
  std::vector<PlanetLink> m_links;
  std::vector<InMesh> m_inMesh;
};

}  // namespace geargraph
