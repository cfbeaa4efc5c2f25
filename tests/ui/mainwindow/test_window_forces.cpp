#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QHelpEvent>
#include <QLineEdit>
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <QToolTip>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/load_edits.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/train_sketch.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/forces/duality_line.h"
#include "ui/forces/forces_panel.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/power_arrows.h"
#include "ui/mainwindow/power_view.h"
#include "ui/panels/gearbox_panel.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/matrix_view.h"
#include "ui/theme/in_sight.h"
#include "ui/view3d/overlay_layer.h"
#include "ui/view3d/view3d.h"
#include "ui/view3d/viewer.h"

namespace geargraph {

/// Loads of the document in all views of a window.
class WindowForcesTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  void open(Mechanism mechanism) {
    window->document().replace(std::move(mechanism), {});
    QTRY_VERIFY(window->isSettled());
  }
  template <class Reduce>
  void change(Reduce reduce) {
    window->document().apply({QStringLiteral("Change"), reduce, 0});
    QTRY_VERIFY(window->isSettled());
  }
  /// Sun at 100 rad/s with 10 N m, ring held, carrier out.
  static Mechanism set(bool isLoaded = true) {
    Mechanism mechanism = test::planetary(24, 18);
    const auto& joints = mechanism.turningJoints;
    mechanism.inputs = std::vector<Input>{{joints[0].id, Number(100), {}}, {joints[1].id, Number(0), {}}};
    mechanism.balances = std::vector<HoldingTorque>{{joints[1].id}, {joints[2].id}};
    if (isLoaded) mechanism.loads = {{{}, JointTorque{joints[0].id, Number(10)}}};
    return mechanism;
  }
  [[nodiscard]] QStringList texts(const DrawingView& drawing) {
    QStringList all;
    for (const Mark& mark : drawing.displayList().marks)
      if (const auto* text = std::get_if<Text>(&mark.what)) all << QString::fromStdString(text->text);
    return all;
  }
  [[nodiscard]] Rational torque() const {
    const auto& loads = window->document().mechanism()->loads;
    return loads.empty() ? Rational(0) : std::get<JointTorque>(loads[0].action).torque.exact();
  }
  /// Where these words stand in the drawing in front.
  [[nodiscard]] std::optional<QPoint> placeOf(const char* words) {
    for (const Mark& mark : window->drawing().displayList().marks) {
      const auto* text = std::get_if<Text>(&mark.what);
      if (text != nullptr && text->text == words)
        return window->drawing().mapFromScene(QPointF(text->center.x, text->center.y));
    }
    return std::nullopt;
  }
  QAction& powerFlow() { return *window->findChild<QAction*>(QStringLiteral("view.powerFlow")); }
  void setPower(bool on) {
    powerFlow().setChecked(on);
    QTRY_VERIFY(window->isSettled());
  }
  void show(const char* name) {
    auto* dock = window->findChild<QDockWidget*>(QLatin1String(name));
    dock->show();
    dock->raise();
    QTRY_VERIFY(isInSight(*dock->widget()));
    QTRY_VERIFY(window->isSettled());
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    setPower(false);
  }
  void cleanup() { window.reset(); }

  void powerFlowsUnderTheDrawings() {
    open(set());
    for (const char* name : {"digraph", "schematic"}) {
      QVERIFY(window->showDrawing(QLatin1String(name)));
      QTRY_VERIFY(window->isSettled());
      QVERIFY2(texts(window->drawing()).contains("T 10 N m"), name);
      QVERIFY(!texts(window->drawing()).contains("1000 W"));
      setPower(true);
      QTRY_VERIFY2(texts(window->drawing()).contains("1000 W"), name);
      QVERIFY(texts(window->drawing()).contains("seen from the ground"));
      setPower(false);
      QTRY_VERIFY2(!texts(window->drawing()).contains("1000 W"), name);
    }
    // It follows the loads.
    setPower(true);
    change([](const Mechanism& before) {
      return withLoadAction(before, 0, JointTorque{before.turningJoints[0].id, Number(20)});
    });
    QTRY_VERIFY(texts(window->digraph()).contains("2000 W"));
    window->document().undoStack().undo();
    QTRY_VERIFY(texts(window->digraph()).contains("1000 W"));
  }

