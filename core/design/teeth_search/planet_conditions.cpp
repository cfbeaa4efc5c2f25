#include "core/design/teeth_search/planet_conditions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "core/foundations/base/contract.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/mechanism/kinds/pair_kind.h"

namespace geargraph {
namespace {

/// A gear of the train that the walk from a planet's gear has reached.
struct ReachedGear {
  GearOrdinal gear;
  int sense = 1;  ///< pitches that pass it for one of the first
};

const TrainPair* pairOf(const TrainWheels& train, MeshOrdinal mesh) {
  const auto found = std::find_if(train.pairs.begin(), train.pairs.end(),
                                  [mesh](const TrainPair& pair) { return pair.mesh == mesh; });
  return found == train.pairs.end() ? nullptr : &*found;
}

}  // namespace

PlanetCondition::PlanetCondition(const std::vector<PlanetGroup>& set, const Placement& placement,
                                 const TrainWheels& train, std::span<const int> wheelAt)
    : m_drawn(static_cast<int>(set.size())) {
  const PlanetGroup& group = set.front();
  m_members.resize(group.links.size());
  const auto memberOf = [&](LinkOrdinal link) -> std::optional<std::size_t> {
    const auto found = std::find(group.links.begin(), group.links.end(), link);
    if (found == group.links.end()) return std::nullopt;
    return static_cast<std::size_t>(found - group.links.begin());
  };
  const auto wheel = [&](GearOrdinal gear) { return wheelAt[static_cast<std::size_t>(int{gear})]; };
  for (const MeshOrdinal mesh : group.meshes) {
    const TrainPair* const pair = pairOf(train, mesh);
    if (pair == nullptr || !touches(pair->kind) || hasSkewAxes(pair->kind)) continue;
    const auto tail = memberOf(train.wheels[pair->tail].link);
    const auto head = memberOf(train.wheels[pair->head].link);
    for (const GearOrdinal gear : {pair->tail, pair->head}) m_wheels.push_back(wheel(gear));
    if (hasIntersectingAxes(pair->kind)) continue;
    if (tail && head) {
      m_sides.push_back({*tail, *head, wheel(pair->tail), wheel(pair->head)});
    } else {
      const GearOrdinal own = tail ? pair->tail : pair->head;
      const GearOrdinal central = tail ? pair->head : pair->tail;
      const bool isRingOutside = isRing(train.wheels[central].spec);
      Member& member = m_members[tail ? *tail : *head];
      const int sign = isBesideEachOther(pair->kind) ? 1 : -1;
      if (isRingOutside || sign > 0) member.sums.push_back({wheel(central), wheel(own), sign});
    }
    for (const auto& [at, gear] : {std::pair(tail, pair->tail), std::pair(head, pair->head)}) {
      if (at && !isRing(train.wheels[gear].spec) && !isConical(train.wheels[gear].spec))
        m_members[*at].tips.push_back(wheel(gear));
    }
  }
  std::sort(m_wheels.begin(), m_wheels.end());
  m_wheels.erase(std::unique(m_wheels.begin(), m_wheels.end()), m_wheels.end());
  addTies(group, placement, train, wheelAt);
}

/// Turning carrier and planet by an angle is turning the central gears backwards under a planet that stays.
void PlanetCondition::addTies(const PlanetGroup& group, const Placement& placement, const TrainWheels& train,
                              std::span<const int> wheelAt) {
  std::optional<AxisGroupOrdinal> centre;
  const auto isOwn = [&](GearOrdinal gear) {
    return std::find(group.links.begin(), group.links.end(), train.wheels[gear].link) != group.links.end();
  };
  for (const MeshOrdinal mesh : group.meshes) {
    const TrainPair* const pair = pairOf(train, mesh);
    if (pair == nullptr) return;
    for (const GearOrdinal gear : {pair->tail, pair->head})
      if (!centre && !isOwn(gear)) centre = train.wheels[gear].axisGroup;
  }
  if (!centre) return;
  for (std::size_t m = 0; m < m_members.size(); ++m) {
    std::vector<GearOrdinal> gears;
    for (const MeshOrdinal mesh : group.meshes) {
      for (const GearOrdinal gear : {pairOf(train, mesh)->tail, pairOf(train, mesh)->head}) {
        if (train.wheels[gear].link == group.links[m] &&
            std::find(gears.begin(), gears.end(), gear) == gears.end())
          gears.push_back(gear);
      }
    }
    for (const GearOrdinal first : gears) {
      std::vector<ReachedGear> queue{{first, 1}};
      for (std::size_t q = 0; q < queue.size(); ++q) {
        const ReachedGear from = queue[q];
        for (const MeshOrdinal mesh : group.meshes) {
          const TrainPair& pair = *pairOf(train, mesh);
          if (pair.tail != from.gear && pair.head != from.gear) continue;
          const GearOrdinal other = pair.tail == from.gear ? pair.head : pair.tail;
          const int sense = from.sense * placement.meshes[mesh]->sign;
          const auto isOther = [other](const ReachedGear& each) { return each.gear == other; };
          if (isOwn(other)) {
            if (std::none_of(queue.begin(), queue.end(), isOther)) queue.push_back({other, sense});
          } else if (train.wheels[other].axisGroup == *centre) {
            const Tie tie{wheelAt[static_cast<std::size_t>(int{first})],
                          wheelAt[static_cast<std::size_t>(int{other})], sense};
            std::vector<Tie>& ties = m_members[m].ties;
            if (std::find(ties.begin(), ties.end(), tie) == ties.end()) ties.push_back(tie);
          }
        }
      }
    }
  }
}

std::int64_t PlanetCondition::places(std::span<const int> teeth) const {
  const auto at = [&](int wheel) { return std::int64_t{teeth[static_cast<std::size_t>(wheel)]}; };
  std::int64_t common = 0;
  for (const Member& member : m_members) {
    for (std::size_t i = 0; i < member.ties.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Tie& one = member.ties[i];
        const Tie& other = member.ties[k];
        const std::int64_t shared = std::gcd(at(one.own), at(other.own));
        const std::int64_t steps = one.sense * at(one.central) * (at(other.own) / shared) -
                                   other.sense * at(other.central) * (at(one.own) / shared);
        common = std::gcd(common, steps);
      }
    }
  }
  return common;
}

