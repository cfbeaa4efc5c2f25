#include <QTest>
#include <random>
#include <set>

#include "tests/ui/tools/pointer_at.h"
#include "ui/tools/snapping.h"
#include "ui/tools/tool_machine.h"

using namespace geargraph;
using test::at;
using test::kJoint;

namespace {

const LinkId kOne("1");
const LinkId kTwo("2");
const MeshId kMesh("15");

Pointer adding(Pointer pointer) {
  pointer.add = true;
  return pointer;
}
Pointer selected(Pointer pointer) {
  pointer.onSelected = true;
  return pointer;
}

using Proposals = std::vector<Proposal>;

}  // namespace

class ToolsTest : public QObject {
  Q_OBJECT
 private slots:
  // --- select ---
  void pressOnALinkSelectsItAtOnce() {
    ToolMachine tool(ToolKind::select);
    QCOMPARE(tool.on(Pressed{at(0, 0, kOne)}), Proposals{SelectOnly{kOne}});
    QCOMPARE(tool.on(Released{at(1, 1, kOne)}), Proposals{SelectOnly{kOne}});
    QVERIFY(tool.isIdle());
  }

  void pressOnASelectedLinkKeepsTheOthersUntilRelease() {
    ToolMachine tool(ToolKind::select);
    QCOMPARE(tool.on(Pressed{selected(at(0, 0, kOne))}), Proposals{});
    QCOMPARE(tool.on(Moved{at(10, 0)}), (Proposals{MoveSelected{10, 0, false}}));
    QCOMPARE(tool.on(Moved{at(10, 20)}), (Proposals{MoveSelected{10, 20, false}}));
    QCOMPARE(tool.on(Released{at(10, 20)}), Proposals{MoveEnded{}});
  }

  void smallWanderingIsStillAClick() {
    ToolMachine tool(ToolKind::select);
    tool.on(Pressed{at(0, 0, kOne)});
    QCOMPARE(tool.on(Moved{at(2, 2, kOne)}), Proposals{});
    QCOMPARE(tool.on(Released{at(2, 2, kOne)}), Proposals{SelectOnly{kOne}});
  }

  void additiveClickToggles() {
    ToolMachine tool(ToolKind::select);
    QCOMPARE(tool.on(Pressed{adding(at(0, 0, kJoint))}), Proposals{});
    QCOMPARE(tool.on(Released{adding(at(0, 0, kJoint))}), Proposals{ToggleSelected{kJoint}});
  }

  void additiveDragTakesTheLinkAlong() {
    ToolMachine tool(ToolKind::select);
    tool.on(Pressed{adding(at(0, 0, kTwo))});
    QCOMPARE(tool.on(Moved{at(9, 0)}), (Proposals{ToggleSelected{kTwo}, MoveSelected{9, 0, false}}));
  }

  void escapeWhileMovingPutsBack() {
    ToolMachine tool(ToolKind::select);
    tool.on(Pressed{at(0, 0, kOne)});
    tool.on(Moved{at(30, 0)});
    QVERIFY(!tool.isIdle());
    QCOMPARE(tool.on(Escaped{}), Proposals{MoveCancelled{}});
    QVERIFY(tool.isIdle());
    QCOMPARE(tool.on(Released{at(30, 0)}), Proposals{});
  }

  void clickOnNothingClears() {
    ToolMachine tool(ToolKind::select);
    tool.on(Pressed{at(0, 0)});
    QCOMPARE(tool.on(Released{at(0, 0)}), Proposals{ClearSelection{}});
    tool.on(Pressed{adding(at(0, 0))});
    QCOMPARE(tool.on(Released{at(0, 0)}), Proposals{});
  }

  void rubberBandSelectsWhatIsInside() {
    ToolMachine tool(ToolKind::select);
    tool.on(Pressed{at(5, 6)});
    QVERIFY(!tool.rubberBand());
    tool.on(Moved{at(100, 80)});
    QCOMPARE(tool.rubberBand(), std::optional(RubberBand{{5, 6}, {100, 80}}));
    QCOMPARE(tool.on(Released{at(100, 80)}), (Proposals{SelectInside{{5, 6}, {100, 80}, false}}));
    QVERIFY(!tool.rubberBand());
  }

  void dragFromAnArrowIsARubberBand() {
    ToolMachine tool(ToolKind::select);
    tool.on(Pressed{adding(at(5, 6, kMesh))});
    tool.on(Moved{at(50, 60)});
    QCOMPARE(tool.on(Released{at(50, 60)}), (Proposals{SelectInside{{5, 6}, {50, 60}, true}}));
  }

