#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/cli/arguments.h"
#include "core/teaching/exercises/exercise_sheet.h"

namespace geargraph::cli {

// The options of a sheet, as `exercises make` and `export --to handout --exercises` have them.

/// Words between separators, without blanks and carriage returns at their ends, and without empty ones.
[[nodiscard]] std::vector<std::string> wordsOf(const std::string& list, char separator);

/// `--title TEXT --seed N --variants N`: all but the kinds, which depend on the mechanism.
[[nodiscard]] std::variant<SheetPlan, UsageError> planFrom(const Arguments& arguments);

/// `--kinds LIST`, or all that the mechanism gives.
[[nodiscard]] std::variant<std::vector<ExerciseKind>, UsageError> kindsFrom(const Arguments& arguments,
                                                                            const ExerciseSource& source);

}  // namespace geargraph::cli
