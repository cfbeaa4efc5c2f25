#include <QRegularExpression>
#include <QTest>
#include <functional>
#include <map>
#include <set>

#include "core/teaching/exercises/exercise_sheet.h"
#include "core/teaching/grading/grade.h"
#include "core/theory/matroid/input_sets.h"
#include "core/theory/ttgraph/tt_solution.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"

namespace geargraph {

/// Right answers and the classic mistakes, worked out here from the document alone, by walking its lists;
/// speeds and inputs by the other method. Nothing is read from the keys of the questions.
class IndependentAnswersTest : public QObject {
  Q_OBJECT

  /// The document's graph by labels.
  struct Graph {
    explicit Graph(const Mechanism& mechanism) : n(mechanism.n()) {
      std::map<std::string, int> labels;
      for (int i = 0; i <= n; ++i) labels[mechanism.links[static_cast<std::size_t>(i)].id.text()] = i;
      int label = n;
      for (const TurningJoint& joint : mechanism.turningJoints)
        joints[++label] = {labels.at(joint.tail.text()), labels.at(joint.head.text())};
      for (const GearMesh& mesh : mechanism.gearMeshes)
        meshes[++label] = {labels.at(mesh.tail.text()), labels.at(mesh.head.text())};
    }
    /// The joints on the path, 1 where it follows the arrow.
    [[nodiscard]] std::map<int, int> path(int from, int to) const {
      std::set<int> seen{from};
      std::map<int, int> steps;
      const std::function<bool(int)> reach = [&](int at) {
        if (at == to) return true;
        for (const auto& [label, ends] : joints) {
          const int next = ends.first == at ? ends.second : ends.second == at ? ends.first : -1;
          if (next < 0 || !seen.insert(next).second) continue;
          steps[label] = ends.first == at ? 1 : -1;
          if (reach(next)) return true;
          steps.erase(label);
        }
        return false;
      };
      if (!reach(from)) qFatal("no path");
      return steps;
    }
    [[nodiscard]] std::map<int, int> cycle(int mesh) const {
      std::map<int, int> steps = path(meshes.at(mesh).second, meshes.at(mesh).first);
      steps[mesh] = 1;
      return steps;
    }
    [[nodiscard]] std::pair<int, int> ends(int edge) const {
      return joints.contains(edge) ? joints.at(edge) : meshes.at(edge);
    }
    [[nodiscard]] int incidence(int link, int edge) const {
      return link == ends(edge).second ? 1 : link == ends(edge).first ? -1 : 0;
    }
    int n;
    std::map<int, std::pair<int, int>> joints, meshes;
  };

  std::map<std::string, int> m_checked;

  static std::pair<int, int> place(const std::string& name) {
    QString row = QString::fromStdString(name).section(',', 0, 0);
    row.remove(QRegularExpression("[^0-9]"));
    return {row.toInt(), QString::fromStdString(name).section(',', 1).toInt()};
  }
  static std::vector<std::string> filled(const Question& question,
                                         const std::function<int(int, int)>& entry) {
    std::vector<std::string> answer;
    for (const AnswerField& field : question.fields) {
      const auto [row, column] = place(field.name);
      answer.push_back(std::to_string(entry(row, column)));
    }
    return answer;
  }
  static int at(const std::map<int, int>& row, int column) {
    return row.contains(column) ? row.at(column) : 0;
  }
  static std::string name(const Question& question, const std::vector<std::string>& answer) {
    const Verdict verdict = grade(question, answer);
    return verdict.isRight ? "right" : verdict.mistake ? verdict.mistake->name : "unnamed";
  }
  void expect(const Question& question, const std::vector<std::string>& answer,
              const std::set<std::string>& names) {
    const std::string told = name(question, answer);
    QVERIFY2(names.contains(told), (question.kind + ": " + question.prompt + " told as " + told).c_str());
    ++m_checked[*names.begin()];
  }
  /// Where the mistaken answer is not the right one by chance.
  void expectMistake(const Question& question, const std::vector<std::string>& answer,
                     const std::vector<std::string>& right, const std::set<std::string>& names) {
    if (answer != right) expect(question, answer, names);
  }

