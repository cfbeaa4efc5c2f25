#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/machine/body_layout/axis_layout.h"
#include "core/machine/body_layout/body_parts.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// The place of a bearing in the coaxial plan of its axis.
struct CoaxialBearing {
  JointOrdinal joint = 0;
  double at = 0;
  BearingForm form = BearingForm::boss;
};

/// How the links of one axis connect their wheels and carry their planets without collision: sleeves inside
/// the wheels, discs between them, drums around them.
struct CoaxialPlan {
  std::vector<ShaftSegment> shafts;  ///< with their radii
  std::vector<ArmPlan> arms;
  std::vector<PinPlan> pins;
  std::vector<RevolvedPlan> revolvedBodies;
  std::vector<WallPlan> walls;
  std::vector<CagePlan> cages;
  std::vector<CoaxialBearing> bearings;
  std::vector<std::pair<std::size_t, double>> hubs;  ///< gears whose hub has to reach a disc, its diameter
  double width = 0;                                  ///< of arms
};

/// Does the axis need a coaxial plan: with two ring gears or more, links that turn on the ground, and planets
/// of theirs on parallel axes?
[[nodiscard]] bool needsCoaxialPlan(AxisGroupOrdinal axisGroup, const Placement& placement,
                                    const GearTrain& train);

/// The plan; std::nullopt if no routing is found, or `stop` was requested meanwhile. Cost: some milliseconds;
/// see profile_router.h.
[[nodiscard]] std::optional<CoaxialPlan> coaxialPlan(AxisGroupOrdinal axisGroup,
                                                     SpanByClass<const AxisLayout> axes,
                                                     const Placement& placement, const GearTrain& train,
                                                     const std::stop_token& stop = {});

}  // namespace geargraph
