#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/theory/levers/lever_plan.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// What is drawn of the levers of a train, as its document engages the couplings.
struct LeverPicture {
  LeverPlan plan;                ///< of the meshes: nothing engaged
  std::vector<Rational> speeds;  ///< by position in plan.links, rad/s; empty without a motion
  std::vector<ShiftElementOrdinal> engaged;
  std::vector<LinkOrdinal> inputs;    ///< links of the main axis that inputs drive against the ground
  std::optional<LinkOrdinal> output;  ///< `driven` of the state that engages the same couplings
  /// By lever and point: the torque of the point's links on the lever, N m, those of a lever add up to 0.
  /// Empty without loads; an inner one is empty where self-stresses leave it open.
  std::vector<std::vector<Rational>> torques;
};

/// `inputs`: driven joints; `rates`: of all joints, in fractions, or empty.
/// @pre all of one mechanism; the plan is leverPlanOf() without held rows
[[nodiscard]] LeverPicture leverPicture(const Mechanism& mechanism, const Placement& placement,
                                        LeverPlan plan, std::span<const int> inputs,
                                        std::span<const Rational> rates);

/// LeverPicture::torques: of all meshes of a lever together, from the torques per tooth: the rows of the
/// kinematics transposed. Exact where the solution is. Cost: meshes times self-stresses.
/// @pre all of one mechanism; report.isAnswered()
[[nodiscard]] std::vector<std::vector<Rational>> leverTorques(const LeverPlan& plan,
                                                              const KinematicModel& model,
                                                              const StaticsReport& report);

}  // namespace geargraph
