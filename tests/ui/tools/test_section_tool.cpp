#include <QTest>

#include "tests/ui/tools/pointer_at.h"
#include "ui/tools/section_tool.h"

namespace geargraph::section_tool {
namespace {

using test::at;

const ElementId kOne = LinkId("1");
const ElementId kTwo = LinkId("2");

/// A drag, event by event.
Step dragged(ToolKind tool, const Pointer& from, const Pointer& to) {
  Step step = on(Idle{}, Pressed{from}, tool);
  step = on(step.next, Moved{to}, tool);
  return on(step.next, Released{to}, tool);
}

}  // namespace

/// The diagram of section_tool.h read aloud.
class SectionToolTest : public QObject {
  Q_OBJECT
 private slots:
  void linkDragged_addsAShaft() {
    const Step step = dragged(ToolKind::link, at(0, 0), at(80, 2));
    QVERIFY(std::holds_alternative<Idle>(step.next));
    QCOMPARE(std::get<AddShaft>(step.proposal.value()), (AddShaft{{0, 0}, {80, 2}, {}}));
  }
  void jointDraggedFromALink_addsAShaftThatItCarries() {
    const Step step = dragged(ToolKind::turningJoint, at(0, 0, kTwo), at(0, -90));
    QCOMPARE(std::get<AddShaft>(step.proposal.value()), (AddShaft{{0, -90}, {0, -90}, LinkId("2")}));
  }
  void jointPressedOnNothing_staysIdle() {
    QVERIFY(std::holds_alternative<Idle>(on(Idle{}, Pressed{at(0, 0)}, ToolKind::turningJoint).next));
  }
  void meshDraggedToALink_meshesBoth() {
    const Step step = dragged(ToolKind::gearMesh, at(0, 0, kOne), at(0, -90, kTwo));
    QCOMPARE(std::get<MeshLinks>(step.proposal.value()),
             (MeshLinks{LinkId("1"), LinkId("2"), {0, 0}, {0, -90}}));
  }
  void meshDraggedToNothing_isWithTheGround() {
    const Step step = dragged(ToolKind::gearMesh, at(0, 0, kOne), at(0, -90));
    QVERIFY(std::get<MeshLinks>(step.proposal.value()).head.empty());
  }
  void aClickOrTheSameLink_proposesNothing() {
    QVERIFY(!dragged(ToolKind::gearMesh, at(0, 0, kOne), at(1, 1, kOne)).proposal);
    QVERIFY(!dragged(ToolKind::gearMesh, at(0, 0, kOne), at(50, 0, kOne)).proposal);
    QVERIFY(!dragged(ToolKind::turningJoint, at(0, 0, kOne), at(1, 1, kOne)).proposal);
  }
  void escapeFromAnyState_isIdle() {
    for (const State& state : {State(Idle{}), State(Shaft{}), State(Carried{}), State(Meshing{})}) {
      QVERIFY(std::holds_alternative<Idle>(on(state, Escaped{}, ToolKind::link).next));
    }
  }
  void theDraftFollowsTheMouse() {
    const Step pressed = on(Idle{}, Pressed{at(5, 5)}, ToolKind::link);
    const Step moved = on(pressed.next, Moved{at(50, 6)}, ToolKind::link);
    QCOMPARE(draft(moved.next)->to, (CanvasPoint{50, 6}));
    QVERIFY(!draft(Idle{}).has_value());
    QVERIFY(hint(Idle{}, ToolKind::link) != hint(moved.next, ToolKind::link));
  }

  void selectDragsAnAxis() {
    const ElementId axis = AxisId("b");
    Step step = on(Idle{}, Pressed{at(0, 0, axis)}, ToolKind::select);
    step = on(step.next, Moved{at(1, 1)}, ToolKind::select);
    QVERIFY(!step.proposal);  // a click may wander
    step = on(step.next, Moved{at(0, -9)}, ToolKind::select);
    QCOMPARE(std::get<DragAxis>(*step.proposal), (DragAxis{AxisId("b"), {0, 0}, {0, -9}, false}));
    QCOMPARE(draft(step.next)->style, Draft::Style::axis);
    QCOMPARE(std::get<AxisDropped>(*on(step.next, Released{at(0, -9)}, ToolKind::select).proposal),
             AxisDropped{});
    QCOMPARE(std::get<AxisPutBack>(*on(step.next, Escaped{}, ToolKind::select).proposal), AxisPutBack{});
    QVERIFY(!on(Idle{}, Released{at(0, 0)}, ToolKind::select).proposal);
    for (const ToolKind tool : {ToolKind::turningJoint, ToolKind::gearMesh, ToolKind::input})
      QVERIFY(std::holds_alternative<Idle>(on(Idle{}, Pressed{at(0, 0, axis)}, tool).next));
  }
};

}  // namespace geargraph::section_tool

QTEST_APPLESS_MAIN(geargraph::section_tool::SectionToolTest)
#include "test_section_tool.moc"
