#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/teaching/exercises/exercise_source.h"
#include "core/theory/statics/losses.h"

namespace geargraph::inline exercises {

/// The torques of a state whose drive has the torque 1 N m and whose driven link bears the load, without
/// losses.
struct StateTorques {
  int state = 0;  ///< position in the document
  Rational ratio;
  std::vector<std::optional<Rational>> couplings;  ///< N m by coupling; none where it is released
  Rational driven;                                 ///< N m, what holds the driven link
};

/// None where the state has no ratio or engages nothing, its torques are shared in unknown parts, or one of
/// them is not a fraction or has several directions. Cost: one exact elimination.
[[nodiscard]] std::optional<StateTorques> stateTorques(const ExerciseSource& source, int state);

/// A train in a steady motion with one link or joint that drives and one that is driven, and nothing else
/// that passes power: a state of a gearbox, or an input with the other inputs held.
struct DrivenTrain {
  int state = -1;            ///< position in the document; -1: no state
  int drive = -1;            ///< a node with a state, else a joint
  int driven = -1;           ///< likewise
  Motion motion;             ///< by joint, the drive turns forward
  StaticsProblem problem;    ///< 1 N m at the drive, balances at the driven part and at what is held
  std::vector<int> rolling;  ///< meshes whose gears turn against their carrier
};

/// Trains of at most kMostRollingMeshes rolling meshes, whose torques are determined, and which pass power
/// through a mesh from the drive to the driven part with an efficiency of 99/100 in each.
/// Cost: a few exact eliminations for each state, or for each pair of an input and a joint on the ground.
[[nodiscard]] std::vector<DrivenTrain> drivenTrains(const ExerciseSource& source);
constexpr int kMostRollingMeshes = 6;

/// What a train passes in both directions, in fractions.
struct TrainEfficiency {
  std::optional<Rational> forward;   ///< none where it locks itself
  std::optional<Rational> backward;  ///< likewise; the driven part drives
  Rational latent;                   ///< power that the meshes pass without losses for each watt that is fed
  std::vector<int> passing;          ///< rolling meshes that pass power
  std::vector<MeshLoss> drivers;     ///< by mesh, driven backwards; empty where it locks itself
};

/// With this efficiency in each mesh. None where the torques are shared in unknown parts, are no fractions,
/// or no mesh passes power. Cost: some exact eliminations; where it locks itself, 2^kMostRollingMeshes of
/// them.
[[nodiscard]] std::optional<TrainEfficiency> efficiencyOf(const ExerciseSource& source,
                                                          const DrivenTrain& train,
                                                          const Rational& meshEfficiency);

}  // namespace geargraph::inline exercises
