#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/teaching/exercises/exercise_source.h"
#include "core/theory/statics/losses.h"

namespace geargraph {

/// The torques of a state with 1 N m at its drive and the load at its driven link, without losses.
struct StateTorques {
  int state = 0;  ///< position in the document
  Rational ratio;
  ByCoupling<std::optional<Rational>> couplings;  ///< N m; none if it is released
  Rational driven;                                ///< N m, the torque that holds the driven link
};

/// std::nullopt if the state has no ratio or engages nothing, its torques are indeterminate, or one of them
/// is irrational or has several directions. Cost: one exact elimination.
[[nodiscard]] std::optional<StateTorques> stateTorques(const ExerciseSource& source, int state);

/// A train in a steady motion with one driving and one driven link or joint, and no other external power: a
/// state of a gearbox, or an input with the other inputs held.
struct DrivenTrain {
  int state = -1;            ///< position in the document; -1: no state
  int drive = -1;            ///< a node with a state, else a joint
  int driven = -1;           ///< likewise
  Motion motion;             ///< by joint, the drive turns forward
  StaticsProblem problem;    ///< 1 N m at the drive, balances at the driven part and at what is held
  std::vector<int> rolling;  ///< meshes whose gears turn against their carrier
};

/// The trains with at most kMaxRollingMeshes rolling meshes whose torques are determinate, and which
/// transmit power through a mesh from the drive to the driven part at an efficiency of 99/100 per mesh.
/// Cost: a few exact eliminations for each state, or for each pair of an input and a joint on the ground.
[[nodiscard]] std::vector<DrivenTrain> drivenTrains(const ExerciseSource& source);
constexpr int kMaxRollingMeshes = 6;

/// The efficiencies of a train in both directions, in fractions.
struct TrainEfficiency {
  std::optional<Rational> forward;   ///< none if it is self-locking
  std::optional<Rational> backward;  ///< likewise; the driven part drives
  Rational latent;                   ///< power through the meshes per power fed, without losses
  std::vector<int> passing;          ///< rolling meshes that transmit power
  ByMesh<MeshLoss> drivers;          ///< driven backwards; empty if self-locking
};

/// With this efficiency in each mesh. std::nullopt if the torques are indeterminate or irrational, or no mesh
/// transmits power. Cost: some exact eliminations; if self-locking, 2^kMaxRollingMeshes of them.
[[nodiscard]] std::optional<TrainEfficiency> efficiencyOf(const ExerciseSource& source,
                                                          const DrivenTrain& train,
                                                          const Rational& meshEfficiency);

}  // namespace geargraph
