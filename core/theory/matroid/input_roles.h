#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/theory/matroid/exact_solution.h"
#include "core/theory/matroid/input_choice.h"
#include "core/theory/matroid/live_solution.h"

namespace geargraph {

/// The outputs whose rates depend on the input, by label: K(y, x) is not 0. Each of them may also be driven
/// in its place while the other inputs stay. Zeros of the live solution are exact.
/// @pre the solution has its matrix; `input` is one of its inputs
[[nodiscard]] std::vector<int> commandedBy(const LiveSolution& solution, int input);

/// The inputs that an output depends on, in column order: those whose place it may take.
/// @pre as above; `output` is one of its outputs
[[nodiscard]] std::vector<int> commandersOf(const LiveSolution& solution, int output);

/// Joints that turn together in every motion, at a fixed ratio: rows of K that are proportional, inputs among
/// them, in groups of two at least, by label. Joints that never turn are in none. Exact.
/// @pre the solution has its matrix
[[nodiscard]] std::vector<std::vector<int>> tiedJoints(const ExactSolution& solution);

/// Completes joints to valid sets of inputs, with the structure of the train found once for all sets.
class InputCompletion {
 public:
  /// Keeps a reference to the model. Cost: structureOf().
  explicit InputCompletion(const KinematicModel& model);

  /// A valid set of inputs with all of `wanted` in it, in that order, completed from `present`. With the
  /// joints of an end-effector as `wanted`, the solution gives the motor speeds for a given motion of the
  /// end-effector. std::nullopt if the wanted joints are not independent. Cost: chooseInputs().
  [[nodiscard]] std::optional<std::vector<int>> with(std::span<const int> wanted,
                                                     std::span<const int> present) const;

 private:
  const KinematicModel& m_model;
  ModularDoubleField m_field;
  Structure m_structure;
};

/// The joints from the ground to a link, the first at the ground.
[[nodiscard]] std::vector<int> chainTo(const SpanningTree& tree, LinkOrdinal link);

}  // namespace geargraph
