#include <QTest>
#include <array>
#include <set>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fragment.h"
#include "core/mechanism/model/patch.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {

/// Links keep their colours while labels move.
class LinkColorsTest : public QObject {
  Q_OBJECT

  static std::vector<int> numbersOf(const Mechanism& mechanism) {
    std::vector<int> numbers;
    for (int link = 0; link <= mechanism.n(); ++link) numbers.push_back(mechanism.colorNumber(link));
    return numbers;
  }
  static Mechanism withoutLink(const Mechanism& mechanism, const char* id) {
    const std::array<ElementId, 1> removed{LinkId(id)};
    return withoutElements(mechanism, removed).value();
  }

 private slots:
  void theyAreTheLabelsUntilALinkIsDeleted() {
    const Mechanism robot = test::robotTopology();
    QCOMPARE(numbersOf(robot), (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
    QVERIFY(robot.view.colors.empty());
    const Mechanism after = withoutLink(robot, "3");
    QCOMPARE(numbersOf(after), (std::vector<int>{0, 1, 2, 4, 5, 6, 7}));
    QCOMPARE(after.linkLabel(3), 3);
    QCOMPARE(after.links[3].id, LinkId("4"));
  }

  void theLastOneLeavesNothingToStore() {
    QVERIFY(withoutLink(test::robotTopology(), "7").view.colors.empty());
  }

  // Its label would be 7, which another link has: the first that is free.
  void aNewLinkTakesAColourThatNoOtherHas() {
    const Mechanism after = withoutLink(test::robotTopology(), "3");
    const Mechanism more = withLink(after, {}).value();
    QCOMPARE(numbersOf(more), (std::vector<int>{0, 1, 2, 4, 5, 6, 7, 3}));
    const Mechanism most = withFragment(more, more).value();
    const std::vector<int> numbers = numbersOf(most);
    QCOMPARE(std::set<int>(numbers.begin(), numbers.end()).size(), most.links.size());
  }

  void anotherGroundMovesLabelsAndNoColours() {
    const Mechanism robot = test::robotTopology();
    const Mechanism after = withGround(robot, LinkId("2")).value();
    for (int link = 1; link <= after.n(); ++link) {
      const LinkId id = after.links[static_cast<std::size_t>(link)].id;
      if (id == LinkId("0")) continue;  // had none of its own
      QCOMPARE(after.colorNumber(link), std::stoi(id.text()));
    }
    QCOMPARE(after.colorNumber(0), 0);
    const std::vector<int> numbers = numbersOf(after);
    QCOMPARE(std::set<int>(numbers.begin(), numbers.end()).size(), after.links.size());
  }

  void undoingGivesThemBack() {
    const Mechanism robot = test::robotTopology();
    const Mechanism after = withoutLink(robot, "3");
    const MechanismPatch patch(robot, after);
    QVERIFY(patch.forward(robot) == after);
    QVERIFY(patch.back(after) == robot);
    const Mechanism less = withoutLink(after, "5");
    const MechanismPatch second(after, less);
    QVERIFY(second.forward(after) == less);
    QVERIFY(second.back(less) == after);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::LinkColorsTest)
#include "test_link_colors.moc"