  void checkMatrices(const ExerciseSource& source, const Graph& graph, std::uint64_t seed) {
    ExerciseRandom random(seed);
    const auto make = [&](ExerciseKind kind) { return makeQuestion(source, kind, random); };
    const Question incidence = make(ExerciseKind::incidence);
    const auto right = filled(incidence, [&](int link, int edge) { return graph.incidence(link, edge); });
    expect(incidence, right, {"right"});
    expect(incidence, filled(incidence, [&](int l, int e) { return -graph.incidence(l, e); }),
           {"incidence-exchanged"});
    expect(incidence, filled(incidence, [&](int l, int e) { return std::abs(graph.incidence(l, e)); }),
           {"signs-left-out"});

    const Question reduced = make(ExerciseKind::reducedIncidence);
    auto withGround = filled(reduced, [&](int link, int edge) { return graph.incidence(link, edge); });
    expect(reduced, withGround, {"ground-row-left-in"});
    for (std::size_t i = 0; i < reduced.fields.size(); ++i) {
      if (place(reduced.fields[i].name).first == 0) withGround[i].clear();
    }
    expect(reduced, withGround, {"right"});

    const Question path = make(ExerciseKind::path);
    const auto z = [&](int joint, int link) { return at(graph.path(link, 0), joint); };
    const auto walks = filled(path, z);
    expect(path, walks, {"right"});
    expect(path, filled(path, [&](int j, int l) { return -z(j, l); }), {"walk-from-ground"});
    const std::size_t size = path.table.columns.size();
    std::vector<std::string> transposed = walks;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) transposed[i * size + j] = walks[j * size + i];
    }
    expectMistake(path, transposed, walks,
                  {"transposed", "walk-from-ground", "signs-left-out", "another-link", "joint-left-out",
                   "joint-off-the-walk", "walked-against-arrow"});
    if (name(path, transposed) == "transposed") ++m_checked["transposed itself"];

    const Question cycles = make(ExerciseKind::cycleBasis);
    const int mesh = place(cycles.fields.front().name).first;
    const auto c = [&](int row, int edge) { return at(graph.cycle(row), edge); };
    const auto row = filled(cycles, c);
    expect(cycles, row, {"right"});
    expect(cycles, filled(cycles, [&](int r, int e) { return -c(r, e); }), {"cycle-backwards"});
    for (const auto& [other, ends] : graph.meshes) {
      const int wanted = other;
      expectMistake(cycles, filled(cycles, [&](int, int e) { return c(wanted, e); }), row,
                    {"another-cycle", "another-mesh-in-cycle", "own-mesh-left-out"});
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      const int edge = place(cycles.fields[i].name).second;
      if (row[i] == "0" || edge == mesh) continue;
      std::vector<std::string> against = row;
      against[i] = row[i] == "1" ? "-1" : "1";
      expect(cycles, against, {"walked-against-arrow", "signs-left-out", "cycle-backwards"});
    }

    const Question tree = make(ExerciseKind::treeMatrix);
    expect(tree, filled(tree, c), {"right"});

