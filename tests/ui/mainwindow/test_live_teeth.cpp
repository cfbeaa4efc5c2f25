#include <QTest>

#include "core/machine/body_layout/complete_train.h"
#include "core/machine/solids/gear_solid.h"
#include "core/mechanism/model/edits.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/mainwindow/document_files.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// Edits of teeth in the real window, and what the 3D view gets of them.
class LiveTeethTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  void setTeeth(int tail, int head) {
    window->document().apply(
        {QStringLiteral("Change teeth"),
         [=](const Mechanism& mechanism) { return withTeeth(mechanism, MeshId("15"), tail, head); }, 0});
  }
  [[nodiscard]] const MechanismScenePtr& stage() const { return window->view3d().stage(); }
  /// Is the solid of every wheel of the document as it is now on the stage, and no other wheel's?
  [[nodiscard]] bool stageShowsTheWheels() const {
    const Mechanism& now = *window->document().mechanism();
    const GearTrain train = trainOf(now, placementOf(now));
    const auto& solids = stage()->scene.solids;
    const auto isShown = [&](const Solid& wanted) {
      return std::any_of(solids.begin(), solids.end(), [&](const auto& solid) { return *solid == wanted; });
    };
    return stage()->scene.instances.size() == train.gears.size() + train.bodies.size() &&
           std::all_of(train.gears.begin(), train.gears.end(),
                       [&](const TrainGear& gear) { return isShown(*gearSolid(gear.spec, kMaxTolerance)); });
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
  }
  void cleanup() { window.reset(); }

  void aChangedToothCountIsOnTheNextStage() {
    QVERIFY(stageShowsTheWheels());
    for (const int teeth : {20, 21, 20, 30}) {
      const MechanismScenePtr before = stage();
      setTeeth(teeth, 2 * teeth);
      QTRY_VERIFY(stage() != before);
      QVERIFY(stageShowsTheWheels());
    }
    const MechanismScenePtr before = stage();
    window->document().undoStack().undo();
    QTRY_VERIFY(stage() != before);
    QVERIFY(stageShowsTheWheels());
  }

  /// What did not change is not made again: the very same solids stay on the stage.
  void unchangedWheelsKeepTheirSolids() {
    const MechanismScenePtr before = stage();
    setTeeth(20, 40);
    QTRY_VERIFY(stage() != before);
    std::size_t kept = 0;
    for (const auto& solid : stage()->scene.solids) {
      kept += std::count(before->scene.solids.begin(), before->scene.solids.end(), solid) > 0 ? 1 : 0;
    }
    QCOMPARE(kept, std::size_t{6 + 8});  // six of the eight wheels, and what they stand on
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::LiveTeethTest)
#include "test_live_teeth.moc"
