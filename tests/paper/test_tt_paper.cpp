#include <QTest>

#include "core/theory/ttgraph/substitution_steps.h"
#include "tests/core/support/robot_variants.h"

namespace geargraph {
namespace {

/// "w51'' = w50 - w10": a circuit as the paper prints it.
std::string circuitText(const Digraph& graph, const VelocityName& chord, std::span<const CircuitTerm> terms) {
  std::string text = chord.toText() + " =";
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const bool negative = terms[i].coefficient < 0;
    if (i > 0) text += negative ? " -" : " +";
    text += (i == 0 && negative ? " -" : " ") + branchName(graph, terms[i].joint).toText();
  }
  return text;
}

}  // namespace

/// Eqs. (26)-(45) of the paper, by its T-T graph, tolerance zero.
class TtPaperTest : public QObject {
  Q_OBJECT

 private:
  Mechanism robot = test::robot();
  DigraphPtr digraph = std::make_shared<const Digraph>(robot);
  SpanningTreePtr tree = std::make_shared<const SpanningTree>(SpanningTree::of(*digraph).value());
  TtGraph graph{robot, digraph, tree, ReferenceLines(placementOf(robot))};
  // Inputs 8, 9, 11; unknowns 10, 12, 13, 14.
  SubstitutionPlan plan = substitutionPlan(graph, std::vector<int>{0, 1, 3});
  RatioRingPtr teethRing = ttRatioRing(graph, RatioNaming::ttGraph);
  RateMatrix<std::optional<RationalFunction>> solution = ttSymbolicSolution(teethRing, graph, plan).value();
  std::vector<SubstitutionStep> steps = substitutionSteps(teethRing, graph, plan, solution).value();
  EquationNumbers numbers{graph, 4};

  /// The terminal equation of the mesh with this number, in the form of (27).
  [[nodiscard]] std::string terminalEquation(int number) const {
    for (int mesh = 0; mesh < digraph->c(); ++mesh) {
      if (numbers.terminal(mesh) != number) continue;
      const TerminalPair& pair = *graph.terminal(mesh);
      return "(" + std::to_string(pair.tail) + "," + std::to_string(pair.head) + ")(" +
             std::to_string(pair.carrier) + "): " + tailChordName(pair).toText() + " = " +
             (pair.sign < 0 ? "-" : "") + ratioNames(*digraph)[static_cast<std::size_t>(mesh)].inverse + " " +
             headChordName(pair).toText();
    }
    return {};
  }

  [[nodiscard]] std::string circuitEquation(int number) const {
    for (int mesh = 0; mesh < digraph->c(); ++mesh) {
      const TerminalPair& pair = *graph.terminal(mesh);
      if (numbers.tailCircuit(mesh) == number) {
        return circuitText(*digraph, tailChordName(pair), graph.tailCircuit(mesh));
      }
      if (numbers.headCircuit(mesh) == number) {
        return circuitText(*digraph, headChordName(pair), graph.headCircuit(mesh));
      }
    }
    return {};
  }

  [[nodiscard]] const SubstitutionStep& stepOf(const std::string& unknown) const {
    for (const SubstitutionStep& step : steps) {
      if (branchName(*digraph, step.joint).toText() == unknown) return step;
    }
    qFatal("no step gives %s", unknown.c_str());
  }

  /// "-n52*n41 w40 -n52 w50": what an unknown comes to over the inputs, zeros left out.
  [[nodiscard]] std::string afterText(const SubstitutionStep& step) const {
    std::string text;
    for (std::size_t input = 0; input < step.after.size(); ++input) {
      if (step.after[input]->isZero()) continue;
      if (!text.empty()) text += " ";
      text += step.after[input]->toText() + " " + branchName(*digraph, plan.inputs[input]).toText();
    }
    return text;
  }

  [[nodiscard]] std::string beforeText(const SubstitutionStep& step) const {
    std::string text;
    for (const SolvedTerm& term : step.before) {
      if (!text.empty()) text += " ";
      text += term.coefficient.toText() + " " + branchName(*digraph, term.joint).toText();
    }
    return text;
  }

  /// The rows of a symbolic solution in the paper's order, by joint: w10, w21, w32, w72.
  [[nodiscard]] static std::vector<std::vector<std::string>> rowsOf(
      const RateMatrix<std::optional<RationalFunction>>& matrix) {
    std::vector<std::vector<std::string>> rows;
    for (const std::size_t joint : {2, 4, 6, 5}) {
      const auto at = std::find(matrix.outputs.begin(), matrix.outputs.end(), static_cast<int>(joint)) -
                      matrix.outputs.begin();
      auto& row = rows.emplace_back();
      for (const auto& entry : matrix.entries[static_cast<std::size_t>(at)]) row.push_back(entry->toText());
    }
    return rows;
  }

