#include <QTest>
#include <map>
#include <set>

#include "core/teaching/exercises/exercise_sheet.h"
#include "core/teaching/grading/conditions.h"
#include "core/teaching/grading/grade.h"
#include "core/teaching/grading/mistake_names.h"
#include "core/teaching/grading/question_json.h"
#include "core/teaching/grading/wrong_answers.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/train_sketch.h"

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

  /// The same answer in other notations.
  static std::vector<std::vector<std::string>> notations(const Question& question,
                                                         const std::vector<std::string>& answer) {
    std::vector<std::vector<std::string>> all(3, answer);
    for (std::size_t i = 0; i < answer.size(); ++i) {
      const AnswerField& field = question.fields[i];
      if (answer[i].empty()) continue;
      if (field.kind == FieldKind::set) {
        QStringList words = QString::fromStdString(answer[i]).split(',');
        std::reverse(words.begin(), words.end());
        all[0][i] = words.join("; ").toStdString();
        all[1][i] = "{" + words.join(' ').toStdString() + "}";
      } else if (field.kind != FieldKind::choice) {
        const Rational value = *Rational::fromText(answer[i]);
        QString print = QString::fromStdString(answer[i]);
        all[0][i] = " " + print.replace('-', "−").toStdString() + " ";
        all[1][i] = (value * 7).toString() + "/7";
        all[2][i] = value.sign() < 0 ? "-(" + value.abs().toString() + ")" : "+" + value.toString() + "·1";
      }
    }
    return all;
  }

  void checkRight(const Question& question, const std::vector<std::string>& answer) {
    const Verdict verdict = grade(question, answer);
    QVERIFY2(verdict.isRight && verdict.points == question.points, shown(question, answer).c_str());
    ++m_counts.rightAnswers;
  }

  void checkRightAnswers(const Question& question) {
    std::vector<std::vector<std::string>> right{question.solution};
    const Condition& first = question.accepted.front();
    if (question.accepted.size() == 1 && first.fields.empty() && first.test == Test::values)
      right = first.values;
    if (first.test == Test::multiple) {
      for (const Rational& factor : {Rational(-1), Rational(1, 12), Rational(-7, 3)}) {
        right.push_back({});
        for (const std::string& value : question.solution)
          right.back().push_back((factor * *Rational::fromText(value)).toString());
      }
    }
    if (first.test == Test::rows) {
      const auto width = static_cast<std::ptrdiff_t>(first.values.front().size());
      std::vector<std::string> turned = question.solution;
      std::rotate(turned.begin(), turned.begin() + width, turned.end());
      for (std::ptrdiff_t i = 0; i < width; ++i) {
        std::string& value = turned[static_cast<std::size_t>(i)];
        value = (-*Rational::fromText(value)).toString();
      }
      right.push_back(turned);
    }
    for (const auto& answer : right) {
      checkRight(question, answer);
      for (const auto& other : notations(question, answer)) checkRight(question, other);
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
      std::vector<std::string> answer = question.solution;
      const int changes = random.between(1, 3);
      for (int i = 0; i < changes; ++i) {
        const auto at = static_cast<std::size_t>(random.below(static_cast<int>(answer.size())));
        const AnswerField& field = question.fields[at];
        answer[at] =
            field.options.empty() ? std::to_string(random.between(-2, 2)) : random.oneOf(field.options);
      }
      if (answer == question.solution) continue;
      QVERIFY2(!grade(question, answer).isRight, shown(question, answer).c_str());
      ++m_counts.randomAnswers;
    }
  }

  void checkMechanism(const Mechanism& mechanism, std::uint64_t seeds) {
    if (mechanism.n() > kMostExerciseLinks) return;
    const ExerciseSource source(mechanism);
    for (const ExerciseKind kind : offeredKinds(source)) {
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        ExerciseRandom random(seed, static_cast<std::uint64_t>(mechanism.n()),
                              static_cast<std::uint64_t>(kind));
        const Question question = makeQuestion(source, kind, random);
        QCOMPARE(question.kind, std::string(kindName(kind)));
        QCOMPARE(question.solution.size(), question.fields.size());
        std::set<std::string> names;
        for (const AnswerField& field : question.fields) QVERIFY(names.insert(field.name).second);
        for (const Mistake& mistake : question.mistakes) QVERIFY(!mistakeTitle(mistake.name).empty());
        checkRightAnswers(question);
        checkMistakes(question);
        checkRandomAnswers(question, random);
        if (QTest::currentTestFailed()) return;
        ++m_counts.questions;
        m_counts.kinds.insert(question.kind);
      }
    }
  }

 private slots:
  void examples() {
    for (const std::string& name : test::exampleNames()) checkMechanism(test::example(name), 6);
  }
  /// Sets of couplings that no state engages make ratios of their own.
  void gearboxesWithFewStates() {
    for (const std::size_t first : {0, 3, 6}) {
      Mechanism box = test::eightSpeed();
      box.states = {box.states[first], box.states[first + 1]};
      checkMechanism(box, 4);
    }
  }
  void textbookTrains() {
    for (const test::TextbookTrain& train : test::textbookTrains()) checkMechanism(train.mechanism, 2);
  }
  void planetarySets() {
    for (int planets = 1; planets <= 5; ++planets)
      checkMechanism(test::planetary(20 + planets, 17, planets), 3);
  }
  void randomTrains() {
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
      const int n = 2 + static_cast<int>(seed % 11);
      checkMechanism(test::randomTrain(seed, n, 1 + static_cast<int>(seed % static_cast<std::uint64_t>(n))),
                     1);
    }
  }
  void randomDigraphs() {
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
      checkMechanism(test::randomTree(seed, 2 + static_cast<int>(seed % 9), 1 + static_cast<int>(seed % 4)),
                     1);
  }

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
    const std::set<std::string> ofAnyAnswer{"unanswered", "not-a-number", "ambiguous-number", "not-a-choice"};
    std::string missing;
    for (const MistakeName& mistake : mistakeNames()) {
      const std::string name(mistake.name);
      if (!m_counts.told.contains(name) && !ofAnyAnswer.contains(name)) missing += name + ' ';
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
