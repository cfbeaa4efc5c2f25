#pragma once

#include <span>
#include <vector>

#include "core/machine/solids/gear_solid.h"
#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"
#include "core/presentation/meshfile/assembly.h"
#include "core/presentation/meshfile/link_scene.h"

namespace geargraph {

/// A mechanism with a spanning tree and placed axes, with its forward kinematics. The arguments outlive it.
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

/// The estimated number of triangles of the gears' solids, within a factor of 3, without bodies: to check a
/// limit before they are made.
[[nodiscard]] double expectedTriangles(const GearTrain& train, double tolerance);

/// Speeds of inputs, rad/s, all different and in no simple ratio, so that a mesh is unlikely to be at rest by
/// coincidence.
[[nodiscard]] std::vector<Rational> genericSpeeds(std::size_t count);

/// The tooth pitches that each mesh of the train passes per unit of time, for uniform rates of the joints
/// (rad per unit of time, by joint): teeth of the tail's gear times its turns against the carrier. Exactly 0
/// for a mesh at rest relative to its carrier. Cost: the walks from gears to carriers.
[[nodiscard]] std::vector<double> pitchRates(const PlacedTrain& placed, std::span<const Rational> rates);

/// The assembly export of a train: all gears, plain below their teeth so that bore and width describe them,
/// and `frames` poses in uniform motion (frameTimes()). Of several motions, each the rates of all joints, the
/// first one that moves the most meshes is used. Fails if a gear cannot be made.
/// @pre frames >= kMinFrames, at least one motion
[[nodiscard]] Expected<Assembly> assemblyOf(const PlacedTrain& placed, GearCache& cache, double tolerance,
                                            std::span<const std::vector<Rational>> motions,
                                            std::size_t frames);

}  // namespace geargraph