    const Question cutset = make(ExerciseKind::cutset);
    const auto q = [&](int joint, int edge) {  // which halves the ends of an edge are in
      const int beyond = graph.joints.at(joint).second;
      const auto side = [&](int link) { return graph.path(link, beyond).contains(joint) ? 0 : 1; };
      return side(graph.ends(edge).second) - side(graph.ends(edge).first);
    };
    const int cut =
        QString::fromStdString(cutset.table.rows.front()).remove(QRegularExpression("[^0-9]")).toInt();
    expect(cutset, filled(cutset, [&](int, int edge) { return q(cut, edge); }), {"right"});
    expectMistake(
        cutset, filled(cutset, [&](int, int e) { return graph.meshes.contains(e) ? -q(cut, e) : q(cut, e); }),
        filled(cutset, [&](int, int edge) { return q(cut, edge); }), {"cutset-as-cycle"});
  }

  void checkEquations(const ExerciseSource& source, const Graph& graph, std::uint64_t seed) {
    ExerciseRandom random(seed);
    const MatroidAnalysis& matroid = *source.matroid();
    const int c = static_cast<int>(graph.meshes.size());
    const auto text = [](int value) { return std::to_string(value); };
    const Question freedom = makeQuestion(source, ExerciseKind::freedom, random);
    expect(freedom, {text(matroid.rank), text(graph.n - matroid.rank)}, {"right"});
    if (matroid.rank < c) {
      expect(freedom, {text(c), text(graph.n - c)}, {"kutzbach-with-redundant-mesh"});
    }

    // The transfer vertex one link too early or too late.
    const Question levels = makeQuestion(source, ExerciseKind::levels, random);
    const std::string carrier = levels.solution[2];
    for (const std::string& link : levels.fields[2].options) {
      if (link == carrier) continue;
      expect(levels, {levels.solution[0], levels.solution[1], link},
             {"wrong-level", "gear-as-carrier", "ground-as-carrier", "carrier-off-the-path"});
    }

    // Terminal equations by the geometry of the mesh and its teeth.
    const Question terminal = makeQuestion(source, ExerciseKind::terminalEquation, random);
    for (std::size_t i = 0; i < source.mechanism().gearMeshes.size(); ++i) {
      if (terminal.elements.front() != ElementId(source.mechanism().gearMeshes[i].id)) continue;
      const MeshGeometry& geometry = *source.snapshot()->kinematics->placement().meshes[i];
      const Rational size(geometry.headTeeth, geometry.tailTeeth);
      const std::string k = std::to_string(geometry.carrier);
      const Rational right = size * Rational(geometry.sign);
      expect(terminal, {k, right.toString()}, {"right"});
      expect(terminal, {k, (-right).toString()},
             {"internal-as-external", "external-as-internal", "bevel-sign", "crossed-sign"});
      if (size != 1) expect(terminal, {k, right.inverse().toString()}, {"ratio-upside-down"});
    }

    if (!reasonAgainst(source, ExerciseKind::inputs)) {
      const Question inputs = makeQuestion(source, ExerciseKind::inputs, random);
      const auto sets =
          InputSets::of(*source.snapshot()->kinematics->model, ModularDoubleField(), source.inputs());
      std::set<std::vector<int>> valid;
      for (std::vector<int>& set : sets->list(400)) valid.insert(set);
      const bool isComplete = valid.size() < 400;
      for (int round = 0; round < 30; ++round) {
        std::vector<int> joints;
        for (int i = 0; i < graph.n; ++i) joints.push_back(i);
        joints = random.someOf(joints, matroid.dof);
        std::string set;
        for (const int joint : joints) set += std::to_string(graph.n + 1 + joint) + ' ';
        if (valid.contains(joints)) {
          expect(inputs, {set}, {"right"});
        } else if (isComplete) {
          expect(inputs, {set}, {"dependent-inputs", "dead-input", "idle-joint-missing"});
        }
      }
    }

    if (!reasonAgainst(source, ExerciseKind::speed)) {
      const Question speed = makeQuestion(source, ExerciseKind::speed, random);
      std::vector<int> inputs;
      std::vector<Rational> rates;
      auto matches = QRegularExpression("theta\\}_\\{(\\d+)\\} = (-?\\d+)\\$")
                         .globalMatch(QString::fromStdString(speed.prompt));
      while (matches.hasNext()) {
        const auto match = matches.next();
        inputs.push_back(match.captured(1).toInt() - graph.n - 1);
        rates.emplace_back(match.captured(2).toInt());
      }
      QCOMPARE(inputs.size(), static_cast<std::size_t>(matroid.dof));
      const TtGraph& tt = *source.ttGraph();
      const auto all = ttRates(tt, substitutionPlan(tt, inputs), rates);
      QVERIFY(all.has_value());
      const QString asked = QString::fromStdString(speed.fields.front().name).section(' ', -1);
      const Rational right = (*all)[static_cast<std::size_t>(asked.toInt() - graph.n - 1)];
      expect(speed, {right.toString()}, {"right"});
      expect(speed, {(-right).toString()}, {"sign-lost"});
    }
  }

  void check(const Mechanism& mechanism, std::uint64_t seed) {
    if (mechanism.n() > kMaxExerciseLinks) return;
    const ExerciseSource source(mechanism);
    const Graph graph(source.mechanism());
    if (reasonAgainst(source, ExerciseKind::cycle)) return;
    checkMatrices(source, graph, seed);
    if (!reasonAgainst(source, ExerciseKind::terminalEquation)) checkEquations(source, graph, seed);
    ++m_checked["mechanisms"];
  }

 private slots:
  void onExamplesAndRandomTrains() {
    for (const std::string& name : test::exampleNames()) check(test::example(name), 5);
    for (int planets = 1; planets <= 4; ++planets) check(test::planetary(18 + planets, 16, planets), 6);
    for (std::uint64_t seed = 500; seed < 640; ++seed) {
      const int n = 2 + static_cast<int>(seed % 9);
      check(test::randomTrain(seed, n, 1 + static_cast<int>(seed % static_cast<std::uint64_t>(n))), seed);
      if (QTest::currentTestFailed()) return;
    }
  }
  void enoughWasChecked() {
    for (const auto& [what, count] : m_checked) qInfo("%s: %d", what.c_str(), count);
    QVERIFY(m_checked["mechanisms"] >= 120);
    QVERIFY(m_checked["right"] >= 2'000);
    for (const char* name : {"incidence-exchanged", "ground-row-left-in", "walk-from-ground",
                             "cycle-backwards", "bevel-sign", "ratio-upside-down", "sign-lost"})
      QVERIFY2(m_checked[name] >= 80, name);
    QVERIFY(m_checked["transposed itself"] >= 20);
    QVERIFY(m_checked["kutzbach-with-redundant-mesh"] >= 3);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::IndependentAnswersTest)
#include "test_independent_answers.moc"
