#pragma once

#include <span>
#include <vector>

#include "core/machine/solids/gear_solid.h"
#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"
#include "core/presentation/meshfile/assembly.h"
#include "core/presentation/meshfile/link_scene.h"

namespace geargraph::inline meshfile {

/// A mechanism that is a tree and has a place for each axis, ready to be moved. What it refers to must
/// outlive it.
struct PlacedTrain {
  const Mechanism& mechanism;
  const SpanningTree& tree;
  const Placement& placement;
  const GearTrain& train;
  ForwardKinematics kinematics;

  /// @pre the placement has a tree
  PlacedTrain(const Mechanism& mechanism, const SpanningTree& tree, const Placement& placement,
              const GearTrain& train);
};

/// About how many triangles the solids of the gears will have, within a factor of 3 (bodies not counted): so
/// that a limit can be kept before they are made.
[[nodiscard]] double expectedTriangles(const GearTrain& train, double tolerance);

/// Speeds of inputs, rad/s, all different and in no simple ratio, so that hardly any mesh stands still by
/// chance.
[[nodiscard]] std::vector<Rational> restlessSpeeds(std::size_t count);

/// Tooth pitches that each mesh of the train passes while time runs by 1, for uniform rates of the joints
/// (rad per unit of time, by joint): teeth of the tail's gear times its turns against the carrier. Exactly 0
/// where the mesh stands still in its carrier. Cost: the walks from gears to carriers.
[[nodiscard]] std::vector<double> pitchRates(const PlacedTrain& placed, std::span<const Rational> rates);

/// The assembly export of a train: all gears, plain below their teeth so that bore and width describe them,
/// and `frames` poses in uniform motion (frameTimes()). Of several motions, each the rates of all joints, the
/// first is taken that moves most meshes. Gears that cannot be made fail it.
/// @pre frames >= kFewestFrames, a motion at least
[[nodiscard]] Expected<Assembly> assemblyOf(const PlacedTrain& placed, GearCache& cache, double tolerance,
                                            std::span<const std::vector<Rational>> motions,
                                            std::size_t frames);

}  // namespace geargraph::inline meshfile
