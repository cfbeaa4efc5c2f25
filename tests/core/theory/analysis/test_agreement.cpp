#include <QTest>
#include <cmath>
#include <random>
#include <set>

#include "core/theory/analysis/agreement.h"
#include "core/theory/matroid/symbolic_solution.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

namespace geargraph {
namespace {

/// A mechanism with both methods' work.
struct Both {
  explicit Both(const Mechanism& mechanism)
      : worked(mechanism),
        graph(worked.mechanism, worked.graph, worked.tree, ReferenceLines(worked.placement)) {}

  [[nodiscard]] const std::vector<int>& inputs() const { return worked.analysis.choice.joints; }
  [[nodiscard]] const std::vector<Rational>& speeds() const { return worked.analysis.speeds; }
  [[nodiscard]] ExactSolution exact() const { return solveExact(worked.model, inputs(), speeds()).value(); }

  test::Worked worked;
  TtGraph graph;
};

/// A train of n links in general position, its inputs left to the program; a loose one seldom has redundant
/// meshes.
Mechanism randomMechanism(int seed, int n, bool loose = false) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  const auto below = [&](int limit) {
    return static_cast<int>(random() % static_cast<std::uint64_t>(limit));
  };
  const Mechanism train = test::randomTrain(random(), n, loose ? n / 2 : n / 2 + below(n));
  return test::moved(test::withDirectionsScaled(train, {2, Rational(5, 3), 1}),
                     test::rotation(1 + below(4), below(4), below(3) - 1, below(4)),
                     {below(90), -below(70), Rational(below(500), 11)});
}

/// The mechanism with the link beyond `joint` hung on another link of the same axis, and the rates that
/// describe the same motion there: Buchsbaum and Freudenstein's coaxial rearrangement. Nothing where no other
/// link fits.
struct Rehung {
  Mechanism mechanism;
  std::vector<Rational> rates;
};

std::optional<Rehung> rehung(const Both& both, int joint, const std::vector<Rational>& rates) {
  const Digraph& graph = *both.worked.graph;
  const SpanningTree& tree = *both.worked.tree;
  const AxisLevels& levels = both.graph.levels();
  const auto levelOf = [&](int other) { return levels.ofJoint[static_cast<std::size_t>(other)]; };
  const int child = tree.child(joint);
  const int parent = tree.parent(child);
  std::set<int> onAxis;
  bool parentStays = false;
  for (int other = 0; other < graph.t(); ++other) {
    if (other == joint || levelOf(other) != levelOf(joint)) continue;
    for (const int end : {graph.turningEdge(other).tail, graph.turningEdge(other).head}) {
      onAxis.insert(end);
      parentStays = parentStays || end == parent;
    }
  }
  std::erase_if(onAxis, [&](int link) { return link == parent || tree.isOnWalk(joint, link); });
  if (!parentStays || onAxis.empty()) return std::nullopt;

  const int hub = *onAxis.rbegin();
  Rehung result{both.worked.mechanism, rates};
  TurningJoint& moved = result.mechanism.turningJoints[static_cast<std::size_t>(joint)];
  const bool outward = graph.turningEdge(joint).head == child;
  (outward ? moved.tail : moved.head) = graph.nodeId(hub);
  Rational relative;  // of the child against its new parent, along the axis
  for (const PathStep& step : treePath(tree, hub, child)) {
    relative += Rational(step.direction * levels.orientationSign(step.joint)) *
                rates[static_cast<std::size_t>(step.joint)];
  }
  const int sense = outward ? levels.orientationSign(joint) : -levels.orientationSign(joint);
  result.rates[static_cast<std::size_t>(joint)] = Rational(sense) * relative;
  return result;
}

/// Carriers, signs and redundancy agree, and the solutions entry by entry.
void compareAll(const Both& both) {
  QVERIFY(both.graph.isComplete());
  for (int mesh = 0; mesh < both.worked.mechanism.c(); ++mesh) {
    const MeshGeometry& geometry = *both.worked.placement.meshes[static_cast<std::size_t>(mesh)];
    QCOMPARE(both.graph.terminal(mesh)->carrier, geometry.carrier);
    QCOMPARE(both.graph.terminal(mesh)->sign, geometry.sign);
  }
  const ExactSolution exact = both.exact();
  const Agreement agreement = agreementWith(both.graph, exact, both.speeds()).value();
  QVERIFY(agreement.equal);
  QVERIFY(agreement.joints.empty());
  QVERIFY(agreement.largestDifference.isZero());
  QCOMPARE(agreement.compared, static_cast<long long>(exact.outputs.size() * exact.inputs.size()));

  const SubstitutionPlan plan = substitutionPlan(both.graph, both.inputs());
  const TtDetermination determination = ttDetermination(both.graph, plan).value();
  QVERIFY(determination.valid());
  QCOMPARE(static_cast<int>(determination.surplusEquations.size()),
           both.worked.mechanism.c() - both.worked.analysis.rank);
  QVERIFY(agreementOf(exact.rates, ttRates(both.graph, plan, both.speeds()).value()).equal);
  const LiveSolution& live = both.worked.analysis.solution.value();
  for (std::size_t joint = 0; joint < live.rates.size(); ++joint) {
    const double expected = exact.rates[joint].toDouble();
    QVERIFY(std::abs(live.rates[joint] - expected) <= 1e-9 * (1 + std::abs(expected)));
  }
}

}  // namespace

