#include <QComboBox>
#include <QLabel>
#include <QStandardItemModel>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include "core/design/synthesis/drive_sets.h"
#include "tests/ui/panels/editing_panels.h"
#include "ui/panels/results_panel.h"

namespace geargraph {

/// Sliding joints in the window: their units, their form, and which kinds of meshes fit them.
class SlidingJointsTest : public QObject {
  Q_OBJECT

  EditingPanels panels;
  std::unique_ptr<ResultsPanel> results;

  void show(Mechanism mechanism) {
    panels.selection.clear();
    panels.document->replace(std::move(mechanism), {});
    settle();
  }
  void settle() {
    const SnapshotPtr snapshot = analyze(panels.document->mechanism(), panels.document->revision());
    panels.inputs->setSnapshot(snapshot);
    results->setSnapshot(snapshot);
  }
  [[nodiscard]] QStringList units() const {
    QStringList texts;
    for (const auto* label : panels.inputs->findChildren<QLabel*>())
      if (label->isVisible() && label->text().endsWith(QStringLiteral("/s"))) texts << label->text();
    return texts;
  }
  QString cell(int row, int column) { return results->model().index(row, column).data().toString(); }
  template <class Widget>
  Widget* shown(const char* name) {
    for (auto* each : panels.properties->findChildren<Widget*>(QLatin1String(name)))
      if (each->isVisible()) return each;
    return nullptr;
  }
  static void choose(QComboBox* box, int item) {
    box->setCurrentIndex(item);
    emit box->activated(item);
  }
  [[nodiscard]] const TurningJoint& joint(int at) const {
    return panels.document->mechanism()->turningJoints[static_cast<std::size_t>(at)];
  }

 private slots:
  void init() {
    panels.open();
    results = std::make_unique<ResultsPanel>(&panels.selection);
    results->resize(500, 300);
    results->show();
  }
  void cleanup() {
    results.reset();
    panels.close();
  }

  void ratesOfSlidesAreLengthsASecond() {
    show(*rackDrive({}));
    QCOMPARE(results->model().rowCount(), 1);
    QCOMPARE(cell(0, 2), QStringLiteral("−20 mm/s"));
    QCOMPARE(results->findChild<QToolButton*>(QStringLiteral("speedUnit"))->text(),
             QStringLiteral("rad/s, mm/s ▾"));
    QCOMPARE(units(), QStringList{QStringLiteral("rad/s")});
    const QString ratio = results->model().ratioText(0);
    QVERIFY2(ratio.endsWith(QStringLiteral("rad/mm")), qPrintable(ratio));
    show(*screwDrive({}));
    QCOMPARE(cell(0, 2), QStringLiteral("−5/2/π mm/s"));
    results->setAbsolute(true);
    const auto* links = results->findChild<QTableView*>(QStringLiteral("linkSpeeds"))->model();
    QCOMPARE(links->index(0, 1).data().toString(), QStringLiteral("1 rad/s about a"));
    QCOMPARE(links->index(1, 1).data().toString(), QStringLiteral("−5/2/π mm/s along a"));
  }

  void aDrivenSlideIsTypedInLengths() {
    Mechanism drive = *rackDrive({});
    drive.inputs->front().joint = drive.turningJoints[1].id;
    show(std::move(drive));
    QCOMPARE(units(), QStringList{QStringLiteral("mm/s")});
    NumberField* speed = panels.field(*panels.inputs, "speed.4");
    QVERIFY(speed != nullptr);
    EditingPanels::type(speed, QStringLiteral("3 m/min"));
    QCOMPARE(panels.document->mechanism()->inputs->front().speed.exact(), Rational(50));
    EditingPanels::type(speed, QStringLiteral("7"));
    QCOMPARE(panels.document->mechanism()->inputs->front().speed.exact(), Rational(7));
    EditingPanels::type(speed, QStringLiteral("1500 rpm"));
    QVERIFY(speed->property("wrong").toBool());
    settle();
    QCOMPARE(cell(0, 2), QStringLiteral("−7/20 rad/s"));
  }

  void theFormMakesAJointSlideAndUndoTakesItBack() {
    show(*rackDrive({}));
    panels.selection.select({ElementId(joint(1).id)});
    auto* kind = shown<QComboBox>("jointKind");
    QVERIFY(kind != nullptr);
    QCOMPARE(kind->currentIndex(), 1);
    EditingPanels::type(panels.numberOf("highLimit"), QStringLiteral("12 cm"));
    QCOMPARE(joint(1).limits.high->exact(), Rational(120));  // in the document's unit
    choose(kind, 0);
    QCOMPARE(joint(1).kind, JointKind::turning);
    QVERIFY(!joint(1).limits.any());  // 120 mm are no angle
    panels.document->undoStack().undo();
    QCOMPARE(joint(1).kind, JointKind::sliding);
    QCOMPARE(joint(1).limits.high->exact(), Rational(120));
    QCOMPARE(kind->currentIndex(), 1);
  }

  void kindsAreOfferedWhereTheyFit() {
    const auto item = [this](const char* kind) {
      auto* box = shown<QComboBox>("meshKind");
      const auto kinds = meshKinds();
      const auto at = std::find(kinds.begin(), kinds.end(), *meshKindFrom(kind)) - kinds.begin();
      return qobject_cast<QStandardItemModel*>(box->model())->item(static_cast<int>(at) + 1);
    };
    show(*rackDrive({}));
    panels.selection.select({ElementId(panels.document->mechanism()->gearMeshes.front().id)});
    QVERIFY(item("rack")->isEnabled());
    QVERIFY(!item("screw")->isEnabled());
    QVERIFY2(item("screw")->toolTip().contains(QStringLiteral("a rack fits")),
             qPrintable(item("screw")->toolTip()));
    QVERIFY(!item("external")->isEnabled());
    show(*screwDrive({}));
    panels.selection.select({ElementId(panels.document->mechanism()->gearMeshes.front().id)});
    QVERIFY(item("screw")->isEnabled());
    QVERIFY(!item("rack")->isEnabled());
    show(*wormStage({}));
    panels.selection.select({ElementId(panels.document->mechanism()->gearMeshes.front().id)});
    QVERIFY(item("worm")->isEnabled());
    for (const char* kind : {"rack", "screw"}) {
      QVERIFY(!item(kind)->isEnabled());
      QVERIFY(item(kind)->toolTip().contains(QStringLiteral("one of them has to slide")));
    }
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::SlidingJointsTest)
#include "test_sliding_joints.moc"
