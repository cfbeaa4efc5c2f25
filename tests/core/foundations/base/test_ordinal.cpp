#include <QTest>
#include <concepts>
#include <vector>

#include "core/foundations/base/ordinal.h"

namespace geargraph {
namespace {

template <class List, class Index>
concept IndexedBy = requires(List list, Index index) {
  list[index];
};

template <class A, class B>
concept ComparableWith = requires(A a, B b) {
  a == b;
};

template <class A, class B>
concept OrderedWith = requires(A a, B b) {
  a < b;
};

static_assert(ComparableWith<JointOrdinal, JointOrdinal> && ComparableWith<JointOrdinal, int>);
static_assert(OrderedWith<JointOrdinal, JointOrdinal> && OrderedWith<JointOrdinal, int>);
static_assert(IndexedBy<ByMesh<double>, MeshOrdinal> && IndexedBy<SpanByMesh<const double>, MeshOrdinal>);
static_assert(std::convertible_to<const ByMesh<double>&, SpanByMesh<const double>>);
// What may not compile:
static_assert(!std::convertible_to<JointOrdinal, MeshOrdinal>);
static_assert(!std::assignable_from<MeshOrdinal&, JointOrdinal>);
static_assert(!ComparableWith<JointOrdinal, MeshOrdinal>);
static_assert(!IndexedBy<ByMesh<double>, JointOrdinal>);
static_assert(!OrderedWith<JointOrdinal, MeshOrdinal>);
static_assert(!IndexedBy<const ByMesh<double>, JointOrdinal>);
static_assert(!IndexedBy<SpanByMesh<const double>, JointOrdinal>);
static_assert(!std::convertible_to<const ByJoint<double>&, SpanByMesh<const double>>);
static_assert(!std::convertible_to<ByJoint<double>, ByMesh<double>>);
// A copy says what its entries are of; a result that is handed on may be given that meaning.
static_assert(!std::convertible_to<const std::vector<double>&, ByMesh<double>>);
static_assert(std::convertible_to<std::vector<double>, ByMesh<double>>);

}  // namespace

class OrdinalTest : public QObject {
  Q_OBJECT

 private slots:
  void anOrdinalCountsLikeAnInt() {
    JointOrdinal joint = 2;
    QVERIFY(++joint == 3);
    joint += 2;
    QVERIFY(--joint == 4 && --joint == 3);
    QVERIFY(joint++ == 3);
    QCOMPARE(joint - 1, 3);
    QVERIFY(joint == JointOrdinal(4) && joint > 3);
    QVERIFY(JointOrdinal() == 0);
    QVERIFY(JointOrdinal(std::size_t{7}) == 7);
  }

  void aListIsIndexedByTheOrdinalsOfItsKind() {
    ByJoint<double> rates{0.5, 1.5, 2.5};
    QCOMPARE(rates.count(), 3);
    for (const JointOrdinal joint : rates.ordinals()) rates[joint] += joint;
    QVERIFY(rates == (ByJoint<double>{0.5, 2.5, 4.5}));
    const ByJoint<double> same(std::vector<double>(rates.begin(), rates.end()));
    QCOMPARE(same[JointOrdinal(2)], 4.5);
    const SpanByJoint<const double> seen = same;
    QCOMPARE(seen[JointOrdinal(1)], 2.5);
    ByMesh<bool> isClosing(2, false);
    isClosing[MeshOrdinal(1)] = true;
    QVERIFY(!isClosing[0] && isClosing[1]);
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::OrdinalTest)
#include "test_ordinal.moc"
