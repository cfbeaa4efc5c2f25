#include <QRegularExpression>
#include <QTest>
#include <map>

#include "core/teaching/exercises/exercise_sheet.h"
#include "core/teaching/grading/grade.h"
#include "core/theory/statics/statics_agreement.h"
#include "core/theory/ttgraph/tt_solution.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/train_sketch.h"

namespace geargraph {

/// Right and wrong answers about forces, worked out here: torques of couplings by the T-T graph, efficiencies
/// by trying which gear drives in every mesh, with dense rows. Nothing is read from the keys.
class ForceAnswersTest : public QObject {
  Q_OBJECT

  using Row = std::vector<Rational>;
  std::map<std::string, int> m_checked;

  static QString matched(const Question& question, const char* pattern) {
    const auto match = QRegularExpression(pattern).match(QString::fromStdString(question.prompt));
    if (!match.hasMatch()) qFatal("%s is not in: %s", pattern, question.prompt.c_str());
    return match.captured(1);
  }
  static Rational fraction(const QString& tex) {  // \frac{24}{25}
    const auto match = QRegularExpression("frac\\{(\\d+)\\}\\{(\\d+)\\}").match(tex);
    return {match.captured(1).toInt(), match.captured(2).toInt()};
  }
  void expect(const Question& question, const std::vector<std::string>& answer, const std::string& name) {
    const Verdict verdict = grade(question, answer);
    const std::string told = verdict.isRight ? "right" : verdict.mistake ? verdict.mistake->name : "unnamed";
    QVERIFY2(told == name, (question.prompt + " [" + answer[0] + " | " + answer[1] + "] told as " + told +
                            " instead of " + name)
                               .c_str());
    ++m_checked[name];
  }
  void expectWrong(const Question& question, const std::vector<std::string>& answer) {
    QVERIFY2(!grade(question, answer).isRight,
             (question.prompt + " [" + answer[0] + " | " + answer[1] + ']').c_str());
    ++m_checked["wrong"];
  }

  // Brakes.

  static std::map<std::string, Rational> sizesOf(const test::StaticsCase& box, const ShiftState& state) {
    std::map<std::string, Rational> sizes = torquesOf(box, state);
    for (auto& [name, torque] : sizes) torque = torque.abs();
    return sizes;
  }
  /// By coupling, the torque for 1 N m at the drive, by the T-T graph.
  static std::map<std::string, Rational> torquesOf(const test::StaticsCase& box, const ShiftState& state) {
    StaticsProblem problem;
    problem.torques = {{box.on(box.graph->nodeOf(*state.drive)), 1}};
    problem.balances = {box.on(box.graph->nodeOf(*state.driven))};
    for (std::size_t i = 0; i < box.mechanism.couplings.size(); ++i) {
      const auto& engaged = state.engaged;
      if (std::find(engaged.begin(), engaged.end(), box.mechanism.couplings[i].id) != engaged.end())
        problem.engaged.push_back(static_cast<int>(i));
    }
    const TtTorques torques = box.solveByTtGraph(problem);
    const std::vector<HeldPart> held = box.held(problem);
    std::map<std::string, Rational> sizes;
    for (std::size_t part = 0; part < held.size(); ++part) {
      if (held[part].coupling < 0) continue;
      const ShiftElement& coupling = box.mechanism.couplings[static_cast<std::size_t>(held[part].coupling)];
      sizes[coupling.id.text()] = torques.chords[part].fraction().value();
    }
    return sizes;
  }

