#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/teaching/grading/question.h"

namespace geargraph::inline grading {

/// A mistake that was found in an answer: its name, where it is seen and why it is one.
struct FoundMistake {
  std::string name;
  std::vector<int> fields;
  std::vector<ElementId> elements;
  std::string reason;
};

/// What the grader tells about an answer.
struct Verdict {
  bool isRight = false;
  int points = 0;  ///< of those of the question
  /// The mistake to be told first. A right answer has none, nor has a wrong one that no known mistake
  /// explains.
  std::optional<FoundMistake> mistake;
  /// The other mistakes of an answer that is wrong in some of its fields, each in fields of its own.
  std::vector<FoundMistake> others;
  std::vector<int> wrongFields;  ///< all that are marked, ascending; empty: the answer as a whole
  std::string reason;            ///< of the mistake; else the rule of the question
};

/// Grades an answer, one text a field. All points for a right answer, half of them (rounded down) where one
/// field of at least four is wrong, else none. Pure. Cost: that of the conditions; microseconds for a row,
/// under a millisecond for a matrix.
/// @pre a text for each field
[[nodiscard]] Verdict grade(const Question& question, const std::vector<std::string>& answer);

}  // namespace geargraph::inline grading
