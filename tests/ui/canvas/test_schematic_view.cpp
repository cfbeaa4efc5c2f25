#include <QMenu>
#include <QSignalSpy>
#include <QTest>

#include "core/mechanism/geometry_edits/axis_drag.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"
#include "tests/support/menu_hand.h"
#include "ui/canvas/schematic_view.h"

using namespace geargraph;

namespace {

struct Driver {
  Document document;
  Selection selection;
  SchematicView view{&document, &selection};

  explicit Driver(const Mechanism& mechanism) {
    view.resize(900, 600);
    view.show();
    static_cast<void>(QTest::qWaitForWindowExposed(&view));
    document.replace(mechanism, "test.geargraph");
    wait();
  }

  void wait() const { QTRY_VERIFY(view.isUpToDate()); }

  /// The axis of the second shaft, as the examples have it.
  [[nodiscard]] AxisId axis() const { return document.mechanism()->axes[1].id; }

  /// Presses on the axis' name and pulls it away from the other axis; returns the reach before.
  AxisReach dragAxis() {
    const AxisReach was = *axisReach(*document.mechanism(), axis());
    const QPoint from = label(axis());
    const int way = from.y() < label(document.mechanism()->axes[0].id).y() ? -1 : 1;
    at = from + QPoint(0, way * 23);
    QTest::mousePress(view.viewport(), Qt::LeftButton, {}, from);
    QTest::mouseMove(view.viewport(), from + QPoint(0, way * 11));
    QTest::mouseMove(view.viewport(), at);
    wait();
    return was;
  }
  void drop() {
    QTest::mouseRelease(view.viewport(), Qt::LeftButton, {}, at);
    wait();
  }
  QPoint at;

  /// A rim of the pinion of spur-pair on the side that meshes with nothing, on the screen, and the way by
  /// which it grows by so many teeth.
  struct RimOnScreen {
    QPoint at;
    QPointF perTooth;
  };
  [[nodiscard]] RimOnScreen rim(LinkId link) const {
    const Mechanism& mechanism = *document.mechanism();
    const GearMesh& mesh = mechanism.gearMeshes.front();
    const int teeth = mesh.tail == link ? mesh.tailTeeth : mesh.headTeeth;
    const std::vector<SheetRim> rims = schematicGeometry(mechanism).rims;
    const SheetRim* best = nullptr;
    double farthest = -1;
    for (const SheetRim& each : rims) {
      if (each.link != link) continue;
      double away = 1e9;  // from the other's rims
      for (const SheetRim& other : rims) {
        if (other.link != link) away = std::min(away, distance(other.from, each.from));
      }
      if (away <= farthest) continue;
      farthest = away;
      best = &each;
    }
    if (best == nullptr) return {};
    const CanvasPoint middle = between(best->from, best->to, 0.5);
    const double scale = view.transform().m11() * best->height / teeth;
    return {view.mapFromScene(middle.x, middle.y), {scale * best->out.x, scale * best->out.y}};
  }

  /// Where an element's label stands on the screen.
  [[nodiscard]] QPoint label(const ElementId& element) const {
    for (const Mark& mark : view.displayList().marks) {
      const auto* text = std::get_if<Text>(&mark.what);
      if (text != nullptr && mark.element == element)
        return view.mapFromScene(text->center.x, text->center.y);
    }
    return {};
  }
  [[nodiscard]] bool isHighlighted(const ElementId& element) const {
    const DisplayList list = view.displayList();
    return std::any_of(list.marks.begin(), list.marks.end(), [&](const Mark& mark) {
      return mark.element == element && mark.role == MarkRole::halo;
    });
  }
};

QStringList entriesOfSchematic(const QMenu& menu) {
  QStringList texts;
  for (const QAction* action : menu.actions()) texts << action->text().section('\t', 0, 0);
  return texts;
}

}  // namespace

class SchematicViewTest : public QObject {
  Q_OBJECT
 private slots:
  void theDocumentIsDrawnAndFitsTheWindow() {
    Driver driver(test::example("robot"));
    QVERIFY(!driver.view.displayList().marks.empty());
    const QRect window = driver.view.viewport()->rect();
    for (const Mark& mark : driver.view.picture().marks) {
      const Extent box = extentOf(mark);
      QVERIFY(window.contains(driver.view.mapFromScene(box.center.x, box.center.y)));
    }
  }

