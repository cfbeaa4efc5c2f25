// The model in Modelica, read as equations: the exact solution fulfils them, they are as many as the
// unknowns, and the torques are those that lose no power.

#include <QRegularExpression>
#include <QTest>

#include "core/presentation/simulators/modelica.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/states/engagement.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;

namespace {

/// "18*j8.phi - j10.phi" as {j8: 18, j10: -1}.
std::map<QString, int> termsOf(const QString& sum) {
  static const QRegularExpression kTerm(QStringLiteral(R"((^|[+-] )?(-?)(?:(\d+)\*)?([a-z]\d+)(?:\.phi)?)"));
  std::map<QString, int> terms;
  for (auto each = kTerm.globalMatch(sum); each.hasNext();) {
    const QRegularExpressionMatch match = each.next();
    const bool isNegative = match.captured(1).startsWith('-') != (match.captured(2) == "-");
    const int size = match.captured(3).isEmpty() ? 1 : match.captured(3).toInt();
    terms[match.captured(4)] += isNegative ? -size : size;
  }
  return terms;
}

struct Model {
  std::vector<std::map<QString, int>> rows;           ///< factors of angles by flange
  std::map<QString, std::map<QString, int>> torques;  ///< factors of multipliers by flange
  QStringList flanges, multipliers;
};

Model modelOf(const std::string& text) {
  Model model;
  for (const QString& line : QString::fromStdString(text).split('\n')) {
    static const QRegularExpression kRow(QStringLiteral(R"(^  (.*phi.*) = 0;  // )"));
    static const QRegularExpression kTorque(QStringLiteral(R"(^  (j\d+)\.tau = (.*);$)"));
    static const QRegularExpression kFlange(QStringLiteral(R"(^  Modelica\.\S+\.Flange_a (j\d+) ".*";$)"));
    static const QRegularExpression kReal(QStringLiteral(R"(^  Real ([mc]\d+)\(unit="N\.m"\) ".*";$)"));
    if (const auto match = kRow.match(line); match.hasMatch())
      model.rows.push_back(termsOf(match.captured(1)));
    if (const auto match = kTorque.match(line); match.hasMatch())
      model.torques[match.captured(1)] = termsOf(match.captured(2));
    if (const auto match = kFlange.match(line); match.hasMatch()) model.flanges += match.captured(1);
    if (const auto match = kReal.match(line); match.hasMatch()) model.multipliers += match.captured(1);
  }
  return model;
}

void check(Mechanism mechanism) {
  const SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(std::move(mechanism)));
  if (hasErrors(snapshot->diagnostics) || snapshot->matroid() == nullptr) return;
  const Model model = modelOf(modelicaText(*snapshot));
  const MatroidAnalysis& matroid = *snapshot->matroid();
  QCOMPARE(static_cast<int>(model.rows.size()), matroid.rank);
  QCOMPARE(static_cast<int>(model.multipliers.size()), matroid.rank);
  QCOMPARE(static_cast<int>(model.flanges.size()), snapshot->graph->t());
  QCOMPARE(static_cast<int>(model.torques.size()), snapshot->graph->t());
  // The torques are the transpose of the rows.
  for (std::size_t row = 0; row < model.rows.size(); ++row) {
    for (const QString& flange : model.flanges) {
      const auto find = [](const std::map<QString, int>& terms, const QString& name) {
        const auto at = terms.find(name);
        return at == terms.end() ? 0 : at->second;
      };
      QCOMPARE(find(model.torques.at(flange), model.multipliers[static_cast<int>(row)]),
               find(model.rows[row], flange));
    }
  }
  // Every motion fulfils the rows, exactly.
  const std::vector<int>& inputs = matroid.choice.joints;
  for (std::size_t driven = 0; driven < inputs.size(); ++driven) {
    std::vector<Rational> speeds(inputs.size());
    speeds[driven] = Rational(1);
    const auto exact = solveExact(*snapshot->kinematics->model, inputs, speeds);
    QVERIFY(exact.has_value());
    std::map<QString, Rational> rates;
    const auto flange = [&](int joint) { return QString("j%1").arg(snapshot->graph->edgeLabel(joint)); };
    for (std::size_t i = 0; i < inputs.size(); ++i) rates[flange(inputs[i])] = speeds[i];
    for (std::size_t i = 0; i < exact->outputs.size(); ++i)
      rates[flange(exact->outputs[i])] = exact->matrix[i * inputs.size() + driven];
    for (const auto& row : model.rows) {
      Rational slip;
      for (const auto& [name, factor] : row) slip = slip + Rational(factor) * rates.at(name);
      QVERIFY(slip.isZero());
    }
  }
}

}  // namespace

class ModelicaTest : public QObject {
  Q_OBJECT

 private slots:
  void theSolutionFulfilsTheEquations_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : test::exampleNames())
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
  }
  void theSolutionFulfilsTheEquations() {
    QFETCH(QString, name);
    const Mechanism mechanism = test::example(name.toStdString());
    check(mechanism);
    for (const ShiftState& state : mechanism.states) {
      Mechanism engaged = mechanism;
      engaged.engaged = state.engaged;
      check(engaged);
    }
  }

  void equationsAreInWholeTeeth() {
    const SnapshotPtr robot = analyzeLive(std::make_shared<const Mechanism>(test::example("robot")));
    const std::string text = modelicaText(*robot);
    QVERIFY(text.find("\n  18*j8.phi + 36*j10.phi = 0;  // mesh 15, 18:36 teeth\n") != std::string::npos);
    QVERIFY(text.find("\n  j8.tau = 18*m15;\n") != std::string::npos);
    QVERIFY(text.find("No tool of Modelica has run it") != std::string::npos);
  }

  void namesAreThoseOfClasses() {
    QCOMPARE(modelicaName("Geared robotic mechanism"), std::string("Geared_robotic_mechanism"));
    QCOMPARE(modelicaName(""), std::string("Mechanism"));
    QCOMPARE(modelicaName("2nd"), std::string("Nd"));
    QCOMPARE(modelicaName("model"), std::string("Model"));
    QCOMPARE(modelicaName("Modelica"), std::string("Modelica_"));
    QCOMPARE(modelicaName("a\n\"b\\ \xC3\xBC"), std::string("A_b"));
  }

  void textsStayInTheirStrings() {
    Mechanism mechanism = test::example("spur-pair");
    mechanism.name = "a \"b\" \\\n end";
    mechanism.links[1].name = "\n x = 1;\n";
    const SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(mechanism));
    const std::string text = modelicaText(*snapshot);
    QVERIFY(text.find("model A_b_end \"a \\\"b\\\" \\\\  end\"\n") != std::string::npos);
    QVERIFY(text.find("\n x = 1") == std::string::npos);
  }
};

QTEST_APPLESS_MAIN(ModelicaTest)
#include "test_modelica.moc"
