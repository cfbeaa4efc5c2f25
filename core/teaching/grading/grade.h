#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/teaching/grading/question.h"

namespace geargraph {

/// A mistake found in an answer: its name, its place and the reason.
struct FoundMistake {
  std::string name;
  std::vector<int> fields;
  std::vector<ElementId> elements;
  std::string reason;
};

/// The result of grading an answer.
struct Verdict {
  bool isRight = false;
  bool isBlank = false;       ///< no field is filled in, and some has to be
  bool isUnreadable = false;  ///< some field cannot be read; its mistake names the place
  int points = 0;             ///< of those of the question
  /// The mistake to be reported first. None for a right answer, and for a wrong one that no known mistake
  /// explains.
  std::optional<FoundMistake> mistake;
  /// Further mistakes, in other fields of the answer.
  std::vector<FoundMistake> others;
  std::vector<int> wrongFields;  ///< all that are marked, ascending; empty: the answer as a whole
  std::string reason;            ///< of the mistake; else the rule of the question
};

/// Grades an answer, one text per field. Full points for a right answer, else the share of its right cells,
/// rounded down (CellMarks). A mistake marks those of its fields that differ. Pure. Cost: that of the
/// conditions; microseconds for a row, under a millisecond for a matrix.
/// @pre a text for each field
[[nodiscard]] Verdict grade(const Question& question, const std::vector<std::string>& answer);

}  // namespace geargraph