  void aClickSelectsAndTheSelectionIsSeen() {
    Driver driver(test::example("robot"));
    for (const ElementId& element : {ElementId(LinkId("7")), ElementId(JointId("13")),
                                     ElementId(MeshId("17")), ElementId(AxisId("d"))}) {
      QVERIFY(!driver.isHighlighted(element));
      QTest::mouseClick(driver.view.viewport(), Qt::LeftButton, {}, driver.label(element));
      QCOMPARE(driver.selection.selected(), (std::set<ElementId>{element}));
      if (element.kind != ElementKind::turningJoint) QVERIFY(driver.isHighlighted(element));
    }
    driver.selection.select({JointId("13")});
    QVERIFY(driver.isHighlighted(JointId("13")));
  }

  void draggingARimChangesTheTeethInWholeSteps() {
    Driver driver(test::example("spur-pair"));
    const GearMesh before = driver.document.mechanism()->gearMeshes.front();
    const auto mesh = [&] { return driver.document.mechanism()->gearMeshes.front(); };
    const Driver::RimOnScreen rim = driver.rim(before.tail);
    QSignalSpy hints(&driver.view, &DrawingView::hintChanged);
    QTest::mousePress(driver.view.viewport(), Qt::LeftButton, {}, rim.at);
    QTest::mouseMove(driver.view.viewport(), rim.at + QPoint(1, 0));
    QVERIFY(mesh() == before);  // a click may wander
    for (const double teeth : {2.0, 4.1, 6.0})
      QTest::mouseMove(driver.view.viewport(), rim.at + (teeth * rim.perTooth).toPoint());
    QCOMPARE(mesh().tailTeeth, before.tailTeeth + 6);
    QCOMPARE(mesh().headTeeth, before.headTeeth);
    const QString label = QStringLiteral("z = %1").arg(before.tailTeeth + 6);
    QVERIFY(hints.last().first().toString().startsWith(label));
    QVERIFY(driver.view.isDrawing());
    QTest::mouseRelease(driver.view.viewport(), Qt::LeftButton, {}, rim.at + (6 * rim.perTooth).toPoint());
    driver.wait();
    QVERIFY(!driver.view.isDrawing());
    QVERIFY(driver.selection.isSelected(before.tail));
    QCOMPARE(driver.document.undoStack().index(), 1);
    driver.document.undoStack().undo();
    QVERIFY(mesh() == before);
  }

  void escapePutsTheTeethBackAndRejectedOnesSayWhy() {
    Driver driver(test::example("spur-pair"));
    const MechanismPtr before = driver.document.mechanism();
    const LinkId gear = before->gearMeshes.front().tail;
    Driver::RimOnScreen rim = driver.rim(gear);
    QTest::mousePress(driver.view.viewport(), Qt::LeftButton, {}, rim.at);
    QTest::mouseMove(driver.view.viewport(), rim.at + (3 * rim.perTooth).toPoint());
    QVERIFY(driver.document.mechanism() != before);
    QTest::keyClick(&driver.view, Qt::Key_Escape);
    QCOMPARE(*driver.document.mechanism(), *before);
    QCOMPARE(driver.document.undoStack().index(), 0);
    QTest::mouseRelease(driver.view.viewport(), Qt::LeftButton, {}, rim.at);
    // With the places, the module and the partner's teeth pinned nothing can follow.
    std::vector<ElementId> pins{before->gearMeshes.front().id, before->gearMeshes.front().head};
    for (const Axis& axis : before->axes) pins.emplace_back(axis.id);
    driver.document.apply(
        {"Pin", [pins](const PlacedMechanism& m) { return withAllPinned(m, pins, true); }, 0});
    driver.wait();
    const MechanismPtr pinned = driver.document.mechanism();
    QSignalSpy rejected(&driver.document, &Document::rejected);
    rim = driver.rim(gear);
    QTest::mousePress(driver.view.viewport(), Qt::LeftButton, {}, rim.at);
    QTest::mouseMove(driver.view.viewport(), rim.at + (5 * rim.perTooth).toPoint());
    QTest::mouseRelease(driver.view.viewport(), Qt::LeftButton, {}, rim.at);
    QCOMPARE(*driver.document.mechanism(), *pinned);
    QVERIFY(rejected.count() > 0);
  }

