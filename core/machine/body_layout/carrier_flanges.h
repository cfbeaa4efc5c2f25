#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/solids/part_solids.h"

namespace geargraph {

/// The second flange of a planetary carrier, on the side of the planets opposite to its arms, and the pillars
/// that join the two.
struct FlangePlan {
  LinkOrdinal link = 0;
  AxisGroupOrdinal axisGroup = 0;  ///< the carrier's own
  double arms = 0;                 ///< level of the arms
  double level = 0;                ///< of the second flange
  Boss hub;
  std::vector<Boss> ends;     ///< bosses around the planets' shafts, in the frame of endOf() but at `level`
  std::vector<int> children;  ///< by end
  std::vector<Boss> pillars;  ///< without holes
};

/// The second flanges of carriers on axes of the ground whose planets are on one side of their arms, where
/// the gears leave room for at least two pillars and no other part collides in any pose. Deterministic.
/// Cost: O(arms * gears).
[[nodiscard]] std::vector<FlangePlan> carrierFlanges(const Arrangement& plan, const GearTrain& train,
                                                     const Placement& placement);

/// Extends the shafts of planets through the second flanges.
void reachFlanges(Arrangement& plan, const std::vector<FlangePlan>& flanges);

}  // namespace geargraph
