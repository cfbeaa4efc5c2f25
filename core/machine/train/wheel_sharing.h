#pragma once

#include <array>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "core/machine/train/wheel_envelopes.h"

namespace geargraph::inline train {

/// Decides which meshes of a link on parallel axes share a wheel where the document leaves that open: equal
/// wheels of a link become one only if nothing in their common plane interferes. The suns of compound
/// planetary gear sets stay two wheels, a planet that meshes with sun and ring is one.
class WheelSharing {
 public:
  WheelSharing(const Mechanism& mechanism, const Placement& placement);

  struct Choice {
    std::optional<int> tail;  ///< an existing wheel; none: a new one
    std::optional<int> head;
  };
  /// The existing wheels that a mesh uses instead of new ones: the first of the equal ones (`tails`, `heads`)
  /// with which nothing in their plane interferes. Cost: O(wheels of both planes) squared, for planes with
  /// few wheels.
  [[nodiscard]] Choice choose(const TrainWheel& tail, std::span<const int> tails, const TrainWheel& head,
                              std::span<const int> heads) const;
  /// Records that a mesh has these wheels of the train, by position; their planes become one.
  void join(int tail, const TrainWheel& tailWheel, int head, const TrainWheel& headWheel);

 private:
  /// A wheel as a disc or ring in its plane.
  struct Round {
    int link = 0;
    int teeth = 0;
    int axisClass = 0;
    double inner = 0, outer = 0;
    Eigen::Vector3d axis;
  };

  [[nodiscard]] static Round roundOf(const TrainWheel& wheel);
  [[nodiscard]] bool pass(const Round& a, const Round& b) const;
  [[nodiscard]] bool passWith(std::optional<int> tail, const TrainWheel& tailWheel, std::optional<int> head,
                              const TrainWheel& headWheel) const;
  [[nodiscard]] std::span<const int> planeOf(std::optional<int> wheel) const;
  int take(int wheel, const TrainWheel& as);

  std::set<std::array<int, 4>> m_meshing;      ///< link and teeth of one wheel, then of the other
  std::vector<WheelOrbit> m_orbits;            ///< by axis class
  std::vector<std::optional<Round>> m_rounds;  ///< by wheel; none: not placed in a plane yet
  std::vector<int> m_planes;                   ///< by wheel
  std::vector<std::vector<int>> m_wheels;      ///< by plane
};

}  // namespace geargraph::inline train