  /// A balance is a motor with what was found; its tip says what it holds, and its power.
  void balancesTellWhatWasFound() {
    open(set());
    for (const char* name : {"digraph", "schematic"}) {
      QVERIFY(window->showDrawing(QLatin1String(name)));
      QTRY_VERIFY(window->isSettled());
      QTRY_VERIFY2(placeOf("M").has_value(), name);
      DrawingView& drawing = window->drawing();
      QStringList tips;
      for (const Mark& mark : drawing.displayList().marks) {
        const auto* text = std::get_if<Text>(&mark.what);
        if (text == nullptr || text->text != "M") continue;
        const QPoint place = drawing.mapFromScene(QPointF(text->center.x, text->center.y));
        QHelpEvent help(QEvent::ToolTip, place, drawing.viewport()->mapToGlobal(place));
        QApplication::sendEvent(drawing.viewport(), &help);
        tips << QToolTip::text();
      }
      QCOMPARE(tips.size(), 2);
      QVERIFY2(tips.join(QString()).contains("It takes 1000 W out of the train"),
               qPrintable(tips.join("; ")));
      for (const QString& tip : tips)
        QVERIFY2(tip.contains("Balance in joint") && tip.contains("found, it holds the loads"),
                 qPrintable(tip));
    }
    QToolTip::hideText();
  }

  void anotherLinkSeesOtherPowers() {
    open(set());
    setPower(true);
    auto* power = window->findChild<PowerView*>();
    QMenu observers;
    power->fillObservers(observers);
    QCOMPARE(observers.actions().size(), 5);
    QVERIFY(observers.actions()[0]->isChecked());
    observers.actions()[3]->trigger();
    QTRY_VERIFY(texts(window->digraph()).contains("seen from link 3"));
    open(set());
    QTRY_VERIFY(texts(window->digraph()).contains("seen from the ground"));
  }

  void withoutLoadsNothingIsSolved() {
    setPower(true);
    QVERIFY(window->workbench().forces().answer() == nullptr);
    QVERIFY(!window->digraph().hasUnderlay());
    open(set());
    QTRY_VERIFY(window->digraph().hasUnderlay());
    QVERIFY(powerFlow().isEnabled());
    change([](const Mechanism& before) { return withoutLoad(before, 0); });
    QVERIFY(window->workbench().forces().answer() == nullptr);
    QVERIFY(!window->digraph().hasUnderlay());
    QVERIFY(!powerFlow().isEnabled() && powerFlow().toolTip().contains("add one in Forces"));
  }

  void theShiftTableHasTorques() {
    open(test::eightSpeed());
    show("dock.gearbox");
    QTRY_VERIFY(window->gearbox().model().torques() != nullptr);
    QCOMPARE(window->gearbox().model().index(0, 1).data().toString(), QStringLiteral("1.232"));
    show("dock.inputs");
    QVERIFY(window->workbench().forces().answer() == nullptr);
  }

  /// W opens an editor in place: a torque is set, changed and removed, each in one step.
  void loadsAreTypedInTheDrawing() {
    open(set(false));
    const JointId sun = window->document().mechanism()->turningJoints[0].id;
    auto& load = *window->findChild<QAction*>(QStringLiteral("mechanism.load"));
    QVERIFY(!load.isEnabled());
    window->selection().select({sun});
    QVERIFY(load.isEnabled());
    const auto type = [&](const char* text) {
      load.trigger();
      auto* editor = window->digraph().findChild<QLineEdit*>(QStringLiteral("torqueEditor"));
      QVERIFY(editor != nullptr);
      editor->selectAll();
      QTest::keyClick(editor, Qt::Key_Delete);
      QTest::keyClicks(editor, QLatin1String(text));
      QTest::keyClick(editor, Qt::Key_Return);
      QTRY_VERIFY(window->digraph().findChild<QLineEdit*>(QStringLiteral("torqueEditor")) == nullptr);
      QTRY_VERIFY(window->isSettled());
    };
    type("10");
    QCOMPARE(torque(), Rational(10));
    QTRY_VERIFY(texts(window->digraph()).contains("T 10 N m"));
    type("-500 Nmm");
    QCOMPARE(torque(), Rational(-1, 2));
    type("much");
    QCOMPARE(torque(), Rational(-1, 2));
    QVERIFY(window->digraph().hint().contains("10 Nm"));
    type("");
    QVERIFY(window->document().mechanism()->loads.empty());
    window->document().undoStack().undo();
    QCOMPARE(torque(), Rational(-1, 2));
    window->selection().select({window->document().mechanism()->links[0].id});
    QVERIFY(!load.isEnabled() && load.toolTip().contains("ground"));
  }

