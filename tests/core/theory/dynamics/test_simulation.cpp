#include <QTest>
#include <cmath>
#include <numbers>

#include "core/mechanism/model/mass_edits.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/dynamics/motion_table.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/trains.h"
#include "tests/core/theory/dynamics/dynamics_case.h"

namespace geargraph {
namespace {

using test::DynamicsCase;
using test::massOf;
using test::number;
using test::triple;

constexpr double kFall = 9.81;

/// A rod of 1 kg that hangs on the y axis, its centre 100 mm below.
Mechanism pendulum() {
  test::TrainBuilder train("pendulum");
  train.link(0, train.axis({0, 0, 0}, {0, 1, 0}));
  train.input(0);
  Mechanism mechanism = train.mechanism();
  mechanism = *withLinkMass(std::move(mechanism), LinkId("1"), massOf(1, triple(0, 0, -100), 0.01, 0.01, 0));
  return *withGravity(std::move(mechanism), triple(0, 0, -kFall));
}

double spreadOfEnergy(const Simulation& simulation) {
  double least = INFINITY;
  double most = -INFINITY;
  for (const MotionSample& sample : simulation.samples) {
    const double sum = sample.kinetic + sample.potential - sample.work;
    least = std::min(least, sum);
    most = std::max(most, sum);
  }
  return most - least;
}

double largestEnergy(const Simulation& simulation) {
  double largest = 0;
  for (const MotionSample& sample : simulation.samples)
    largest = std::max({largest, sample.kinetic, std::abs(sample.work)});
  return largest;
}

}  // namespace

class SimulationTest : public QObject {
  Q_OBJECT

 private slots:
  // T = 4 sqrt((I + m l²) / (m g l)) K(sin(amplitude / 2)), by the arithmetic-geometric mean.
  void aPendulumHasItsPeriod() {
    const DynamicsCase worked(pendulum());
    TrainDynamics dynamics(worked.dynamics.train);
    for (const double amplitude : {0.01, 1., 2.5}) {
      const double small = std::sqrt((0.01 + 0.01) / (1 * kFall * 0.1));
      double a = 1;
      double b = std::cos(amplitude / 2);
      for (int i = 0; i < 10; ++i) std::tie(a, b) = std::pair((a + b) / 2, std::sqrt(a * b));
      SimulationOptions options = worked.options();
      options.angles[0] = amplitude;
      options.seconds = 2 * std::numbers::pi * small / a;
      options.interval = options.seconds / 4;
      const Simulation simulation = simulate(dynamics, options);
      QCOMPARE(simulation.end, SimulationEnd::complete);
      QCOMPARE(simulation.samples.size(), 5u);
      QVERIFY(std::abs(simulation.samples[1].angles[0]) < 1e-6);
      QVERIFY(std::abs(simulation.samples[2].angles[0] + amplitude) < 1e-6);
      QVERIFY(std::abs(simulation.samples[4].angles[0] - amplitude) < 1e-6);
      QVERIFY(spreadOfEnergy(simulation) < 1e-7);
    }
  }

  // A constant torque on a constant inertia: omega = tau t / M; with damping it approaches tau / damping.
  void aMotorSpinsAPlanetarySetUp() {
    const DynamicsCase worked(test::example("planetary-ring-held"));
    TrainDynamics dynamics(worked.dynamics.train);
    const double inertia = dynamics.at(worked.zeros(), worked.zeros()).inertia(0, 0);
    SimulationOptions options = worked.options();
    options.motors[0].torque = 0.3;
    options.seconds = 0.5;
    const Simulation free = simulate(dynamics, options);
    QVERIFY(std::abs(free.samples.back().speeds[0] / (0.3 * 0.5 / inertia) - 1) < 1e-9);
    QVERIFY(std::abs(free.samples.back().time - 0.5) < 1e-12);
    QCOMPARE(free.samples.size(), 51u);
    options.motors[0].damping = 0.02;
    options.seconds = 60 * inertia / 0.02;
    options.interval = options.seconds / 100;
    const Simulation damped = simulate(dynamics, options);
    QVERIFY(std::abs(damped.samples.back().speeds[0] - 15) < 1e-6);
    const double time = damped.samples[1].time;
    QVERIFY(std::abs(damped.samples[1].speeds[0] / (15 * (1 - std::exp(-0.02 * time / inertia))) - 1) < 1e-7);
  }

