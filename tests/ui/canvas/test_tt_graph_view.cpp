#include "core/theory/analysis/analysis.h"
#include "tests/core/support/example_files.h"
#include "tests/ui/canvas/view_driver.h"
#include "ui/canvas/context_menu.h"
#include "ui/canvas/tt_graph_view.h"

#include <QMenu>

using namespace geargraph;

namespace {

Mechanism robot() {
  return test::example("robot");
}

/// A T-T graph view that gets the analysis of every document at once.
struct TtDriver : DriverOf<TtGraphView> {
  explicit TtDriver(const Mechanism& mechanism) {
    const auto analyze = [this] { view.setSnapshot(analyzeLive(document.mechanism(), document.revision())); };
    QObject::connect(&document, &Document::changed, &view, analyze);
    QObject::connect(&document, &Document::replaced, &view, analyze);
    document.replace(mechanism, "test.geargraph");
  }
  [[nodiscard]] QPoint whereIs(int label) const { return onScreen(center(label)); }
  [[nodiscard]] QString walks() const {
    QStringList walks;
    for (const Mark& mark : view.displayList().marks) {
      if (mark.role != MarkRole::walk) continue;
      walks << QString::fromStdString(mark.element.id.text() + " " + nameOf(std::get<Fill>(mark.what).tint));
    }
    return walks.join(", ");
  }
};

const TtGraphScene& sceneOf(const TtDriver& d) {
  return static_cast<const TtGraphScene&>(*d.view.scene());
}

}  // namespace

class TtGraphViewTest : public QObject {
  Q_OBJECT
 private slots:
  void chosenMeshShowsItsCircuitsAndEquations() {
    TtDriver d(robot());
    QVERIFY(d.view.caption().isEmpty());
    d.selection.select({MeshId("16")});
    QCOMPARE(d.walks(), QString("9 accent, 10 accent, 12 negative-ink, 16 accent, 16 negative-ink"));
    QCOMPARE(d.view.caption(),
             (QStringList{"(5,2)(1):  5 –b– 0 –b– 1 –c– 2,  transfer vertex 1", "ω₅₁′′ = −n₂₅ ω₂₁′′   (28)",
                          "ω₅₁′′ = ω₅₀ − ω₁₀   (31)", "ω₂₁′′ = ω₂₁   (35)"}));
    d.selection.select({LinkId("3")});
    QVERIFY(d.view.caption().isEmpty());
    d.view.showCycle(MeshId("18"));
    QCOMPARE(d.view.caption().at(1), QString("ω₇₂′′′′ = n₃₇ ω₃₂′′′′   (30)"));
  }

  void clickPicksBothChordsOfAMesh() {
    TtDriver d(robot());
    d.click(d.middle(MeshId("15")));
    QCOMPARE(d.selected(), QString("15"));
    d.click(d.center(3), Qt::ShiftModifier);
    QCOMPARE(d.selected(), QString("3 15"));
    d.hover(d.center(6));
    QVERIFY(d.selection.isHovered(LinkId("6")));
  }

  void draggedNodeIsOneUndoStepAndLeavesTheDigraphAlone() {
    TtDriver d(robot());
    const NodePositions digraph = d.mechanism().view.nodes;
    const CanvasPoint from = d.center(3);
    d.drag(from, from + CanvasPoint{150, 60}, Qt::AltModifier);
    QCOMPARE(d.steps(), 1);
    QVERIFY(distance(d.center(3), from + CanvasPoint{150, 60}) < 3);  // the mouse moves by pixels
    QCOMPARE(d.mechanism().view.ttNodes.size(), std::size_t{1});
    QVERIFY(d.mechanism().view.nodes == digraph);
    d.document.undoStack().undo();
    QCOMPARE(d.center(3), from);
    QVERIFY(d.mechanism().view.ttNodes.empty());
  }

