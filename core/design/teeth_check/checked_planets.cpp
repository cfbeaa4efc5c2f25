#include "core/design/teeth_check/checked_planets.h"
#include "core/mechanism/kinds/pair_kind.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>

namespace geargraph {
namespace {

/// One gear of a chain of meshes.
struct ChainGear {
  LinkOrdinal link = 0;
  int wheel = 0;
  int sense = 1;
};

int countAt(std::span<const int> teeth, int wheel) {
  return teeth[static_cast<std::size_t>(wheel)];
}

}  // namespace

CheckedPlanets::CheckedPlanets(const Mechanism& mechanism, const Placement& placement,
                               const std::vector<PlanetGroup>& set, std::span<const int> wheelOfEnd)
    : m_drawn(static_cast<int>(set.size())) {
  const PlanetGroup& group = set.front();
  const auto positionOf = [&](LinkOrdinal link) {
    return std::find(group.links.begin(), group.links.end(), link) - group.links.begin();
  };
  const auto isPlanet = [&](LinkOrdinal link) {
    return positionOf(link) < static_cast<std::ptrdiff_t>(group.links.size());
  };
  const auto wheelAt = [&](int end) { return wheelOfEnd[static_cast<std::size_t>(end)]; };
  int centralClass = -1;
  for (const MeshOrdinal mesh : group.meshes) {
    const MeshGeometry& geometry = *placement.meshes[mesh];
    if (centralClass < 0 && !isPlanet(geometry.tail)) centralClass = geometry.tailClass;
    if (centralClass < 0 && !isPlanet(geometry.head)) centralClass = geometry.headClass;
  }
  m_links.resize(group.links.size());
  for (const MeshOrdinal mesh : group.meshes) {
    const MeshGeometry& geometry = *placement.meshes[mesh];
    const GearMesh& drawn = mechanism.gearMeshes[mesh];
    if (!touches(geometry.kind) || hasSkewAxes(geometry.kind)) continue;
    const bool isInternal = hasRing(geometry.kind);
    const bool isTailRing = isInternal && drawn.tailTeeth > drawn.headTeeth;
    const bool isHeadRing = isInternal && !isTailRing;
    const int tail = wheelAt(2 * mesh), head = wheelAt(2 * mesh + 1);
    const Distance distance{tail, head, isHeadRing ? -1 : 1, isTailRing ? -1 : 1};
    const bool isBevel = hasIntersectingAxes(geometry.kind);
    if (isPlanet(geometry.tail) && isPlanet(geometry.head) && !isBevel) {
      m_inMesh.push_back({static_cast<std::size_t>(positionOf(geometry.tail)),
                          static_cast<std::size_t>(positionOf(geometry.head)), tail, head});
    }
    for (const bool isTail : {true, false}) {
      const LinkOrdinal link = isTail ? geometry.tail : geometry.head;
      if (!isPlanet(link)) continue;
      PlanetLink& own = m_links[static_cast<std::size_t>(positionOf(link))];
      const bool isRing = isTail ? isTailRing : isHeadRing;
      if (!isBevel && !isRing) own.external.push_back(isTail ? tail : head);
      if (!isBevel && !isRing && !isPlanet(isTail ? geometry.head : geometry.tail))
        own.distances.push_back(distance);
    }
  }
  // Chains from each gear of a planet to wheels on the carrier's axis.
  for (std::size_t l = 0; l < m_links.size(); ++l) {
    std::set<int> firsts;
    for (const MeshOrdinal mesh : group.meshes) {
      if (placement.meshes[mesh]->tail == group.links[l]) firsts.insert(wheelAt(2 * mesh));
      if (placement.meshes[mesh]->head == group.links[l]) firsts.insert(wheelAt(2 * mesh + 1));
    }
    for (const int first : firsts) {
      std::vector<ChainGear> chain{{group.links[l], first, 1}};
      std::set<std::pair<int, int>> seen{{group.links[l], first}};
      for (std::size_t at = 0; at < chain.size(); ++at) {
        const ChainGear from = chain[at];
        for (const MeshOrdinal mesh : group.meshes) {
          const MeshGeometry& geometry = *placement.meshes[mesh];
          for (const bool isTail : {true, false}) {
            const LinkOrdinal own = isTail ? geometry.tail : geometry.head;
            const LinkOrdinal other = isTail ? geometry.head : geometry.tail;
            if (own != from.link || wheelAt(2 * mesh + (isTail ? 0 : 1)) != from.wheel) continue;
            const ChainGear next{other, wheelAt(2 * mesh + (isTail ? 1 : 0)), from.sense * geometry.sign};
            const int otherClass = isTail ? geometry.headClass : geometry.tailClass;
            if (isPlanet(other)) {
              if (seen.insert({next.link, next.wheel}).second) chain.push_back(next);
            } else if (otherClass == centralClass) {
              m_links[l].gears.push_back({first, next.wheel, next.sense});
            }
          }
        }
      }
    }
  }
}

int CheckedPlanets::distanceOf(const PlanetLink& link, std::span<const int> teeth) {
  int least = 0;
  for (const Distance& distance : link.distances) {
    const int here = distance.tailFactor * countAt(teeth, distance.tail) +
                     distance.headFactor * countAt(teeth, distance.head);
    least = least == 0 ? here : std::min(least, here);
  }
  return least;
}

int CheckedPlanets::largestOf(const PlanetLink& link, std::span<const int> teeth) {
  int largest = -2;
  for (const int wheel : link.external) largest = std::max(largest, countAt(teeth, wheel));
  return largest + 2;
}

bool CheckedPlanets::clears(std::span<const int> teeth, int planets) const {
  const auto neighboursClear = [&](const PlanetLink& link) {
    const std::int64_t d = distanceOf(link, teeth), tip = largestOf(link, teeth);
    if (planets < 2 || d == 0) return true;
    if (planets == 2) return d > tip;
    if (planets == 3) return 3 * d * d > 4 * tip * tip;
    if (planets == 4) return d * d > 2 * tip * tip;
    if (planets == 6) return d > 2 * tip;
    return static_cast<double>(d) * std::sin(std::numbers::pi / planets) > static_cast<double>(tip);
  };
  if (!std::all_of(m_links.begin(), m_links.end(), neighboursClear)) return false;
  for (const InMesh& pair : m_inMesh) {
    const double a = distanceOf(m_links[pair.one], teeth), b = distanceOf(m_links[pair.other], teeth);
    if (a == 0 || b == 0) continue;
    const double c = countAt(teeth, pair.oneWheel) + countAt(teeth, pair.otherWheel);
    if (!(c < a + b && a < b + c && b < a + c)) return false;
    if (planets < 2) continue;
    const double angle = std::acos((a * a + b * b - c * c) / (2 * a * b));
    const double rest = 2 * std::numbers::pi / planets - angle;
    const double x = a - b * std::cos(rest), y = b * std::sin(rest);
    constexpr double kTouch = 1e-9;
    const int tips = largestOf(m_links[pair.one], teeth) + largestOf(m_links[pair.other], teeth);
    if (std::hypot(x, y) <= tips + kTouch) return false;
  }
  return true;
}

bool CheckedPlanets::assembles(std::span<const int> teeth, int planets) const {
  for (const PlanetLink& link : m_links) {
    if (link.gears.empty()) continue;
    const Gear& first = link.gears.front();
    const std::int64_t own = countAt(teeth, first.wheel);
    bool fits = false;
    for (std::int64_t pitch = 0; pitch < own && !fits; ++pitch) {
      // The planet turns by (sense C / n + pitch) / own; every gear has to pass sense C / n and whole
      // pitches.
      const std::int64_t turn = first.sense * std::int64_t{countAt(teeth, first.central)} + pitch * planets;
      fits = std::all_of(link.gears.begin(), link.gears.end(), [&](const Gear& gear) {
        const std::int64_t rest =
            countAt(teeth, gear.wheel) * turn - gear.sense * std::int64_t{countAt(teeth, gear.central)} * own;
        return rest % (planets * own) == 0;
      });
    }
    if (!fits) return false;
  }
  return true;
}

}  // namespace geargraph
