#include <QUndoStack>

#include "core/mechanism/placement/placement.h"
#include "core/presentation/drawing/hit_test.h"
#include "tests/ui/canvas/view_driver.h"

using namespace geargraph;

namespace {

const Qt::KeyboardModifiers kAlt = Qt::AltModifier;

/// Draws the paper's robot with nothing but mouse and tool keys.
void drawRobot(ViewDriver& d) {
  const NodePositions places = robotPositions();
  // The ground stands in the middle of an empty sheet; the others lie around it.
  const CanvasPoint origin = d.center(0) - places.at(LinkId("0")) + CanvasPoint{-180, 0};
  const auto place = [&](int link) { return origin + places.at(LinkId(std::to_string(link))); };
  d.drag(d.center(0), place(0), kAlt);
  d.key(Qt::Key_L);
  for (int link = 1; link <= 7; ++link) d.click(place(link));
  d.key(Qt::Key_T);
  for (const auto& [tail, head] : {std::pair{0, 4}, {0, 5}, {0, 1}, {1, 6}, {1, 2}, {2, 7}, {2, 3}}) {
    d.drag(d.center(tail), d.center(head));
  }
  d.key(Qt::Key_G);
  for (const auto& [tail, head] : {std::pair{4, 1}, {5, 2}, {6, 7}, {7, 3}}) {
    d.click(d.center(tail));
    d.click(d.center(head));
  }
  d.key(Qt::Key_I);
  for (const int joint : {0, 1, 3}) {
    d.click(d.middle(d.mechanism().turningJoints[static_cast<std::size_t>(joint)].id));
  }
  d.key(Qt::Key_V);
}

QString arrows(const Mechanism& mechanism) {
  QStringList out;
  const auto label = [&](const ElementId& element) {
    return QString::fromStdString(*labelOf(mechanism, element));
  };
  for (const TurningJoint& j : mechanism.turningJoints) {
    out << label(j.id) + ":" + label(j.tail) + ">" + label(j.head);
  }
  for (const GearMesh& m : mechanism.gearMeshes)
    out << label(m.id) + ":" + label(m.tail) + "~" + label(m.head);
  return out.join(" ");
}

const SheetParts& partsOf(const ViewDriver& d) {
  return static_cast<DrawingScene*>(d.view.scene())->parts();
}

int inkedPixels(QWidget& widget, const QRect& area) {
  const QImage image = widget.grab().toImage();
  const QRgb ground = image.pixel(1, 1);
  int count = 0;
  for (int y = area.top(); y < area.bottom(); ++y) {
    for (int x = area.left(); x < area.right(); ++x) count += image.pixel(x, y) != ground ? 1 : 0;
  }
  return count;
}

}  // namespace

class DigraphViewTest : public QObject {
  Q_OBJECT
 private slots:
  // --- drawing a mechanism ---
  void robotIsDrawnFromAnEmptyDocument() {
    ViewDriver d;
    drawRobot(d);
    QCOMPARE(arrows(d.mechanism()), QString("8:0>4 9:0>5 10:0>1 11:1>6 12:1>2 13:2>7 14:2>3 "
                                            "15:4~1 16:5~2 17:6~7 18:7~3"));
    QCOMPARE(arrows(d.mechanism()), arrows(test::robotTopology()));
    QVERIFY(d.mechanism().inputs.has_value());
    QCOMPARE(d.mechanism().inputs->size(), std::size_t{3});
    QCOMPARE(d.steps(), 1 + 7 + 7 + 4 + 3);
    QCOMPARE(d.mechanism().view.nodes.size(), std::size_t{8});
  }