/// Every result twice: the matroid method and the T-T graph, exactly.
class AgreementTest : public QObject {
  Q_OBJECT

 private slots:
  void textbookTrains_data() {
    QTest::addColumn<int>("index");
    int index = 0;
    for (const test::TextbookTrain& train : test::textbookTrains()) {
      QTest::newRow(train.name.c_str()) << index++;
    }
  }

  void textbookTrains() {
    QFETCH(int, index);
    const test::TextbookTrain train = test::textbookTrains()[static_cast<std::size_t>(index)];
    const Mechanism elsewhere =
        test::moved(train.mechanism, test::rotation(2, -1, 3, 1), {5, 0, Rational(7, 9)});
    for (const Mechanism& mechanism :
         {train.mechanism, elsewhere, test::withDirectionsScaled(elsewhere, {4, Rational(1, 3)})}) {
      const Both both(mechanism);
      compareAll(both);
      QCOMPARE(both.worked.analysis.rank, train.rank);
      QCOMPARE(both.worked.analysis.dof, train.freedoms);
      const std::vector<Rational> rates = both.exact().rates;
      for (const auto& [joint, rate] : train.rates) QCOMPARE(rates[static_cast<std::size_t>(joint)], rate);
    }
  }

  void flippedAxesDescribeTheSameMotion() {
    for (const test::TextbookTrain& train : test::textbookTrains()) {
      for (std::size_t axis = 0; axis < train.mechanism.axes.size(); ++axis) {
        const Both both(test::withAxisFlipped(train.mechanism, static_cast<int>(axis)));
        compareAll(both);
        const std::vector<Rational> rates = both.exact().rates;
        for (const auto& [joint, rate] : train.rates) QCOMPARE(rates[static_cast<std::size_t>(joint)], rate);
      }
    }
  }

  void otherTreesDescribeTheSameMotion() {
    std::vector<Mechanism> mechanisms;
    for (const test::TextbookTrain& train : test::textbookTrains()) mechanisms.push_back(train.mechanism);
    for (int seed = 1; seed <= 60; ++seed) mechanisms.push_back(randomMechanism(seed + 2000, 10 + seed % 30));
    int rearranged = 0;
    for (const Mechanism& mechanism : mechanisms) {
      const Both both(mechanism);
      const std::vector<Rational> rates = both.exact().rates;
      for (int joint = 0; joint < mechanism.t(); ++joint) {
        auto other = rehung(both, joint, rates);
        if (!other) continue;
        other->mechanism.inputs.reset();
        const Both changed(other->mechanism);
        std::vector<Rational> speeds;
        for (const int input : changed.inputs())
          speeds.push_back(other->rates[static_cast<std::size_t>(input)]);
        QCOMPARE(solveExact(changed.worked.model, changed.inputs(), speeds)->rates, other->rates);
        const SubstitutionPlan plan = substitutionPlan(changed.graph, changed.inputs());
        QCOMPARE(ttRates(changed.graph, plan, speeds).value(), other->rates);
        QCOMPARE(changed.worked.analysis.rank, both.worked.analysis.rank);
        ++rearranged;
      }
    }
    QVERIFY(rearranged > 200);
  }

