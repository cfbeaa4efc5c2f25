#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/foundations/base/translation.h"
#include "core/teaching/exercises/exercise_kinds.h"

namespace geargraph {

/// What a mechanism lacks for a question, in a few words: "no meshes". std::nullopt: nothing.
using Lack = std::optional<std::string>;

/// All there is of a kind of question: exercises, lessons, sheets, handouts and the command line read it
/// here. It is written beside its maker, whose QuestionBuilder also gets the mistakes that are explained.
struct ExerciseEntry {
  ExerciseKind kind = {};
  std::string_view name = {};   ///< "cycle-basis": stable, for files and the command line
  std::string_view title = {};  ///< "Fill in a row of C", marked by toTranslate()
  /// Where to look and which rule to use, marked by toTranslate(). The same for every mechanism, so that it
  /// cannot reveal the answer.
  std::string_view hint = {};
  LessonView view = LessonView::digraph;  ///< which shows what is asked about, and not the answer
  Lack (*lack)(const ExerciseSource& source) = nullptr;
  /// @pre !lack(source)
  Question (*make)(const ExerciseSource& source, ExerciseRandom& random) = nullptr;
};

// What several kinds need.

[[nodiscard]] Lack withoutEdges(const ExerciseSource& source);
[[nodiscard]] Lack withoutTree(const ExerciseSource& source);
[[nodiscard]] Lack withoutMeshes(const ExerciseSource& source);     ///< nor a tree
[[nodiscard]] Lack withoutEquations(const ExerciseSource& source);  ///< of both methods
[[nodiscard]] Lack withoutFreedom(const ExerciseSource& source);
[[nodiscard]] Lack withoutStates(const ExerciseSource& source);

[[nodiscard]] ExerciseEntry incidenceEntry();
[[nodiscard]] ExerciseEntry orientationEntry();
[[nodiscard]] ExerciseEntry reducedIncidenceEntry();
[[nodiscard]] ExerciseEntry pathEntry();
[[nodiscard]] ExerciseEntry treeMatrixEntry();
[[nodiscard]] ExerciseEntry cycleEntry();
[[nodiscard]] ExerciseEntry cycleSenseEntry();
[[nodiscard]] ExerciseEntry cycleBasisEntry();
[[nodiscard]] ExerciseEntry anyCyclesEntry();
[[nodiscard]] ExerciseEntry spanningTreeEntry();
[[nodiscard]] ExerciseEntry wrongEntryEntry();
[[nodiscard]] ExerciseEntry coefficientEntry();
[[nodiscard]] ExerciseEntry freedomEntry();
[[nodiscard]] ExerciseEntry redundantMeshEntry();
[[nodiscard]] ExerciseEntry inputsEntry();
[[nodiscard]] ExerciseEntry speedEntry();
[[nodiscard]] ExerciseEntry levelsEntry();
[[nodiscard]] ExerciseEntry terminalEquationEntry();
[[nodiscard]] ExerciseEntry fundamentalCircuitEntry();
[[nodiscard]] ExerciseEntry cutsetEntry();
[[nodiscard]] ExerciseEntry portTorqueEntry();
[[nodiscard]] ExerciseEntry teethEntry();
[[nodiscard]] ExerciseEntry ringTeethEntry();
[[nodiscard]] ExerciseEntry engagementEntry();
[[nodiscard]] ExerciseEntry brakeTorqueEntry();
[[nodiscard]] ExerciseEntry selfLockingEntry();
[[nodiscard]] ExerciseEntry brakeReactionEntry();

/// All kinds, in the order of ExerciseKind.
constexpr auto kExerciseEntries = std::to_array<ExerciseEntry (*)()>({
    incidenceEntry,
    orientationEntry,
    reducedIncidenceEntry,
    pathEntry,
    treeMatrixEntry,
    cycleEntry,
    cycleSenseEntry,
    cycleBasisEntry,
    anyCyclesEntry,
    spanningTreeEntry,
    wrongEntryEntry,
    coefficientEntry,
    freedomEntry,
    redundantMeshEntry,
    inputsEntry,
    speedEntry,
    levelsEntry,
    terminalEquationEntry,
    fundamentalCircuitEntry,
    cutsetEntry,
    portTorqueEntry,
    teethEntry,
    ringTeethEntry,
    engagementEntry,
    brakeTorqueEntry,
    selfLockingEntry,
    brakeReactionEntry,
});
static_assert(kExerciseEntries.size() == kExerciseKindCount);

}  // namespace geargraph
