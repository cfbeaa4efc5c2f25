#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "core/mechanism/model/edits.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/snapshot_of.h"
#include "ui/models/matrix_model.h"

namespace geargraph {
namespace {

using test::snapshotOf;

QString shown(const MatrixModel& model, int row, int column) {
  return model.index(row, column).data().toString();
}

}  // namespace

class MatrixModelTest : public QObject {
  Q_OBJECT

 private slots:
  void keepsTheRulesOfModels() {
    MatrixModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setSnapshot(snapshotOf(test::robotTopology()));
    for (const NamedResult* result : namedResults()) model.setResult(*result);
    model.setResult(resultOf(MatrixKind::cutset));
    model.setSnapshot(snapshotOf(emptyMechanism()));
    model.setSnapshot(snapshotOf(test::randomTree(3, 12, 7)));
    model.setPreview(
        previewOf(test::robotTopology(), {ElementKind::gearMesh, LinkId("3"), LinkId("6"), true}));
    model.setPreview(std::nullopt);
  }

  void showsEntriesWithLabels() {
    MatrixModel model;
    model.setSnapshot(snapshotOf(test::robotTopology()));
    QCOMPARE(model.rowCount(), 4);
    QCOMPARE(model.columnCount(), 11);
    QCOMPARE(model.partition(), 7);
    QCOMPARE(model.headerData(1, Qt::Vertical).toString(), QStringLiteral("C16"));
    QCOMPARE(model.headerData(10, Qt::Horizontal).toString(), QStringLiteral("18"));
    QCOMPARE(shown(model, 1, 2), QStringLiteral("−1"));
    QCOMPARE(model.index(1, 2).data(MatrixModel::ValueRole).toInt(), -1);
    QVERIFY(model.explanation(model.index(1, 2)).title == "C16, joint 10: −1");
  }

  void withoutTreeOnlyIncidenceIsThere() {
    auto loose = withLink(test::robotTopology(), CanvasPoint{});
    MatrixModel model;
    model.setSnapshot(snapshotOf(std::move(loose).value()));
    QVERIFY(model.table() == nullptr);
    QCOMPARE(model.rowCount(), 0);
    model.setResult(resultOf(MatrixKind::incidence));
    QCOMPARE(model.rowCount(), 9);
  }

  void aCycleLightsUpAsAWhole() {
    MatrixModel model;
    model.setSnapshot(snapshotOf(test::robotTopology()));
    const std::set<ElementId> cycle{JointId("9"), JointId("10"), JointId("12"), MeshId("16")};
    QCOMPARE(model.elementsOfCell(1, 0), cycle);
    model.setResult(resultOf(MatrixKind::incidence));
    QCOMPARE(model.elementsOfCell(4, 0), (std::set<ElementId>{LinkId("4"), JointId("8")}));
  }

  void previewAddsTheMeshBeingDrawn() {
    MatrixModel model;
    const Mechanism robot = test::robotTopology();
    model.setSnapshot(snapshotOf(robot));
    model.setPreview(previewOf(robot, {ElementKind::gearMesh, LinkId("3"), LinkId("6"), true}));
    QCOMPARE(model.rowCount(), 5);
    QCOMPARE(model.columnCount(), 12);
    QVERIFY(model.headerData(11, Qt::Horizontal, MatrixModel::PreviewRole).toBool());
    QVERIFY(model.headerData(4, Qt::Vertical, MatrixModel::PreviewRole).toBool());
    QVERIFY(!model.headerData(10, Qt::Horizontal, MatrixModel::PreviewRole).toBool());
    QVERIFY(model.index(4, 4).data(MatrixModel::PreviewRole).toBool());
    QVERIFY(!model.index(1, 2).data(MatrixModel::PreviewRole).toBool());
    model.setPreview(std::nullopt);
    QCOMPARE(model.rowCount(), 4);
  }

