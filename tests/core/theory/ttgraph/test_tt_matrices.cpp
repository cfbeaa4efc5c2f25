#include <QTest>
#include <map>
#include <vector>

#include "core/theory/ttgraph/tt_matrices.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/tt_case.h"

namespace geargraph {
namespace {

using Row = std::map<int, int>;  ///< the non-zeros, by column

Row rowOf(const std::vector<TtEntry>& entries) {
  Row row;
  for (const TtEntry& entry : entries) row[entry.column] = entry.value;
  return row;
}

struct Dense {
  std::vector<Row> circuits;
  std::vector<Row> cutsets;

  explicit Dense(const TtGraph& graph) {
    const TtMatrices matrices(graph);
    for (int chord = 0; chord < matrices.chords(); ++chord)
      circuits.push_back(rowOf(matrices.circuit(chord)));
    for (int branch = 0; branch < matrices.branches(); ++branch)
      cutsets.push_back(rowOf(matrices.cutset(branch)));
  }

  /// How many entries of B Q'^T are not 0.
  [[nodiscard]] int productsThatDiffer() const {
    int count = 0;
    for (const Row& circuit : circuits) {
      for (const Row& cutset : cutsets) {
        int sum = 0;
        for (const auto& [column, value] : circuit) {
          const auto other = cutset.find(column);
          if (other != cutset.end()) sum += value * other->second;
        }
        if (sum != 0) ++count;
      }
    }
    return count;
  }
};

/// The entries that the T-T graph's statics takes (ttTorques(), CutsetEquations(TtGraph)): by branch, from
/// the circuits that are written down once for all chords.
std::vector<Row> cutsetsOfStatics(const TtGraph& graph) {
  const int t = graph.graph().t();
  std::vector<Row> rows(static_cast<std::size_t>(t));
  for (int branch = 0; branch < t; ++branch) rows[static_cast<std::size_t>(branch)][branch] = 1;
  for (int mesh = 0; mesh < graph.graph().c(); ++mesh) {
    for (const CircuitTerm& term : graph.tailCircuit(mesh))
      rows[static_cast<std::size_t>(term.joint)][t + 2 * mesh] = term.coefficient;
    for (const CircuitTerm& term : graph.headCircuit(mesh))
      rows[static_cast<std::size_t>(term.joint)][t + 2 * mesh + 1] = term.coefficient;
  }
  int column = t + 2 * graph.graph().c();
  for (const HeldCircuit& held : graph.held()) {
    for (const CircuitTerm& term : held.terms)
      rows[static_cast<std::size_t>(term.joint)][column] += term.coefficient;
    ++column;
  }
  return rows;
}

bool agreesWithStatics(const TtGraph& graph) {
  return Dense(graph).cutsets == cutsetsOfStatics(graph);
}

}  // namespace

class TtMatricesTest : public QObject {
  Q_OBJECT

 private slots:
  /// (31)-(38) of the paper and their duals: w_12' = ... as columns of the robot's page.
  void theRobotsRows() {
    const test::TtCase robot(test::example("robot"));
    const TtMatrices matrices(robot.graph);
    QCOMPARE(matrices.branches(), 7);
    QCOMPARE(matrices.chords(), 8);
    // (31)-(38): w_10' = w_10 (joint 10), w_40' = w_40 (8); w_51'' = w_50 - w_10 (9, 10), w_21'' = w_21 (12).
    const auto circuit = [&](int chord) { return rowOf(matrices.circuit(chord)); };
    QVERIFY((circuit(0) == Row{{0, -1}, {7, 1}}));
    QVERIFY((circuit(1) == Row{{2, -1}, {8, 1}}));
    QVERIFY((circuit(2) == Row{{1, -1}, {2, 1}, {9, 1}}));
    QVERIFY((circuit(3) == Row{{4, -1}, {10, 1}}));
    // M_10 + M'_10 - M''_51 = 0, M_32 + M''''_32 = 0 and M_21 + M''_21 - M'''_62 = 0,
    // the duals of the above.
    const auto cutset = [&](int branch) { return rowOf(matrices.cutset(branch)); };
    QVERIFY((cutset(2) == Row{{2, 1}, {8, 1}, {9, -1}}));
    QVERIFY((cutset(6) == Row{{6, 1}, {14, 1}}));
    QVERIFY((cutset(4) == Row{{4, 1}, {10, 1}, {11, -1}}));
  }

