#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "core/machine/arrangement/arrangement.h"
#include "core/machine/arrangement/swept_envelope.h"

namespace geargraph::inline arrangement {

/// A tube of a case from place to place: a boss from a pinion's eye to the ring, or what lengthens an arm.
struct CaseTube {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  double inner = 0;
  double outer = 0;
};

/// The case of a bevel differential: a ring of the carrier's about its own axis and round its pinions, which
/// joins the eyes that hold them; where there is room a second one in the plane of its arms, and bars along
/// the axis from one to the other.
struct CasePlan {
  int link = 0;
  int axisClass = 0;  ///< the carrier's own
  double inner = 0;
  double outer = 0;
  std::vector<std::pair<double, double>> rings;  ///< one or two: from where to where along the axis
  Eigen::Vector3d towards;                       ///< a pinion; the bars stand between
  std::vector<CaseTube> tubes;
};

/// The cases of all carriers on axes of the ground that hold two bevel pinions or more, on axes that meet
/// their own at right angles in one point. None where something else would be in the ring in any pose: the
/// frame of the ground, too, which goes round it where it can (planFrame). Deterministic. Cost: O(arms);
/// where there is such a carrier, that of sweptEnvelopes().
[[nodiscard]] std::vector<CasePlan> carrierCases(const Arrangement& plan, const GearTrain& train,
                                                 const Placement& placement);

/// A case sweeps nothing but itself.
[[nodiscard]] SweptEnvelope envelopeOf(const CasePlan& made, const AxisLayout& axis);

}  // namespace geargraph::inline arrangement