  /// The chip of a load is pulled: the torque follows, in one step; Esc puts it back.
  void loadsAreDragged() {
    open(set());
    for (const char* name : {"digraph", "schematic"}) {
      QVERIFY(window->showDrawing(QLatin1String(name)));
      QTRY_VERIFY(window->isSettled());
      QTRY_VERIFY(placeOf("T 10 N m").has_value());
      const int steps = window->document().undoStack().count();
      QCoreApplication::processEvents();  // panels that found torques want other heights
      const QPoint chip = *placeOf("T 10 N m");
      QWidget* const sheet = window->drawing().viewport();
      QTest::mousePress(sheet, Qt::LeftButton, {}, chip);
      QTest::mouseMove(sheet, chip + QPoint(20, 0));
      QVERIFY2(torque() == Rational(15), torque().toString().c_str());  // at once
      QVERIFY(window->drawing().isDrawing());
      QVERIFY(window->drawing().hint().contains("15 N m"));
      QTest::mouseMove(sheet, chip + QPoint(20, 60));
      QCOMPARE(torque(), Rational(0));
      QTest::mouseMove(sheet, chip + QPoint(40, -40));
      QTest::mouseRelease(sheet, Qt::LeftButton, {}, chip + QPoint(40, -40));
      QCOMPARE(torque(), Rational(30));
      QVERIFY(!window->drawing().isDrawing());
      QCOMPARE(window->document().undoStack().count(), steps + 1);
      QTRY_VERIFY2(texts(window->drawing()).contains("T 30 N m"), name);
      window->document().undoStack().undo();
      QCOMPARE(torque(), Rational(10));

      QTRY_VERIFY(placeOf("T 10 N m").has_value());
      QTest::mousePress(sheet, Qt::LeftButton, {}, *placeOf("T 10 N m"));
      QTest::mouseMove(sheet, chip + QPoint(28, 0));
      QVERIFY(torque() != Rational(10));
      QTest::keyClick(sheet, Qt::Key_Escape);
      QCOMPARE(torque(), Rational(10));
      QTest::mouseRelease(sheet, Qt::LeftButton, {}, chip + QPoint(28, 0));
      QCOMPARE(torque(), Rational(10));
      QVERIFY(!window->document().undoStack().canRedo());
      QCOMPARE(window->document().undoStack().index(), 0);
    }
  }

  /// What was found is no load: pulling it changes nothing.
  void whatWasFoundIsNotDragged() {
    open(set());
    QTRY_VERIFY(placeOf("T 25 N m").has_value());
    const QPoint chip = *placeOf("T 25 N m");
    QWidget* const sheet = window->drawing().viewport();
    QTest::mousePress(sheet, Qt::LeftButton, {}, chip);
    QTest::mouseMove(sheet, chip + QPoint(20, 0));
    QTest::mouseRelease(sheet, Qt::LeftButton, {}, chip + QPoint(20, 0));
    QCOMPARE(torque(), Rational(10));
    QCOMPARE(window->document().mechanism()->loads.size(), std::size_t{1});
  }

  /// The tool Load: a drag on a link loads it, a click is for typing.
  void theToolLoads() {
    open(set(false));
    auto& tool = *window->findChild<QAction*>(QStringLiteral("tool.load"));
    tool.trigger();
    QVERIFY(tool.isChecked());
    QVERIFY(window->drawing().tool() == ToolKind::load);
    QVERIFY(window->drawing().hint().contains("10 Nm"));
    QWidget* const sheet = window->drawing().viewport();
    test::Hand hand(*window);
    const QPoint link = hand.placeOf(1);
    QTest::mousePress(sheet, Qt::LeftButton, {}, link);
    QTest::mouseMove(sheet, link + QPoint(24, 0));
    QTest::mouseRelease(sheet, Qt::LeftButton, {}, link + QPoint(24, 0));
    const auto& loads = window->document().mechanism()->loads;
    QCOMPARE(loads.size(), std::size_t{1});
    QCOMPARE(std::get<LinkTorque>(loads[0].action).torque.exact(), Rational(6));
    QCOMPARE(window->document().undoStack().count(), 1);
    QTRY_VERIFY(texts(window->drawing()).contains("T 6 N m"));
    QTest::mouseClick(sheet, Qt::LeftButton, {}, hand.placeOf(2));
    QVERIFY(window->digraph().findChild<QLineEdit*>(QStringLiteral("torqueEditor")) != nullptr);
    QTest::keyClick(window->digraph().findChild<QLineEdit*>(QStringLiteral("torqueEditor")), Qt::Key_Escape);
    QTest::mouseClick(sheet, Qt::LeftButton, {}, hand.placeOf(0));
    QVERIFY(window->drawing().hint().contains("ground"));
    QCOMPARE(window->document().mechanism()->loads.size(), std::size_t{1});
  }

  void forcesIn3D() {
    open(set());
    ViewOptions options = window->view3d().options();
    QVERIFY(window->view3d().view().forces != nullptr);
    const std::size_t count = window->view3d().view().forces->size();
    QCOMPARE(count, std::size_t{2 + 4});
    options.marks.forces = true;
    window->view3d().setOptions(options);
    QVERIFY(window->view3d().view().marks.forces);
    change([](const Mechanism& before) { return withoutLoad(before, 0); });
    QVERIFY(window->view3d().view().forces == nullptr);
    QVERIFY2(window->view3d().forcesCaption().contains("without loads"),
             qPrintable(window->view3d().forcesCaption()));
  }

