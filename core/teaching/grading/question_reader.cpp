// Reads questions and answers from JSON.

#include "core/teaching/grading/question_reader.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/foundations/base/rational.h"
#include "core/foundations/base/translation.h"
#include "core/teaching/grading/question_json.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxFields = 10'000;

template <class Value, class NameOf>
Value named(MemberReader& reader, const std::string& name, int count, NameOf nameOf,
            const std::string& pointer) {
  for (int i = 0; i < count; ++i) {
    if (nameOf(static_cast<Value>(i)) == name) return static_cast<Value>(i);
  }
  reader.fail(pointer, translated("\"%1\" is not known here.", {name}));
  return {};
}

/// The values of the symbols, each a number.
void readSymbols(MemberReader& reader, const JsonValue& object, const std::string& pointer,
                 NumberSymbols& symbols) {
  const auto found =
      reader.fault() ? std::nullopt : reader.member(object, "symbols", JsonKind::object, pointer, false);
  if (!found) return;
  found->forEachMember([&](const JsonValue& name, const JsonValue& value) {
    const std::string text = reader.elementText(value, pointer + "/symbols/" + name.string());
    if (!Rational::fromText(text))
      reader.fail(pointer + "/symbols/" + name.string(), translated("A number is needed here."));
    symbols.emplace(name.string(), text);
  });
}

Question readQuestion(MemberReader& reader, const JsonValue& object, const std::string& pointer) {
  Question question;
  question.kind = reader.text(object, "kind", pointer);
  question.prompt = reader.text(object, "prompt", pointer);
  question.formula = reader.text(object, "formula", pointer, false);
  question.points = reader.memberNumber(object, "points", pointer).value_or(0);
  question.elements = reader.fault() ? std::vector<ElementId>() : reader.elements(object, pointer);
  if (const auto table =
          reader.fault() ? std::nullopt : reader.member(object, "table", JsonKind::object, pointer, false)) {
    question.table.rows = reader.texts(*table, "rows", pointer + "/table", true);
    question.table.columns = reader.texts(*table, "columns", pointer + "/table", true);
    question.table.partition = reader.memberNumber(*table, "partition", pointer + "/table", false);
  }
  reader.each(object, "fields", pointer, true, [&](const JsonValue& element, const std::string& place) {
    AnswerField field;
    field.name = reader.text(element, "name", place);
    field.kind =
        named<FieldKind>(reader, reader.text(element, "kind", place), 4, fieldKindName, place + "/kind");
    if (reader.fault()) return;
    field.options = reader.texts(element, "options", place, false);
    field.elements = reader.elements(element, place);
    const auto mayBeEmpty = reader.member(element, "mayBeEmpty", JsonKind::boolean, place, false);
    field.mayBeEmpty = mayBeEmpty && mayBeEmpty->boolean();
    field.unit = reader.text(element, "unit", place, false);
    question.fields.push_back(std::move(field));
  });
  if (reader.text(object, "decimal", pointer, false) == ",") question.comma = CommaUse::decimal;
  readSymbols(reader, object, pointer, question.symbols);
  question.accepted = readConditions(reader, object, "accepted", pointer);
  question.solution = reader.texts(object, "solution", pointer, true);
  question.rule = reader.text(object, "rule", pointer);
  reader.each(object, "mistakes", pointer, true, [&](const JsonValue& element, const std::string& place) {
    Mistake mistake;
    mistake.name = reader.text(element, "name", place);
    mistake.when = readConditions(reader, element, "when", place);
    if (reader.fault()) return;
    mistake.fields = reader.numbers(element, "fields", place);
    mistake.elements = reader.elements(element, place);
    mistake.reason = reader.text(element, "reason", place);
    question.mistakes.push_back(std::move(mistake));
  });
  return question;
}

bool isNumberText(const std::string& text) {
  return Rational::fromText(text).has_value();
}

/// What holds() relies on: positions of fields, and the shape and numbers of the rows of each test.
bool isSound(const Condition& condition, const Question& question) {
  const auto isField = [&](int field) {
    return field >= 0 && static_cast<std::size_t>(field) < question.fields.size();
  };
  if (!std::all_of(condition.fields.begin(), condition.fields.end(), isField)) return false;
  const std::size_t fields = condition.fields.empty() ? question.fields.size() : condition.fields.size();
  const auto& rows = condition.values;
  if (rows.empty()) return false;
  const auto haveLength = [&](std::size_t length) {
    return std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return row.size() == length; });
  };
  const auto areNumbers = [&](std::size_t first) {
    return std::all_of(rows.begin(), rows.end(), [&](const auto& row) {
      return row.size() >= first &&
             std::all_of(row.begin() + static_cast<std::ptrdiff_t>(first), row.end(), isNumberText);
    });
  };
  switch (condition.test) {
    case Test::values:
    case Test::differs:
      return haveLength(fields);
    case Test::multiple:
      return rows.size() == 1 && haveLength(fields) && areNumbers(0);
    case Test::rows:
      return !rows.front().empty() && haveLength(rows.front().size()) && areNumbers(0) &&
             fields == rows.size() * rows.front().size();
    case Test::spanningTree:
    case Test::hasLoop:
      return haveLength(3);
    case Test::basis:
    case Test::dependent:
      return !rows.front().empty() && haveLength(rows.front().size()) && areNumbers(1);
    case Test::fewer:
    case Test::more:
      return rows.size() == 1 && haveLength(1) && areNumbers(0);
    case Test::quotient:
      return fields == 2 && rows.size() == 1 && haveLength(1) && areNumbers(0);
    case Test::within:
    case Test::outside:
      return rows.size() == 1 && haveLength(2) && areNumbers(0);
    case Test::includes:
    case Test::lacks:
    case Test::touches:
      return rows.size() == 1;
  }
  return false;
}

}  // namespace