  void tidyGivesNodesBackToTheLayout() {
    TtDriver d(robot());
    const CanvasPoint from = d.center(3);
    d.drag(from, from + CanvasPoint{150, 60});
    d.view.tidy();
    QCOMPARE(d.center(3), from);
    QCOMPARE(d.steps(), 2);
  }

  void editsComeByKeysAndMenus() {
    TtDriver d(robot());
    d.click(d.center(3));
    d.key(Qt::Key_Delete);
    QCOMPARE(d.mechanism().n(), 6);
    d.document.undoStack().undo();
    d.click(d.middle(JointId("13")));
    d.key(Qt::Key_X);
    QCOMPARE(d.mechanism().turningJoints[5].tail, LinkId("7"));
    const std::unique_ptr<QMenu> menu(d.view.contextMenuAt(d.whereIs(6)));
    QStringList entries;
    for (const QAction* action : menu->actions()) entries << action->text().section('\t', 0, 0);
    QVERIFY2(entries.contains("Rename") && entries.contains("Stop driving it"),
             qPrintable(entries.join("; ")));
  }

  void meshIsDrawnWithTheToolAndGetsItsChords() {
    Mechanism mechanism = robot();
    const std::array<ElementId, 1> mesh{MeshId("15")};
    mechanism = withoutElements(mechanism, mesh).value();
    TtDriver d(mechanism);
    d.view.setTool(ToolKind::gearMesh);
    d.drag(d.center(4), d.center(1));
    QCOMPARE(d.mechanism().c(), 4);
    int lines = 0;
    for (const Outline& outline : d.view.displayList().outlines) {
      const bool line = std::holds_alternative<Curve>(outline.shape);
      lines += line && outline.element == ElementId(d.mechanism().gearMeshes.back().id) ? 1 : 0;
    }
    QCOMPARE(lines, 2);
  }

  void newLinkStandsWhereItWasClicked() {
    TtDriver d(robot());
    d.view.setTool(ToolKind::link);
    const CanvasPoint at = d.center(0) + CanvasPoint{-260, 20};
    d.click(at);
    QCOMPARE(d.mechanism().n(), 8);
    QCOMPARE(d.mechanism().view.ttNodes.size(), std::size_t{1});
    QVERIFY(distance(d.center(8), at) < 2);
    QVERIFY(!d.mechanism().view.nodes.contains(d.link(8)));
    QVERIFY(!d.view.notice().isEmpty());
  }

  void aDeletedLinkLeavesNoPlaceBehind() {
    TtDriver d(robot());
    d.drag(d.center(3), d.center(3) + CanvasPoint{150, 60});
    d.drag(d.center(4), d.center(4) + CanvasPoint{-80, 0});
    d.selection.select({LinkId("3")});
    d.view.deleteSelected();
    QVERIFY(!d.mechanism().view.ttNodes.contains(LinkId("3")));
    QCOMPARE(d.mechanism().view.ttNodes.size(), std::size_t{1});
  }

  void whatIsMissingIsSaid() {
    TtDriver d(robot());
    QVERIFY(d.view.notice().isEmpty());
    d.selection.select({JointId("12")});
    d.view.deleteSelected();
    QVERIFY2(d.view.notice().join(" ").contains("No tree yet"), qPrintable(d.view.notice().join(" ")));
    d.document.undoStack().undo();
    QVERIFY(d.view.notice().isEmpty());
    QVERIFY(d.document.apply(
        {"mesh", [](const Mechanism& m) { return withGearMesh(m, LinkId("4"), LinkId("3")); }, 0}));
    QVERIFY2(d.view.notice().join(" ").contains("mesh 19"), qPrintable(d.view.notice().join(" ")));
  }

