#include <QTest>

#include "core/mechanism/model/element_index.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/train_sketch.h"

namespace geargraph {

class ElementIndexTest : public QObject {
  Q_OBJECT

  template <class List, class Find>
  static void checkFinds(const List& list, const Mechanism& mechanism, const ElementIndex& index, Find find) {
    for (const auto& element : list) {
      QVERIFY(index.contains(element.id));
      QCOMPARE(index.labelOf(element.id), labelOf(mechanism, element.id));
      QCOMPARE(find(element.id), &element);
    }
  }

 private slots:
  void answersAsTheMechanismDoes() {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const auto train = std::make_shared<const Mechanism>(test::randomTrain(seed, 60, 24));
      const ElementIndex index(train);
      const auto find = [&](auto id) { return index.find(id); };
      checkFinds(train->links, *train, index, find);
      checkFinds(train->axes, *train, index, find);
      checkFinds(train->turningJoints, *train, index, find);
      checkFinds(train->gearMeshes, *train, index, find);
    }
  }

  void knowsWhatIsNotThere() {
    Mechanism robot = test::robotTopology();
    robot.couplings.push_back({ShiftElementId("B1"), ShiftElementKind::brake, {LinkId("1")}, {}});
    robot.states.push_back({"first", {ShiftElementId("B1")}, {}, {}, {}});
    const ElementIndex index(std::make_shared<const Mechanism>(std::move(robot)));
    QVERIFY(index.find(LinkId("no such link")) == nullptr);
    QVERIFY(index.find(JointId("1")) == nullptr);  // the id of a link
    QVERIFY(!index.labelOf(LinkId("no such link")));
    QVERIFY(!index.labelOf(AxisId("no such axis")));
    QVERIFY(!index.contains(ShiftElementId("B2")));
    QVERIFY(!index.contains(WheelId("w")));
    QVERIFY(index.contains(ShiftElementId("B1")));
    QCOMPARE(index.labelOf(ShiftElementId("B1")), std::optional<std::string>("B1"));
    QVERIFY(index.contains(ElementId(ElementKind::state, InternedString("first"))));
    QVERIFY(!index.contains(ElementId(ElementKind::state, InternedString("second"))));
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::ElementIndexTest)
#include "test_element_index.moc"
