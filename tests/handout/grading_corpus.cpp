// Writes questions with their keys, answers to them, and what core/teaching/grading says of these: a line of
// JSON a question,
// {"question": ..., "cases": [{"answer": [...], "verdict": {...}}, ...]}. The test handout.grader holds the
// grader of handouts against it.

#include <array>
#include <iostream>

#include "core/foundations/files/json_writer.h"
#include "core/teaching/grading/grade.h"
#include "core/teaching/grading/question_json.h"
#include "core/teaching/grading/wrong_answers.h"
#include "tests/core/support/exercise_corpus.h"
#include "tests/core/support/spellings.h"

namespace geargraph {
namespace {

constexpr auto kRow = JsonWriter::Layout::row;
constexpr std::uint64_t kMaxSeeds = 1;  ///< of a kind; the test of core takes more

/// Texts that are hard to read, or none of what is asked for.
constexpr std::array<const char*, 56> kOddTexts = {"",
                                                   " ",
                                                   "1,250",
                                                   "0,250",
                                                   "1.250",
                                                   "1,25",
                                                   "12,345,678",
                                                   "1.2.3",
                                                   "1,2.3",
                                                   "1 / 3",
                                                   "1:3",
                                                   "--1",
                                                   "+-1",
                                                   "- 1",
                                                   "1/0",
                                                   "0/5",
                                                   "(1",
                                                   "1)",
                                                   "((1))",
                                                   "-(2/3)·4",
                                                   "2(3)",
                                                   "1e5",
                                                   "0x1",
                                                   "½",
                                                   "\u22121",
                                                   "\u2013\u22121",
                                                   "\u00a01\u202f",
                                                   "1\t",
                                                   "\n1\r\n",
                                                   "1\n2",
                                                   ".5",
                                                   "5.",
                                                   ".",
                                                   "-",
                                                   "00012",
                                                   "000",
                                                   "0.333",
                                                   "0.3333",
                                                   "-0.667",
                                                   "0,66",
                                                   "1.000",
                                                   "1\u00d72",
                                                   "6\u00f73",
                                                   "6\u20443",
                                                   "one",
                                                   "x",
                                                   "8 9",
                                                   "8;;9,",
                                                   "{8, 9}",
                                                   "{",
                                                   "8,8,8",
                                                   "8,9,10,11,12",
                                                   "A",
                                                   "\u0663",
                                                   "1+1",
                                                   "3-2-1"};

std::string deep(int parentheses) {
  return std::string(static_cast<std::size_t>(parentheses), '(') + "1" +
         std::string(static_cast<std::size_t>(parentheses), ')');
}

void writeTexts(JsonWriter& json, std::string_view key, const std::vector<std::string>& texts) {
  json.key(key);
  json.beginArray(kRow);
  for (const std::string& text : texts) json.string(text);
  json.endArray();
}

void writeFields(JsonWriter& json, std::string_view key, const std::vector<int>& fields) {
  json.key(key);
  json.beginArray(kRow);
  for (const int field : fields) json.number(static_cast<std::int64_t>(field));
  json.endArray();
}

void writeMistake(JsonWriter& json, const FoundMistake& mistake) {
  json.beginObject(kRow);
  json.member("name", mistake.name);
  writeFields(json, "fields", mistake.fields);
  std::vector<std::string> elements;
  for (const ElementId& element : mistake.elements)
    elements.push_back(std::string(listName(element.kind)) + '/' + element.id.text());
  writeTexts(json, "elements", elements);
  json.member("reason", mistake.reason);
  json.endObject();
}

void writeCase(JsonWriter& json, const Question& question, const test::AnswerTexts& answer) {
  const Verdict verdict = grade(question, answer);
  json.beginObject(kRow);
  writeTexts(json, "answer", answer);
  json.key("verdict");
  json.beginObject(kRow);
  json.member("isRight", verdict.isRight);
  json.member("isBlank", verdict.isBlank);
  json.member("isUnreadable", verdict.isUnreadable);
  json.member("points", verdict.points);
  json.key("mistakes");
  json.beginArray(kRow);
  if (verdict.mistake) writeMistake(json, *verdict.mistake);
  for (const FoundMistake& mistake : verdict.others) writeMistake(json, mistake);
  json.endArray();
  writeFields(json, "wrongFields", verdict.wrongFields);
  json.member("reason", verdict.reason);
  json.endObject();
  json.endObject();
}

/// The solution with odd texts in one field or two, other ones each time.
void writeOddCases(JsonWriter& json, const Question& question, ExerciseRandom& random) {
  static std::size_t next = 0;
  const int fields = static_cast<int>(question.fields.size());
  for (int round = 0; round < 12; ++round) {
    test::AnswerTexts answer = question.solution;
    for (int changes = random.between(1, 2); changes > 0; --changes)
      answer[static_cast<std::size_t>(random.below(fields))] = kOddTexts[next++ % kOddTexts.size()];
    writeCase(json, question, answer);
  }
  for (const char* separator : {",", ";", "\t"}) {
    test::AnswerTexts answer(question.solution.size());
    answer.front() = test::joined(question.solution, separator);
    writeCase(json, question, answer);
  }
  for (const std::string& text : {deep(20), deep(21), std::string(200, '7'), std::string(201, '7')}) {
    test::AnswerTexts answer = question.solution;
    answer.back() = text;
    writeCase(json, question, answer);
  }
}

void writeOneLine(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());  // within texts they are escaped
  std::cout << text << '\n';
}

void writeLine(const Question& question, ExerciseRandom& random) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.key("question");
    writeQuestion(json, question, QuestionPart::withKey);
    json.key("cases");
    json.beginArray();
    for (const test::AnswerTexts& answer : test::rightAnswers(question)) {
      writeCase(json, question, answer);
      for (const test::AnswerTexts& other : test::notations(question, answer))
        writeCase(json, question, other);
    }
    for (const Mistake& mistake : question.mistakes) {
      if (const auto answer = wrongAnswer(question, mistake)) writeCase(json, question, *answer);
    }
    for (int round = 0; round < 4; ++round) writeCase(json, question, test::changedAnswer(question, random));
    writeOddCases(json, question, random);
    json.endArray();
    json.endObject();
  }
  writeOneLine(sink.take());
}

/// The corpus of spellings: a question of one field each.
void writeSpellings() {
  for (const test::SpelledAnswer& spelled : test::spelledAnswers()) {
    TextSink sink;
    {
      JsonWriter json(sink);
      json.beginObject();
      json.key("question");
      writeQuestion(json, spelled.question, QuestionPart::withKey);
      json.key("cases");
      json.beginArray();
      writeCase(json, spelled.question, {spelled.text});
      json.endArray();
      json.endObject();
    }
    writeOneLine(sink.take());
  }
}

void writeCorpus() {
  writeSpellings();
  const auto write = [](const Mechanism& mechanism, std::uint64_t seeds) {
    test::visitQuestions(
        mechanism, std::min(seeds, kMaxSeeds),
        [](const Question& question, ExerciseKind, ExerciseRandom& random) { writeLine(question, random); });
  };
  test::visitExamples(write);
  test::visitGearboxesWithFewStates(write);
  test::visitTextbookTrains(write);
  test::visitPlanetarySets(write);
  test::visitRandomTrains(write);
  test::visitRandomDigraphs(write);
}

}  // namespace
}  // namespace geargraph

int main() {
  std::ios::sync_with_stdio(false);
  geargraph::writeCorpus();
  return std::cout.flush() ? 0 : 1;
}
