#include <QTest>

#include "core/mechanism/model/mass_edits.h"
#include "core/presentation/typeset/tex_reader.h"
#include "core/teaching/force_tables/dynamics_table.h"
#include "tests/core/support/example_files.h"
#include "tests/core/theory/dynamics/dynamics_case.h"

namespace geargraph {
namespace {

using test::DynamicsCase;

DynamicState stateOf(const DynamicsCase& worked) {
  TrainDynamics dynamics(worked.dynamics.train);
  Eigen::VectorXd speeds = Eigen::VectorXd::Constant(worked.inputs(), 2);
  return {dynamics.at(worked.zeros(), speeds), dynamics.reflectedInertias(worked.zeros())};
}

double valueAt(const ValueTable& table, std::size_t row, std::size_t column) {
  return table.rows.at(row).cells.at(column).number.value();
}

}  // namespace

class DynamicsTablesTest : public QObject {
  Q_OBJECT

 private slots:
  void everyColumnIsDefinedAndEveryRowIsFull() {
    const DynamicsCase robot(test::example("robot"));
    const DynamicState state = stateOf(robot);
    const ValueTable tables[] = {massTable(robot.mechanism, robot.dynamics.links, 0.001),
                                 reflectedTable(robot.mechanism, robot.dynamics, state),
                                 equationTable(robot.mechanism, robot.dynamics, state)};
    for (const ValueTable& table : tables) {
      QVERIFY(!table.rows.empty());
      for (const ForceColumn& column : table.columns) QVERIFY(column.meaning.ends_with('.'));
      for (const ForceRow& row : table.rows) QCOMPARE(row.cells.size(), table.columns.size());
    }
  }

  void massesAreThoseOfTheLinks() {
    Mechanism mechanism = test::example("robot");
    const LinkId stated = mechanism.links[3].id;
    mechanism = *withLinkMass(std::move(mechanism), stated,
                              test::massOf(2, test::triple(1, 2, 3), 0.01, 0.02, 0.025));
    const DynamicsCase robot(std::move(mechanism));
    const ValueTable table = massTable(robot.mechanism, robot.dynamics.links, 0.001);
    QCOMPARE(static_cast<int>(table.columns.size()), static_cast<int>(MassColumn::count));
    QCOMPARE(static_cast<int>(table.rows.size()), robot.mechanism.n());
    QCOMPARE(table.rows[2].elements.front(), ElementId(stated));
    const std::vector<double> expected{2, 1, 2, 3, 0.01, 0.02, 0.025};
    for (std::size_t i = 0; i < expected.size(); ++i)
      QVERIFY(std::abs(valueAt(table, 2, i + 1) - expected[i]) < 1e-12);
    QCOMPARE(table.rows[2].cells.back().text, std::string("stated"));
    QCOMPARE(table.rows[0].cells.back().text, std::string("solids"));
    QVERIFY(valueAt(table, 0, 1) > 0);
  }

  void noCoordinateIsNoise() {
    for (const char* name : {"robot", "humpage-reduction"}) {
      const DynamicsCase worked(test::example(name));
      const ValueTable table = massTable(worked.mechanism, worked.dynamics.links, 0.001);
      for (const ForceRow& row : table.rows) {
        for (std::size_t column = 2; column <= 4; ++column) {
          const double place = row.cells.at(column).number.value();  // mm
          QVERIFY2(place == 0 || std::abs(place) > 1e-4, row.cells[column].text.c_str());
        }
      }
    }
  }

  void theSharesOfTheLinksSumToTheDiagonalOfTheInertia() {
    const DynamicsCase robot(test::example("robot"));
    const DynamicState state = stateOf(robot);
    const ValueTable reflected = reflectedTable(robot.mechanism, robot.dynamics, state);
    const ValueTable equation = equationTable(robot.mechanism, robot.dynamics, state);
    const std::size_t inputs = robot.dynamics.inputs.size();
    QCOMPARE(inputs, std::size_t{3});
    for (std::size_t i = 0; i < inputs; ++i) {
      double sum = 0;
      for (std::size_t link = 0; link + 1 < reflected.rows.size(); ++link)
        sum += valueAt(reflected, link, i + 1);
      QVERIFY(std::abs(sum - valueAt(reflected, reflected.rows.size() - 1, i + 1)) < 1e-12);
      QVERIFY(std::abs(sum - valueAt(equation, i, i + 1)) < 1e-12);
      QCOMPARE(valueAt(equation, i, inputs + 3),
               valueAt(equation, i, inputs + 1) - valueAt(equation, i, inputs + 2));
    }
  }

  void theEquationIsTexThatCanBeSet() {
    const DynamicsCase robot(test::example("robot"));
    const std::string tex = equationTex(robot.mechanism, robot.dynamics, stateOf(robot));
    QVERIFY2(readTex(tex).fault.empty(), tex.c_str());
    QVERIFY(tex.find("\\ddot{\\theta}_{9}") != std::string::npos);
    QCOMPARE(texNumber(0.0123456), std::string("0.01235"));
    QCOMPARE(texNumber(-1.5e-7), std::string("-1.5 \\cdot 10^{-7}"));
    QCOMPARE(texNumber(0), std::string("0"));
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::DynamicsTablesTest)
#include "test_dynamics_tables.moc"
