#include <QTest>

#include "core/theory/ttgraph/tt_solution.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"
#include "tests/core/support/tt_case.h"

namespace geargraph {
namespace {

/// The known rates, the freedoms and the redundant meshes come out. False says which did not.
bool isAsKnown(const test::TextbookTrain& train, const Mechanism& mechanism) {
  const test::TtCase found(mechanism);
  if (!found.graph.isComplete()) return false;
  const SubstitutionPlan plan = substitutionPlan(found.graph, found.inputs());
  const TtDetermination determination = ttDetermination(found.graph, plan).value();
  if (!determination.valid()) return false;
  if (static_cast<int>(plan.inputs.size()) != train.freedoms) return false;
  if (static_cast<int>(determination.surplusEquations.size()) != mechanism.c() - train.rank) return false;
  const std::vector<Rational> rates = ttRates(found.graph, plan, found.speeds()).value();
  if (!found.rollsWithoutSliding(rates)) return false;
  for (const auto& [joint, rate] : train.rates) {
    if (rates[static_cast<std::size_t>(joint)] != rate) {
      qWarning("joint %d: %s, known is %s", joint, rates[static_cast<std::size_t>(joint)].toString().c_str(),
               rate.toString().c_str());
      return false;
    }
  }
  return true;
}

}  // namespace

/// The T-T method against trains whose motion is known.
class TtTextbookTest : public QObject {
  Q_OBJECT

 private:
  std::vector<test::TextbookTrain> m_trains = test::textbookTrains();

 private slots:
  void knownTrainsMoveAsKnown_data() {
    QTest::addColumn<int>("index");
    int index = 0;
    for (const test::TextbookTrain& train : test::textbookTrains())
      QTest::newRow(train.name.c_str()) << index++;
  }

  void knownTrainsMoveAsKnown() {
    QFETCH(int, index);
    const test::TextbookTrain& train = m_trains[static_cast<std::size_t>(index)];
    QVERIFY(isAsKnown(train, train.mechanism));
    const Mechanism elsewhere =
        test::moved(train.mechanism, test::rotation(1, 2, -1, 3), {7, Rational(-22, 7), 100});
    QVERIFY(isAsKnown(train, elsewhere));
    QVERIFY(isAsKnown(train, test::withDirectionsScaled(elsewhere, {Rational(3, 2), 5, Rational(1, 9)})));
    for (std::size_t axis = 0; axis < elsewhere.axes.size(); ++axis) {
      QVERIFY(isAsKnown(train, test::withAxisFlipped(elsewhere, static_cast<int>(axis))));
    }
  }

  void doublesCannotTellTheLockedRingFromTheMovableOne() {
    const test::TextbookTrain locked = *std::find_if(m_trains.begin(), m_trains.end(), [](const auto& t) {
      return t.name == "locked by the twentieth digit";
    });
    Rational product = 1;
    for (const GearMesh& mesh : locked.mechanism.gearMeshes)
      product *= Rational(mesh.tailTeeth, mesh.headTeeth);
    QVERIFY(product != Rational(1));
    QVERIFY((product - Rational(1)).abs() < Rational::fromDouble(0x1p-53));
  }

  void tooFewInputsLeaveJointsOpen() {
    const test::TtCase found(m_trains[7].mechanism);  // planetary, one planet
    const TtDetermination determination =
        ttDetermination(found.graph, substitutionPlan(found.graph, std::vector<int>{0})).value();
    QVERIFY(!determination.valid());
    QCOMPARE(determination.openJoints.size(), std::size_t(1));
    QVERIFY(!determination.contradictory);
  }

  /// 1 drives 3 by 20/40, 3 drives 2 by 20/40; 2 turns on the line of 1, which its own axis names the other
  /// way round: it turns as 1 does in space, so against its axis.
  void anAxisThatPointsAgainstTheOneItLiesOnIsMinded() {
    test::TrainSketch train(3);
    train.axis("a", {"0", "0", "0"}).axis("b", {"0", "0", "0"}, {"0", "0", "-1"}).axis("c", {"60", "0", "0"});
    train.joint(0, 1, "a").joint(0, 2, "b").joint(0, 3, "c");
    train.mesh(1, 3, 20, 40).mesh(3, 2, 20, 40).inputs({{4, "1"}});
    const test::TtCase found(train.build());
    const SubstitutionPlan plan = substitutionPlan(found.graph, found.inputs());
    QCOMPARE(ttRates(found.graph, plan, found.speeds()).value(),
             (std::vector<Rational>{1, Rational(-1, 4), Rational(-1, 2)}));
  }

  void tooManyInputsContradict() {
    const test::TtCase found(m_trains[7].mechanism);
    const TtDetermination determination =
        ttDetermination(found.graph, substitutionPlan(found.graph, std::vector<int>{0, 1, 2})).value();
    QVERIFY(determination.openJoints.empty());
    QVERIFY(determination.contradictory);
  }

  void dependentInputsOfTheRightNumberAreRejected() {
    const test::TtCase found(test::robot());  // q10 = -i15 q8 whatever the rest
    const TtDetermination determination =
        ttDetermination(found.graph, substitutionPlan(found.graph, std::vector<int>{0, 2, 3})).value();
    QVERIFY(determination.contradictory);
    QVERIFY(!determination.openJoints.empty());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::TtTextbookTest)
#include "test_tt_textbook.moc"