  void circuitsAndCutsetsOfAllExamplesAreOrthogonal() {
    int shown = 0;
    for (const std::string& name : test::exampleNames()) {
      const Mechanism plain = test::example(name);
      if (!SpanningTree::of(Digraph(plain))) continue;  // one to repair
      std::vector<std::vector<ShiftElementId>> engagements{{}};
      for (const ShiftState& state : plain.states) engagements.push_back(state.engaged);
      for (const std::vector<ShiftElementId>& engaged : engagements) {
        Mechanism mechanism = plain;
        mechanism.engaged = engaged;
        const test::TtCase found(mechanism);
        if (!found.graph.isComplete()) continue;
        QVERIFY2(Dense(found.graph).productsThatDiffer() == 0, name.c_str());
        QVERIFY2(agreesWithStatics(found.graph), name.c_str());
        ++shown;
      }
    }
    QVERIFY2(shown >= 30, qPrintable(QString::number(shown)));
  }

  void circuitsAndCutsetsOfRandomTrainsAreOrthogonal_data() {
    QTest::addColumn<int>("links");
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 40; ++seed) QTest::addRow("8 links, %d", seed) << 8 << seed;
    for (int seed = 41; seed <= 60; ++seed) QTest::addRow("30 links, %d", seed) << 30 << seed;
    for (int seed = 61; seed <= 66; ++seed) QTest::addRow("200 links, %d", seed) << 200 << seed;
    QTest::addRow("500 links") << 500 << 67;
  }

  void circuitsAndCutsetsOfRandomTrainsAreOrthogonal() {
    QFETCH(int, links);
    QFETCH(int, seed);
    const test::TtCase found(
        test::randomTrain(static_cast<std::uint64_t>(seed), links, links / 2 + seed % 7));
    QVERIFY(found.graph.isComplete());
    const Dense dense(found.graph);
    QCOMPARE(dense.productsThatDiffer(), 0);
    QVERIFY(agreesWithStatics(found.graph));
    // One entry turned round is noticed: the test can fail.
    Dense wrong = dense;
    for (Row& cutset : wrong.cutsets) {
      if (cutset.size() < 2) continue;
      cutset.rbegin()->second *= -1;
      QVERIFY(wrong.productsThatDiffer() > 0);
      return;
    }
    QFAIL("No cutset has a chord.");
  }

  /// What the rows say: torques that hold every link in balance do no work at speeds that the circuits allow.
  void speedsOfTheCircuitsDoNoWorkOnTheCutsets() {
    const test::TtCase found(test::randomTrain(5, 12, 8));
    const TtMatrices matrices(found.graph);
    std::vector<int> speeds;   // of branches any, of chords by their circuits
    std::vector<int> torques;  // of chords any, of branches by their cutsets
    for (int branch = 0; branch < matrices.branches(); ++branch) speeds.push_back(3 * branch % 11 - 5);
    for (int chord = 0; chord < matrices.chords(); ++chord) {
      int sum = 0;
      for (const TtEntry& entry : matrices.circuit(chord))
        if (entry.column < matrices.branches())
          sum -= entry.value * speeds[static_cast<std::size_t>(entry.column)];
      speeds.push_back(sum);
    }
    torques.assign(speeds.size(), 0);
    for (int chord = 0; chord < matrices.chords(); ++chord)
      torques[static_cast<std::size_t>(matrices.branches() + chord)] = 5 * chord % 13 - 6;
    for (int branch = 0; branch < matrices.branches(); ++branch) {
      for (const TtEntry& entry : matrices.cutset(branch))
        if (entry.column != branch)
          torques[static_cast<std::size_t>(branch)] -=
              entry.value * torques[static_cast<std::size_t>(entry.column)];
    }
    int power = 0;
    for (std::size_t edge = 0; edge < speeds.size(); ++edge) power += speeds[edge] * torques[edge];
    QCOMPARE(power, 0);
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::TtMatricesTest)
#include "test_tt_matrices.moc"