  void randomTrains_data() {
    QTest::addColumn<int>("links");
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 150; ++seed)
      QTest::addRow("%d links, %d", 8 + seed % 25, seed) << 8 + seed % 25 << seed;
    for (int seed = 151; seed <= 190; ++seed)
      QTest::addRow("%d links, %d", seed - 80, seed) << seed - 80 << seed;
    for (int seed = 191; seed <= 194; ++seed) QTest::addRow("500 links, %d", seed) << 500 << seed;
  }

  void randomTrains() {
    QFETCH(int, links);
    QFETCH(int, seed);
    compareAll(Both(randomMechanism(seed, links)));
  }

  void functionsOfTheRatiosAgree() {
    int same = 0;
    for (int seed = 1; seed <= 60; ++seed) {
      const Both both(randomMechanism(seed + 1000, 6 + seed % 12, seed % 3 != 0));
      const CoefficientMatrix matrix(both.worked.mechanism, both.worked.model, both.worked.placement);
      const auto matroid = solveSymbolic(both.worked.mechanism, both.worked.model, matrix,
                                         both.worked.analysis.independentMeshes, both.inputs());
      if (!matroid) continue;
      const auto ttGraph =
          ttSymbolicSolution(matroid->ring, both.graph, substitutionPlan(both.graph, both.inputs()));
      QCOMPARE(ttGraph->outputs, matroid->outputs);
      const std::size_t columns = both.inputs().size();
      for (std::size_t row = 0; row < matroid->outputs.size(); ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
          const auto& a = matroid->matrix[row * columns + column];
          const auto& b = ttGraph->entries[row][column];
          if (!a || !b) continue;
          if (both.worked.analysis.redundancies.empty()) {
            QVERIFY(*a == *b);
            ++same;
          } else {  // either may have kept another mesh of a redundant loop
            QCOMPARE(a->valueAt(matroid->ring->values()).value(),
                     b->valueAt(matroid->ring->values()).value());
          }
        }
      }
    }
    QVERIFY(same > 500);
  }

  void aDifferenceIsFoundAndMeasured() {
    const Both both(test::robot());
    ExactSolution wrong = both.exact();
    wrong.matrix[1 * 3 + 0] += Rational(1, 1000);  // joint 12, input 8
    const Agreement agreement = agreementWith(both.graph, wrong, both.speeds()).value();
    QVERIFY(!agreement.equal);
    QCOMPARE(agreement.joints, (std::vector<int>{4}));
    QCOMPARE(agreement.largestDifference, Rational(1, 1000));
  }

  void rowsInAnotherOrderAgree() {
    const Both both(test::robot());
    const auto exact = both.exact();
    ExactSolution swapped = exact;  // as (25) and (45) do
    std::swap(swapped.outputs[2], swapped.outputs[3]);
    std::swap_ranges(swapped.matrix.begin() + 6, swapped.matrix.begin() + 9, swapped.matrix.begin() + 9);
    QVERIFY(agreementWith(both.graph, swapped, both.speeds())->equal);
  }

  void aMeshOfTheOtherSignIsFound() {
    const Both both(test::robot());
    Mechanism other = test::robot();
    other.gearMeshes[0].kind = MeshKind::internal;
    other.gearMeshes[0].pitchPoint.reset();
    const Both turned(other);
    const Agreement agreement = agreementWith(turned.graph, both.exact(), both.speeds()).value();
    QVERIFY(!agreement.equal);
    QCOMPARE(agreement.joints, (std::vector<int>{2, 4, 5, 6}));
  }

  void aRedundantMeshThatOneMethodSeesOtherwiseIsFound() {
    // Three planets; in the other document one planet's second mesh has another ratio, which locks the train.
    const auto planets = [](int teeth) {
      test::TrainBuilder train("planets");
      const int a = train.axis({0, 0, 0}, {0, 0, 1});
      const int sun = train.link(0, a);
      const int ring = train.link(0, a);
      const int carrier = train.link(0, a);
      for (int i = 0; i < 2; ++i) {
        const int b = train.axis({i == 0 ? 40 : -40, 0, 0}, {0, 0, 1});
        const int planet = train.link(carrier, b);
        train.external(sun, a, 24, planet, b, 18);
        train.internal(planet, b, i == 0 ? 18 : teeth, ring, a, 60);
      }
      return train.mechanism();
    };
    const Both good(planets(18));
    const Both locked(planets(19));
    QVERIFY(agreementWith(good.graph, good.exact(), good.speeds())->equal);
    QVERIFY(!agreementWith(locked.graph, good.exact(), good.speeds())->equal);
    ExactSolution ratesOnly = good.exact();
    ratesOnly.matrix.clear();
    QVERIFY(agreementWith(good.graph, ratesOnly, good.speeds())->equal);
    QVERIFY(!agreementWith(locked.graph, ratesOnly, good.speeds())->equal);
  }

  void inputsThatOneMethodRejectsDoNotAgree() {
    const Both both(test::robot());
    ExactSolution wrong = both.exact();
    wrong.inputs = {0, 2, 3};  // 10 follows from 8
    QVERIFY(!agreementWith(both.graph, wrong, both.speeds())->equal);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::AgreementTest)
#include "test_agreement.moc"
