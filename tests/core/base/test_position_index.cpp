#include <QtTest>

#include "core/base/position_index.h"

using namespace geargraph;

namespace {

struct Element {
  LinkId id;
};

}  // namespace

class TestPositionIndex : public QObject {
  Q_OBJECT
 private slots:
  void everyElementIsFoundAtItsPosition() {
    std::vector<Element> list;
    for (int i = 0; i < 5000; ++i) list.push_back({LinkId("link " + std::to_string(i * 7))});
    const PositionIndex<LinkTag> index(list);
    for (int i = 0; i < 5000; ++i) QCOMPARE(index.at(LinkId("link " + std::to_string(i * 7))), i);
  }

  void whatIsNotInTheListHasNoPosition() {
    QCOMPARE(PositionIndex<LinkTag>().positionOf(LinkId("1")), -1);
    QCOMPARE(PositionIndex<LinkTag>(std::vector<Element>()).positionOf(LinkId("1")), -1);
    QCOMPARE(PositionIndex<LinkTag>(std::vector<Element>{{LinkId("1")}}).positionOf(LinkId("2")), -1);
  }
};

QTEST_APPLESS_MAIN(TestPositionIndex)
#include "test_position_index.moc"
