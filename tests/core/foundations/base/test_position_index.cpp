#include <QTest>

#include "core/foundations/base/position_index.h"

using namespace geargraph;

namespace {

struct Element {
  LinkId id;
};

}  // namespace

class PositionIndexTest : public QObject {
  Q_OBJECT
 private slots:
  void everyElementIsFoundAtItsPosition() {
    std::vector<Element> list;
    for (int i = 0; i < 5000; ++i) list.push_back({LinkId("link " + std::to_string(i * 7))});
    const PositionIndex<LinkTag> index(list);
    for (int i = 0; i < 5000; ++i) QCOMPARE(index.at(LinkId("link " + std::to_string(i * 7))), i);
  }

  void idsThatTheProcessMetFarApartAreFoundToo() {
    std::vector<Element> list;
    for (int i = 0; i < 40'000; ++i) {
      const LinkId id("scattered " + std::to_string(i));
      if (i % 2000 == 0) list.push_back({id});
    }
    const PositionIndex<LinkTag> index(list);
    for (std::size_t i = 0; i < list.size(); ++i) QCOMPARE(index.at(list[i].id), static_cast<int>(i));
    for (int i = 1; i < 2000; ++i) {
      QCOMPARE(index.positionOf(LinkId("scattered " + std::to_string(i))), -1);
    }
  }

  void idsOutsideTheRangeOfAListHaveNoPosition() {
    const LinkId before("met before the list");
    const std::vector<Element> list{{LinkId("met first")}, {LinkId("met second")}, {LinkId("met third")}};
    const LinkId behind("met behind the list");
    const PositionIndex<LinkTag> index(std::vector<Element>{list[2], list[0], list[1]});
    QCOMPARE(index.at(list[2].id), 0);
    QCOMPARE(index.at(list[0].id), 1);
    QCOMPARE(index.at(list[1].id), 2);
    for (const LinkId id : {before, behind, LinkId()}) QCOMPARE(index.positionOf(id), -1);
  }

  void whatIsNotInTheListHasNoPosition() {
    QCOMPARE(PositionIndex<LinkTag>().positionOf(LinkId("1")), -1);
    QCOMPARE(PositionIndex<LinkTag>(std::vector<Element>()).positionOf(LinkId("1")), -1);
    QCOMPARE(PositionIndex<LinkTag>(std::vector<Element>{{LinkId("1")}}).positionOf(LinkId("2")), -1);
  }
};

QTEST_APPLESS_MAIN(PositionIndexTest)
#include "test_position_index.moc"
