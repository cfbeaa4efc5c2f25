#include <QTest>

#include "core/foundations/base/translation.h"

namespace geargraph {

class WordsTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { setCatalogue({}); }

  void withoutACatalogueTheTextIsItself() {
    QCOMPARE(translated("The ground"), std::string("The ground"));
    QCOMPARE(translated("%n of them", 3), std::string("3 of them"));
  }

  void theCatalogueIsAskedWithTheCount() {
    setCatalogue([](const char* text, int n) -> std::string {
      if (std::string_view(text) == "%n field(s)") return n == 1 ? "%n Feld" : "%n Felder";
      return std::string_view(text) == "The ground" ? "Das Gestell" : "";
    });
    QCOMPARE(translated("The ground"), std::string("Das Gestell"));
    QCOMPARE(translated("%n field(s)", 1), std::string("1 Feld"));
    QCOMPARE(translated("%n field(s)", 2), std::string("2 Felder"));
    QCOMPARE(translated("unknown"), std::string("unknown"));
  }

  void placesAreFilledInTheOrderOfTheLanguage() {
    QCOMPARE(filled("%1 from %2", {"a", "b"}), std::string("a from b"));
    QCOMPARE(filled("%2: %1, %1", {"a", "b"}), std::string("b: a, a"));
    QCOMPARE(filled("%1", {"%2", "b"}), std::string("%2"));  // what is put in is not read again
    QCOMPARE(filled("100 %, %3", {"a"}), std::string("100 %, %3"));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::WordsTest)
#include "test_words.moc"
