#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/presentation/exporters/option_values.h"
#include "core/teaching/exercises/exercise_sheet.h"

namespace geargraph {

// The options of a sheet, common to `exercises make` and `export --to handout --exercises`.

/// The parts of a list, trimmed of blanks and carriage returns, without empty ones.
[[nodiscard]] std::vector<std::string> wordsOf(const std::string& list, char separator);

/// The plan of `--title TEXT --seed N --variants N`, without the kinds, which depend on the mechanism.
[[nodiscard]] std::variant<SheetPlan, UsageError> planFrom(const OptionValues& given);

/// The kinds of `--kinds LIST`, or all that are available for the mechanism.
[[nodiscard]] std::variant<std::vector<ExerciseKind>, UsageError> kindsFrom(const OptionValues& given,
                                                                            const ExerciseSource& source);

/// Why no exercises are made of a mechanism of more than kMaxExerciseLinks links, as a sentence.
[[nodiscard]] std::string exercisesTooLarge();

}  // namespace geargraph