  void checkBrakes(const Mechanism& mechanism, std::uint64_t seeds) {
    const ExerciseSource source(mechanism);
    QVERIFY(!reasonAgainst(source, ExerciseKind::brakeTorque));
    const test::StaticsCase box(source.mechanism());
    std::map<std::string, std::map<std::string, Rational>> states;  // by name, then by coupling
    for (const ShiftState& state : mechanism.states) states[state.name] = sizesOf(box, state);
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      ExerciseRandom random(seed, 8, 8);
      const Question question = makeQuestion(source, ExerciseKind::brakeTorque, random);
      const int drive = matched(question, "drive is \\$(\\d+)\\$ N m").toInt();
      const bool isOfState = question.fields.front().name != "state";
      std::map<std::string, Rational> sizes;  // by option; 0 where nothing is engaged
      if (isOfState) {
        sizes = states.at(matched(question, "^State \u201c([^\u201d]*)\u201d").toStdString());
      } else {
        const std::string asked = matched(question, "does (?:brake|clutch) (\\S+) carry").toStdString();
        for (const auto& [name, each] : states)
          if (each.contains(asked)) sizes[name] = each.at(asked);
      }
      Rational most = 0;
      for (const auto& [option, size] : sizes) most = std::max(most, size);
      for (const std::string& option : question.fields.front().options) {
        const std::string value = (most * drive).toString();
        if (!sizes.contains(option)) {
          expect(question, {option, value}, "released-coupling");
        } else if (sizes[option] == most) {
          expect(question, {option, value}, "right");
          expect(question, {option, "-" + value}, "right");
          expectWrong(question, {option, (most * (drive + 1)).toString()});
          expectWrong(question, {option, "0"});
        } else {
          const Verdict verdict = grade(question, {option, value});
          QVERIFY(!verdict.isRight && verdict.mistake);
          QVERIFY2(verdict.mistake->name == "smaller-torque" ||
                       verdict.mistake->name == (isOfState ? "fastest-coupling" : "largest-ratio"),
                   verdict.mistake->name.c_str());
          expectWrong(question, {option, (sizes[option] * drive).toString()});
          ++m_checked["smaller"];
        }
      }
      ++m_checked[isOfState ? "of a state" : "of a coupling"];
    }
  }

  // Self-locking.

  /// x with rows x = right; none where there is none or several. Square.
  static std::optional<Row> solved(std::vector<Row> rows, Row right) {
    const std::size_t n = rows.size();
    for (std::size_t column = 0; column < n; ++column) {
      std::size_t pivot = column;
      while (pivot < n && rows[pivot][column].isZero()) ++pivot;
      if (pivot == n) return std::nullopt;
      std::swap(rows[pivot], rows[column]);
      std::swap(right[pivot], right[column]);
      for (std::size_t other = 0; other < n; ++other) {
        if (other == column || rows[other][column].isZero()) continue;
        const Rational factor = rows[other][column] / rows[column][column];
        for (std::size_t i = 0; i < n; ++i) rows[other][i] -= factor * rows[column][i];
        right[other] -= factor * right[column];
      }
    }
    for (std::size_t i = 0; i < n; ++i) right[i] = right[i] / rows[i][i];
    return right;
  }
  static Rational product(const Row& a, const Row& b) {
    Rational sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }

  /// The efficiency from drive to driven (torque 1 at the drive) or backwards (torque -1); none where no
  /// choice of driving gears is consistent. One row of the rates' equations a mesh is A + B, the parts of its
  /// tail and its head: with losses A + eta B or eta A + B, and the mesh takes power in both.
  static std::optional<Rational> efficiency(const ExerciseSource& source, int drive, int driven,
                                            const std::vector<int>& balanced, const Row& motion,
                                            const Rational& eta, int torque) {
    const int c = source.graph().c();
    const int t = source.graph().t();
    std::vector<int> open;  // joints without a balance
    for (int joint = 0; joint < t; ++joint)
      if (std::find(balanced.begin(), balanced.end(), joint) == balanced.end()) open.push_back(joint);
    for (int pattern = 0; pattern < 1 << c; ++pattern) {
      std::vector<Row> lossy;
      std::vector<char> rolls;
      for (int mesh = 0; mesh < c; ++mesh) {
        const Row sum = source.teethRow(mesh);
        const Row difference = source.teethRow(mesh, RowChange::signOfHead);
        Row row, tail;
        for (int joint = 0; joint < t; ++joint) {
          const auto at = static_cast<std::size_t>(joint);
          const Rational a = (sum[at] + difference[at]) / 2;
          const Rational b = (sum[at] - difference[at]) / 2;
          tail.push_back(a);
          row.push_back((pattern >> mesh & 1) != 0 ? a + eta * b : eta * a + b);
        }
        rolls.push_back(product(tail, motion).isZero() ? 0 : 1);
        lossy.push_back(rolls.back() != 0 ? row : sum);
      }
      std::vector<Row> rows;
      Row right;
      for (const int joint : open) {
        rows.emplace_back();
        for (const Row& row : lossy) rows.back().push_back(row[static_cast<std::size_t>(joint)]);
        right.emplace_back(joint == drive ? -torque : 0);
      }
      const auto forces = solved(std::move(rows), std::move(right));
      if (!forces) continue;
      bool isConsistent = true;
      Rational load = 0;
      for (int mesh = 0; mesh < c; ++mesh) {
        const auto at = static_cast<std::size_t>(mesh);
        isConsistent = isConsistent && ((*forces)[at] * product(lossy[at], motion)).sign() <= 0;
        load -= (*forces)[at] * lossy[at][static_cast<std::size_t>(driven)];
      }
      const Rational taken = -load * motion[static_cast<std::size_t>(driven)];
      const Rational fed = motion[static_cast<std::size_t>(drive)] * torque;
      if (!isConsistent || taken.sign() != fed.sign()) continue;
      return torque > 0 ? taken / fed : fed / taken;
    }
    return std::nullopt;
  }

