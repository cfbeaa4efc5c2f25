#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/body_layout/swept_envelope.h"

namespace geargraph {

/// A tube of a differential case: a boss from a pinion's bearing to the ring, or an extension of an arm.
struct CaseTube {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  double inner = 0;
  double outer = 0;
};

/// The case of a bevel differential: a ring of the carrier around its own axis and its pinions, which joins
/// the bosses that hold them; if there is room, also a second ring in the plane of its arms, and bars along
/// the axis between the two.
struct CasePlan {
  LinkOrdinal link = 0;
  AxisGroupOrdinal axisGroup = 0;  ///< the carrier's own
  double inner = 0;
  double outer = 0;
  std::vector<std::pair<double, double>> rings;  ///< one or two: their intervals along the axis
  Eigen::Vector3d towards;  ///< unit vector towards a pinion; the bars are between the pinions
  std::vector<CaseTube> tubes;
};

/// The cases of all carriers on axes of the ground that hold two bevel pinions or more, on axes that
/// intersect their own at right angles in one point. A carrier gets no case if another part would collide
/// with the ring in any pose; the frame of the ground is routed around cases where possible (planFrame()).
/// Deterministic. Cost: O(arms); where there is such a carrier, that of sweptEnvelopes().
[[nodiscard]] std::vector<CasePlan> carrierCases(const Arrangement& plan, const GearTrain& train,
                                                 const Placement& placement);

/// The swept envelope of a case: the case itself, a solid of revolution.
[[nodiscard]] SweptEnvelope envelopeOf(const CasePlan& made, const AxisLayout& axis);

}  // namespace geargraph