  void whatIsMissingIsSaidAboveTheDrawing() {
    TtDriver d(robot());
    d.view.resize(900, 320);  // the height decides how large the drawing is
    d.view.fit();
    d.selection.select({JointId("12")});
    d.view.deleteSelected();
    const Extent drawn = extentOf(d.view.displayList());
    const int textHeight = static_cast<int>(d.view.notice().size()) * QFontMetrics(d.view.font()).height();
    QVERIFY2(d.onScreen({drawn.center.x, drawn.top()}).y() > textHeight + 12,
             qPrintable(QString("%1 lines").arg(d.view.notice().size())));
  }

  void unseenDrawingIsMadeWhenItIsShown() {
    TtDriver d(robot());
    d.view.hide();
    d.document.apply(
        {"mesh", [](const Mechanism& m) { return withoutElements(m, std::array<ElementId, 1>{LinkId("3")}); },
         0});
    d.view.show();
    static_cast<void>(QTest::qWaitForWindowExposed(&d.view));
    for (const Outline& outline : d.view.displayList().outlines) {
      QVERIFY(!(outline.element == ElementId(LinkId("3"))));
    }
  }

  void emptyDocumentSaysWhatToDo() {
    TtDriver d(emptyMechanism());
    QCOMPARE(d.view.displayList().outlines.size(), std::size_t{1});
    QVERIFY(d.view.notice().isEmpty());
  }

  // --- large documents ---
  void aLargeDrawingIsMadeBesideTheWindowsThread() {
    TtDriver d(test::randomTree(23, 1200, 500));
    QVERIFY(d.view.displayList().outlines.empty());
    QVERIFY(!d.view.isUpToDate() && !d.view.whyNoPicture().isEmpty());
    QTRY_VERIFY_WITH_TIMEOUT(d.view.isUpToDate(), 60000);
    QVERIFY(d.view.whyNoPicture().isEmpty());
    QCOMPARE(d.view.picture().outlines.size(), d.view.displayList().outlines.size());
    QCOMPARE(sceneOf(d).parts().count(kNodeDepth), std::size_t{1201});
  }

  void whatStandsOutIsDrawnAloneAndOfThousandsInSlices() {
    TtDriver d(test::randomTree(23, 1200, 500));
    QTRY_VERIFY_WITH_TIMEOUT(d.view.isUpToDate(), 60000);
    const auto halos = [&] { return sceneOf(d).parts().count(kHaloDepth); };
    const quint64 before = sceneOf(d).drawnParts();
    d.click(d.center(700));
    d.click(d.center(30));
    QCOMPARE(d.selected(), QString("30"));
    QCOMPARE(halos(), std::size_t{1});
    QVERIFY2(sceneOf(d).drawnParts() - before < 20,
             qPrintable(QString::number(sceneOf(d).drawnParts() - before)));

    constexpr std::size_t kAll = 1201 + 1200 + 500;
    d.view.selectAll();
    QVERIFY(halos() < kAll / 2);  // no event has been asked to do all of it
    QTRY_COMPARE_WITH_TIMEOUT(halos(), kAll, 60000);
    d.selection.select({d.link(9)});  // the newest selection is what is seen in the end
    QTRY_COMPARE_WITH_TIMEOUT(halos(), std::size_t{1}, 60000);
  }

  void theNewestOfSeveralLargeDocumentsIsShown() {
    TtDriver d(test::randomTree(23, 1200, 500));
    d.document.replace(test::randomTree(5, 900, 300), "other.geargraph");
    d.document.replace(robot(), "robot.geargraph");
    QCOMPARE(sceneOf(d).parts().count(kNodeDepth), std::size_t{8});
    const TtGraphSheet* shown = sceneOf(d).sheet();
    d.document.replace(test::randomTree(5, 800, 300), "third.geargraph");
    QTRY_VERIFY_WITH_TIMEOUT(d.view.isUpToDate(), 60000);
    QVERIFY(sceneOf(d).sheet() != shown);
    QCOMPARE(sceneOf(d).parts().count(kNodeDepth), std::size_t{801});
  }
};

QTEST_MAIN(TtGraphViewTest)
#include "test_tt_graph_view.moc"
