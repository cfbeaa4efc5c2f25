#include <QTest>

#include "tests/ui/tools/pointer_at.h"
#include "ui/tools/load_tool.h"
#include "ui/tools/tool_machine.h"

using namespace geargraph;
using test::at;
using test::kJoint;

namespace {

/// What the tool proposes for these events, one after the other.
class MouseHand {
 public:
  std::optional<std::variant<load_tool::PullTorque, load_tool::TorqueSet, load_tool::TorquePutBack,
                             load_tool::TypeTorque>>
  on(const ToolEvent& event) {
    load_tool::Step step = load_tool::on(m_state, event);
    m_state = step.next;
    return step.proposal;
  }
  [[nodiscard]] bool isIdle() const { return m_state.index() == 0; }
  [[nodiscard]] std::string_view hint() const { return load_tool::hint(m_state); }

 private:
  load_tool::State m_state;
};

template <class Proposal>
bool is(const auto& found, const Proposal& wanted) {
  return found && std::holds_alternative<Proposal>(*found) && std::get<Proposal>(*found) == wanted;
}

}  // namespace

class LoadToolTest : public QObject {
  Q_OBJECT
 private slots:
  void aDragCountsSteps() {
    MouseHand hand;
    QVERIFY(!hand.on(Pressed{at(0, 0, kJoint)}));
    QVERIFY(!hand.isIdle());
    QVERIFY(!hand.on(Moved{at(2, 2)}));  // a click may wander
    QVERIFY(is(hand.on(Moved{at(8, 0)}), load_tool::PullTorque{kJoint, 2, false}));
    QVERIFY(is(hand.on(Moved{at(0, -12)}), load_tool::PullTorque{kJoint, 3, false}));
    Pointer fine = at(-20, 0);
    fine.unsnapped = true;
    QVERIFY(is(hand.on(Moved{fine}), load_tool::PullTorque{kJoint, -5, true}));
    QVERIFY(is(hand.on(Moved{at(0, 0)}), load_tool::PullTorque{kJoint, 0, false}));
    QVERIFY(is(hand.on(Released{at(0, 0)}), load_tool::TorqueSet{}));
    QVERIFY(hand.isIdle());
  }
  void aClickIsForTyping() {
    MouseHand hand;
    hand.on(Pressed{at(0, 0, LinkId("1"))});
    QVERIFY(is(hand.on(Released{at(1, 1)}), load_tool::TypeTorque{LinkId("1")}));
  }
  void escPutsBack() {
    MouseHand hand;
    hand.on(Pressed{at(0, 0, kJoint)});
    QVERIFY(!hand.on(Escaped{}));
    QVERIFY(hand.isIdle());
    hand.on(Pressed{at(0, 0, kJoint)});
    hand.on(Moved{at(40, 0)});
    QVERIFY(hand.hint().find("Esc") != std::string_view::npos);
    QVERIFY(is(hand.on(Escaped{}), load_tool::TorquePutBack{}));
    QVERIFY(hand.isIdle());
  }
  void whatBearsNoLoadIsNotGrabbed() {
    MouseHand hand;
    hand.on(Pressed{at(0, 0)});
    QVERIFY(hand.isIdle());
    hand.on(Pressed{at(0, 0, MeshId("15"))});
    QVERIFY(hand.isIdle());
  }
  void itHasAKeyAndAName() {
    QCOMPARE(toolKey(ToolKind::load), 'W');
    QCOMPARE(toolName(ToolKind::load), std::string_view("Load"));
    QVERIFY(ToolMachine(ToolKind::load).hint().find("10 Nm") != std::string_view::npos);
  }
};

QTEST_APPLESS_MAIN(LoadToolTest)
#include "test_load_tool.moc"
