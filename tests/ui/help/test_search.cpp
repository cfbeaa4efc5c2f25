#include <QAbstractItemModelTester>
#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QTest>

#include "core/mechanism/model/edits.h"
#include "tests/core/support/mechanisms.h"
#include "ui/help/search_model.h"
#include "ui/help/word_match.h"

namespace geargraph {

class SearchTest : public QObject {
  Q_OBJECT

  QMenuBar menus;
  SearchModel model;

  [[nodiscard]] QString best(const QString& query) {
    model.setQuery(query);
    return model.rowCount() == 0 ? QString() : model.index(0).data().toString();
  }

 private slots:
  void initTestCase() {
    QMenu* file = menus.addMenu("&File");
    file->addAction("&Open…")->setShortcut(QKeySequence("Ctrl+O"));
    QMenu* examples = file->addMenu("Open e&xample");
    examples->addAction("robot");
    QMenu* mechanism = menus.addMenu("&Mechanism");
    mechanism->addAction("Turning joint");
    QAction* ground = mechanism->addAction("Make &ground");
    ground->setEnabled(false);
    mechanism->addAction("Gearbox")->setProperty(kSearchWords, "Brake clutch hold shift");
    mechanism->addAction("Speeds")->setProperty(kSearchWords, "plot graph");
    ground->setToolTip("Select one link to make it the ground.");

    std::vector<SearchEntry> entries = commandEntries(menus);
    Mechanism robot = *withName(test::robotTopology(), LinkId("4"), "Drive pinion");
    for (SearchEntry& entry : elementEntries(robot)) entries.push_back(std::move(entry));
    for (SearchEntry& entry : termEntries()) entries.push_back(std::move(entry));
    model.setEntries(std::move(entries));
  }

  void theModelKeepsItsContract() {
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setQuery("turning");
    model.setQuery("nothing is called so");
    QCOMPARE(model.rowCount(), 0);
  }

  void commandsAreFoundBySynonyms() {
    for (const char* word : {"brake", "hold", "clutch", "shift"}) QCOMPARE(best(word), QString("Gearbox"));
    QCOMPARE(best("plot"), QString("Speeds"));
    QCOMPARE(best("speeds"), QString("Speeds"));  // a name before another word for something else
    QCOMPARE(best("gear mesh 16"), QString("Gear mesh 16"));
  }

  void elementsAreFoundByLabelAndByName() {
    QCOMPARE(best("link 4"), QString("Link 4: Drive pinion"));
    QCOMPARE(best("pinion"), QString("Link 4: Drive pinion"));
    QCOMPARE(best("joint 12"), QString("Turning joint 12"));
    QCOMPARE(best("16"), QString("Gear mesh 16"));
    QCOMPARE(best("mesh 16"), QString("Gear mesh 16"));
    QCOMPARE(model.index(0).data(SearchModel::SideRole).toString(), QString("5 → 2"));
  }

  void commandsStandUnderTheirMenusNameAndShowTheirKeys() {
    QCOMPARE(best("open"), QString("Open"));
    QCOMPARE(model.index(0).data(SearchModel::SideRole).toString(),
             QKeySequence("Ctrl+O").toString(QKeySequence::NativeText));
    QCOMPARE(best("exam rob"), QString("Open example: robot"));
    QCOMPARE(best("mechanism turning"), QString("Turning joint"));
  }

  void whatIsNotPossibleSaysWhy() {
    QCOMPARE(best("make ground"), QString("Make ground"));
    QVERIFY(!model.index(0).data(SearchModel::EnabledRole).toBool());
    QCOMPARE(model.index(0).data(SearchModel::DetailRole).toString(),
             QString("Select one link to make it the ground."));
  }

  void termsAreFoundBySymbolAndInAsciiLetters() {
    QCOMPARE(best("cutset"), QString("Fundamental cutset matrix"));
    QCOMPARE(best("gamma0"), QString("Incidence matrix"));
  }

  void aSlipOfTheKeyboardIsForgiven_data() {
    QTest::addColumn<QString>("query");
    QTest::newRow("exchanged") << "tunring joint";
    QTest::newRow("left out") << "turnng joint";
    QTest::newRow("too many") << "turrning joint";
    QTest::newRow("another") << "turming joint";
    QTest::newRow("begun") << "tunrin";
  }
  void aSlipOfTheKeyboardIsForgiven() {
    QFETCH(QString, query);
    QVERIFY2(best(query).startsWith("Turning joint"), qPrintable(best(query)));
    QCOMPARE(best("trnuing joint"), QString());  // two slips are too many
  }

  void numbersAreNeverGuessed() {
    QCOMPARE(best("mesh 1666"), QString());
    QCOMPARE(matchScore("link 100", {"1000"}, true), 0);
  }

  void allWordsHaveToBeFound() {
    QVERIFY(matchScore("gear mesh 16", wordsOf("16 gear"), false) > 0);
    QCOMPARE(matchScore("gear mesh 16", wordsOf("16 joint"), false), 0);
    QVERIFY(matchScore("link 4", {"4"}, false) > matchScore("link 40", {"4"}, false));
    QVERIFY(matchScore("link 40", {"4"}, false) > matchScore("link 14", {"4"}, false));
  }

  void tenThousandLinksGiveTheBestHundred() {
    Mechanism large = emptyMechanism();
    for (int i = 1; i <= 10'000; ++i) {
      const std::string id = "L" + std::to_string(i);
      large.links.push_back({LinkId(id), {}, {}});
      large.turningJoints.push_back(
          {JointId("J" + std::to_string(i)), large.links.front().id, LinkId(id), AxisId("a"), Number(0), {}});
    }
    SearchModel wide;
    wide.setEntries(elementEntries(large));
    wide.setQuery("link 9876");
    QCOMPARE(wide.index(0).data().toString(), QString("Link 9876"));
    wide.setQuery("joint 15000");
    QCOMPARE(wide.entryAt(0).element, std::optional<ElementId>(JointId("J5000")));
    wide.setQuery("1");
    QCOMPARE(wide.rowCount(), SearchModel::kMax);
    QCOMPARE(wide.index(0).data().toString(), QString("Link 1"));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::SearchTest)
#include "test_search.moc"