  /// With the bands of the drawings arrows are over the solids, as the same link sees the power.
  void powerIn3D() {
    open(set());
    const auto& arrows = *window->findChild<PowerArrows*>();
    const auto& layer = *window->view3d().findChild<OverlayLayer*>();
    QVERIFY(arrows.shown() == nullptr && !layer.painting());
    const auto& viewer = *static_cast<const Viewer*>(layer.parent());
    ViewOptions options = window->view3d().options();
    options.marks.forces = true;
    window->view3d().setOptions(options);
    QTRY_VERIFY(!viewer.shownForces().arrows.empty());
    QVERIFY(!viewer.shownForces().areLabelsShared);
    setPower(true);
    QTRY_VERIFY(arrows.shown() != nullptr && layer.painting());
    QVERIFY(viewer.shownForces().areLabelsShared);
    QVERIFY(!arrows.shown()->arrows.empty());
    QCOMPARE(arrows.shown()->picture.fed, 1000.0);
    QCOMPARE(arrows.shown()->picture.observer, 0);
    QMenu observers;
    window->findChild<PowerView*>()->fillObservers(observers);
    observers.actions()[3]->trigger();
    QTRY_COMPARE(arrows.shown()->picture.observer, 3);
    // It follows the loads, and is a painting of its own.
    change([](const Mechanism& before) {
      return withLoadAction(before, 0, JointTorque{before.turningJoints[0].id, Number(20)});
    });
    QTRY_COMPARE(arrows.shown()->picture.fed, 2000.0);
    setPower(false);
    QTRY_VERIFY(arrows.shown() == nullptr && !layer.painting());
    setPower(true);
    QTRY_VERIFY(arrows.shown() != nullptr);
    change([](const Mechanism& before) { return withoutLoad(before, 0); });
    QVERIFY(arrows.shown() == nullptr && !layer.painting());
  }

  /// Where forces are shared the picture says which are missing, and how they are found.
  void sharedForcesAreTold() {
    open(set());
    QTRY_VERIFY(window->view3d().view().forces != nullptr);
    QVERIFY2(window->view3d().forcesCaption().isEmpty(), qPrintable(window->view3d().forcesCaption()));
    Mechanism planets = test::planetary(24, 18, 3);
    const auto& joints = planets.turningJoints;
    planets.inputs = std::vector<Input>{{joints[0].id, Number(100), {}}, {joints[1].id, Number(0), {}}};
    planets.balances = std::vector<HoldingTorque>{{joints[1].id}, {joints[2].id}};
    planets.loads = {{{}, JointTorque{joints[0].id, Number(10)}}};
    open(planets);
    const auto caption = [&] { return window->view3d().forcesCaption(); };
    QTRY_VERIFY2(caption().contains("shared in unknown parts") && caption().contains("Share by stiffness"),
                 qPrintable(caption()));
    for (int mesh = 0; mesh < planets.c(); ++mesh)
      QVERIFY2(caption().contains(QString::number(planets.meshLabel(mesh))), qPrintable(caption()));
    show("dock.forces");
    auto* share = window->findChild<QToolButton*>(QStringLiteral("shareByStiffness"));
    QTRY_VERIFY(share->isVisible());
    share->click();
    QTRY_COMPARE(caption(), QString("Shared by equal stiffness of all teeth: an assumption."));
    QVERIFY(window->view3d().view().forces->size() >= std::size_t(planets.c()));
  }

  /// One entry in three places: it is framed in Matrices, and a click in Forces shows it there.
  void theSharedEntryIsFramedInMatrices() {
    open(set());
    show("dock.forces");
    window->forces().showView(ForceView::why);
    QTRY_VERIFY(window->forces().dualityLine().isVisible());
    const Mechanism& mechanism = *window->document().mechanism();
    window->selection().select({mechanism.turningJoints[1].id, mechanism.gearMeshes[1].id});
    auto& matrices = *window->findChild<MatricesPanel*>();
    QVERIFY(matrices.view().isFramed(1, 1));  // C10 below joint 6, not in sight yet
    emit window->forces().dualityLine().linkActivated(QStringLiteral("entry"));
    QTRY_VERIFY(isInSight(matrices));
    QVERIFY(matrices.model().result().name == "p");
    QVERIFY(matrices.view().isFramed(1, 1));
    QCOMPARE(matrices.view().currentIndex(), matrices.model().index(1, 1));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowForcesTest)
#include "test_window_forces.moc"
