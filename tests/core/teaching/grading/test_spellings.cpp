#include <QTest>
#include <map>

#include "core/teaching/grading/grade.h"
#include "tests/core/support/spellings.h"

namespace geargraph {

/// The corpus of spellings, which the grader of handouts reads as well (handout.grader).
class SpellingsTest : public QObject {
  Q_OBJECT

  static std::string outcome(const Verdict& verdict) {
    return verdict.isRight        ? "right"
           : verdict.isBlank      ? "blank"
           : verdict.isUnreadable ? "unreadable"
                                  : "wrong";
  }

 private slots:
  void everySpellingHasItsVerdict() {
    std::map<std::string, int> counts;
    std::string faults;
    for (const test::SpelledAnswer& spelled : test::spelledAnswers()) {
      const Verdict verdict = grade(spelled.question, {spelled.text});
      ++counts[spelled.verdict];
      if (outcome(verdict) != spelled.verdict)
        faults += spelled.place + ": " + outcome(verdict) + ", not " + spelled.verdict + '\n';
      if (verdict.isUnreadable && (!verdict.mistake || verdict.wrongFields != std::vector<int>{0}))
        faults += spelled.place + ": no place\n";
    }
    QVERIFY2(faults.empty(), faults.c_str());
    QVERIFY(counts["right"] >= 250 && counts["wrong"] >= 80 && counts["unreadable"] >= 80 &&
            counts["blank"] >= 5);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::SpellingsTest)
#include "test_spellings.moc"