std::vector<Condition> readConditions(MemberReader& reader, const JsonValue& object, std::string_view name,
                                      const std::string& pointer) {
  std::vector<Condition> conditions;
  reader.each(object, name, pointer, true, [&](const JsonValue& element, const std::string& place) {
    Condition condition;
    condition.test = named<Test>(reader, reader.text(element, "test", place),
                                 static_cast<int>(Test::outside) + 1, testName, place + "/test");
    condition.fields = reader.numbers(element, "fields", place);
    reader.each(element, "values", place, true, [&](const JsonValue& row, const std::string& rowPlace) {
      std::vector<std::string> values;
      reader.eachElement(row, rowPlace, [&](const JsonValue& value, const std::string& valuePlace) {
        values.push_back(reader.elementText(value, valuePlace));
      });
      condition.values.push_back(std::move(values));
    });
    conditions.push_back(std::move(condition));
  });
  return conditions;
}

std::optional<std::string> unsoundPart(const Question& question) {
  if (question.fields.empty() || question.fields.size() > kMaxFields) return "fields";
  const std::size_t cells = question.table.rows.size() * question.table.columns.size();
  if (!question.table.columns.empty() && cells != question.fields.size()) return "table";
  if (question.solution.size() != question.fields.size()) return "solution";
  const auto areSound = [&](const std::vector<Condition>& conditions) {
    return !conditions.empty() &&
           std::all_of(conditions.begin(), conditions.end(),
                       [&](const Condition& condition) { return isSound(condition, question); });
  };
  if (!areSound(question.accepted)) return "accepted";
  for (const Mistake& mistake : question.mistakes) {
    const auto isField = [&](int field) {
      return field >= 0 && static_cast<std::size_t>(field) < question.fields.size();
    };
    if (!areSound(mistake.when) || !std::all_of(mistake.fields.begin(), mistake.fields.end(), isField))
      return "mistakes";
  }
  return std::nullopt;
}

Expected<std::vector<Question>> readQuestions(std::string_view text) {
  const auto document = JsonDocument::parse(text);
  if (!document) return document.error();
  MemberReader reader;
  std::vector<Question> questions;
  reader.heading(document->root(), "geargraph-questions", kQuestionsVersion);
  if (!reader.fault()) {
    reader.each(document->root(), "questions", "", true,
                [&](const JsonValue& element, const std::string& place) {
                  if (reader.fault()) return;
                  questions.push_back(readQuestion(reader, element, place));
                  const auto unsound = reader.fault() ? std::nullopt : unsoundPart(questions.back());
                  if (unsound)
                    reader.fail(place + '/' + *unsound,
                                translated("This part does not fit the fields of its question."));
                });
  }
  if (reader.fault()) return *reader.fault();
  return questions;
}

Expected<AnswerSheet> readAnswers(std::string_view text) {
  const auto document = JsonDocument::parse(text);
  if (!document) return document.error();
  MemberReader reader;
  AnswerSheet sheet;
  const JsonValue root = document->root();
  reader.heading(root, "geargraph-answers", kAnswersVersion);
  if (reader.fault()) return *reader.fault();
  sheet.sheet = reader.text(root, "sheet", "");
  sheet.variant = reader.memberNumber(root, "variant", "").value_or(0);
  sheet.student = reader.text(root, "student", "", false);
  const auto answers = reader.member(root, "answers", JsonKind::object, "");
  if (!answers) return *reader.fault();
  answers->forEachMember([&](const JsonValue& key, const JsonValue& fields) {
    const std::string name = key.string();
    const std::string place = "/answers/" + name;
    int question = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), question);
    if (error != std::errc() || end != name.data() + name.size() || question < 1)
      return reader.fail(place, translated("Answers are kept by the number of their question."));
    if (!fields.is(JsonKind::object)) return reader.fail(place, translated("An object is needed here."));
    fields.forEachMember([&](const JsonValue& field, const JsonValue& answer) {
      const bool isText = answer.is(JsonKind::string);
      if (!isText && !answer.is(JsonKind::number))
        return reader.fail(place + '/' + field.string(), translated("An answer is a text or a number."));
      sheet.answers[question][field.string()] = isText ? answer.string() : std::string(answer.slice());
    });
  });
  if (reader.fault()) return *reader.fault();
  return sheet;
}

}  // namespace geargraph
