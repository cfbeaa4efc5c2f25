#include <QAbstractItemModelTester>
#include <QRegularExpression>
#include <QTest>

#include "core/mechanism/model/edits.h"
#include "tests/core/support/example_files.h"
#include "ui/models/printed_number.h"
#include "ui/models/results_model.h"

namespace geargraph {
namespace {

/// The paper's robot, driven as its Eq. (25) has it.
Mechanism drivenRobot() {
  return test::example("robot");
}

}  // namespace

class ResultsModelTest : public QObject {
  Q_OBJECT

  [[nodiscard]] static QStringList row(const ResultsModel& model, int i) {
    QStringList texts;
    for (int j = 1; j < model.columnCount(); ++j) texts << model.index(i, j).data().toString();
    return texts;
  }

 private slots:
  void showsEq25InSymbolsAndFractions() {
    ResultsModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    const SnapshotPtr live = analyzeLive(std::make_shared<const Mechanism>(drivenRobot()));
    model.setSnapshot(live);
    QVERIFY(live->matroid() != nullptr && live->matroid()->solution);
    QCOMPARE(model.rowCount(), 4);
    QCOMPARE(row(model, 0), (QStringList{"−0.5", "0", "0", "−0.5"}));  // numbers at once

    model.setSnapshot(analyzeFully(live));
    QVERIFY(model.hasSymbols());
    QCOMPARE(row(model, 0), (QStringList{"-i15", "0", "0", "−1/2"}));
    QCOMPARE(row(model, 1), (QStringList{"-i16*i15", "-i16", "0", "−2/3"}));
    QCOMPARE(row(model, 2), (QStringList{"-i17*i16*i15", "-i17*i16", "-i17", "−8/9"}));
    QCOMPARE(row(model, 3), (QStringList{"-i18*i17*i16*i15", "-i18*i17*i16", "-i18*i17", "−16/27"}));
    model.setSymbolic(false);
    QCOMPARE(row(model, 1), (QStringList{"−1/3", "−2/3", "0", "−2/3"}));
  }

  /// Ctrl+C in a table that has no current cell asks for one that is not there.
  void noCellHasNoTextAndNoWarning() {
    QTest::failOnWarning(QRegularExpression(QStringLiteral("not valid")));
    ResultsModel model;
    model.setSnapshot(analyze(std::make_shared<const Mechanism>(drivenRobot())));
    QVERIFY(model.index(0, 0).data().isValid());
    QVERIFY(!model.data({}, Qt::DisplayRole).isValid());
  }

  void knowsJointsAndLinks() {
    ResultsModel model;
    model.setSnapshot(analyze(std::make_shared<const Mechanism>(drivenRobot())));
    QCOMPARE(model.headerData(3, Qt::Horizontal).toString(), QStringLiteral("11"));
    QCOMPARE(model.headerData(4, Qt::Horizontal).toString(), QStringLiteral("now"));
    QCOMPARE(model.outputAt(1), ElementId(JointId("12")));
    QCOMPARE(model.inputAt(2), ElementId(JointId("11")));
    QCOMPARE(model.linkAt(1), ElementId(LinkId("2")));
    QCOMPARE(model.index(1, 0).data(ResultsModel::LinkLabelRole).toInt(), 2);
    QVERIFY(model.index(0, 2).data(ResultsModel::ZeroRole).toBool());
  }

  void withoutSolutionThereAreNoRows() {
    ResultsModel model;
    model.setSnapshot(analyze(std::make_shared<const Mechanism>(emptyMechanism())));
    QCOMPARE(model.rowCount(), 0);
    model.setSnapshot(
        analyze(std::make_shared<const Mechanism>(withLink(drivenRobot(), CanvasPoint{}).value())));
    QCOMPARE(model.rowCount(), 0);
    QCOMPARE(model.columnCount(), 0);
  }

  void longFractionsAreToldInDigits() {
    QCOMPARE(printedFraction(Rational(-16, 27)), QStringLiteral("−16/27"));
    QCOMPARE(printedFraction(Rational(1'234'567, 7'654'321)), QStringLiteral("0.16129"));
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::ResultsModelTest)
#include "test_results_model.moc"