  void escapeDropsTheRubberBand() {
    ToolMachine tool(ToolKind::select);
    tool.on(Pressed{at(0, 0)});
    tool.on(Moved{at(50, 50)});
    QCOMPARE(tool.on(Escaped{}), Proposals{});
    QVERIFY(tool.isIdle() && !tool.rubberBand());
  }

  // --- turning joint and gear mesh ---
  void dragBetweenTwoLinksProposesOneJoint() {
    ToolMachine tool(ToolKind::turningJoint);
    QCOMPARE(tool.on(Pressed{at(0, 0, kOne)}), Proposals{});
    tool.on(Moved{at(50, 0)});
    QCOMPARE(tool.arrowDraft(), std::optional(ArrowDraft{ElementKind::turningJoint, kOne, {}, {50, 0}}));
    tool.on(Moved{at(99, 0, kTwo)});
    QCOMPARE(tool.arrowDraft(), std::optional(ArrowDraft{ElementKind::turningJoint, kOne, kTwo, {99, 0}}));
    QCOMPARE(tool.on(Released{at(99, 0, kTwo)}),
             (Proposals{AddJoint{ElementKind::turningJoint, kOne, kTwo}}));
    QVERIFY(tool.isIdle() && !tool.arrowDraft());
  }

  void twoClicksProposeOneMesh() {
    ToolMachine tool(ToolKind::gearMesh);
    tool.on(Pressed{at(0, 0, kOne)});
    QCOMPARE(tool.on(Released{at(0, 0, kOne)}), Proposals{});
    QVERIFY(!tool.isIdle());
    tool.on(Moved{at(70, 0)});
    QCOMPARE(tool.arrowDraft(), std::optional(ArrowDraft{ElementKind::gearMesh, kOne, {}, {70, 0}}));
    QCOMPARE(tool.on(Pressed{at(99, 0, kTwo)}), (Proposals{AddJoint{ElementKind::gearMesh, kOne, kTwo}}));
    QCOMPARE(tool.on(Released{at(99, 0, kTwo)}), Proposals{});
    QVERIFY(tool.isIdle());
  }

  void theFirstLinkIsNoHead() {
    ToolMachine tool(ToolKind::turningJoint);
    tool.on(Pressed{at(0, 0, kOne)});
    tool.on(Moved{at(3, 0, kOne)});
    QVERIFY(tool.arrowDraft()->head.empty());
    tool.on(Released{at(3, 0, kOne)});
    QCOMPARE(tool.on(Pressed{at(3, 0, kOne)}), Proposals{});
    QVERIFY(tool.isIdle());
  }

  void releaseOnNothingGivesUp_data() {
    QTest::addColumn<int>("target");
    QTest::newRow("empty ground") << 0;
    QTest::newRow("another joint") << 1;
  }
  void releaseOnNothingGivesUp() {
    QFETCH(int, target);
    ToolMachine tool(ToolKind::gearMesh);
    tool.on(Pressed{at(0, 0, kOne)});
    const Pointer end = target == 0 ? at(50, 50) : at(50, 50, kJoint);
    QCOMPARE(tool.on(Released{end}), Proposals{});
    QVERIFY(tool.isIdle());
  }

  void pressOnNothingStartsNoArrow() {
    ToolMachine tool(ToolKind::turningJoint);
    tool.on(Pressed{at(0, 0)});
    QVERIFY(tool.isIdle());
    tool.on(Pressed{at(0, 0, kMesh)});
    QVERIFY(tool.isIdle());
  }

  void escapeFromAnyStateIsIdle_data() {
    QTest::addColumn<int>("kind");
    for (int kind = 0; kind < kToolCount; ++kind) {
      QTest::newRow(std::string(toolName(static_cast<ToolKind>(kind))).c_str()) << kind;
    }
  }
  void escapeFromAnyStateIsIdle() {
    QFETCH(int, kind);
    for (const Pointer& start : {at(0, 0), at(0, 0, kOne), at(0, 0, kJoint)}) {
      for (int moves = 0; moves < 2; ++moves) {
        ToolMachine tool(static_cast<ToolKind>(kind));
        tool.on(Pressed{start});
        if (moves == 1) tool.on(Moved{at(40, 40)});
        tool.on(Escaped{});
        QVERIFY(tool.isIdle());
        QVERIFY(!tool.rubberBand() && !tool.arrowDraft() && !tool.linkDraft());
      }
    }
  }

