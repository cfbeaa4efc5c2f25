#pragma once

#include "core/teaching/exercises/exercise_kinds.h"

namespace geargraph {

// What several questions, or the entries of their kinds, ask of a mechanism.

/// An external mesh and an internal one that share a planet, its axis and their carrier.
struct PlanetPair {
  MeshOrdinal sunMesh = 0;
  MeshOrdinal ringMesh = 0;
  int planet = 0, sun = 0, ring = 0;  ///< nodes
  int sunTeeth = 0, planetTeethAtSun = 0, planetTeethAtRing = 0;
};
[[nodiscard]] std::vector<PlanetPair> planetPairs(const ExerciseSource& source);

/// Matrices small enough for searching a wrong entry.
[[nodiscard]] std::vector<MatrixKind> searchableMatrices(const ExerciseSource& source);

/// Joints whose rate follows from the inputs and is not 0.
[[nodiscard]] std::vector<int> predictableJoints(const ExerciseSource& source);

/// States with a ratio that engage at least one coupling.
[[nodiscard]] std::vector<int> statesWithRatio(const ExerciseSource& source);

/// Does a state engage couplings of different torques, or a coupling carry different torques in some states?
[[nodiscard]] bool hasBrakeComparison(const ExerciseSource& source);

/// Does a state engage a brake that carries a torque about the axis of the drive?
[[nodiscard]] bool hasBrakeReaction(const ExerciseSource& source);

/// By mesh: 1 if its row is a linear combination of others, so that it may be left out.
[[nodiscard]] std::vector<char> dispensableMeshes(const ExerciseSource& source);

}  // namespace geargraph
