#include "core/teaching/exercises/question_builder.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "core/teaching/grading/conditions.h"

namespace geargraph {

QuestionBuilder::QuestionBuilder(ExerciseKind kind, int points) {
  question.kind = kindName(kind);
  question.points = points;
}

void QuestionBuilder::field(std::string name, FieldKind kind, std::vector<std::string> options,
                            std::vector<ElementId> elements) {
  const std::string title = translated(name);
  question.fields.push_back({std::move(name), kind, std::move(options), std::move(elements), false});
  titled(title);
}

void QuestionBuilder::titled(const std::string& title) {
  AnswerField& field = question.fields.back();
  if (title != field.name) field.title = title;
}

void QuestionBuilder::table(std::vector<std::string> rows, std::vector<std::string> columns, FieldKind kind) {
  for (const std::string& row : rows) {
    for (const std::string& column : columns) field(row + ',' + column, kind);
  }
  question.table.rows = std::move(rows);
  question.table.columns = std::move(columns);
}

void QuestionBuilder::accept(std::vector<std::string> values,
                             const std::vector<std::vector<std::string>>& alternatives) {
  Condition condition{Test::values, {}, {values}};
  for (const auto& other : alternatives) {
    if (other != values) condition.values.push_back(other);
  }
  accept(std::move(values), {std::move(condition)});
}

void QuestionBuilder::accept(std::vector<std::string> solution, std::vector<Condition> conditions) {
  question.solution = std::move(solution);
  question.accepted = std::move(conditions);
}

bool QuestionBuilder::isCovered(const std::vector<std::string>& values) const {
  const ReadAnswer read = readAnswer(question, values);
  return allHold(question.accepted, read) ||
         std::any_of(question.mistakes.begin(), question.mistakes.end(), [&](const Mistake& mistake) {
           return mistake.fields.empty() && allHold(mistake.when, read);
         });
}

void QuestionBuilder::wrong(const char* name, const std::vector<std::string>& values, std::string reason,
                            std::vector<ElementId> elements) {
  if (isCovered(values)) return;
  wrongIf(name, {{Test::values, {}, {values}}}, std::move(reason), std::move(elements));
}

void QuestionBuilder::wrongMultiple(const char* name, const std::vector<std::string>& values,
                                    std::string reason, std::vector<ElementId> elements) {
  if (isCovered(values)) return;
  wrongIf(name, {{Test::multiple, {}, {values}}}, std::move(reason), std::move(elements));
}

void QuestionBuilder::wrongFields(const char* name, const std::vector<int>& fields,
                                  const std::vector<std::vector<std::string>>& values, std::string reason,
                                  std::vector<ElementId> elements) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& row : values) {
    std::vector<std::string> answer = question.solution;
    for (std::size_t i = 0; i < fields.size(); ++i) answer[static_cast<std::size_t>(fields[i])] = row[i];
    if (std::find(rows.begin(), rows.end(), row) == rows.end() && !isCovered(answer)) rows.push_back(row);
  }
  if (!rows.empty())
    wrongIf(name, {{Test::values, fields, rows}}, std::move(reason), std::move(elements), fields);
}

void QuestionBuilder::wrongField(const char* name, int field, const std::vector<std::string>& texts,
                                 std::string reason, std::vector<ElementId> elements) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& text : texts) rows.push_back({text});
  wrongFields(name, {field}, rows, std::move(reason), std::move(elements));
}

void QuestionBuilder::wrongIf(const char* name, std::vector<Condition> when, std::string reason,
                              std::vector<ElementId> elements, std::vector<int> fields) {
  question.mistakes.push_back(
      {name, std::move(when), std::move(fields), std::move(elements), std::move(reason)});
}

void QuestionBuilder::wrongNonSigns() {
  std::vector<int> filled;
  for (std::size_t i = 0; i < question.fields.size(); ++i) {
    if (!question.fields[i].mayBeEmpty) filled.push_back(static_cast<int>(i));
  }
  wrongIf("entry-not-a-sign", {{Test::outside, filled, {{"-1", "1"}}}},
          translated("The entries of this matrix are −1, 0 and 1 only: they tell senses, not sizes."));
}

std::string asText(int value) {
  return std::to_string(value);
}

std::vector<std::string> asTexts(const std::vector<int>& values) {
  std::vector<std::string> texts;
  for (const int value : values) texts.push_back(asText(value));
  return texts;
}

std::vector<std::string> asTexts(const std::vector<Rational>& values) {
  std::vector<std::string> texts;
  for (const Rational& value : values) texts.push_back(value.toString());
  return texts;
}

std::string inWords(const Rational& value) {
  return (value.sign() < 0 ? "\u2212" : "") + value.abs().toString();
}

std::string inWords(int value) {
  return inWords(Rational(value));
}

std::string asTex(const Rational& value) {
  const std::string text = value.abs().toString();
  const auto slash = text.find('/');
  const std::string sign = value.sign() < 0 ? "-" : "";
  if (slash == std::string::npos) return sign + text;
  return sign + "\\frac{" + text.substr(0, slash) + "}{" + text.substr(slash + 1) + '}';
}

std::string namedInPrompt(const std::string& name) {
  std::string text;
  for (const char c : name) text += c == '$' ? std::string("\uff04") : std::string(1, c);
  return text;
}

std::vector<int> negated(std::vector<int> values) {
  for (int& value : values) value = -value;
  return values;
}

std::vector<int> magnitudes(std::vector<int> values) {
  for (int& value : values) value = std::abs(value);
  return values;
}

std::string edgeName(const ExerciseSource& source, int edge) {
  return edge < source.graph().t() ? translated("joint %1", {source.edgeLabel(edge)})
                                   : translated("mesh %1", {source.edgeLabel(edge)});
}

std::vector<int> firstNumbers(int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

}  // namespace geargraph
