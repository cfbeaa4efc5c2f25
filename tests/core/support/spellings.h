#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/foundations/files/file.h"
#include "core/foundations/files/json.h"
#include "core/teaching/grading/question.h"
#include "tests/core/support/example_files.h"

// The spellings of answers in tests/handout/spellings.json, each as a question of one field with the verdict
// that every grader has to give.

namespace geargraph::test {

struct SpelledAnswer {
  std::string text;
  std::string verdict;  ///< right, wrong, unreadable, blank
  std::string place;    ///< for messages
  Question question;
};

inline std::vector<SpelledAnswer> spelledAnswers() {
  const auto bytes = readFile(sourcePath("tests/handout/spellings.json"), 1'000'000);
  const auto document = JsonDocument::parse(std::get<std::string>(bytes));
  const JsonValue root = document->root();
  const auto textsOf = [](const JsonValue& array) {
    std::vector<std::string> texts;
    array.forEachElement([&](const JsonValue& text, std::size_t) { texts.push_back(text.string()); });
    return texts;
  };
  Question asked;
  asked.kind = "spelling";
  asked.points = 4;
  asked.rule = "The rule.";
  root.member("symbols")->forEachMember([&](const JsonValue& name, const JsonValue& value) {
    asked.symbols.emplace(name.string(), value.string());
  });
  const std::vector<std::string> choices = textsOf(*root.member("choices"));
  const std::vector<std::string> set = textsOf(*root.member("set"));
  std::vector<SpelledAnswer> all;
  root.member("spellings")->forEachElement([&](const JsonValue& row, std::size_t) {
    const std::vector<std::string> cells = textsOf(row);
    const std::string& kind = cells[2];
    AnswerField field;
    field.name = "x";
    field.kind = kind == "integer"  ? FieldKind::integer
                 : kind == "choice" ? FieldKind::choice
                 : kind == "set"    ? FieldKind::set
                                    : FieldKind::number;
    if (field.kind == FieldKind::number && kind != "number") field.unit = kind;
    if (field.kind == FieldKind::choice) field.options = choices;
    if (field.kind == FieldKind::set) field.options = set;
    SpelledAnswer spelled{cells[0], cells[4], "“" + cells[0] + "” for " + cells[1] + " (" + cells[3] + ")",
                          asked};
    spelled.question.comma = cells[3] == "en" ? CommaUse::ambiguous : CommaUse::decimal;
    spelled.question.fields = {field};
    spelled.question.solution = {cells[1]};
    spelled.question.accepted = {{Test::values, {}, {{cells[1]}}}};
    all.push_back(std::move(spelled));
  });
  return all;
}

}  // namespace geargraph::test