int PlanetCondition::centreOf(const Member& member, std::span<const int> teeth) {
  int least = 0;
  for (const CentreSum& sum : member.sums) {
    const int here = sum.at(teeth);
    if (least == 0 || here < least) least = here;
  }
  return least;
}

int PlanetCondition::tipOf(const Member& member, std::span<const int> teeth) {
  int largest = 0;
  for (const int wheel : member.tips) largest = std::max(largest, teeth[static_cast<std::size_t>(wheel)] + 2);
  return largest;
}

bool PlanetCondition::clears(std::span<const int> teeth, int planets) const {
  for (const Member& member : m_members) {
    const int centre = centreOf(member, teeth);
    if (planets > 1 && centre != 0 && !arcClears(centre, planets, tipOf(member, teeth))) return false;
  }
  return std::all_of(m_sides.begin(), m_sides.end(),
                     [&](const Side& side) { return pairClears(side, teeth, planets); });
}

/// The three axes are the corners of a triangle, and a planet clears the other kind of the next pair.
bool PlanetCondition::pairClears(const Side& side, std::span<const int> teeth, int planets) const {
  const int one = centreOf(m_members[side.one], teeth);
  const int other = centreOf(m_members[side.other], teeth);
  if (one == 0 || other == 0) return true;  // no wheel on the carrier's axis
  const int apart =
      teeth[static_cast<std::size_t>(side.oneWheel)] + teeth[static_cast<std::size_t>(side.otherWheel)];
  if (apart <= std::abs(one - other) || apart >= one + other) return false;
  if (planets < 2) return true;
  const long double a = one, b = other, d = apart;
  const long double between = std::acos((a * a + b * b - d * d) / (2 * a * b));
  const long double next = 2 * std::numbers::pi_v<long double> / planets - between;
  const long double distance = std::sqrt(a * a + b * b - 2 * a * b * std::cos(next));
  // Both are doubled: 2 a / module. What touches does not clear.
  constexpr long double kTouches = 1e-9L;
  return distance > tipOf(m_members[side.one], teeth) + tipOf(m_members[side.other], teeth) + kTouches;
}

bool arcClears(int centre, int planets, int tip) {
  GEARGRAPH_REQUIRE(planets >= 1 && planets <= kMaxPlanetsCompared);
  if (planets == 1) return true;
  if (planets == 2) return centre > tip;
  if (planets == 6) return centre > 2 * tip;
  // Irrational, so never equal; the sine is right to 1e-19, the product to far less than the guard.
  static const std::vector<long double> sines = [] {
    std::vector<long double> values(kMaxPlanetsCompared + 1);
    for (int n = 1; n <= kMaxPlanetsCompared; ++n)
      values[static_cast<std::size_t>(n)] = std::sin(std::numbers::pi_v<long double> / n);
    return values;
  }();
  constexpr long double kGuard = 1e-13L;
  const long double room = centre * sines[static_cast<std::size_t>(planets)] - tip;
  GEARGRAPH_REQUIRE(std::abs(room) > kGuard);
  return room > 0;
}

}  // namespace geargraph
