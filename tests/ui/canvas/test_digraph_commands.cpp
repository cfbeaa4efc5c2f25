#include <QLineEdit>
#include <QMenu>
#include <QUndoStack>

#include "core/mechanism/model/pins.h"
#include "tests/ui/canvas/view_driver.h"
#include "ui/canvas/canvas_edits.h"
#include "ui/canvas/cycle_walk.h"

using namespace geargraph;

namespace {

const Qt::KeyboardModifiers kControl = Qt::ControlModifier;

QLineEdit* numberEditorOf(const ViewDriver& d) {
  for (QLineEdit* editor : d.view.viewport()->findChildren<QLineEdit*>()) {
    if (editor->isVisible()) return editor;
  }
  return nullptr;
}

/// The entries as shown, without their keys; grey ones in brackets.
QStringList entries(const QMenu& menu) {
  QStringList out;
  for (const QAction* action : menu.actions()) {
    if (action->isSeparator()) continue;
    const QString text = action->text().section('\t', 0, 0);
    out << (action->isEnabled() ? text : "[" + text + "]");
  }
  return out;
}

QAction* entry(const QMenu& menu, const QString& text) {
  for (QAction* action : menu.actions()) {
    if (action->text().startsWith(text)) return action;
  }
  return nullptr;
}

std::unique_ptr<QMenu> menuAt(ViewDriver& d, CanvasPoint at) {
  return std::unique_ptr<QMenu>(d.view.contextMenuAt(d.onScreen(at)));
}

}  // namespace

class DigraphCommandsTest : public QObject {
  Q_OBJECT
 private slots:
  // --- selection and hover ---
  void clickSelectsAndShiftOrControlToggles() {
    ViewDriver d(placedRobot());
    d.click(d.center(3));
    QCOMPARE(d.selected(), QString("3"));
    d.click(d.middle(JointId("11")), Qt::ShiftModifier);
    d.click(d.center(7), kControl);
    QCOMPARE(d.selected(), QString("3 7 11"));
    d.click(d.center(3), Qt::ShiftModifier);
    QCOMPARE(d.selected(), QString("7 11"));
    d.click({20, 20});
    QCOMPARE(d.selected(), QString());
  }

  void rubberBandSelectsAndShiftAdds() {
    ViewDriver d(placedRobot());
    d.drag({90, 290}, {340, 370});
    QCOMPARE(d.selected(), QString("0 1 10"));
    d.drag({630, 130}, {700, 200}, Qt::ShiftModifier);
    QCOMPARE(d.selected(), QString("0 1 3 10"));
    QCOMPARE(d.steps(), 0);
  }

  void controlASelectsAllAndEscapeNothing() {
    ViewDriver d(placedRobot());
    d.key(Qt::Key_A, kControl);
    QCOMPARE(d.selection.selected().size(), std::size_t{19});
    d.key(Qt::Key_Escape);
    QCOMPARE(d.selected(), QString());
  }