  void undoToEmptyAndRedoGiveTheVerySameDocuments() {
    ViewDriver d;
    const MechanismPtr empty = d.document.mechanism();
    drawRobot(d);
    const MechanismPtr robot = d.document.mechanism();
    QUndoStack& history = d.document.undoStack();
    while (history.canUndo()) history.undo();
    QCOMPARE(d.document.mechanism(), empty);
    QCOMPARE(d.view.displayList().outlines.size(), std::size_t{1});
    while (history.canRedo()) history.redo();
    QCOMPARE(d.document.mechanism(), robot);
  }

  void emptySheetSaysWhatToDoUntilThereIsALink() {
    ViewDriver d;
    const QRect message(100, d.view.height() / 2 + 55, d.view.width() - 200, 40);
    QVERIFY(inkedPixels(d.view, message) > 100);
    d.key(Qt::Key_L);
    d.click(d.center(0) + CanvasPoint{100, 0});
    QCOMPARE(inkedPixels(d.view, message), 0);
  }

  // --- moving ---
  /// A tooth count that is dragged sends a new mechanism sixty times a second, of which nothing is seen here.
  void whatIsNotInTheDigraphLeavesItAsItIs() {
    ViewDriver d(placedRobot());
    const auto* scene = static_cast<DigraphScene*>(d.view.scene());
    const DigraphGeometryPtr before = scene->geometry();
    const MeshId mesh = d.mechanism().gearMeshes.front().id;
    QVERIFY(d.document.apply({"", [&](const Mechanism& m) { return withTeeth(m, mesh, 19, 57); }, 0}));
    QCOMPARE(scene->geometry(), before);
    QVERIFY(d.document.apply({"", [&](const Mechanism& m) { return withName(m, d.link(2), "arm"); }, 0}));
    QVERIFY(scene->geometry() != before);
    QCOMPARE(QString::fromStdString(scene->geometry()->nodes[2].name), QStringLiteral("arm"));
    d.document.undoStack().undo();
    QVERIFY(scene->geometry()->nodes[2].name.empty());
  }

  void aDragIsOneUndoStep() {
    ViewDriver d(placedRobot());
    const MechanismPtr before = d.document.mechanism();
    d.drag(d.center(3), {700, 90}, kAlt);
    QCOMPARE(d.steps(), 1);
    QCOMPARE(d.mechanism().view.nodes.at(LinkId("3")), (CanvasPoint{700, 90}));
    d.drag(d.center(3), {710, 40}, kAlt);
    QCOMPARE(d.steps(), 2);
    d.document.undoStack().undo();
    QCOMPARE(d.mechanism().view.nodes.at(LinkId("3")), (CanvasPoint{700, 90}));
    d.document.undoStack().undo();
    QCOMPARE(d.document.mechanism(), before);
  }

  void severalSelectedNodesMoveTogether() {
    ViewDriver d(placedRobot());
    d.click(d.center(3));
    d.click(d.center(7), Qt::ShiftModifier);
    d.drag(d.center(7), d.center(7) + CanvasPoint{31, 17}, kAlt);
    QCOMPARE(d.center(7), (CanvasPoint{691, 357}));
    QCOMPARE(d.center(3), (CanvasPoint{691, 177}));
    QCOMPARE(d.center(2), (CanvasPoint{470, 250}));
    QCOMPARE(d.steps(), 1);
  }

  void escapePutsADragBackAndLeavesNoStep() {
    ViewDriver d(placedRobot());
    const Mechanism before = d.mechanism();
    d.press(d.center(3));
    d.move({700, 90});
    d.move({720, 60});
    QVERIFY(!(d.mechanism() == before));
    d.key(Qt::Key_Escape);
    QVERIFY(d.mechanism() == before);
    QCOMPARE(d.document.undoStack().count(), 0);
    d.release({720, 60});
    QVERIFY(d.mechanism() == before);
  }

  void dragsSnapToRowsAndColumnsUnlessAltIsHeld() {
    ViewDriver d(placedRobot());
    d.drag(d.center(3), {473, 100});
    QCOMPARE(d.center(3).x, 470.0);
    d.drag(d.center(3), {500, 103});
    d.drag(d.center(3), {473, 103}, kAlt);
    QCOMPARE(d.center(3), (CanvasPoint{473, 103}));
  }

