#pragma once

#include <string>
#include <vector>

#include "core/teaching/grading/number_text.h"
#include "core/teaching/grading/question.h"

namespace geargraph {

enum class AnswerFault { none, empty, notANumber, ambiguousNumber, unknownName, otherUnit, notAChoice };

/// One parsed field of an answer.
struct ReadField {
  FieldKind kind = FieldKind::integer;
  AnswerFault fault = AnswerFault::none;
  bool isEmpty = false;               ///< nothing was filled in
  std::string place = {};             ///< of a fault: the part of the text that cannot be read
  WrittenNumber number;               ///< for numbers
  std::string text;                   ///< for a choice: the option
  std::vector<std::string> elements;  ///< for a set: its options, in the question's order, each once

  /// Does the text `value` parse to the same? "" is an empty field.
  [[nodiscard]] bool readsLike(const std::string& value) const;
};

using ReadAnswer = std::vector<ReadField>;

/// Sets are listed with commas, semicolons or blanks, in any order, with or without braces. The case of words
/// does not matter where only one option fits. The unit of the notation is that of the field.
[[nodiscard]] ReadField readField(const AnswerField& field, const std::string& text,
                                  const NumberNotation& notation = {});

/// @pre a text for each field
[[nodiscard]] ReadAnswer readAnswer(const Question& question, const std::vector<std::string>& answer);

/// A set in the notation of answers and conditions: "8,9,11".
[[nodiscard]] std::string setText(const std::vector<std::string>& elements);

}  // namespace geargraph
