#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/teaching/exercises/exercise_kinds.h"

namespace geargraph::inline exercises {

constexpr int kMostVariants = 1'000;
constexpr int kMostQuestions = 100;

/// Counts the changes of the generator after which the same seed makes other questions.
constexpr int kGeneratorVersion = 1;

/// What a sheet is made from, beside the mechanism.
struct SheetPlan {
  std::string title;
  std::vector<ExerciseKind> kinds;  ///< of the questions, in their order; a kind may occur again
  std::uint64_t seed = 1;
  int variants = 1;  ///< 1: the same sheet for everyone
  friend bool operator==(const SheetPlan&, const SheetPlan&) = default;
};

/// One variant of a sheet with its keys.
struct SheetVariant {
  int variant = 1;
  std::vector<Question> questions;
  [[nodiscard]] int points() const;
};

/// The kinds that the mechanism gives, once each.
[[nodiscard]] std::vector<ExerciseKind> offeredKinds(const ExerciseSource& source);

/// The same seed, variant and place in the sheet make the same question. Questions of one kind are drawn
/// again where they are equal, some times.
/// @pre 1 <= variant; every kind of the plan is offered
[[nodiscard]] SheetVariant makeVariant(const ExerciseSource& source, const SheetPlan& plan, int variant);

/// A sheet as a file: from it every variant and its key can be made again. It holds no question and no key,
/// but who has it and this program can have both.
struct SheetFile {
  SheetPlan plan;
  Mechanism mechanism;
};

constexpr int kSheetVersion = 1;

[[nodiscard]] std::string sheetJson(const SheetFile& sheet);
/// `syntax`, `format`, `version` (of the file or of the generator), `schema`, and what is wrong with the
/// mechanism.
[[nodiscard]] Expected<SheetFile> readSheet(std::string_view text);

/// 16 hexadecimal digits by which answers name their sheet: FNV-1a (64 bits) of plan and mechanism.
[[nodiscard]] std::string sheetMark(const SheetFile& sheet);

}  // namespace geargraph::inline exercises
