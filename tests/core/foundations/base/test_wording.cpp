#include <QTest>

#include "core/foundations/base/text_lists.h"

using namespace geargraph;

class WordingTest : public QObject {
  Q_OBJECT

 private slots:
  void namesAreListedAsInASentence() {
    QCOMPARE(listed({}, kAllNames), std::string());
    QCOMPARE(listed({"8"}, kAllNames), std::string("8"));
    QCOMPARE(listed({"8", "9"}, kAllNames), std::string("8 and 9"));
    QCOMPARE(listed({"8", "9", "12"}, kAllNames), std::string("8, 9 and 12"));
    QCOMPARE(listed({"8", "9", "12"}, kAllNames, "or"), std::string("8, 9 or 12"));
  }

  void ofManyTheFirstAreNamedAndTheOthersCounted() {
    QCOMPARE(listed({"8", "9", "12"}, 3), std::string("8, 9 and 12"));
    QCOMPARE(listed({"8", "9", "12", "13"}, 2), std::string("8, 9 and 2 more"));
  }

  void xmlKeepsTheTextAndNothingElse() {
    QCOMPARE(escapedXml("a<b>\"c\"&d"), std::string("a&lt;b&gt;&quot;c&quot;&amp;d"));
    QCOMPARE(escapedXml("sun\tω\x01"), std::string("sun ω "));
  }
};

QTEST_APPLESS_MAIN(WordingTest)
#include "test_wording.moc"
