#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/teaching/exercises/exercise_random.h"
#include "core/teaching/exercises/exercise_source.h"
#include "core/teaching/grading/question.h"

namespace geargraph {

/// The kinds of questions about a mechanism, in the order of the paper.
enum class ExerciseKind : std::uint8_t {
  incidence,
  orientation,
  reducedIncidence,
  path,
  treeMatrix,
  cycle,
  cycleSense,
  cycleBasis,
  anyCycles,
  spanningTree,
  wrongEntry,
  coefficients,
  freedom,
  redundantMesh,
  inputs,
  speed,
  levels,
  terminalEquation,
  fundamentalCircuit,
  cutset,
  portTorque,
  teeth,
  ringTeeth,
  engagement,
  brakeTorque,
  selfLocking,
  brakeReaction,  // the last: kExerciseKindCount
};
constexpr std::size_t kExerciseKindCount = static_cast<std::size_t>(ExerciseKind::brakeReaction) + 1;

/// The drawing shown during a step of a lesson, or beside a question.
enum class LessonView : std::uint8_t { digraph, ttGraph, schematic };

[[nodiscard]] const std::vector<ExerciseKind>& allExerciseKinds();
[[nodiscard]] std::string_view kindName(ExerciseKind kind);  ///< "cycle-basis": stable, for the command line
[[nodiscard]] std::string kindTitle(ExerciseKind kind);      ///< "Fill in a row of C"
[[nodiscard]] std::optional<ExerciseKind> kindFromName(std::string_view name);
/// A hint where to look and which rule to use, in plain text. It is the same for every mechanism, so it
/// cannot reveal the answer.
[[nodiscard]] std::string kindHint(ExerciseKind kind);
/// The drawing that shows what the question asks about.
[[nodiscard]] LessonView kindView(ExerciseKind kind);

/// Why there is no question of this kind for the mechanism: "no brakes or clutches". std::nullopt if there is
/// one.
[[nodiscard]] std::optional<std::string> reasonAgainst(const ExerciseSource& source, ExerciseKind kind);

/// Generates a question of this kind; the random numbers choose the mesh, the cells, the numbers. The same
/// random numbers give the same question. @pre !reasonAgainst(source, kind)
[[nodiscard]] Question makeQuestion(const ExerciseSource& source, ExerciseKind kind, ExerciseRandom& random);

}  // namespace geargraph
