#include "core/teaching/grading/question_json.h"

#include <array>

namespace geargraph {
namespace {

constexpr auto kRow = JsonWriter::Layout::row;

void writeTexts(JsonWriter& json, std::string_view key, const std::vector<std::string>& texts) {
  json.key(key);
  json.beginArray(kRow);
  for (const std::string& text : texts) json.string(text);
  json.endArray();
}

void writeNumbers(JsonWriter& json, std::string_view key, const std::vector<int>& numbers) {
  json.key(key);
  json.beginArray(kRow);
  for (const int number : numbers) json.number(static_cast<std::int64_t>(number));
  json.endArray();
}

/// "gearMeshes/16": list of the document and id.
void writeElements(JsonWriter& json, const std::vector<ElementId>& elements) {
  if (elements.empty()) return;
  std::vector<std::string> texts;
  for (const ElementId& element : elements)
    texts.push_back(std::string(listName(element.kind)) + '/' + element.id.text());
  writeTexts(json, "elements", texts);
}

void writeConditions(JsonWriter& json, std::string_view key, const std::vector<Condition>& conditions) {
  json.key(key);
  json.beginArray(kRow);
  for (const Condition& condition : conditions) {
    json.beginObject(kRow);
    json.member("test", testName(condition.test));
    if (!condition.fields.empty()) writeNumbers(json, "fields", condition.fields);
    json.key("values");
    json.beginArray(kRow);
    for (const auto& row : condition.values) {
      json.beginArray(kRow);
      for (const std::string& value : row) json.string(value);
      json.endArray();
    }
    json.endArray();
    json.endObject();
  }
  json.endArray();
}

void writeField(JsonWriter& json, const AnswerField& field) {
  json.beginObject(kRow);
  json.member("name", field.name);
  json.member("kind", fieldKindName(field.kind));
  if (!field.options.empty()) writeTexts(json, "options", field.options);
  writeElements(json, field.elements);
  if (field.mayBeEmpty) json.member("mayBeEmpty", true);
  if (!field.unit.empty()) json.member("unit", field.unit);
  json.endObject();
}

void writeKey(JsonWriter& json, const Question& question) {
  writeConditions(json, "accepted", question.accepted);
  writeTexts(json, "solution", question.solution);
  json.member("rule", question.rule);
  json.key("mistakes");
  json.beginArray();
  for (const Mistake& mistake : question.mistakes) {
    json.beginObject(kRow);
    json.member("name", mistake.name);
    writeConditions(json, "when", mistake.when);
    if (!mistake.fields.empty()) writeNumbers(json, "fields", mistake.fields);
    writeElements(json, mistake.elements);
    json.member("reason", mistake.reason);
    json.endObject();
  }
  json.endArray();
  if (question.symbols.empty()) return;
  json.key("symbols");
  json.beginObject(kRow);
  for (const auto& [name, value] : question.symbols) json.member(name, value);
  json.endObject();
}

}  // namespace

std::string_view testName(Test test) {
  constexpr std::array<std::string_view, 16> kNames = {
      "values", "differs", "multiple", "rows",  "spanning-tree", "has-loop", "basis",  "dependent",
      "fewer",  "more",    "includes", "lacks", "touches",       "quotient", "within", "outside"};
  return kNames[static_cast<std::size_t>(test)];
}

std::string_view fieldKindName(FieldKind kind) {
  constexpr std::array<std::string_view, 4> kNames = {"integer", "number", "choice", "set"};
  return kNames[static_cast<std::size_t>(kind)];
}

void writeQuestion(JsonWriter& json, const Question& question, QuestionPart part) {
  json.beginObject();
  json.member("kind", question.kind);
  json.member("prompt", question.prompt);
  if (!question.formula.empty()) json.member("formula", question.formula);
  json.member("points", question.points);
  if (question.comma == CommaUse::decimal) json.member("decimal", ",");
  writeElements(json, question.elements);
  if (!question.table.columns.empty()) {
    json.key("table");
    json.beginObject(kRow);
    writeTexts(json, "rows", question.table.rows);
    writeTexts(json, "columns", question.table.columns);
    if (question.table.partition) json.member("partition", *question.table.partition);
    json.endObject();
  }
  json.key("fields");
  json.beginArray();
  for (const AnswerField& field : question.fields) writeField(json, field);
  json.endArray();
  if (part == QuestionPart::withKey) writeKey(json, question);
  json.endObject();
}

std::string questionsJson(const std::vector<Question>& questions, QuestionPart part) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-questions");
    json.member("version", kQuestionsVersion);
    json.key("questions");
    json.beginArray();
    for (const Question& question : questions) writeQuestion(json, question, part);
    json.endArray();
    json.endObject();
  }
  return sink.take() + '\n';
}

std::string answersJson(const AnswerSheet& answers) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-answers");
    json.member("version", kAnswersVersion);
    json.member("sheet", answers.sheet);
    json.member("variant", answers.variant);
    json.member("student", answers.student);
    json.key("answers");
    json.beginObject();
    for (const auto& [question, fields] : answers.answers) {
      json.key(std::to_string(question));
      json.beginObject(kRow);
      for (const auto& [name, text] : fields) json.member(name, text);
      json.endObject();
    }
    json.endObject();
    json.endObject();
  }
  return sink.take() + '\n';
}

}  // namespace geargraph
