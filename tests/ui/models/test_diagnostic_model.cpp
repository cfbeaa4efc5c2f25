#include <QAbstractItemModelTester>
#include <QTest>

#include "ui/models/diagnostic_model.h"

namespace geargraph {

class DiagnosticModelTest : public QObject {
  Q_OBJECT

 private slots:
  void errorsStandFirst() {
    DiagnosticModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setDiagnostics({{Code::noMeshes, "No meshes.", {}, {}, 0, 0},
                          {Code::locked, "Locked.", {MeshId("15")}, {}, 0, 0},
                          {Code::disconnected, "Loose.", {LinkId("3"), LinkId("7")}, {}, 0, 0}});
    QCOMPARE(model.rowCount(), 3);
    QCOMPARE(model.index(0).data().toString(), QStringLiteral("Loose."));
    QCOMPARE(model.index(0).data(DiagnosticModel::CodeRole).toString(), QStringLiteral("disconnected"));
    QCOMPARE(model.index(0).data(Qt::ToolTipRole).toString(), QStringLiteral("Code: disconnected"));
    QCOMPARE(model.index(2).data(DiagnosticModel::SeverityRole).toInt(), static_cast<int>(Severity::info));
    QVERIFY(model.index(0).data(DiagnosticModel::UnfinishedRole).toBool());
    QCOMPARE(model.index(0).data(DiagnosticModel::SeverityRole).toInt(), static_cast<int>(Severity::info));
    QVERIFY(!model.index(1).data(DiagnosticModel::UnfinishedRole).toBool());
    QCOMPARE(model.elementsOf(model.index(0)), (std::set<ElementId>{LinkId("3"), LinkId("7")}));
    QVERIFY(model.elementsOf(QModelIndex()).empty());
  }

  void numbersHaveAMinusSign() {
    DiagnosticModel model;
    model.setDiagnostics({{Code::noMeshes, "Shift -0.5 at (0, -1) in a-1, T-T, 1-2, x_-3.", {}, {}, 0, 0}});
    QCOMPARE(model.index(0).data().toString(),
             QStringLiteral("Shift −0.5 at (0, −1) in a-1, T-T, 1-2, x_-3."));
  }

  void placesAreSaid() {
    DiagnosticModel model;
    model.setDiagnostics(
        {{Code::syntax, "Not JSON.", {}, {}, 3, 7}, {Code::schema, "Missing.", {}, "/links/2/id", 9, 1}});
    QCOMPARE(model.index(0).data(DiagnosticModel::PlaceRole).toString(), QStringLiteral("line 3, column 7"));
    QCOMPARE(model.index(1).data(DiagnosticModel::PlaceRole).toString(),
             QStringLiteral("line 9, column 1 · /links/2/id"));
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::DiagnosticModelTest)
#include "test_diagnostic_model.moc"