  void hoveringInAnotherViewLightsItUpHere() {
    Driver driver(test::example("three-planets"));
    driver.selection.hover(ElementId(LinkId("5")));
    QVERIFY(driver.isHighlighted(LinkId("3")));  // the planet that is drawn for all three
    driver.selection.unhover();
    QVERIFY(!driver.isHighlighted(LinkId("3")));
  }

  void anEditIsDrawnAndAnotherNameIsNot() {
    Driver driver(test::example("spur-pair"));
    QSignalSpy spy(&driver.view, &SchematicView::drawn);
    driver.document.apply(
        {"Rename", [](const Mechanism& m) { return withName(m, LinkId("1"), "pinion"); }, 0});
    QVERIFY(driver.view.isUpToDate());
    const std::string before = textOf(driver.view.picture());
    driver.document.apply({"Teeth", [](const Mechanism& m) { return withTeeth(m, MeshId("5"), 21, 29); }, 0});
    driver.wait();
    QCOMPARE(spy.count(), 1);
    driver.document.apply(
        {"Delete", [](const Mechanism& m) { return withoutElements(m, std::vector<ElementId>{LinkId("2")}); },
         0});
    driver.wait();
    QVERIFY(textOf(driver.view.picture()) != before);
  }

  void whatNobodySeesIsLaidOutWhenItIsShown() {
    Driver driver(test::example("eight-speed-gearbox"));
    QSignalSpy spy(&driver.view, &SchematicView::drawn);
    const auto drag = [&driver](int teeth) {
      driver.document.apply({"Teeth",
                             [teeth](const Mechanism& m) {
                               return withTeethFitted(m, MeshId("25"), m.find(MeshId("25"))->tailTeeth,
                                                      teeth);
                             },
                             0});
    };
    driver.view.hide();
    for (const int teeth : {24, 25, 26}) drag(teeth);
    QVERIFY(driver.view.isSettled() && !driver.view.isUpToDate());  // there is nothing to wait for
    QVERIFY(!driver.view.whyNoPicture().isEmpty());
    const std::string before = textOf(driver.view.displayList());
    driver.view.show();
    QTRY_VERIFY(driver.view.isUpToDate());  // at once, but on a machine that does something else, too
    QVERIFY(textOf(driver.view.displayList()) != before);
    QCOMPARE(spy.count(), 1);
    QTest::qWait(0);
    QCOMPARE(spy.count(), 1);  // and not again
  }

  void thePictureOfWhatNobodySeesIsThatOfTheDocument() {
    Driver driver(test::example("spur-pair"));
    driver.view.hide();
    driver.document.apply({"Teeth", [](const Mechanism& m) { return withTeeth(m, MeshId("5"), 21, 29); }, 0});
    const std::string hidden = textOf(driver.view.picture());
    QVERIFY(driver.view.whyNoPicture().isEmpty());
    const Driver shown(*driver.document.mechanism());
    QCOMPARE(hidden, textOf(shown.view.displayList()));
  }