  void hoverIsSharedWithTheOtherViews() {
    ViewDriver d(placedRobot());
    d.hover(d.center(2));
    QVERIFY(d.selection.isHovered(LinkId("2")));
    d.hover(d.middle(MeshId("17")));
    QVERIFY(d.selection.isHovered(MeshId("17")) && !d.selection.isHovered(LinkId("2")));
    d.hover({20, 20});
    QVERIFY(d.selection.hovered().empty());
    d.hover(d.center(2));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&d.view, &leave);
    QVERIFY(d.selection.hovered().empty());
  }

  void hoverOfAnotherViewLightsUpHereAndIsNotTakenAway() {
    ViewDriver d(placedRobot());
    const auto halos = [&] {
      int count = 0;
      for (const Mark& mark : d.view.displayList().marks) count += mark.role == MarkRole::halo ? 1 : 0;
      return count;
    };
    QCOMPARE(halos(), 0);
    d.selection.hover({LinkId("7"), JointId("13")});
    QCOMPARE(halos(), 2);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&d.view, &leave);
    QCOMPARE(halos(), 2);
  }

  void whatIsGoneIsNotSelectedAnyMore() {
    ViewDriver d(placedRobot());
    d.click(d.middle(JointId("14")));
    d.key(Qt::Key_Delete);
    QCOMPARE(d.selected(), QString());
    d.document.undoStack().undo();
    QCOMPARE(d.selected(), QString());
  }

  // --- editing by keys ---
  void deleteAndBackspaceRemoveWithAllThatHangsOn() {
    ViewDriver d(placedRobot());
    d.click(d.center(6));
    d.key(Qt::Key_Delete);
    QCOMPARE(d.mechanism().links.size(), std::size_t{7});
    QCOMPARE(d.mechanism().turningJoints.size(), std::size_t{6});
    QCOMPARE(d.mechanism().gearMeshes.size(), std::size_t{3});
    d.click(d.middle(MeshId("18")));
    d.key(Qt::Key_Backspace);
    QCOMPARE(d.mechanism().gearMeshes.size(), std::size_t{2});
    QCOMPARE(d.steps(), 2);
  }

  void theGroundIsNotDeletedAndSaysWhy() {
    ViewDriver d(placedRobot());
    QStringList why;
    connect(&d.document, &Document::rejected, this,
            [&](const Diagnostics& found) { why << QString::fromStdString(found.front().message); });
    d.click(d.center(0));
    d.key(Qt::Key_Delete);
    QCOMPARE(d.steps(), 0);
    QCOMPARE(why.size(), 1);
    QVERIFY(why.first().contains("ground"));
  }

  void arrowKeysNudge() {
    ViewDriver d(placedRobot());
    d.key(Qt::Key_Right);
    QCOMPARE(d.steps(), 0);
    d.click(d.center(3));
    d.key(Qt::Key_Right);
    d.key(Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(d.center(3), (CanvasPoint{670, 159}));
    QCOMPARE(d.steps(), 2);
  }

  void aHeldArrowKeyIsOneUndoStep() {
    ViewDriver d(placedRobot());
    d.click(d.center(3));
    for (int i = 0; i < 5; ++i) {
      QKeyEvent event(QEvent::KeyPress, Qt::Key_Down, Qt::NoModifier, {}, i > 0);
      QCoreApplication::sendEvent(&d.view, &event);
    }
    QCOMPARE(d.center(3), (CanvasPoint{660, 210}));
    QCOMPARE(d.steps(), 1);
  }

  void xFlipsTheSelectedArrows() {
    ViewDriver d(placedRobot());
    d.click(d.middle(JointId("11")));
    d.click(d.middle(MeshId("17")), Qt::ShiftModifier);
    d.key(Qt::Key_X);
    QCOMPARE(d.mechanism().find(JointId("11"))->tail, LinkId("6"));
    QCOMPARE(d.mechanism().find(MeshId("17"))->tail, LinkId("7"));
    QCOMPARE(d.mechanism().find(MeshId("17"))->tailTeeth, 18);
    QCOMPARE(d.steps(), 1);
    d.click(d.center(3));
    d.key(Qt::Key_X);
    QCOMPARE(d.steps(), 1);
  }

  // --- renaming in place ---
  void f2RenamesInPlace() {
    ViewDriver d(placedRobot());
    d.click(d.center(3));
    d.key(Qt::Key_F2);
    QLineEdit* editor = numberEditorOf(d);
    QVERIFY(editor != nullptr);
    QTest::keyClicks(editor, "hand");
    QTest::keyClick(editor, Qt::Key_Return);
    QCOMPARE(d.mechanism().links[3].name, std::string("hand"));
    QCOMPARE(d.steps(), 1);
    QVERIFY(numberEditorOf(d) == nullptr);
  }

  void doubleClickRenamesAndEscapeLeavesTheName() {
    ViewDriver d(placedRobot());
    const std::string before = d.mechanism().links[3].name;
    QTest::mouseDClick(d.view.viewport(), Qt::LeftButton, {}, d.onScreen(d.center(3)));
    QLineEdit* editor = numberEditorOf(d);
    QVERIFY(editor != nullptr);
    QTest::keyClicks(editor, "t");  // a letter for the name, not the key of a tool
    QTest::keyClick(editor, Qt::Key_Escape);
    QCOMPARE(d.mechanism().links[3].name, before);
    QCOMPARE(d.steps(), 0);
    QCOMPARE(d.view.tool(), ToolKind::select);
  }

  void doubleClickOnAnArrowAsksForItsProperties() {
    ViewDriver d(placedRobot());
    QStringList wanted;
    connect(&d.view, &DigraphView::propertiesWanted, this,
            [&](const ElementId& element) { wanted << QString::fromStdString(element.id.text()); });
    QTest::mouseDClick(d.view.viewport(), Qt::LeftButton, {}, d.onScreen(d.middle(MeshId("17"))));
    QCOMPARE(wanted, QStringList("17"));
  }

  // --- context menus ---
  void menuOfALinkSaysWhatIsNotPossible() {
    ViewDriver d(placedRobot());
    d.document.apply({"", [](const Mechanism& m) { return withInputs(m, std::nullopt); }, 0});
    QCOMPARE(entries(*menuAt(d, d.center(3))),
             (QStringList{"Rename", "Drive it", "Make it the ground", "Attach a gear", "Hold it with a brake",
                          "[Connect it to another link with a clutch (select two links)]",
                          "Pin the teeth of its gears", "Delete"}));
    QCOMPARE(
        entries(*menuAt(d, d.center(0))),
        (QStringList{"Rename", "[Drive it (the ground does not move)]",
                     "[Make it the ground (it is the ground)]", "[Attach a gear (the ground does not move)]",
                     "[Hold it with a brake (the ground does not move)]",
                     "[Connect it to another link with a clutch (select two links)]",
                     "Pin the teeth of its gears", "[Delete (the ground cannot be deleted)]"}));
    QCOMPARE(d.selected(), QString("0"));
  }

  void menuOfArrowsFlipsAndDrives() {
    ViewDriver d(placedRobot());
    d.document.apply({"", [](const Mechanism& m) { return withInputs(m, std::nullopt); }, 0});
    QCOMPARE(entries(*menuAt(d, d.middle(MeshId("17")))),
             (QStringList{"[Drive it (only turning joints can be driven)]", "Flip the arrow",
                          "Make it internal", "Pin the module", "Delete"}));
    const auto menu = menuAt(d, d.middle(JointId("12")));
    entry(*menu, "Drive it")->trigger();
    QVERIFY(isInput(d.mechanism(), JointId("12")));
    QCOMPARE(entries(*menuAt(d, d.middle(JointId("12")))).first(), QString("Stop driving it"));
    entry(*menu, "Flip")->trigger();
    QCOMPARE(d.mechanism().find(JointId("12"))->tail, LinkId("2"));
    entry(*menu, "Delete")->trigger();
    QVERIFY(d.mechanism().find(JointId("12")) == nullptr);
  }

  void menuSplitsALinkAndWeldsIt() {
    ViewDriver d(placedRobot());
    QVERIFY(entry(*menuAt(d, d.center(3)), "Split it") == nullptr);  // nothing hangs on it that could go
    const int links = d.mechanism().n();
    d.selection.select({LinkId("2"), MeshId("16")});
    entry(*menuAt(d, d.center(2)), "Split it")->trigger();
    QCOMPARE(d.mechanism().n(), links + 1);
    const LinkId part = d.mechanism().links.back().id;
    QCOMPARE(d.mechanism().find(MeshId("16"))->head, part);
    QCOMPARE(d.selection.selected(), std::set<ElementId>{part});
    QVERIFY(d.mechanism().view.nodes.contains(part));
    d.selection.select({LinkId("2"), part});
    QAction* weld = entry(*menuAt(d, d.center(2)), "Weld link 2");
    QVERIFY(weld != nullptr && weld->isEnabled());
    d.view.weldSelected();
    QCOMPARE(d.mechanism().n(), links);
    QCOMPARE(d.steps(), 2);
    d.selection.select({LinkId("5"), LinkId("2")});
    const auto menu = menuAt(d, d.center(2));
    QVERIFY(!entry(*menu, "Weld link 2")->isEnabled());
    QVERIFY(entry(*menu, "Weld link 2")->toolTip().contains("mesh 16"));
  }

  void newGearsComeIntoSight() {
    ViewDriver d(placedRobot());
    d.view.resize(260, 420);
    d.view.resetZoom();
    d.view.centerOn(470, 250);
    QCoreApplication::processEvents();
    const QRectF sight = d.view.mapToScene(d.view.viewport()->rect()).boundingRect();
    QVERIFY(sight.contains(470, 250) && !sight.adjusted(20, 20, -20, -20).contains(470 + 120, 250));
    d.selection.select({LinkId("2")});
    d.view.attachGear();
    const CanvasPoint place = d.mechanism().view.nodes.at(d.mechanism().links.back().id);
    QVERIFY(sight.adjusted(20, 20, -20, -20).contains(place.x, place.y));
  }

  void menuPutsBrakesAndClutchesOn() {
    ViewDriver d(placedRobot());
    entry(*menuAt(d, d.center(3)), "Hold it")->trigger();
    QCOMPARE(d.mechanism().couplings.size(), std::size_t{1});
    QCOMPARE(d.mechanism().couplings[0].links, std::vector<LinkId>{LinkId("3")});
    QCOMPARE(d.mechanism().couplings[0].kind, ShiftElementKind::brake);
    QCOMPARE(d.mechanism().engaged, std::vector{ShiftElementId("A")});  // it holds
    d.selection.select({LinkId("2"), LinkId("5")});
    entry(*menuAt(d, d.center(5)), "Connect link 2 and link 5")->trigger();
    QCOMPARE(d.mechanism().couplings[1].kind, ShiftElementKind::clutch);
    QCOMPARE(d.steps(), 2);
    entry(*menuAt(d, d.center(3)), "Release brake A")->trigger();
    QCOMPARE(d.mechanism().engaged, std::vector{ShiftElementId("B")});
    QVERIFY(entry(*menuAt(d, d.center(3)), "Engage brake A")->isEnabled());
    d.selection.select({LinkId("2"), LinkId("5")});
    entry(*menuAt(d, d.center(5)), "Take clutch B off")->trigger();
    QVERIFY(d.mechanism().engaged.empty());
    entry(*menuAt(d, d.center(3)), "Take brake A off")->trigger();
    QVERIFY(d.mechanism().couplings.empty());
    d.selection.select({LinkId("0"), LinkId("5")});
    QVERIFY(!entry(*menuAt(d, d.center(5)), "Connect link 0")->isEnabled());
  }

  void menuPinsAxesTeethAndModules() {
    ViewDriver d(placedRobot());
    entry(*menuAt(d, d.center(3)), "Pin the teeth of its gears")->trigger();
    QVERIFY(isPinned(*d.mechanism().find(LinkId("3"))));
    QVERIFY(entry(*menuAt(d, d.center(3)), "Pin the teeth of its gears")->isChecked());
    entry(*menuAt(d, d.middle(JointId("12"))), "Axis c pinned")->trigger();
    QVERIFY(isPinned(*d.mechanism().find(AxisId("c"))));
    entry(*menuAt(d, d.middle(JointId("12"))), "Axis c pinned")->trigger();
    QVERIFY(!isPinned(*d.mechanism().find(AxisId("c"))));
    entry(*menuAt(d, d.middle(MeshId("17"))), "Pin the module")->trigger();
    QVERIFY(isPinned(*d.mechanism().find(MeshId("17"))));
    QVERIFY(entry(*menuAt(d, d.middle(MeshId("17"))), "Pin the module")->isChecked());
    QCOMPARE(d.steps(), 4);
  }

  void lettersOfAxesRunOnAfterADeletion() {
    ViewDriver d(placedRobot());
    const auto axes = [&] {
      std::string letters;
      for (const TurningJoint& joint : d.mechanism().turningJoints) letters += joint.axis.text();
      return letters;
    };
    QCOMPARE(axes(), std::string("abbccde"));
    d.click(d.center(4));
    d.key(Qt::Key_Delete);
    QCOMPARE(axes(), std::string("aabbcd"));
    d.document.undoStack().undo();
    QCOMPARE(axes(), std::string("abbccde"));
  }

  void menuLaysAnAxis() {
    ViewDriver d(placedRobot());
    const auto layMenu = [&] {
      auto menu = menuAt(d, d.middle(JointId("12")));
      QAction* lay = entry(*menu, "Lay axis c");
      return std::pair(std::move(menu), lay);
    };
    {
      const auto [menu, lay] = layMenu();
      QCOMPARE(entries(*lay->menu()), (QStringList{"Along x", "Along y", "Along z", "Square to",
                                                   "Parallel to", "Through the meeting point of"}));
      QVERIFY(entry(*entry(*lay->menu(), "Square to")->menu(), "Axis b") != nullptr);
      QVERIFY(entry(*entry(*lay->menu(), "Square to")->menu(), "Axis c") == nullptr);
      entry(*lay->menu(), "Along y")->trigger();
    }
    QCOMPARE(d.steps(), 1);
    const Placement& placement = d.document.placed().placement();
    QVERIFY(std::abs(placement.axes[2].direction[1]) > 1 - 1e-12);
    entry(*menuAt(d, d.middle(JointId("12"))), "Axis c pinned")->trigger();
    const auto [menu, lay] = layMenu();
    QVERIFY(!lay->isEnabled() && lay->text().contains("pinned"));
  }

  void menuMakesAPairInternalAndExternal() {
    ViewDriver d(placedRobot());
    entry(*menuAt(d, d.middle(MeshId("15"))), "Make it internal")->trigger();
    QCOMPARE(d.mechanism().find(MeshId("15"))->kind, std::optional(MeshKind::internal));
    entry(*menuAt(d, d.middle(MeshId("15"))), "Make it external")->trigger();
    QCOMPARE(d.mechanism().find(MeshId("15"))->kind, std::optional(MeshKind::external));
    QCOMPARE(d.steps(), 2);
  }

  void menuMakesAnotherLinkTheGround() {
    ViewDriver d(placedRobot());
    entry(*menuAt(d, d.center(4)), "Make it")->trigger();
    QCOMPARE(d.mechanism().links.front().id, LinkId("4"));
    QCOMPARE(d.steps(), 1);
  }

  void menuOfTheSheetMakesLinksAndTidies() {
    ViewDriver d(placedRobot());
    const CanvasPoint at{40, 40};
    const auto menu = menuAt(d, at);
    QCOMPARE(entries(*menu),
             (QStringList{"New link here", "New note here", "Select all", "Tidy the drawing", "Fit"}));
    entry(*menu, "New link")->trigger();
    QCOMPARE(d.center(8), at);
    entry(*menu, "Tidy")->trigger();
    QCOMPARE(d.steps(), 2);
    QVERIFY(d.center(8) != at);
    QCOMPARE(d.mechanism().view.nodes.size(), std::size_t{9});
  }

  void aLinkThatNothingCarriesCannotBeDriven() {
    ViewDriver d;
    d.key(Qt::Key_L);
    d.click(d.center(0) + CanvasPoint{120, 0});
    QVERIFY(entries(*menuAt(d, d.center(1))).contains("[Drive it (no turning joint carries it yet)]"));
  }

  // --- cycles ---
  void cycleOfAMeshIsWalkedAsInTheRowOfC() {
    const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(test::robotTopology()));
    const std::optional<CycleWalk> walk = cycleWalk(*snapshot, MeshId("16"));
    QVERIFY(walk.has_value());
    QCOMPARE(walk->caption, QString("Cycle C16: 5 ···16··· 2 –12– 1 –10– 0 –9– 5"));
    const IntegerMatrixPtr& rows = snapshot->matrix(MatrixKind::cycleBasis);
    for (int column = 0; column < rows->columns(); ++column) {
      const auto found = walk->emphases.find(rows->columnHeading(column).element);
      QCOMPARE(found == walk->emphases.end() ? 0 : found->second.walk, rows->entry(1, column));
    }
    QVERIFY(!cycleWalk(*snapshot, MeshId("99")).has_value());
  }

  void aMeshSelectedAloneShowsItsCycle() {
    ViewDriver d(placedRobot());
    d.view.setSnapshot(analyze(d.document.mechanism()));
    const auto walked = [&] {
      QStringList labels;
      for (const Mark& mark : d.view.displayList().marks) {
        if (mark.role == MarkRole::walk)
          labels << QString::fromStdString(*labelOf(d.mechanism(), mark.element));
      }
      return labels.join(" ");
    };
    d.click(d.middle(MeshId("15")));
    QCOMPARE(walked(), QString("8 10 15"));
    d.click(d.center(3), Qt::ShiftModifier);
    QCOMPARE(walked(), QString());
    d.view.showCycle(MeshId("18"));
    QCOMPARE(walked(), QString("13 14 18"));
    d.view.showCycle({});
    QCOMPARE(walked(), QString());
    // What the matrices hover for the row C16.
    d.selection.hover({MeshId("16"), JointId("9"), JointId("10"), JointId("12")});
    QCOMPARE(walked(), QString("9 10 12 16"));
    d.selection.hover({MeshId("16"), JointId("9"), JointId("10"), JointId("11")});
    QCOMPARE(walked(), QString());
    d.selection.hover({MeshId("16"), JointId("9")});
    QCOMPARE(walked(), QString());
  }

  // --- colours ---
  void darkAndLightFollowThePaletteUntilChosen() {
    ViewDriver d(placedRobot());
    const auto ground = [&] { return d.view.grab().toImage().pixelColor(3, 3).name(); };
    QPalette dark = d.view.palette();
    dark.setColor(QPalette::Window, QColor("#202020"));
    d.view.setPalette(dark);
    QCOMPARE(ground(), QString("#1e2227"));
    d.view.setTheme(Theme::light);
    QCOMPARE(ground(), QString("#ffffff"));
    d.view.setPalette(QPalette(QColor("#101010")));
    QCOMPARE(ground(), QString("#ffffff"));
  }
};

QTEST_MAIN(DigraphCommandsTest)
#include "test_digraph_commands.moc"