  // --- link, input, pan ---
  void clickOnEmptyGroundProposesALink() {
    ToolMachine tool(ToolKind::link);
    tool.on(Moved{at(5, 5)});
    QCOMPARE(tool.linkDraft(), std::optional(CanvasPoint{5, 5}));
    tool.on(Pressed{at(5, 5)});
    QCOMPARE(tool.on(Released{at(6, 7)}), (Proposals{AddLink{{6, 7}}}));
  }

  void clickOnALinkMakesNoneThere() {
    ToolMachine tool(ToolKind::link);
    tool.on(Moved{at(5, 5, kOne)});
    QVERIFY(!tool.linkDraft());
    tool.on(Pressed{at(5, 5, kOne)});
    QCOMPARE(tool.on(Released{at(5, 5, kOne)}), Proposals{});
  }

  void inputTogglesJointsAndLinksButNoMesh() {
    ToolMachine tool(ToolKind::input);
    QCOMPARE(tool.on(Pressed{at(0, 0, kJoint)}), Proposals{ToggleInput{kJoint}});
    QCOMPARE(tool.on(Pressed{at(0, 0, kOne)}), Proposals{ToggleInput{kOne}});
    QCOMPARE(tool.on(Pressed{at(0, 0, kMesh)}), Proposals{});
    QCOMPARE(tool.on(Pressed{at(0, 0)}), Proposals{});
  }

  void panKeepsTheGrabbedPointUnderTheMouse() {
    ToolMachine tool(ToolKind::pan);
    tool.on(Pressed{at(10, 10, kOne)});
    QCOMPARE(tool.on(Moved{at(13, 8)}), (Proposals{PanBy{3, -2}}));
    // The sheet followed, so the same mouse place is the grabbed point again.
    QCOMPARE(tool.on(Moved{at(10, 10)}), (Proposals{PanBy{0, 0}}));
    QCOMPARE(tool.on(Released{at(10, 10)}), Proposals{});
    QCOMPARE(tool.on(Moved{at(50, 50)}), Proposals{});
  }

  void everyToolHasANameAKeyAndAHint() {
    std::set<char> keys;
    for (int kind = 0; kind < kToolCount; ++kind) {
      const auto tool = static_cast<ToolKind>(kind);
      QVERIFY(!toolName(tool).empty());
      QVERIFY(!ToolMachine(tool).hint().empty());
      keys.insert(toolKey(tool));
    }
    QCOMPARE(keys.size(), std::size_t{kToolCount});
  }

  // --- snapping ---
  void dragSnapsToTheNearestRowAndColumn() {
    const std::vector<CanvasPoint> moving{{0, 0}};
    const std::vector<CanvasPoint> resting{{103, 50}, {98, 200}, {300, 46}};
    const Snap snap = snapped(moving, resting, 100, 47, 6);
    QCOMPARE(snap, (Snap{98, 46, 98.0, 46.0}));
  }

  void snapsAsIfEveryPairWereCompared() {
    std::mt19937 random(5);
    const auto places = [&](int count) {
      std::vector<CanvasPoint> all;
      for (int i = 0; i < count; ++i)
        all.push_back(
            {0.25 * static_cast<double>(random() % 4000), 0.25 * static_cast<double>(random() % 4000)});
      return all;
    };
    for (int round = 0; round < 200; ++round) {
      const std::vector<CanvasPoint> moving = places(1 + static_cast<int>(random() % 5));
      const std::vector<CanvasPoint> resting = places(static_cast<int>(random() % 40));
      constexpr double kReach = 6;
      std::optional<double> least;  // of all corrections in x
      for (const CanvasPoint& node : moving) {
        for (const CanvasPoint& other : resting) {
          const double pull = std::abs(other.x - node.x - 13);
          if (pull <= kReach && (!least || pull < *least)) least = pull;
        }
      }
      const Snap snap = snapped(moving, resting, 13, -7, kReach);
      QCOMPARE(snap.column.has_value(), least.has_value());
      QCOMPARE(std::abs(snap.dx - 13), least.value_or(0));
    }
  }

  void farNodesDoNotPull() {
    const std::vector<CanvasPoint> moving{{0, 0}, {10, 10}};
    const std::vector<CanvasPoint> resting{{200, 200}};
    QCOMPARE(snapped(moving, resting, 50, 60, 6), (Snap{50, 60, {}, {}}));
    QCOMPARE(snapped(moving, {}, 50, 60, 6), (Snap{50, 60, {}, {}}));
  }
};

QTEST_GUILESS_MAIN(ToolsTest)
#include "test_tools.moc"
