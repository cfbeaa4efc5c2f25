#pragma once

#include <string>

#include "core/teaching/exercises/exercise_sheet.h"

namespace geargraph::inline handout {

/// One variant of an exercise sheet, with its keys.
struct HandoutExercises {
  SheetPlan plan;
  std::string mark;  ///< sheetMark(): by it answers name their sheet
  SheetVariant sheet;
};

/// @pre the source is of this mechanism and gives every kind of the plan; 1 <= variant <= plan.variants
[[nodiscard]] HandoutExercises handoutExercises(const ExerciseSource& source, const SheetPlan& plan,
                                                int variant);

/// The content of a section: all questions with blanks, to be read and printed without scripts. The element
/// of a question is of class "question", that of a blank carries data-field, its position.
[[nodiscard]] std::string exercisesSection(const HandoutExercises& exercises);

/// What the page's script grades by: {"sheet": mark, "variant": ..., "questions": [...]} with keys as in
/// exercises.schema.json; packed by gzip, in base64: no answer meets the eye of who reads the file.
[[nodiscard]] std::string exercisesKey(const HandoutExercises& exercises);

}  // namespace geargraph::inline handout
