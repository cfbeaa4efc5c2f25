#pragma once

#include <string>

#include "core/teaching/exercises/exercise_sheet.h"

namespace geargraph {

/// One variant of an exercise sheet, with its answer keys.
struct HandoutExercises {
  SheetPlan plan;
  std::string mark;  ///< sheetMark(), which files of answers contain to identify their sheet
  SheetVariant sheet;
  MechanismPtr mechanism;    ///< that of the variant, which the page has to show
  std::string student = {};  ///< whose page it is, so that the name need not be typed; empty: anyone's
};

/// @pre the source gives every kind of the plan; 1 <= variant <= plan.variants
[[nodiscard]] HandoutExercises handoutExercises(const ExerciseSource& source, const SheetPlan& plan,
                                                int variant);

/// The content of a section: all questions with blanks, readable and printable without scripts. The element
/// of a question has the class "question", that of a blank the attribute data-field with its position.
[[nodiscard]] std::string exercisesSection(const HandoutExercises& exercises);

/// The data for grading in the page's script: {"sheet": mark, "variant": ..., "student": name, "questions":
/// [...], "shown":
/// [...]}, with keys as in exercises.schema.json, and for each question the names of its "fields" and
/// "columns" in the current language, gzipped and in base64, so that answers are not readable in the file.
[[nodiscard]] std::string exercisesKey(const HandoutExercises& exercises);

}  // namespace geargraph