 private slots:
  // The two rows of (26) with across and through variables exchanged; here the across row, for both signs,
  // and n21 = N2 / N1 = 1 / n12. After (26) the paper takes the sign from the directions of rotation, which
  // says nothing for non-parallel axes: it comes from the drawn pose.
  void eq26_relationOfTwoGears() {
    const TerminalPair& opposite = *graph.terminal(0);
    const TerminalPair& together = *graph.terminal(3);
    QCOMPARE(opposite.sign, -1);
    QCOMPARE(together.sign, 1);
    QCOMPARE(opposite.tailTeeth, 18);
    QCOMPARE(opposite.headTeeth, 36);
    QCOMPARE(teethRing->values()[0], Rational(18, 36));
    const auto rates = ttRates(graph, plan, std::vector<Rational>{1, 0, 0}).value();
    // w40' = -n14 w10' with n14 = 36/18 = 2, and w72'''' = n37 w32'''' with n37 = 24/16 = 3/2.
    QCOMPARE(rates[0], Rational(-2) * rates[2]);
    QCOMPARE(rates[5], Rational(3, 2) * rates[6]);
    QVERIFY(!rates[6].isZero());
  }

  // "If both of the gears rotate in the same direction the sign is (+), otherwise the sign is (-)": on
  // parallel axes outer gears turn against each other and a ring turns with its pinion, also where nobody has
  // placed their axes, as in the paper's graphs.
  void eq26_signOfGearsOnParallelAxes() {
    for (const auto& [kind, sign] : {std::pair(MeshKind::external, -1), std::pair(MeshKind::internal, 1)}) {
      test::TrainBuilder train("two gears");
      const int first = train.axis({0, 0, 0}, {0, 0, 1});
      const int second = train.axis({50, 0, 0}, {0, 0, 1});
      train.link(0, first);
      train.link(0, second);
      kind == MeshKind::external ? train.external(1, first, 20, 2, second, 30)
                                 : train.internal(1, first, 20, 2, second, 70);
      const Mechanism& gears = train.mechanism();
      const auto edges = std::make_shared<const Digraph>(gears);
      const auto branches = std::make_shared<const SpanningTree>(SpanningTree::of(*edges).value());
      const Placement placement = placementOf(gears);
      for (const ReferenceLines& lines : {ReferenceLines(placement), ReferenceLines()}) {
        const TtGraph pair(gears, edges, branches, lines);
        QCOMPARE(pair.terminal(0).value().sign, sign);
        // w10 = n21 w20 with its sign, n21 = N2 / N1
        const auto rates = ttSolution(pair, substitutionPlan(pair, std::vector<int>{1})).value();
        const Rational ratio(gears.gearMeshes[0].headTeeth, gears.gearMeshes[0].tailTeeth);
        QCOMPARE(rates.entries[0][0], Rational(sign) * ratio);
      }
    }
  }

  void eq27_terminalEquationOf41() {
    QCOMPARE(terminalEquation(27), std::string("(4,1)(0): w40' = -n14 w10'"));
  }
  void eq28_terminalEquationOf52() {
    QCOMPARE(terminalEquation(28), std::string("(5,2)(1): w51'' = -n25 w21''"));
  }
  // N7 stands for two wheels of link 7: N7' here, N7'' in (30).
  void eq29_terminalEquationOf67() {
    QCOMPARE(terminalEquation(29), std::string("(6,7)(2): w62''' = -n76 w72'''"));
  }
  void eq30_terminalEquationOf73() {
    QCOMPARE(terminalEquation(30), std::string("(7,3)(2): w72'''' = n37 w32''''"));
  }

  // The paper reads (31)-(38) from "Fig. 5"; the chords stand in Fig. 6.
  void eq31_circuitOfChord51() { QCOMPARE(circuitEquation(31), std::string("w51'' = w50 - w10")); }
  void eq32_circuitOfChord62() { QCOMPARE(circuitEquation(32), std::string("w62''' = w61 - w21")); }
  void eq33_circuitOfChord40() { QCOMPARE(circuitEquation(33), std::string("w40' = w40")); }
  void eq34_circuitOfChord10() { QCOMPARE(circuitEquation(34), std::string("w10' = w10")); }
  void eq35_circuitOfChord21() { QCOMPARE(circuitEquation(35), std::string("w21'' = w21")); }
  void eq36_circuitOfChord72() { QCOMPARE(circuitEquation(36), std::string("w72''' = w72")); }
  void eq37_circuitOfSecondChord72() { QCOMPARE(circuitEquation(37), std::string("w72'''' = w72")); }
  void eq38_circuitOfChord32() { QCOMPARE(circuitEquation(38), std::string("w32'''' = w32")); }

