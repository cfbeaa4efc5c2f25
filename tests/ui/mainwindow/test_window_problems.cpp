#include <QDockWidget>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "core/design/collision/motion_diagnostics.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/shapes.h"
#include "tests/core/support/deep_train.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/document_files.h"
#include "ui/panels/problems_panel.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// A mechanism is broken by hand and repaired from the Problems panel.
class WindowProblemsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  [[nodiscard]] const MechanismPtr& now() { return window->document().mechanism(); }
  template <class Reduce>
  void change(Reduce reduce) {
    window->document().apply({QStringLiteral("Break"), reduce, 0});
    QTRY_VERIFY(window->isSettled());
  }
  void showProblems() {
    auto* dock = window->findChild<QDockWidget*>("dock.problems");
    dock->show();
    dock->raise();
    QTRY_VERIFY(window->problems().isVisible());
  }
  [[nodiscard]] QStringList codes() {
    QStringList all;
    DiagnosticModel& model = window->problems().model();
    for (int row = 0; row < model.rowCount(); ++row) {
      all << model.index(row).data(DiagnosticModel::CodeRole).toString();
    }
    return all;
  }
  QPushButton* fix(const QString& text) {
    for (auto* button : window->problems().findChildren<QPushButton*>("fix")) {
      if (button->isVisible() && button->text() == text) return button;
    }
    return nullptr;
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    showProblems();
  }
  void cleanup() { window.reset(); }

  // A part that is not there is no silent gap in the picture.
  void aMissing3dFileIsAProblem() {
    const QTemporaryDir folder;
    Mechanism robot = *now();
    robot.links.at(3).shapes.push_back({"no-such-part.stl"});
    const QString path = folder.filePath(QStringLiteral("robot.geargraph"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(file.write(QByteArray::fromStdString(writeMechanism(robot))) > 0);
    file.close();
    window = test::openedWindow(path);
    QVERIFY(window != nullptr);
    showProblems();
    QTRY_VERIFY2(codes().contains(QStringLiteral("missing-file")), qPrintable(codes().join(' ')));
    change([](const Mechanism& m) { return withShapes(m, LinkId("3"), {}); });
    QTRY_VERIFY(!codes().contains(QStringLiteral("missing-file")));
  }

  void aClickRepairsAndUndoTakesItBack() {
    const MechanismPtr sound = now();
    change([](const Mechanism& before) { return withTeeth(before, MeshId("15"), 18, 30); });
    const MechanismPtr broken = now();
    QCOMPARE(codes(), QStringList{"teeth-geometry"});
    QTRY_VERIFY(fix("Use 36 teeth on gear 1") != nullptr);
    QTest::mouseClick(fix("Use 36 teeth on gear 1"), Qt::LeftButton);
    QCOMPARE(*now(), *sound);
    QTRY_VERIFY(window->isSettled());
    QVERIFY(codes().isEmpty());
    QCOMPARE(window->document().undoStack().undoText(), QString("Use 36 teeth on gear 1"));
    QTest::keyClick(&window->digraph(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(now().get(), broken.get());
    QTRY_COMPARE(codes(), QStringList{"teeth-geometry"});
  }

  /// Bevels on the other side of their apex: links get into each other's way, and an offset clears them.
  void anOverlapIn3DIsClearedByItsButton() {
    const auto overlaps = [this] {  // in the reference pose
      QStringList all;
      const QAbstractItemModel& model = window->problems().model();
      for (int row = 0; row < model.rowCount(); ++row) all << model.index(row, 0).data().toString();
      return all.filter(QRegularExpression(QStringLiteral("overlap (in 3D|and do not mesh)"))).size();
    };
    int cleared = 0;
    for (const char* mesh : {"15", "16", "17", "18"}) {
      for (const bool ofTail : {true, false}) {
        const int steps = window->document().undoStack().index();
        change([mesh, ofTail](const PlacedMechanism& before) {
          return withBevelSideFlipped(before, MeshId(mesh), ofTail);
        });
        const auto before = overlaps();
        QPushButton* move = nullptr;
        for (auto* button : window->problems().findChildren<QPushButton*>("fix")) {
          if (button->isVisible() && button->text().startsWith(QStringLiteral("Move joint "))) move = button;
        }
        if (move != nullptr) {
          const QString text = move->text();
          QTest::mouseClick(move, Qt::LeftButton);
          QTRY_VERIFY(window->isSettled());
          QTRY_VERIFY2(overlaps() < before, qPrintable(text));
          QCOMPARE(window->document().undoStack().undoText(), text);
          ++cleared;
        }
        while (window->document().undoStack().index() > steps) window->document().undoStack().undo();
        QTRY_VERIFY(window->isSettled());
      }
    }
    QVERIFY(cleared > 0);
  }

  /// A load that nothing holds, with the motion by name; gone with the load.
  void loadsThatNothingHolds() {
    change([](const Mechanism& before) {
      return withBalances(before, std::vector<HoldingTorque>{{JointId("8")}, {JointId("9")}});
    });
    QVERIFY(codes().isEmpty());
    change([](const Mechanism& before) {
      return withLoad(before, {{}, JointTorque{JointId("14"), Number(10)}});
    });
    QCOMPARE(codes(), QStringList{"unbalanced"});
    QListView& list = window->problems().list();
    QVERIFY(list.model()->index(0, 0).data().toString().contains("joints 11, 13 and 14 turn freely"));
    QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier,
                      list.visualRect(list.model()->index(0, 0)).center());
    QCOMPARE(window->selection().selected(),
             (std::set<ElementId>{JointId("11"), JointId("13"), JointId("14")}));
    change([](const Mechanism& before) { return withBalances(before, std::nullopt); });
    QVERIFY(codes().isEmpty());
    window->document().undoStack().undo();
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(codes(), QStringList{"unbalanced"});
    change([](const Mechanism& before) { return withoutLoad(before, 0); });
    QVERIFY(codes().isEmpty());
  }

  void aRowLightsItsCulpritsBesideItsButtons() {
    change([](const Mechanism& before) { return withLink(before, CanvasPoint{600, 20}); });
    QCOMPARE(codes(), QStringList{"disconnected"});
    QListView& list = window->problems().list();
    const QRect row = list.visualRect(list.model()->index(0, 0));
    QPushButton* tie = fix("Tie link 8 to the ground");
    QVERIFY(tie != nullptr);
    const QPoint inList = tie->mapTo(list.viewport(), tie->rect().center());
    QVERIFY(row.contains(inList));
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, row.topLeft() + QPoint(60, 12));
    QCOMPARE(window->selection().selected(), std::set<ElementId>{now()->links.back().id});
    QTest::mouseClick(tie, Qt::LeftButton);
    QTRY_VERIFY(window->isSettled());
    QVERIFY(!codes().contains("disconnected"));
    QCOMPARE(now()->t(), 8);
  }

  void whatTheTeethSayIsListed() {
    QVERIFY(window->openDocument(":/examples/spur-pair.geargraph"));
    QTRY_VERIFY(window->isSettled());
    change([](const Mechanism& before) {
      const MeshId mesh = before.gearMeshes.front().id;
      return withTeeth(*withPitchPoint(before, mesh, std::nullopt), mesh, 9, 18);
    });
    QVERIFY2(codes().contains("undercut"), qPrintable(codes().join(' ')));
    QPushButton* more = fix("Use twice the teeth everywhere");
    QVERIFY(more != nullptr);
    more->setFocus();
    QTest::keyClick(more, Qt::Key_Space);
    QTRY_VERIFY(window->isSettled());
    QVERIFY(!codes().contains("undercut"));
  }

  void inputsAreExchanged() {
    change([](const Mechanism& before) {
      return withInputs(before, std::vector<Input>{{JointId("8"), Number(1), {}},
                                                   {JointId("10"), Number(2), {}},
                                                   {JointId("11"), Number(3), {}}});
    });
    QCOMPARE(codes(), QStringList{"invalid-inputs"});
    QTest::mouseClick(fix("Exchange input 10 for 9"), Qt::LeftButton);
    QTRY_VERIFY(window->isSettled());
    QVERIFY(codes().isEmpty());
    QCOMPARE(now()->inputs->at(1).joint, JointId("9"));
  }

  void withoutFreedomNothingIsAskedToBeDriven() {
    QVERIFY(window->openDocument(":/examples/locked-train.geargraph"));
    QTRY_VERIFY(window->isSettled());
    window->document().apply({QStringLiteral("Free the inputs"),
                              [](const Mechanism& before) { return withInputs(before, std::nullopt); }, 0});
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(window->findChild<QLabel*>("noInputs")->text(),
             QString("There is nothing to drive: the mechanism has no degree of freedom."));
  }

  void aClickOnACollisionShowsThePoseInWhichItHappens() {
    QVERIFY(codes().isEmpty());
    change([](const Mechanism& before) {
      Mechanism free = before;
      for (TurningJoint& joint : free.turningJoints) joint.limits = {};
      return Expected<Mechanism>(free);
    });
    DiagnosticModel& model = window->problems().model();
    QVERIFY(model.rowCount() > 0);
    const Diagnostic first = model.diagnostics().front();
    QCOMPARE(first.code, Code::interference);
    QVERIFY(first.time && *first.time > 1);
    QCOMPARE(first.elements.size(), std::size_t{2});

    View3D& view = window->view3d();
    view.setTurnedByHand({1, 1, 1});
    view.playback().setPlaying(true);
    auto* dock = window->findChild<QDockWidget*>("dock.view3d");
    dock->close();
    QListView& list = window->problems().list();
    const QRect row = list.visualRect(list.model()->index(0, 0));
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, row.topLeft() + QPoint(60, 12));
    QVERIFY(dock->isVisible());
    QVERIFY(!view.playback().isPlaying());
    QCOMPARE(view.playback().time(), *first.time);
    QCOMPARE(view.turnedByHand(), std::vector<double>(3, 0));
    QCOMPARE(window->selection().selected(),
             std::set<ElementId>(first.elements.begin(), first.elements.end()));

    QTest::keyClick(&window->digraph(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(window->isSettled());
    QVERIFY(codes().isEmpty());
  }

  void motionThatIsNotCheckedIsToldBelowTheList() {
    auto* note = window->problems().findChild<QLabel*>(QStringLiteral("motionNote"));
    QVERIFY(!note->isVisible());
    window->document().replace(test::deepTrain(1, kMaxCheckedLinks + 1), {});
    QTRY_VERIFY_WITH_TIMEOUT(window->isSettled(), 60'000);
    QVERIFY(note->isVisible());
    QCOMPARE(note->text(), QString("The motion of more than 300 links is not checked for collisions."));
    QVERIFY(window->openDocument(robotExamplePath()));
    QTRY_VERIFY(window->isSettled());
    QVERIFY(!note->isVisible());
  }

  void problemsOfAFileAreNotRepairedHere() {
    change([](const Mechanism& before) { return withTeeth(before, MeshId("15"), 18, 30); });
    QVERIFY(!window->openDocument("/nowhere.geargraph"));
    QVERIFY(fix("Use 36 teeth on gear 1") == nullptr);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowProblemsTest)
#include "test_window_problems.moc"
