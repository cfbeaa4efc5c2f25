#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/teaching/exercises/exercise_kinds.h"
#include "core/teaching/grading/read_answer.h"

namespace geargraph {

/// Builds a question. Mistakes are tested in the order in which they are added; one whose answer is accepted,
/// or explained by an earlier mistake on this mechanism, is left out.
class QuestionBuilder {
 public:
  QuestionBuilder(ExerciseKind kind, int points);

  Question question;

  /// Adds a field to the list. A name that consists of words is marked by toTranslate(); if it also has
  /// labels, use titled().
  void field(std::string name, FieldKind kind, std::vector<std::string> options = {},
             std::vector<ElementId> elements = {});
  /// Sets the displayed title of the last field, if its name is no marked text.
  void titled(const std::string& title);
  /// Sets the unit that the number of the last field may have.
  void inUnit(const char* unit) { question.fields.back().unit = unit; }
  /// Adds a table of fields named "row,column".
  void table(std::vector<std::string> rows, std::vector<std::string> columns, FieldKind kind);

  /// Accepts exactly these values, and the alternatives.
  void accept(std::vector<std::string> values,
              const std::vector<std::vector<std::string>>& alternatives = {});
  void accept(std::vector<std::string> solution, std::vector<Condition> conditions);

  /// Adds a mistake by a complete answer.
  void wrong(const char* name, const std::vector<std::string>& values, std::string reason,
             std::vector<ElementId> elements = {});
  /// The same for any multiple of these values.
  void wrongMultiple(const char* name, const std::vector<std::string>& values, std::string reason,
                     std::vector<ElementId> elements = {});
  /// Adds a mistake by the values of some fields, one text per field in each row, whatever the others are.
  void wrongFields(const char* name, const std::vector<int>& fields,
                   const std::vector<std::vector<std::string>>& values, std::string reason,
                   std::vector<ElementId> elements = {});
  void wrongField(const char* name, int field, const std::vector<std::string>& texts, std::string reason,
                  std::vector<ElementId> elements = {});
  /// Adds a mistake by arbitrary conditions.
  void wrongIf(const char* name, std::vector<Condition> when, std::string reason,
               std::vector<ElementId> elements = {}, std::vector<int> fields = {});
  /// Adds the mistake that some field is none of -1, 0, 1.
  void wrongNonSigns();

 private:
  [[nodiscard]] bool isCovered(const std::vector<std::string>& values) const;
};

// Texts of numbers in answers and in sentences.

[[nodiscard]] std::string asText(int value);  ///< "-1"
[[nodiscard]] std::vector<std::string> asTexts(const std::vector<int>& values);
[[nodiscard]] std::vector<std::string> asTexts(const std::vector<Rational>& values);
[[nodiscard]] std::string inWords(int value);  ///< "−1", with the Unicode minus sign
[[nodiscard]] std::string inWords(const Rational& value);
[[nodiscard]] std::string asTex(const Rational& value);  ///< "-\frac{3}{2}"
/// A user's name escaped for a prompt, because dollar signs would begin a formula.
[[nodiscard]] std::string namedInPrompt(const std::string& name);

[[nodiscard]] std::vector<int> negated(std::vector<int> values);
[[nodiscard]] std::vector<int> magnitudes(std::vector<int> values);

/// "joint 8", "mesh 16".
[[nodiscard]] std::string edgeName(const ExerciseSource& source, int edge);
[[nodiscard]] std::vector<int> firstNumbers(int count);  ///< 0 .. count-1

}  // namespace geargraph