  /// A drawing that takes longer than a moment is not the last document's meanwhile, and no picture is made.
  void ofALargeTrainThatNobodySawNothingOldIsShown() {
    Driver driver(test::example("robot"));
    driver.view.hide();
    driver.document.replace(test::randomTrain(1, 45, 20), "large.geargraph");
    driver.view.show();
    QVERIFY(!driver.view.isUpToDate() && !driver.view.whyNoPicture().isEmpty());
    QVERIFY(driver.view.displayList().marks.empty());
    QTRY_VERIFY_WITH_TIMEOUT(driver.view.isUpToDate(), 60'000);
    QVERIFY(!driver.view.displayList().marks.empty());
  }

  void menusOfferWhatCanBeDone() {
    Driver driver(test::example("robot"));
    const std::unique_ptr<QMenu> ofJoint(driver.view.contextMenuAt(driver.label(JointId("13"))));
    QVERIFY(entriesOfSchematic(*ofJoint).contains("Drive it"));
    const std::unique_ptr<QMenu> ofAxis(driver.view.contextMenuAt(driver.label(AxisId("d"))));
    QCOMPARE(entriesOfSchematic(*ofAxis),
             (QStringList{"Lay axis d", "Axis d pinned", "", "Delete with its joints"}));
    const std::unique_ptr<QMenu> ofSheet(driver.view.contextMenuAt({3, 3}));
    QVERIFY(!entriesOfSchematic(*ofSheet).contains("New link here"));
    QVERIFY(!entriesOfSchematic(*ofSheet).contains("Tidy the drawing"));
  }

  void aMenuMovesABevelToTheOtherSideOfItsApex() {
    Driver driver(test::example("robot"));
    const auto signOf17 = [&driver] { return placementOf(*driver.document.mechanism()).meshes[2]->sign; };
    const int was = signOf17();
    const std::unique_ptr<QMenu> menu(driver.view.contextMenuAt(driver.label(MeshId("17"))));
    const QStringList texts = entriesOfSchematic(*menu);
    QVERIFY(texts.contains("Move gear 7 to the other side of the apex"));
    menu->actions().at(texts.indexOf("Move gear 6 to the other side of the apex"))->trigger();
    QCOMPARE(signOf17(), -was);
    driver.wait();
    driver.document.undoStack().undo();
    QCOMPARE(signOf17(), was);
  }

  void aDoubleClickOnAnAxisShowsItsJoint() {
    Driver driver(test::example("robot"));
    QSignalSpy spy(&driver.view, &SchematicView::propertiesWanted);
    QTest::mouseDClick(driver.view.viewport(), Qt::LeftButton, {}, driver.label(AxisId("d")));
    QCOMPARE(spy.count(), 1);
    QCOMPARE(spy.front().front().value<ElementId>(), ElementId(JointId("13")));
  }

  void aPlanetarySetIsDrawnFromAnEmptySheet() {
    Driver driver(emptyMechanism());
    const auto drag = [&](ToolKind tool, QPoint from, QPoint to) {
      driver.view.setTool(tool);
      QTest::mousePress(driver.view.viewport(), Qt::LeftButton, {}, from);
      QTest::mouseMove(driver.view.viewport(), (from + to) / 2);
      QTest::mouseMove(driver.view.viewport(), to);
      QTest::mouseRelease(driver.view.viewport(), Qt::LeftButton, {}, to);
      driver.wait();
    };
    const auto mechanism = [&]() -> const Mechanism& { return *driver.document.mechanism(); };
    const auto link = [&](int label) {
      return driver.label(mechanism().links[static_cast<std::size_t>(label)].id);
    };
    const QPoint middle = driver.view.viewport()->rect().center();
    drag(ToolKind::link, middle, middle + QPoint(80, 0));  // the sun
    const auto onAxis = [&](int axis) {
      const QPoint name = driver.label(mechanism().axes[static_cast<std::size_t>(axis)].id);
      return name - QPoint(25, 0);
    };
    drag(ToolKind::link, onAxis(0), onAxis(0) + QPoint(40, 0));  // the carrier
    QCOMPARE(mechanism().axes.size(), std::size_t{1});
    drag(ToolKind::turningJoint, link(2), link(2) - QPoint(0, 140));  // the planet
    QCOMPARE(mechanism().turningJoints.back().tail, mechanism().links[2].id);
    drag(ToolKind::gearMesh, link(1), link(3));
    drag(ToolKind::gearMesh, link(3), QPoint(link(3).x(), 4));  // the ring, in the frame
    QCOMPARE(mechanism().c(), 2);
    QCOMPARE(mechanism().gearMeshes[1].kind, std::optional(MeshKind::internal));
    QCOMPARE(driver.document.undoStack().count(), 5);
    QVERIFY(placementOf(mechanism()).diagnostics.empty());
    const Mechanism drawn = mechanism();
    while (driver.document.undoStack().canUndo()) driver.document.undoStack().undo();
    QCOMPARE(mechanism(), emptyMechanism());
    while (driver.document.undoStack().canRedo()) driver.document.undoStack().redo();
    QCOMPARE(mechanism(), drawn);
  }

  void aDraggedAxisTakesItsModuleAlongAndTeethAreOffered() {
    Driver driver(test::example("spur-pair"));
    const MechanismPtr before = driver.document.mechanism();
    const AxisReach was = driver.dragAxis();
    // Live: the module has followed, the teeth have not, and it is one step.
    const AxisReach now = *axisReach(*driver.document.mechanism(), driver.axis());
    QVERIFY(now.distance > was.distance && now.module > was.module);
    QCOMPARE(driver.document.mechanism()->gearMeshes[0].tailTeeth, before->gearMeshes[0].tailTeeth);
    QVERIFY(std::abs(now.module / 0.05 - std::round(now.module / 0.05)) < 1e-9);
    driver.drop();
    auto* offer = driver.view.findChild<QMenu*>("axisOffer");
    QVERIFY(offer != nullptr && offer->isVisible());
    QAction* teeth = offer->actions().at(2);
    test::clickEntry(*offer, teeth);
    const Mechanism& after = *driver.document.mechanism();
    QVERIFY(after.gearMeshes[0].tailTeeth + after.gearMeshes[0].headTeeth >
            before->gearMeshes[0].tailTeeth + before->gearMeshes[0].headTeeth);
    QVERIFY(std::abs(axisReach(after, driver.axis())->module - was.module) < 1e-9);
    QVERIFY(std::abs(axisReach(after, driver.axis())->distance - now.distance) <= was.module / 4 + 1e-9);
    QCOMPARE(driver.document.undoStack().count(), 1);
    driver.document.undoStack().undo();
    QCOMPARE(*driver.document.mechanism(), *before);
  }

  void escapeLeavesTheOfferAndTheAxisWhereItIs() {
    Driver driver(test::example("spur-pair"));
    const AxisReach was = driver.dragAxis();
    const Mechanism dropped = *driver.document.mechanism();
    driver.drop();
    auto* offer = driver.view.findChild<QMenu*>("axisOffer");
    QTest::keyClick(offer, Qt::Key_Down);
    QVERIFY(driver.document.mechanism()->gearMeshes != dropped.gearMeshes);  // a preview of what is offered
    QTest::keyClick(offer, Qt::Key_Escape);
    QCOMPARE(*driver.document.mechanism(), dropped);
    QCOMPARE(driver.document.undoStack().count(), 1);
    QVERIFY(axisReach(dropped, driver.axis())->distance > was.distance);
    QTRY_VERIFY(driver.view.findChild<QMenu*>("axisOffer") == nullptr);
  }

  void escapeInADragPutsTheAxisBack() {
    Driver driver(test::example("spur-pair"));
    const MechanismPtr before = driver.document.mechanism();
    driver.dragAxis();
    QTest::keyClick(&driver.view, Qt::Key_Escape);
    QCOMPARE(*driver.document.mechanism(), *before);
    QCOMPARE(driver.document.undoStack().count(), 0);
    driver.drop();
    QVERIFY(driver.view.findChild<QMenu*>("axisOffer") == nullptr);
  }

  void whatCannotFollowIsSaidAndTheLastPictureStays() {
    Driver driver(test::example("spur-pair"));
    driver.document.replace(*withPinned(*driver.document.mechanism(), driver.axis(), true), "test.geargraph");
    driver.wait();
    const Mechanism before = *driver.document.mechanism();
    const std::string picture = textOf(driver.view.picture());
    QSignalSpy rejected(&driver.document, &Document::rejected);
    driver.dragAxis();
    QVERIFY(!rejected.empty());
    QCOMPARE(rejected.front().front().value<Diagnostics>().front().elements,
             std::vector<ElementId>{driver.axis()});
    QCOMPARE(*driver.document.mechanism(), before);
    driver.drop();
    QCOMPARE(textOf(driver.view.picture()), picture);
  }

  void escapeGivesADragUp() {
    Driver driver(test::example("spur-pair"));
    driver.view.setTool(ToolKind::link);
    QTest::mousePress(driver.view.viewport(), Qt::LeftButton, {}, {10, 10});
    QTest::keyClick(&driver.view, Qt::Key_Escape);
    QTest::mouseRelease(driver.view.viewport(), Qt::LeftButton, {}, {80, 10});
    QCOMPARE(driver.document.undoStack().count(), 0);
  }
};

QTEST_MAIN(SchematicViewTest)
#include "test_schematic_view.moc"
