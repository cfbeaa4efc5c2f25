#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/foundations/files/json_writer.h"
#include "core/teaching/grading/question.h"

namespace geargraph {

/// With the key (accepted answers, solution, mistakes), or only what a learner sees.
enum class QuestionPart { withKey, withoutKey };

/// A question as an object of exercises.schema.json.
void writeQuestion(JsonWriter& json, const Question& question, QuestionPart part);

constexpr int kQuestionsVersion = 1;

/// {"format": "geargraph-questions", "version": 1, "questions": [...]}
[[nodiscard]] std::string questionsJson(const std::vector<Question>& questions, QuestionPart part);
/// Reads questions with their keys. Fails with `syntax`, `format`, `version`, or `schema` at the place of the
/// first error. Identity: readQuestions(questionsJson(q, withKey)) is q.
[[nodiscard]] Expected<std::vector<Question>> readQuestions(std::string_view text);

/// A submission: by question number, from 1, the texts by field name.
struct AnswerSheet {
  std::string sheet;  ///< sheetMark() of the sheet
  int variant = 1;
  std::string student;  ///< as written by them; may be empty
  std::map<int, std::map<std::string, std::string>> answers;
  friend bool operator==(const AnswerSheet&, const AnswerSheet&) = default;
};

constexpr int kAnswersVersion = 1;

/// {"format": "geargraph-answers", "version": 1, "sheet": ..., "variant": 7, "student": "", "answers": {"1":
/// {"C16,8": "1"}}}
[[nodiscard]] std::string answersJson(const AnswerSheet& answers);
/// Fails as readQuestions(). Answers may be JSON numbers, whose spelling is kept. Identity:
/// readAnswers(answersJson(a)) is a.
[[nodiscard]] Expected<AnswerSheet> readAnswers(std::string_view text);

[[nodiscard]] std::string_view testName(Test test);            ///< "spanning-tree"
[[nodiscard]] std::string_view fieldKindName(FieldKind kind);  ///< "integer"

}  // namespace geargraph
