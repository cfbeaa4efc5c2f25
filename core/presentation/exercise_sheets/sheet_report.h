#pragma once

#include <string>

#include "core/presentation/report/report.h"
#include "core/teaching/exercises/exercise_sheet.h"

namespace geargraph {

/// The questions with blanks, or with their answers and the reasons.
enum class SheetForm { questions, solution };

/// One variant of an exercise sheet as a document, for all forms that a report has: the mechanism with its
/// schematic, digraph and lists of joints and meshes, then the questions. Without the T-T graph, because
/// questions ask for its carriers. `student`: the name to be printed; empty: a line for the name.
/// @pre the variant was made from this source and plan
[[nodiscard]] Report sheetReport(const ExerciseSource& source, const SheetPlan& plan,
                                 const SheetVariant& sheet, const std::string& student, SheetForm form);

}  // namespace geargraph