  void energyIsBalancedInEveryExample() {
    int balanced = 0;
    for (const std::string& name : test::exampleNames()) {
      const Mechanism example = *withGravity(test::example(name), triple(0, 2, -kFall));
      if (!treeDiagnostics(example).empty() || example.unit != "mm") continue;
      const test::Worked before(example);
      if (!before.analysis.solution || before.analysis.solution->inputs.empty()) continue;
      const DynamicsCase worked(example);
      TrainDynamics dynamics(worked.dynamics.train);
      SimulationOptions options = worked.options();
      for (std::size_t i = 0; i < options.motors.size(); ++i) {
        options.motors[i] = {0.2 + 0.1 * static_cast<double>(i), 1e-3};
        options.speeds[static_cast<Eigen::Index>(i)] = 1 - static_cast<double>(i);
      }
      const Simulation simulation = simulate(dynamics, options);
      QVERIFY2(simulation.end == SimulationEnd::complete, name.c_str());
      QVERIFY2(spreadOfEnergy(simulation) < 1e-6 * largestEnergy(simulation), name.c_str());
      QVERIFY(largestEnergy(simulation) > 1e-6);
      ++balanced;
    }
    QVERIFY(balanced >= 12);
  }

  void itEndsAtTheLimitOfAJoint() {
    const DynamicsCase worked(pendulum());
    TrainDynamics dynamics(worked.dynamics.train);
    SimulationOptions options = worked.options();
    options.angles[0] = 1;
    options.limits = {{-0.5, 2}};
    const Simulation simulation = simulate(dynamics, options);
    QCOMPARE(simulation.end, SimulationEnd::atLimit);
    QCOMPARE(simulation.limitJoint, 0);
    QVERIFY(std::abs(simulation.samples.back().angles[0] + 0.5) < 1e-9);
    QVERIFY(simulation.samples.back().time < 1);
    options.limits = {{-1.5, 2}};
    QCOMPARE(simulate(dynamics, options).end, SimulationEnd::complete);
    options.limits = {{-0.5, 0.5}};  // beyond it at the start
    const Simulation none = simulate(dynamics, options);
    QCOMPARE(none.end, SimulationEnd::atLimit);
    QCOMPARE(none.samples.size(), 1u);
  }

  void aMotionWithoutMassIsRejected() {
    Mechanism massless = *withLinkMass(pendulum(), LinkId("1"), LinkMass{number(0)});
    const DynamicsCase worked(std::move(massless));
    TrainDynamics dynamics(worked.dynamics.train);
    const Simulation simulation = simulate(dynamics, worked.options());
    QCOMPARE(simulation.end, SimulationEnd::massless);
    QVERIFY(simulation.samples.empty());
  }

  void aStopEndsIt() {
    const DynamicsCase worked(pendulum());
    TrainDynamics dynamics(worked.dynamics.train);
    SimulationOptions options = worked.options();
    options.angles[0] = 1;
    options.seconds = 1000;
    std::stop_source source;
    double reached = 0;
    const Simulation simulation = simulate(dynamics, options, source.get_token(), [&](double time) {
      reached = time;
      if (time > 1) source.request_stop();
    });
    QCOMPARE(simulation.end, SimulationEnd::stopped);
    QVERIFY(reached > 1 && reached < 10);
  }

  void aTableHasAColumnForEachQuantityAndItsEnergiesBalance() {
    const DynamicsCase worked(pendulum());
    TrainDynamics dynamics(worked.dynamics.train);
    SimulationOptions options = worked.options();
    options.angles[0] = 1;
    options.motors[0] = {2, 0.5};
    const Simulation simulation = simulate(dynamics, options);
    const std::vector<std::string> labels{"2"};
    const std::vector<std::string> expected{"time",     "angle 2", "speed 2",   "acceleration 2",
                                            "torque 2", "kinetic", "potential", "work"};
    QCOMPARE(motionColumns(labels), expected);
    const MotionSample& sample = simulation.samples.back();
    const std::vector<double> row = motionRow(sample);
    QCOMPARE(row.size(), expected.size());
    QCOMPARE(row[0], 1.0);
    QCOMPARE(row[4], 2 - 0.5 * row[2]);
    QCOMPARE(row[7], sample.work);
    QVERIFY(std::abs(energyDefect(simulation)) < 1e-7 * largestEnergy(simulation));
    Simulation wrong = simulation;
    wrong.samples[50].kinetic -= 1;
    QVERIFY(std::abs(energyDefect(wrong) + 1) < 1e-6);
    QVERIFY(endSentence(simulation.end, {}).empty());
    QVERIFY(endSentence(SimulationEnd::atLimit, "7").find("joint 7") != std::string::npos);
  }

  // The start is given, not the reference pose; samples are at whole intervals and at the end.
  void samplesAreWhereTheyWereAskedFor() {
    const DynamicsCase worked(pendulum());
    TrainDynamics dynamics(worked.dynamics.train);
    SimulationOptions options = worked.options();
    options.speeds[0] = 0.5;
    options.seconds = 0.25;
    options.interval = 0.1;
    const Simulation simulation = simulate(dynamics, options);
    QCOMPARE(simulation.samples.size(), 4u);
    QCOMPARE(simulation.samples[2].time, 0.2);
    QCOMPARE(simulation.samples[3].time, 0.25);
    QCOMPARE(simulation.samples[0].speeds[0], 0.5);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::SimulationTest)
#include "test_simulation.moc"
