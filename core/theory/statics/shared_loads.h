#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/theory/statics/losses.h"

namespace geargraph {

/// The least and the greatest value of a torque.
struct SharedRange {
  Real least;
  Real most;
};

/// By unknown: does its value depend on how the members of self-stresses share their loads? Without losses
/// these are the members. With losses also every torque on the way of the power that they lose: what a null
/// vector reaches when the meshes of self-stresses lose different parts. `losses` by mesh, or empty.
/// std::nullopt if `stop` was requested. Cost: with losses one exact elimination.
/// @pre lossless.isBalanced(); `loads` are those of the solution
[[nodiscard]] std::optional<std::vector<char>> dependsOnShares(const KinematicModel& model,
                                                               const StaticsSolution& lossless,
                                                               const RadicalColumns& loads,
                                                               std::span<const MeshLoss> losses,
                                                               const std::stop_token& stop = {});

/// By held part: the range of its torque over all distributions of the load in which every mesh drives as it
/// does in `solution`, so that no mesh of a self-stress works against the others (preload may lose any
/// amount). std::nullopt where it is not bounded, or finding it takes more work than a live view has time
/// for. Cost: two linear programs for each part that a self-stress reaches.
/// @pre solution.outcome is solved, and its shares are decided
[[nodiscard]] std::vector<std::optional<SharedRange>> sharedRanges(const KinematicModel& model,
                                                                   const LossySolution& solution);

}  // namespace geargraph
