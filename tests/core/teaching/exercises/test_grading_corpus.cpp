#include <QTest>
#include <map>
#include <set>

#include "core/teaching/exercises/exercise_sheet.h"
#include "core/teaching/exercises/pair_teaching.h"
#include "core/teaching/grading/conditions.h"
#include "core/teaching/grading/grade.h"
#include "core/teaching/grading/mistake_names.h"
#include "core/teaching/grading/question_json.h"
#include "core/teaching/grading/wrong_answers.h"
#include "tests/core/support/exercise_corpus.h"

namespace geargraph {

/// Every mistake of every question on the examples, on textbook trains and on random ones.
class GradingCorpusTest : public QObject {
  Q_OBJECT

  struct Counts {
    long long questions = 0, rightAnswers = 0, mistakes = 0, coinciding = 0, unreached = 0, randomAnswers = 0;
    std::map<std::string, long long> told;
    std::map<std::string, long long> unreachedNames;
    std::set<std::string> kinds;
  };
  Counts m_counts;

  static std::string shown(const Question& question, const std::vector<std::string>& answer) {
    std::string text = question.kind + ": " + question.prompt + " [";
    for (const std::string& field : answer) text += field + " | ";
    return text + ']';
  }

  void checkRight(const Question& question, const std::vector<std::string>& answer) {
    const Verdict verdict = grade(question, answer);
    QVERIFY2(verdict.isRight && verdict.points == question.points, shown(question, answer).c_str());
    ++m_counts.rightAnswers;
  }

  void checkRightAnswers(const Question& question) {
    for (const auto& answer : test::rightAnswers(question)) {
      checkRight(question, answer);
      for (const auto& other : test::notations(question, answer)) checkRight(question, other);
    }
  }

  void checkMistakes(const Question& question) {
    for (const Mistake& mistake : question.mistakes) {
      const auto answer = wrongAnswer(question, mistake);
      if (!answer) {
        ++m_counts.unreached;
        ++m_counts.unreachedNames[mistake.name];
        continue;
      }
      const std::string text = shown(question, *answer);
      const ReadAnswer read = readAnswer(question, *answer);
      QVERIFY2(allHold(mistake.when, read), text.c_str());
      const Verdict verdict = grade(question, *answer);
      QVERIFY2(!verdict.isRight && verdict.mistake.has_value(), (mistake.name + " in " + text).c_str());
      QVERIFY2(!verdict.reason.empty() && verdict.points < question.points, text.c_str());
      ++m_counts.mistakes;
      ++m_counts.told[verdict.mistake->name];
      if (verdict.mistake->name == mistake.name) continue;
      // Then both explain this answer.
      const bool isExplained =
          std::any_of(question.mistakes.begin(), question.mistakes.end(), [&](const Mistake& m) {
            return m.name == verdict.mistake->name && m.reason == verdict.mistake->reason &&
                   allHold(m.when, read);
          });
      QVERIFY2(isExplained, (mistake.name + " told as " + verdict.mistake->name + " in " + text).c_str());
      ++m_counts.coinciding;
    }
  }

  /// Of questions with one right answer: whatever differs from it is wrong.
  void checkRandomAnswers(const Question& question, ExerciseRandom& random) {
    if (question.accepted.size() != 1 || question.accepted.front().test != Test::values ||
        question.accepted.front().values.size() != 1)
      return;
    for (int round = 0; round < 4; ++round) {
      const std::vector<std::string> answer = test::changedAnswer(question, random);
      if (answer == question.solution) continue;
      QVERIFY2(!grade(question, answer).isRight, shown(question, answer).c_str());
      ++m_counts.randomAnswers;
    }
  }

