#include <QTest>
#include <map>
#include <set>

#include "core/teaching/exercises/exercise_source.h"
#include "core/teaching/grading/grade.h"
#include "core/teaching/grading/question_json.h"
#include "tests/core/support/exercise_corpus.h"
#include "tests/core/support/pseudo_language.h"

namespace geargraph {
namespace {

std::vector<std::string> namesIn(const Mechanism& mechanism) {
  std::vector<std::string> names{"rad"};
  for (const ShiftElement& coupling : mechanism.couplings) names.push_back(coupling.id.text());
  for (const ShiftState& state : mechanism.states) names.push_back(state.name);
  return names;
}

/// Every text of a question that people read.
std::vector<std::string> textsOf(const Question& question) {
  std::vector<std::string> texts{question.prompt, question.rule};
  for (const Mistake& mistake : question.mistakes) texts.push_back(mistake.reason);
  if (!question.table.columns.empty()) return texts;  // its fields are named by labels
  for (const AnswerField& field : question.fields) {
    texts.push_back(field.shownName());
    texts.insert(texts.end(), field.options.begin(), field.options.end());
  }
  return texts;
}

template <class Visit>
void visitCorpus(const Visit& visit) {
  test::visitExamples(visit);
  test::visitGearboxesWithFewStates(visit);
  test::visitPlanetarySets(visit);
  test::visitDrives(visit);
}

}  // namespace

/// The words of exercises are looked up in the catalogue, all of them.
class ExerciseWordsTest : public QObject {
  Q_OBJECT

  static void verifyTranslated(const std::string& text, const std::vector<std::string>& names = {}) {
    const auto words = test::PseudoLanguage::english(text, names);
    QVERIFY2(words.empty(), (text + " [" + (words.empty() ? "" : words.front()) + ']').c_str());
  }

 private slots:
  void questionsOfEveryKindAreTranslated() {
    const test::PseudoLanguage pseudo;
    std::set<ExerciseKind> asked;
    visitCorpus([&](const Mechanism& mechanism, std::uint64_t seeds) {
      const std::vector<std::string> names = namesIn(mechanism);
      test::visitQuestions(mechanism, seeds, [&](const Question& question, ExerciseKind kind, auto&) {
        asked.insert(kind);
        for (const std::string& text : textsOf(question)) verifyTranslated(text, names);
      });
    });
    QCOMPARE(asked.size(), allExerciseKinds().size());
  }

  void titlesHintsAndReasonsAreTranslated() {
    const test::PseudoLanguage pseudo;
    for (const ExerciseKind kind : allExerciseKinds()) {
      verifyTranslated(kindTitle(kind));
      verifyTranslated(kindHint(kind));
    }
    visitCorpus([&](const Mechanism& mechanism, std::uint64_t) {
      const ExerciseSource source(mechanism);
      verifyTranslated(difficultyOf(source).text);
      for (const ExerciseKind kind : allExerciseKinds())
        if (const auto reason = reasonAgainst(source, kind)) verifyTranslated(*reason);
    });
  }

  void answersThatCannotBeReadAreTranslated() {
    const test::PseudoLanguage pseudo;
    Question question;
    question.fields = {{"n", FieldKind::integer}, {"c", FieldKind::choice, {"a", "b"}}};
    question.solution = {"1", "a"};
    question.accepted = {{Test::values, {}, {question.solution}}};
    for (const auto& answer :
         std::vector<std::vector<std::string>>{{"", "a"}, {"1,234", "a"}, {"?", "a"}, {"1", "z"}})
      verifyTranslated(grade(question, answer).reason);
  }

  /// What files and scripts read is the same in every language, and grades an answer alike.
  void namesStayWhatTheyAre() {
    visitCorpus([&](const Mechanism& mechanism, std::uint64_t) {
      std::vector<Question> english;
      test::visitQuestions(mechanism, 1,
                           [&](const Question& q, ExerciseKind, auto&) { english.push_back(q); });
      const test::PseudoLanguage pseudo;
      std::size_t i = 0;
      test::visitQuestions(mechanism, 1, [&](const Question& other, ExerciseKind, auto&) {
        const Question& same = english.at(i++);
        QCOMPARE(other.kind, same.kind);
        QCOMPARE(other.fields.size(), same.fields.size());
        for (std::size_t f = 0; f < same.fields.size(); ++f)
          QCOMPARE(other.fields[f].name, same.fields[f].name);
        QVERIFY(grade(other, other.solution).isRight);
        QCOMPARE(other.mistakes.size(), same.mistakes.size());
        for (std::size_t m = 0; m < same.mistakes.size(); ++m)
          QCOMPARE(other.mistakes[m].name, same.mistakes[m].name);
      });
    });
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::ExerciseWordsTest)
#include "test_exercise_words.moc"