  void linksWithoutPlacesAreShownAndKeepTheirPlaceWhenOneMoves() {
    Mechanism robot = placedRobot();
    robot.view.nodes.erase(LinkId("7"));
    ViewDriver d(robot);
    const CanvasPoint found = d.center(7);
    QVERIFY(found != CanvasPoint());
    d.drag(d.center(3), {700, 60}, kAlt);
    QCOMPARE(d.center(7), found);
    QVERIFY(d.mechanism().view.nodes.at(LinkId("7")) == found);
  }

  // --- arrows being drawn ---
  void previewFollowsTheArrow() {
    ViewDriver d(placedRobot());
    std::vector<std::optional<JointPreview>> seen;
    connect(&d.view, &DigraphView::previewChanged, this,
            [&](const std::optional<JointPreview>& preview) { seen.push_back(preview); });
    d.key(Qt::Key_G);
    d.press(d.center(6));
    d.move({560, 380});
    d.move(d.center(3));
    d.move({560, 300});
    d.move(d.center(3));
    d.release(d.center(3));
    const LinkId six("6");
    const LinkId three("3");
    using P = JointPreview;
    const ElementKind mesh = ElementKind::gearMesh;
    const std::vector<std::optional<P>> expected{P{mesh, six, {}, false}, P{mesh, six, three, true},
                                                 P{mesh, six, {}, false}, P{mesh, six, three, true},
                                                 std::nullopt};
    QCOMPARE(seen.size(), expected.size());
    QVERIFY(seen == expected);
    QCOMPARE(d.selected(), QString("19"));
  }

  void aLoopOfTurningJointsIsRejectedBeforeTheRelease() {
    ViewDriver d(placedRobot());
    std::optional<JointPreview> last;
    connect(&d.view, &DigraphView::previewChanged, this,
            [&](const std::optional<JointPreview>& preview) { last = preview; });
    int rejections = 0;
    connect(&d.document, &Document::rejected, this, [&](const Diagnostics&) { ++rejections; });
    d.key(Qt::Key_T);
    d.press(d.center(6));
    d.move(d.center(3));
    QVERIFY(last && !last->valid && last->head == LinkId("3"));
    QVERIFY2(d.view.hint().contains("loop"), qPrintable(d.view.hint()));
    d.release(d.center(3));
    QCOMPARE(rejections, 1);
    QCOMPARE(d.steps(), 0);
    QVERIFY(!last);
  }

  void keysLayTheAxisOfTheJointThatIsDrawn() {
    Mechanism two = *withLink(emptyMechanism(), {300, 200});
    two.view.nodes[two.links[0].id] = {100, 200};
    const Qt::Key keys[] = {Qt::Key_X, Qt::Key_Y, Qt::Key_Z};
    for (int along = 0; along < 3; ++along) {
      ViewDriver d(two);
      d.key(Qt::Key_T);
      d.press(d.center(0));
      d.move(d.center(1));
      QVERIFY2(d.view.hint().contains("X, Y or Z"), qPrintable(d.view.hint()));
      d.key(keys[(along + 1) % 3]);  // changed one's mind
      d.key(keys[along]);
      QVERIFY2(d.view.hint().endsWith(QString("along ") + QChar('x' + along)), qPrintable(d.view.hint()));
      d.release(d.center(1));
      QCOMPARE(d.steps(), 1);
      QCOMPARE(d.mechanism().t(), 1);
      const Placement placement = placementOf(d.mechanism());
      for (int i = 0; i < 3; ++i)
        QCOMPARE(placement.axes.at(0).direction[static_cast<std::size_t>(i)], i == along ? 1.0 : 0.0);
      d.document.undoStack().undo();
      QCOMPARE(d.mechanism().t(), 0);
      // The choice was for that stroke.
      d.key(Qt::Key_Escape);
      d.key(Qt::Key_T);
      d.press(d.center(0));
      d.move(d.center(1));
      QVERIFY2(d.view.hint().contains("X, Y or Z"), qPrintable(d.view.hint()));
      d.key(Qt::Key_Escape);
    }
  }