  void checkQuestion(const Question& question, ExerciseRandom& random) {
    QCOMPARE(question.solution.size(), question.fields.size());
    std::set<std::string> names;
    for (const AnswerField& field : question.fields) QVERIFY(names.insert(field.name).second);
    for (const AnswerField& field : question.fields) {
      const std::set<ElementId> lit(field.elements.begin(), field.elements.end());
      QVERIFY2(lit.size() == field.elements.size(), (question.kind + ": " + field.name).c_str());
    }
    for (const Mistake& mistake : question.mistakes) QVERIFY(!mistakeTitle(mistake.name).empty());
    checkRightAnswers(question);
    checkMistakes(question);
    checkRandomAnswers(question, random);
    ++m_counts.questions;
    m_counts.kinds.insert(question.kind);
  }

  auto checker() {
    return [this](const Mechanism& mechanism, std::uint64_t seeds) {
      test::visitQuestions(mechanism, seeds,
                           [this](const Question& question, ExerciseKind kind, ExerciseRandom& random) {
                             if (QTest::currentTestFailed()) return;
                             QCOMPARE(question.kind, std::string(kindName(kind)));
                             checkQuestion(question, random);
                           });
    };
  }

 private slots:
  void examples() { test::visitExamples(checker()); }
  void gearboxesWithFewStates() { test::visitGearboxesWithFewStates(checker()); }
  void textbookTrains() { test::visitTextbookTrains(checker()); }
  void planetarySets() { test::visitPlanetarySets(checker()); }
  void drives() { test::visitDrives(checker()); }
  void randomTrains() { test::visitRandomTrains(checker()); }
  void randomDigraphs() { test::visitRandomDigraphs(checker()); }

  /// JSON keeps what a grader needs: the same verdicts after reading.
  void verdictsSurviveJson() {
    const ExerciseSource source(test::example("ravigneaux"));
    const SheetVariant sheet = makeVariant(source, {"S", offeredKinds(source), 4, 1}, 1);
    const auto read = readQuestions(questionsJson(sheet.questions, QuestionPart::withKey));
    QVERIFY(read.has_value());
    QVERIFY(*read == sheet.questions);
  }

  /// The corpus is as large as it should be, and every mistake was told somewhere.
  void theCorpusIsComplete() {
    qInfo(
        "%lld questions of %zu kinds, %lld right answers, %lld mistakes (%lld told by another name that "
        "fits, "
        "%lld without an example), %lld random answers",
        m_counts.questions, m_counts.kinds.size(), m_counts.rightAnswers, m_counts.mistakes,
        m_counts.coinciding, m_counts.unreached, m_counts.randomAnswers);
    for (const auto& [name, count] : m_counts.unreachedNames)
      qInfo("without an example: %s %lld", name.c_str(), count);
    QCOMPARE(m_counts.kinds.size(), allExerciseKinds().size());
    const std::set<std::string> ofAnyAnswer{"unanswered",   "not-a-number",   "ambiguous-number",
                                            "not-a-choice", "unknown-symbol", "other-unit"};
    std::set<std::string_view> ofSlides;  // of which no questions are asked
    for (const MeshKind kind : meshKinds()) {
      if (slides(kind)) ofSlides.insert(pairTeachings()[kind].signMistake);
    }
    QCOMPARE(ofSlides.size(), std::size_t{2});
    std::string missing;
    for (const MistakeName& mistake : mistakeNames()) {
      const std::string name(mistake.name);
      if (!m_counts.told.contains(name) && !ofAnyAnswer.contains(name) && !ofSlides.contains(name))
        missing += name + ' ';
    }
    QVERIFY2(missing.empty(), missing.c_str());
    QVERIFY(m_counts.questions > 3'000);
    QVERIFY(m_counts.rightAnswers > 12'000);
    QVERIFY(m_counts.mistakes > 50'000);
    QVERIFY(m_counts.randomAnswers > 5'000);
    QVERIFY(m_counts.told.size() >= 60);
    QVERIFY(m_counts.coinciding * 5 < m_counts.mistakes);
    QVERIFY(m_counts.unreached * 50 < m_counts.mistakes);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::GradingCorpusTest)
#include "test_grading_corpus.moc"