  // Printed "(33), (33), and (27)"; meant are (33), (34), and (27).
  void eq39_velocityOfLink1() {
    const SubstitutionStep& step = stepOf("w10");
    QCOMPARE(step.number, 39);
    QCOMPARE(step.uses, (std::vector<int>{34, 27, 33}));
    QCOMPARE(beforeText(step), std::string("-n41 w40"));
    QCOMPARE(afterText(step), std::string("-n41 w40"));
  }

  // The text cites (35), (28), and (39); the circuit (31) is put in too.
  void eq40_velocityOfLink2() {
    const SubstitutionStep& step = stepOf("w21");
    QCOMPARE(step.number, 40);
    QCOMPARE(step.uses, (std::vector<int>{35, 28, 31, 39}));
    QCOMPARE(beforeText(step), std::string("-n52 w50 n52 w10"));
    QCOMPARE(afterText(step), std::string("-n52*n41 w40 -n52 w50"));
  }

  // (36), (29) and (32) are put in for w72, which has no number yet.
  void eq41_velocityOfLink3() {
    const SubstitutionStep& step = stepOf("w32");
    QCOMPARE(step.number, 41);
    QCOMPARE(step.uses, (std::vector<int>{38, 30, 37, 36, 29, 32, 40}));
    QCOMPARE(beforeText(step), std::string("n73 w72"));
    QCOMPARE(afterText(step), std::string("-n73*n67*n52*n41 w40 -n73*n67*n52 w50 -n73*n67 w61"));
  }

  // "Finally, w72 can be obtained from Eq. (41)"
  void eq42_velocityOfLink7() {
    const SubstitutionStep& step = stepOf("w72");
    QCOMPARE(step.number, 42);
    QCOMPARE(step.uses, (std::vector<int>{41}));
    QCOMPARE(beforeText(step), std::string("1/n73 w32"));
    QCOMPARE(afterText(step), std::string("-n67*n52*n41 w40 -n67*n52 w50 -n67 w61"));
    // w72 = n37 w32
    for (std::size_t input = 0; input < 3; ++input) {
      const RationalFunction n73 = RationalFunction::variable(teethRing, 3);
      QCOMPARE(*step.after[input] * n73, *stepOf("w32").after[input]);
    }
  }

  // clang-format off
  void eq43_solutionInTeethRatios() {
    const std::vector<std::vector<std::string>> expected = {
      //  w40                    w50              w61
      {"-n41",               "0",             "0"},         // w10
      {"-n52*n41",           "-n52",          "0"},         // w21
      {"-n73*n67*n52*n41",   "-n73*n67*n52",  "-n73*n67"},  // w32
      {"-n67*n52*n41",       "-n67*n52",      "-n67"},      // w72
    };
    QCOMPARE(rowsOf(solution), expected);
    QCOMPARE(numbers.matrix(), 43);
  }

  void eq44_namesOfTheRatios() {
    std::vector<std::pair<std::string, std::string>> names;
    for (const RatioNames& name : ratioNames(*digraph)) names.emplace_back(name.ttGraph, name.matroid);
    const std::vector<std::pair<std::string, std::string>> expected = {
      {"n41", "i15"}, {"n52", "i16"}, {"n67", "i17"}, {"n73", "i18"},
    };
    QCOMPARE(names, expected);
    QCOMPARE(numbers.names(), 44);
  }

  // "The same as Eq. (25)" by joint: (25) lists 13 = w72 before 14 = w32, (45) the other way round.
  void eq45_solutionInGearRatios() {
    const std::vector<std::vector<std::string>> expected = {
      //  w40                    w50              w61
      {"-i15",               "0",             "0"},         // w10
      {"-i16*i15",           "-i16",          "0"},         // w21
      {"-i18*i17*i16*i15",   "-i18*i17*i16",  "-i18*i17"},  // w32
      {"-i17*i16*i15",       "-i17*i16",      "-i17"},      // w72
    };
    QCOMPARE(rowsOf(ttSymbolicSolution(ttRatioRing(graph, RatioNaming::matroid), graph, plan).value()), expected);
    QCOMPARE(numbers.result(), 45);
  }
  // clang-format on

  void eq45_holdsForTheRobotAgainstItsArrows() {
    const Mechanism against = test::robotAgainstItsArrows();
    const auto edges = std::make_shared<const Digraph>(against);
    const auto branches = std::make_shared<const SpanningTree>(SpanningTree::of(*edges).value());
    const TtGraph found(against, edges, branches, ReferenceLines(placementOf(against)));
    const auto rates = ttSolution(found, substitutionPlan(found, std::vector<int>{0, 1, 3})).value();
    std::vector<Rational> entries;
    for (const auto& row : rates.entries) entries.insert(entries.end(), row.begin(), row.end());
    QCOMPARE(entries, test::solutionAgainstItsArrows());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::TtPaperTest)
#include "test_tt_paper.moc"
