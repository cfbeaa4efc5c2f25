#pragma once

#include <array>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "core/machine/train/wheel_envelopes.h"

namespace geargraph {

/// Decides which meshes of a link on parallel axes share a wheel where the document leaves that open: equal
/// wheels of a link become one only if nothing in their common plane interferes. The suns of compound
/// planetary gear sets stay two wheels, a planet that meshes with sun and ring is one.
class WheelSharing {
 public:
  WheelSharing(const Mechanism& mechanism, const Placement& placement);

  struct Choice {
    std::optional<GearOrdinal> tail;  ///< an existing wheel; none: a new one
    std::optional<GearOrdinal> head;
  };
  /// The existing wheels that a mesh uses instead of new ones: the first of the equal ones (`tails`, `heads`)
  /// with which nothing in their plane interferes. Cost: O(wheels of both planes) squared, for planes with
  /// few wheels.
  [[nodiscard]] Choice choose(const TrainWheel& tail, std::span<const GearOrdinal> tails,
                              const TrainWheel& head, std::span<const GearOrdinal> heads) const;
  /// Records that a mesh has these wheels of the train, by position; their planes become one.
  void join(GearOrdinal tail, const TrainWheel& tailWheel, GearOrdinal head, const TrainWheel& headWheel);

 private:
  using PlaneOrdinal = Ordinal<struct PlaneTag>;

  /// A wheel as a disc or ring in its plane.
  struct WheelDisc {
    LinkOrdinal link = 0;
    int teeth = 0;
    AxisGroupOrdinal axisGroup = 0;
    double inner = 0, outer = 0;
    Eigen::Vector3d axis;
  };

  [[nodiscard]] static WheelDisc roundOf(const TrainWheel& wheel);
  [[nodiscard]] bool pass(const WheelDisc& a, const WheelDisc& b) const;
  [[nodiscard]] bool passWith(std::optional<GearOrdinal> tail, const TrainWheel& tailWheel,
                              std::optional<GearOrdinal> head, const TrainWheel& headWheel) const;
  [[nodiscard]] std::span<const GearOrdinal> planeOf(std::optional<GearOrdinal> wheel) const;
  PlaneOrdinal take(GearOrdinal wheel, const TrainWheel& as);

  std::set<std::array<int, 4>> m_meshing;  ///< link and teeth of one wheel, then of the other
  ByClass<WheelOrbit> m_orbits;
  ByGear<std::optional<WheelDisc>> m_rounds;  ///< none: not placed in a plane yet
  ByGear<PlaneOrdinal> m_planes;
  OrdinalVector<struct PlaneTag, std::vector<GearOrdinal>> m_wheels;  ///< by plane
};

}  // namespace geargraph