  void checkLocking(const Mechanism& mechanism, std::uint64_t seeds) {
    const ExerciseSource source(mechanism);
    if (!source.mechanism().states.empty() || source.graph().c() > 6) return;
    if (reasonAgainst(source, ExerciseKind::selfLocking)) return;
    if (source.matroid()->rank < source.graph().c()) return;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      ExerciseRandom random(seed, 9, 9);
      const Question question = makeQuestion(source, ExerciseKind::selfLocking, random);
      const int first = source.graph().n() + 1;
      const int drive = matched(question, "motor in joint \\$(\\d+)\\$").toInt() - first;
      const int driven = matched(question, "load at joint \\$(\\d+)\\$").toInt() - first;
      const Rational eta = fraction(matched(question, "passes the part \\$([^$]*)\\$"));
      std::vector<Rational> speeds;
      std::vector<int> balanced{driven};
      for (const int input : source.inputs()) {
        speeds.emplace_back(input == drive ? 1 : 0);
        if (input != drive) balanced.push_back(input);
      }
      const auto motion =
          ttRates(*source.ttGraph(), substitutionPlan(*source.ttGraph(), source.inputs()), speeds);
      QVERIFY(motion.has_value());
      const auto forward = efficiency(source, drive, driven, balanced, *motion, eta, 1);
      const auto backward = efficiency(source, drive, driven, balanced, *motion, eta, -1);
      QVERIFY2(forward.has_value(), question.prompt.c_str());
      if (backward) {
        const std::string value = backward->toString();
        expect(question, {"turns", value}, "right");
        expect(question, {"locks itself", value}, "lock-claimed");
        expectWrong(question, {"locks itself", "0"});
        expectWrong(question, {"turns", "0"});
        if (*forward != *backward) expect(question, {"turns", forward->toString()}, "forward-for-backward");
        if (*backward != 1) expectWrong(question, {"turns", "1"});
      } else {
        expect(question, {"locks itself", "0"}, "right");
        expect(question, {"locks itself", forward->toString()}, "locked-with-power");
        expect(question, {"turns", "0"}, "lock-overlooked");
        expect(question, {"turns", forward->toString()}, "forward-for-backward");
        ++m_checked["locked"];
      }
    }
  }

 private slots:
  void largestTorquesByTheTtGraph() {
    for (const char* name : {"ravigneaux", "simpson", "eight-speed-gearbox"})
      checkBrakes(test::example(name), 40);
    checkBrakes(test::eightSpeed(), 40);
  }

  /// The brake of a planetary set holds T (i - 1), T at the drive and i the ratio.
  void aSingleBrakeHoldsTheSum() {
    const ExerciseSource source(test::example("simpson"));
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      ExerciseRandom random(seed);
      const Question question = makeQuestion(source, ExerciseKind::brakeTorque, random);
      if (question.fields.front().name != "state") continue;
      const Rational drive = matched(question, "drive is \\$(\\d+)\\$ N m").toInt();
      Rational most = 0;
      for (const int state : {0, 3}) {  // both by brake B2 alone
        const EngagedSet& set = source.engagedSets(state)[*source.setOfState(state)];
        most = std::max(most, ((*set.solution.ratio - Rational(1)) * drive).abs());
      }
      QCOMPARE(QString::fromStdString(question.solution[1]), QString::fromStdString(most.toString()));
      ++m_checked["sum"];
    }
    QVERIFY(m_checked["sum"] >= 5);
  }

  /// By the T-T graph; the housing feels the opposite.
  void brakesAndTheHousing() {
    for (const Mechanism& mechanism :
         {test::example("ravigneaux"), test::example("simpson"), test::eightSpeed()}) {
      const ExerciseSource source(mechanism);
      QVERIFY(!reasonAgainst(source, ExerciseKind::brakeReaction));
      const test::StaticsCase box(source.mechanism());
      std::map<std::string, std::map<std::string, Rational>> states;  // by name, then by coupling
      for (const ShiftState& state : mechanism.states) states[state.name] = torquesOf(box, state);
      for (std::uint64_t seed = 0; seed < 40; ++seed) {
        ExerciseRandom random(seed, 8, 8);
        const Question question = makeQuestion(source, ExerciseKind::brakeReaction, random);
        const int drive = matched(question, "drive is \\$(\\d+)\\$ N m").toInt();
        const std::string state = matched(question, "^State \u201c([^\u201d]*)\u201d").toStdString();
        const std::string brake = matched(question, "does brake (\\S+) exert").toStdString();
        const Rational torque = states.at(state).at(brake) * drive;
        const std::string on = torque.toString();
        const std::vector<std::string>& senses = question.fields[1].options;
        const std::string& link = torque.sign() > 0 ? senses[0] : senses[1];
        const std::string& housing = torque.sign() > 0 ? senses[1] : senses[0];
        expect(question, {on, housing}, "right");
        expect(question, {on, link}, "same-sense-on-both");
        expect(question, {(-torque).toString(), link}, "reaction-for-action");
        expect(question, {(torque * 7).toString(), link}, "same-sense-on-both");
        expectWrong(question, {(torque * 7).toString(), housing});
        m_checked["reaction"] += 1;
      }
    }
  }

  /// From sun to carrier with the ring held: eta = (1 + x eta0) / (1 + x), backwards (1 + x) / (1 + x /
  /// eta0), x = ring teeth / sun teeth, eta0 of both meshes (Mueller).
  void planetarySetByWillis() {
    const ExerciseSource source(test::example("planetary-ring-held"));
    const auto& meshes = source.mechanism().gearMeshes;
    const Rational x(meshes[1].headTeeth, meshes[0].tailTeeth);
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      ExerciseRandom random(seed);
      const Question question = makeQuestion(source, ExerciseKind::selfLocking, random);
      if (question.prompt.find("load at joint $5$") == std::string::npos) continue;
      const Rational eta = fraction(matched(question, "passes the part \\$([^$]*)\\$"));
      const Rational both = eta * eta;
      expect(question, {"turns", ((Rational(1) + x) / (Rational(1) + x / both)).toString()}, "right");
      expect(question, {"turns", ((Rational(1) + x * both) / (Rational(1) + x)).toString()},
             "forward-for-backward");
      expect(question, {"turns", both.toString()}, "fixed-axis-losses");
      ++m_checked["willis"];
    }
    QVERIFY(m_checked["willis"] >= 5);
  }

  void lockingByTryingAllDrivers() {
    for (const std::string& name : test::exampleNames()) {
      const Mechanism mechanism = test::example(name);
      if (mechanism.n() <= kMaxExerciseLinks) checkLocking(mechanism, 8);
    }
    for (const test::TextbookTrain& train : test::textbookTrains()) checkLocking(train.mechanism, 4);
    for (std::uint64_t seed = 1; seed <= 160; ++seed) {
      const int n = 2 + static_cast<int>(seed % 7);
      checkLocking(test::randomTrain(seed, n, 1 + static_cast<int>(seed % static_cast<std::uint64_t>(n))), 2);
      if (QTest::currentTestFailed()) return;
    }
  }

  void reasonsArePlain() {
    const auto reason = [](const Mechanism& mechanism, ExerciseKind kind) {
      return QString::fromStdString(reasonAgainst(ExerciseSource(mechanism), kind).value_or("none"));
    };
    QCOMPARE(reason(test::example("robot"), ExerciseKind::brakeTorque), QString("no brakes or clutches"));
    QCOMPARE(reason(test::example("robot"), ExerciseKind::brakeReaction), QString("no brakes or clutches"));
    Mechanism one = test::example("simpson");
    one.states.resize(1);
    QCOMPARE(reason(one, ExerciseKind::brakeTorque),
             QString("no two torques of brakes or clutches to compare"));
    QCOMPARE(reason(test::example("locked-train"), ExerciseKind::selfLocking), QString("nothing can move"));
    QCOMPARE(reason(test::example("three-planets"), ExerciseKind::selfLocking),
             QString("no drive passes power through 1 to 6 meshes"));
    QCOMPARE(reason(emptyMechanism(), ExerciseKind::selfLocking), QString("no joints"));
  }

  void enoughWasChecked() {
    for (const auto& [what, count] : m_checked) qInfo("%s: %d", what.c_str(), count);
    QVERIFY(m_checked["right"] >= 400);
    QVERIFY(m_checked["of a state"] >= 30);
    QVERIFY(m_checked["of a coupling"] >= 60);
    QVERIFY(m_checked["locked"] >= 20);
    QVERIFY(m_checked["forward-for-backward"] >= 40);
    QVERIFY(m_checked["released-coupling"] >= 100);
    QVERIFY(m_checked["reaction"] >= 100);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::ForceAnswersTest)
#include "test_force_answers.moc"