  void previewOfATurningJointRenumbersTheMeshes() {
    auto loose = withLink(test::robotTopology(), CanvasPoint{});
    MatrixModel model;
    model.setResult(resultOf(MatrixKind::incidence));
    model.setSnapshot(snapshotOf(*loose));
    const LinkId added = loose->links.back().id;
    model.setPreview(previewOf(*loose, {ElementKind::turningJoint, LinkId("3"), added, true}));
    QCOMPARE(model.columnCount(), 12);
    QCOMPARE(model.headerData(7, Qt::Horizontal).toString(), QStringLiteral("16"));
    QVERIFY(model.headerData(7, Qt::Horizontal, MatrixModel::PreviewRole).toBool());
    QCOMPARE(shown(model, 3, 7), QStringLiteral("−1"));
    QCOMPARE(shown(model, 8, 7), QStringLiteral("1"));
  }

  void noPreviewOfWhatWouldBeRejected() {
    const Mechanism robot = test::robotTopology();
    QVERIFY(!previewOf(robot, {ElementKind::turningJoint, LinkId("3"), LinkId("6"), true}));  // a loop
    QVERIFY(!previewOf(robot, {ElementKind::gearMesh, LinkId("3"), LinkId(), false}));
    QVERIFY(!previewOf(robot, {ElementKind::gearMesh, LinkId("3"), LinkId("6"), false}));
  }

  void changedCellsGlowAndStop() {
    MatrixModel model;
    const Mechanism robot = test::robotTopology();
    model.setSnapshot(snapshotOf(robot));
    model.setSnapshot(snapshotOf(withFlipped(robot, JointId("10")).value()));
    QVERIFY(model.index(0, 2).data(MatrixModel::ChangedRole).toBool());   // -1 became 1
    QVERIFY(!model.index(0, 0).data(MatrixModel::ChangedRole).toBool());  // still 1
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    QVERIFY(changed.wait(10 * MatrixModel::kGlowMilliseconds));
    QVERIFY(!model.index(0, 2).data(MatrixModel::ChangedRole).toBool());
  }

  void changesAreKnownByIdsNotPlaces() {
    MatrixModel model;
    model.setResult(resultOf(MatrixKind::incidence));
    const Mechanism robot = test::robotTopology();
    model.setSnapshot(snapshotOf(robot));
    const ElementId gone[] = {ElementId(MeshId("15"))};
    model.setSnapshot(snapshotOf(withoutElements(robot, gone).value()));
    for (int row = 0; row < model.rowCount(); ++row) {
      for (int column = 0; column < model.columnCount(); ++column) {
        QVERIFY(!model.index(row, column).data(MatrixModel::ChangedRole).toBool());
      }
    }
  }

  /// Teeth are in no matrix of whole numbers: nothing is painted anew while they are dragged.
  void aChangeOfTeethChangesNoMatrix() {
    MatrixModel model;
    const Mechanism robot = test::robotTopology();
    model.setSnapshot(snapshotOf(robot));
    const QSignalSpy data(&model, &QAbstractItemModel::dataChanged);
    const QSignalSpy matrix(&model, &MatrixModel::matrixChanged);
    const SnapshotPtr next = snapshotOf(withTeeth(robot, MeshId("15"), 20, 40).value());
    model.setSnapshot(next);
    QCOMPARE(data.count() + matrix.count(), 0);
    QCOMPARE(model.table()->integers(), next->matrix(MatrixKind::cycleBasis));
    model.setSnapshot(snapshotOf(withFlipped(robot, JointId("10")).value()));
    QCOMPARE(matrix.count(), 1);
  }

  void sameShapeIsNoReset() {
    MatrixModel model;
    const Mechanism robot = test::robotTopology();
    model.setSnapshot(snapshotOf(robot));
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    model.setSnapshot(snapshotOf(withTeeth(robot, MeshId("15"), 20, 40).value()));
    QCOMPARE(reset.count(), 0);
    model.setSnapshot(snapshotOf(emptyMechanism()));
    QCOMPARE(reset.count(), 1);
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::MatrixModelTest)
#include "test_matrix_model.moc"
