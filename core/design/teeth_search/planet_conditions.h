#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/machine/train/train_wheels.h"
#include "core/mechanism/placement/planet_groups.h"

namespace geargraph {

/// A centre distance in teeth, twice the distance over the module: a sum, or a difference for a ring.
struct CentreSum {
  int wheel = 0;
  int other = 0;
  int sign = 1;  ///< teeth of `wheel` + sign * teeth of `other`

  [[nodiscard]] int at(std::span<const int> teeth) const {
    return teeth[static_cast<std::size_t>(wheel)] + sign * teeth[static_cast<std::size_t>(other)];
  }
  friend bool operator==(const CentreSum&, const CentreSum&) = default;
};

/// What the teeth of a planet and of the wheels round its carrier's axis have to be so that n equal planets
/// go in at equal distances and clear each other. Of one planet, or of planets that mesh with each other.
///
/// Assembly  a planet's place may be turned by 1/n turn only together with the planet: each gear of its link
///           is tied by meshes to a central wheel, C teeth pass it, and for two such gears of p and q teeth
///           lcm(p, q) |s C/p - t D/q| is a multiple of n (core/machine/train/planet_assembly.cpp).
/// Clearance centre sum * sin(pi/n) > teeth of the largest gear + 2, with addenda of a module.
class PlanetCondition {
 public:
  /// `wheelAt`: the searched wheel by gear of the train.
  PlanetCondition(const std::vector<PlanetGroup>& set, const Placement& placement, const TrainWheels& train,
                  std::span<const int> wheelAt);

  /// Planets that are drawn.
  [[nodiscard]] int drawn() const { return m_drawn; }
  /// The wheels that the conditions depend on, ascending.
  [[nodiscard]] const std::vector<int>& wheels() const { return m_wheels; }
  /// Do planets of the set mesh with each other, so that the axes are the corners of a triangle?
  [[nodiscard]] bool hasTriangle() const { return !m_sides.empty(); }

  /// At how many places round the axis an equal planet goes in: n planets go in if n divides it; 0: any n do.
  [[nodiscard]] std::int64_t places(std::span<const int> teeth) const;
  [[nodiscard]] bool assembles(std::span<const int> teeth, int planets) const {
    return places(teeth) % planets == 0;
  }
  /// @pre planets <= kMaxPlanetsCompared
  [[nodiscard]] bool clears(std::span<const int> teeth, int planets) const;

 private:
  /// A gear of a planet's link, and the wheel round the carrier's axis that meshes tie it to.
  struct Tie {
    int own = 0;
    int central = 0;
    int sense = 1;
    friend bool operator==(const Tie&, const Tie&) = default;
  };
  /// The gears of one link of the group.
  struct Member {
    std::vector<CentreSum> sums;  ///< to the carrier's axis
    std::vector<int> tips;        ///< external gears
    std::vector<Tie> ties;
  };
  /// Two links of a group that mesh with each other.
  struct Side {
    std::size_t one = 0, other = 0;  ///< members
    int oneWheel = 0, otherWheel = 0;
  };

  void addTies(const PlanetGroup& group, const Placement& placement, const TrainWheels& train,
               std::span<const int> wheelAt);
  [[nodiscard]] static int centreOf(const Member& member, std::span<const int> teeth);
  [[nodiscard]] static int tipOf(const Member& member, std::span<const int> teeth);
  [[nodiscard]] bool pairClears(const Side& side, std::span<const int> teeth, int planets) const;

  int m_drawn = 1;
  std::vector<Member> m_members;
  std::vector<Side> m_sides;
  std::vector<int> m_wheels;
};

constexpr int kMaxPlanetsCompared = 100;

/// Is centre * sin(pi / planets) > tip? Exact: the sine is rational for 1, 2 and 6 planets only.
[[nodiscard]] bool arcClears(int centre, int planets, int tip);

}  // namespace geargraph
