#pragma once

#include <string>
#include <vector>

#include "core/teaching/grading/number_text.h"
#include "core/teaching/grading/question.h"

namespace geargraph::inline grading {

enum class AnswerFault { none, empty, notANumber, ambiguousNumber, notAChoice };

/// One parsed field of an answer.
struct ReadField {
  FieldKind kind = FieldKind::integer;
  AnswerFault fault = AnswerFault::none;
  bool isEmpty = false;               ///< nothing was filled in
  WrittenNumber number;               ///< for numbers
  std::string text;                   ///< for a choice: the option
  std::vector<std::string> elements;  ///< for a set: its options, in the question's order, each once

  /// Does the text `value` parse to the same? "" is an empty field.
  [[nodiscard]] bool readsLike(const std::string& value) const;
};

using ReadAnswer = std::vector<ReadField>;

/// Sets are listed with commas, semicolons or blanks, in any order, with or without braces.
[[nodiscard]] ReadField readField(const AnswerField& field, const std::string& text);

/// @pre a text for each field
[[nodiscard]] ReadAnswer readAnswer(const Question& question, const std::vector<std::string>& answer);

/// A set in the notation of answers and conditions: "8,9,11".
[[nodiscard]] std::string setText(const std::vector<std::string>& elements);

}  // namespace geargraph::inline grading