  void escapeGivesUpAnArrowButKeepsTheTool() {
    ViewDriver d(placedRobot());
    d.key(Qt::Key_T);
    d.press(d.center(6));
    d.move(d.center(3));
    d.key(Qt::Key_Escape);
    d.release(d.center(3));
    QCOMPARE(d.steps(), 0);
    QCOMPARE(d.view.tool(), ToolKind::turningJoint);
    d.key(Qt::Key_Escape);
    QCOMPARE(d.view.tool(), ToolKind::select);
  }

  void toolKeysPickToolsAndTellWhatComesNext() {
    ViewDriver d;
    QSignalSpy tools(&d.view, &DigraphView::toolChanged);
    QSignalSpy hints(&d.view, &DigraphView::hintChanged);
    for (int kind = kToolCount - 1; kind >= 0; --kind) {
      const auto tool = static_cast<ToolKind>(kind);
      d.key(static_cast<Qt::Key>(toolKey(tool)));
      QCOMPARE(d.view.tool(), tool);
    }
    QCOMPARE(tools.size(), kToolCount);
    QCOMPARE(hints.size(), kToolCount);
    QCOMPARE(hints.last().first().toString(), d.view.hint());
  }

  // --- inputs ---
  void inputToolTogglesJointsAndTheJointsOfLinks() {
    ViewDriver d(placedRobot());
    const auto inputs = [&] {
      QStringList out;
      if (!d.mechanism().inputs) return QString("none");
      for (const Input& input : *d.mechanism().inputs) out << QString::fromStdString(input.joint.text());
      return out.join(" ");
    };
    d.document.apply({"no inputs", [](const Mechanism& m) { return withInputs(m, std::nullopt); }, 0});
    d.key(Qt::Key_I);
    d.click(d.middle(JointId("12")));
    QCOMPARE(inputs(), QString("12"));
    d.click(d.center(6));
    QCOMPARE(inputs(), QString("12 11"));
    d.click(d.center(2));
    QCOMPARE(inputs(), QString("11"));
    d.click(d.center(6));
    QCOMPARE(inputs(), QString("none"));
    d.click(d.center(0));
    QCOMPARE(inputs(), QString("none"));
    QVERIFY(d.view.hint().contains("ground"));
  }

