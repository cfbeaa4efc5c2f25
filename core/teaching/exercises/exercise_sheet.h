#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/teaching/exercises/exercise_kinds.h"

namespace geargraph {

constexpr int kMaxVariants = 1'000;
constexpr int kMaxQuestions = 100;

/// The version of the generator, increased when the same seed gives other questions.
constexpr int kGeneratorVersion = 2;

/// The parameters of a sheet, in addition to the mechanism.
struct SheetPlan {
  std::string title;
  std::vector<ExerciseKind> kinds;  ///< of the questions, in their order; kinds may repeat
  std::uint64_t seed = 1;
  int variants = 1;             ///< 1: the same sheet for everyone
  CommaUse comma = commaUse();  ///< of answers: that of the language in which the sheet is made
  friend bool operator==(const SheetPlan&, const SheetPlan&) = default;
};

/// One variant of a sheet with its answer keys.
struct SheetVariant {
  int variant = 1;
  std::vector<Question> questions;
  [[nodiscard]] int points() const;
};

/// The kinds of questions available for the mechanism, once each.
[[nodiscard]] std::vector<ExerciseKind> offeredKinds(const ExerciseSource& source);

/// Generates a variant. The same seed, variant and position in the sheet give the same question. Equal
/// questions of one kind are redrawn a few times.
/// @pre 1 <= variant; every kind of the plan is among offeredKinds()
[[nodiscard]] SheetVariant makeVariant(const ExerciseSource& source, const SheetPlan& plan, int variant);

/// The content of a sheet's file, from which every variant and its key can be reproduced. It contains no
/// questions and keys, but anyone with this program can generate both from it.
struct SheetFile {
  SheetPlan plan;
  Mechanism mechanism;
};

constexpr int kSheetVersion = 1;

[[nodiscard]] std::string sheetJson(const SheetFile& sheet);
/// `syntax`, `format`, `version` (of the file or of the generator), `schema`, and the errors of the
/// mechanism.
[[nodiscard]] Expected<SheetFile> readSheet(std::string_view text);

/// The identifier of a sheet in files of answers: 16 hexadecimal digits, FNV-1a (64 bits) of plan and
/// mechanism.
[[nodiscard]] std::string sheetMark(const SheetFile& sheet);

}  // namespace geargraph