  // --- zoom and pan ---
  void wheelZoomsAtTheMouse() {
    ViewDriver d(placedRobot());
    const QPoint at(620, 170);
    const QPointF before = d.view.mapToScene(at);
    QWheelEvent event(at, d.view.viewport()->mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(d.view.viewport(), &event);
    QVERIFY(d.view.transform().m11() > 1.3);
    const QPointF off = d.view.mapToScene(at) - before;
    QVERIFY2(std::hypot(off.x(), off.y()) <= 1.5, qPrintable(QString("%1 %2").arg(off.x()).arg(off.y())));
  }

  void keysZoomAndFit() {
    ViewDriver d(placedRobot());
    d.key(Qt::Key_Plus, Qt::ControlModifier);
    QCOMPARE(d.view.transform().m11(), 1.25);
    d.key(Qt::Key_Minus, Qt::ControlModifier);
    QCOMPARE(d.view.transform().m11(), 1.0);
    for (const auto& [code, modifiers] :
         {std::pair{Qt::Key_F, Qt::NoModifier}, std::pair{Qt::Key_0, Qt::ControlModifier}}) {
      for (int i = 0; i < 9; ++i) d.key(Qt::Key_Plus, Qt::ControlModifier);
      QVERIFY(!d.view.viewport()->rect().contains(d.onScreen(d.center(3))));
      d.key(code, modifiers);
      for (int link = 0; link <= 7; ++link) {
        QVERIFY(d.view.viewport()->rect().contains(d.onScreen(d.center(link))));
      }
    }
    d.key(Qt::Key_1, Qt::ControlModifier);
    QCOMPARE(d.view.transform().m11(), 1.0);
  }

  void middleDragAndSpaceDragPan() {
    ViewDriver d(placedRobot());
    QSignalSpy taps(&d.view, &DigraphView::spaceTapped);
    const QPoint start = d.onScreen(d.center(3));
    d.drag({400, 50}, {430, 90}, {}, Qt::MiddleButton);
    QCOMPARE(d.onScreen(d.center(3)) - start, QPoint(30, 40));
    QTest::keyPress(&d.view, Qt::Key_Space);
    d.drag(d.center(1), d.center(1) + CanvasPoint{-20, 10});
    QTest::keyRelease(&d.view, Qt::Key_Space);
    QCOMPARE(d.onScreen(d.center(3)) - start, QPoint(10, 50));
    QCOMPARE(d.steps(), 0);
    QCOMPARE(taps.size(), 0);
    d.key(Qt::Key_Space);
    QCOMPARE(taps.size(), 1);
  }

  void windowThatGrowsShowsTheWholeDrawingUntilItIsMoved() {
    ViewDriver d(placedRobot());
    d.view.fit();
    d.view.resize(500, 320);
    const double small = d.view.transform().m11();
    QVERIFY(small < 1);
    d.view.resize(900, 600);
    QVERIFY(d.view.transform().m11() > small);
    d.view.zoomIn();
    const double chosen = d.view.transform().m11();
    d.view.resize(500, 320);
    QCOMPARE(d.view.transform().m11(), chosen);
  }

  // --- large documents ---
  void aLargeDrawingIsPutUpWhileTheWindowAnswers() {
    Mechanism large = test::randomTree(23, 2400, 1200);
    const NodePositions places = layoutOf(large);
    ViewDriver d(large);
    QVERIFY(!d.view.isSettled());  // no event has been asked to do all of it
    QTRY_VERIFY_WITH_TIMEOUT(d.view.isSettled(), 60000);
    const auto isDrawnAs = [&](const NodePositions& expected) {
      const Mechanism& now = d.mechanism();
      const DisplayList list = digraphDrawing(digraphGeometry(now, expected), {});
      return d.view.displayList().marks == list.marks && partsOf(d).count() > 4800;
    };
    QVERIFY(isDrawnAs(places));
    const QRect seen = d.view.viewport()->rect().adjusted(-2, -2, 2, 2);  // whole pixels
    const QRectF drawn = static_cast<DrawingScene*>(d.view.scene())->drawnRect();
    QVERIFY(d.view.mapToScene(seen).boundingRect().contains(drawn));

    // Edits while the drawing is being made: the last one is what is seen.
    NodePositions moved = places;
    for (int i = 1; i <= 5; ++i) {
      const LinkId link = d.link(100 * i);
      const CanvasPoint to{37.0 * i, -90.0 * i};
      moved[link] = to;
      const auto edit = [&](const Mechanism& m) -> Expected<Mechanism> {
        Mechanism placed = m;
        placed.view.nodes = moved;
        return placed;
      };
      QVERIFY(d.document.apply({QStringLiteral("Move"), edit, 0}));
    }
    QTRY_VERIFY_WITH_TIMEOUT(d.view.isSettled(), 60000);
    QVERIFY(isDrawnAs(moved));
  }

  void aClickDrawsWhatStandsOutAlone() {
    Mechanism large = test::randomTree(23, 1200, 600);
    large.view.nodes = layoutOf(large);
    ViewDriver d(large);
    QTRY_VERIFY_WITH_TIMEOUT(d.view.isSettled(), 60000);
    const auto drawn = [&] { return static_cast<DrawingScene*>(d.view.scene())->drawnParts(); };
    d.click(d.center(700));
    const quint64 before = drawn();
    d.click(d.center(30));
    QVERIFY(d.selection.isSelected(d.link(30)));
    QVERIFY2(drawn() - before < 20, qPrintable(QString::number(drawn() - before)));
  }

  void thousandsOfElementsAreDrawnAgainInSlices() {
    Mechanism large = test::randomTree(23, 1200, 600);
    large.view.nodes = layoutOf(large);
    ViewDriver d(large);
    QTRY_VERIFY_WITH_TIMEOUT(d.view.isSettled(), 60000);
    const auto halos = [&] { return partsOf(d).count(kHaloDepth); };
    constexpr std::size_t kAll = 1201 + 1200 + 600;
    QCOMPARE(halos(), std::size_t{0});
    d.view.selectAll();
    QVERIFY(halos() < kAll / 2);  // no event has been asked to do all of it
    QTRY_COMPARE_WITH_TIMEOUT(halos(), kAll, 60000);

    const LinkId link = d.link(700);
    d.selection.select({link});  // the newest selection is what is seen in the end
    QTRY_COMPARE_WITH_TIMEOUT(halos(), std::size_t{1}, 60000);
    QCOMPARE(d.view.displayList().marks,
             digraphDrawing(d.mechanism(), large.view.nodes, {{link, {.selected = true}}}).marks);
  }

  void allNodesMoveInSlices() {
    Mechanism large = test::randomTree(23, 1200, 600);
    large.view.nodes = layoutOf(large);
    ViewDriver d(large);
    QTRY_VERIFY_WITH_TIMEOUT(d.view.isSettled(), 60000);
    const QRectF before = static_cast<DrawingScene*>(d.view.scene())->drawnRect();
    const auto edit = [](const Mechanism& m) -> Expected<Mechanism> {
      Mechanism moved = m;
      for (auto& [link, place] : moved.view.nodes) place = place + CanvasPoint{300, 700};
      return moved;
    };
    QVERIFY(d.document.apply({QStringLiteral("Move"), edit, 0}));
    QVERIFY(!d.view.isSettled());
    QTRY_VERIFY_WITH_TIMEOUT(d.view.isSettled(), 60000);
    const QRectF after = static_cast<DrawingScene*>(d.view.scene())->drawnRect();
    QCOMPARE(after.topLeft(), before.topLeft() + QPointF(300, 700));
    QCOMPARE(after.size(), before.size());
    const auto& outlines = static_cast<DrawingScene*>(d.view.scene())->outlines();
    QCOMPARE(elementAt(outlines, d.center(5)), std::optional<ElementId>(d.link(5)));
  }

  void largeDocumentsAreLaidOutBesideTheWindowsThread() {
    ViewDriver d;
    d.document.replace(test::randomTree(4, 300, 100), {});
    QVERIFY(d.view.displayList().outlines.empty());
    QTRY_VERIFY_WITH_TIMEOUT(!d.view.displayList().outlines.empty(), 20000);
    QCOMPARE(d.steps(), 0);
    QVERIFY(d.mechanism().view.nodes.empty());
  }

  void aLayoutThatComesTooLateIsDropped() {
    ViewDriver d;
    d.document.replace(test::randomTree(4, 300, 100), {});
    d.document.replace(placedRobot(), {});
    const DisplayList robot = d.view.displayList();
    // The thread of the first document is joined when a third one needs it, so its answer has been queued by
    // then.
    d.document.replace(test::randomTree(5, 200, 50), {});
    QTRY_VERIFY_WITH_TIMEOUT(!d.view.displayList().outlines.empty(), 20000);
    d.document.replace(placedRobot(), {});
    QVERIFY(d.view.displayList() == robot);
  }
};

QTEST_MAIN(DigraphViewTest)
#include "test_digraph_view.moc"
