#include <QTest>
#include <random>

#include "core/mechanism/model/mass_edits.h"
#include "core/theory/statics/applied_loads.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/trains.h"
#include "tests/core/theory/dynamics/dynamics_case.h"

namespace geargraph {
namespace {

using test::DynamicsCase;
using test::massOf;
using test::number;
using test::triple;

/// Every moving link gets a body of its own that is no solid of revolution, beside its axis.
Mechanism withRandomMasses(Mechanism mechanism, std::mt19937& random) {
  std::uniform_real_distribution<double> spread(0.8, 1.2);
  std::uniform_real_distribution<double> place(-80, 80);
  for (std::size_t i = 1; i < mechanism.links.size(); ++i) {
    const LinkId link = mechanism.links[i].id;
    LinkMass mass = massOf(spread(random), triple(place(random), place(random), place(random)),
                           1e-3 * spread(random), 1e-3 * spread(random), 1e-3 * spread(random));
    (*mass.inertia)[3] = number(1e-4 * spread(random));
    (*mass.inertia)[5] = number(-1e-4 * spread(random));
    mechanism = *withLinkMass(std::move(mechanism), link, mass);
  }
  return *withGravity(std::move(mechanism), triple(1, -2, -9.81));
}

Eigen::VectorXd randomVector(Eigen::Index size, std::mt19937& random) {
  std::uniform_real_distribution<double> value(-2, 2);
  return Eigen::VectorXd::NullaryExpr(size, [&](Eigen::Index) { return value(random); });
}

/// h by Lagrange from M and the potential energy alone, by differences: dM/dt theta' - grad kinetic + grad
/// potential.
Eigen::VectorXd lagrangeBias(TrainDynamics& dynamics, const Eigen::VectorXd& angles,
                             const Eigen::VectorXd& speeds) {
  constexpr double kStep = 1e-4;
  const Eigen::Index inputs = angles.size();
  Eigen::VectorXd bias(inputs);
  const EquationOfMotion ahead = dynamics.at(angles + kStep * speeds, speeds);
  const EquationOfMotion behind = dynamics.at(angles - kStep * speeds, speeds);
  bias = (ahead.inertia - behind.inertia) / (2 * kStep) * speeds;
  for (Eigen::Index i = 0; i < inputs; ++i) {
    const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(inputs, i);
    const EquationOfMotion more = dynamics.at(angles + step, speeds);
    const double high = more.kinetic - more.potential;
    const EquationOfMotion less = dynamics.at(angles - step, speeds);
    bias[i] -= (high - (less.kinetic - less.potential)) / (2 * kStep);
  }
  return bias;
}

/// A planetary set, ring fixed: sun and carrier on one axis, one planet.
Mechanism planetarySet(int sunTeeth, int planetTeeth) {
  test::TrainBuilder train("planetary");
  const int center = train.axis({0, 0, 0}, {0, 0, 1});
  const int sun = train.link(0, center);
  const int carrier = train.link(0, center);
  const int pin = train.axis({sunTeeth + planetTeeth, 0, 0}, {0, 0, 1});  // module 2
  const int planet = train.link(carrier, pin);
  train.external(sun, center, sunTeeth, planet, pin, planetTeeth);
  train.internal(planet, pin, planetTeeth, 0, center, sunTeeth + 2 * planetTeeth);
  train.input(0);
  return train.mechanism();
}

}  // namespace

class DynamicsTest : public QObject {
  Q_OBJECT

 private slots:
  // Every link's moment times the square of its ratio, and the planet's mass on the carrier's circle.
  void aPlanetarySetHasTheInertiaOfTheFormula() {
    const int sunTeeth = 20;
    const int planetTeeth = 15;
    const double inSun = 1e-3;
    const double inCarrier = 2e-3;
    const double inPlanet = 3e-4;
    const double planetMass = 0.4;
    Mechanism set = planetarySet(sunTeeth, planetTeeth);
    set = *withLinkMass(std::move(set), LinkId("1"), massOf(1, triple(0, 0, 0), 1, 1, inSun));
    set = *withLinkMass(std::move(set), LinkId("2"), massOf(1, triple(0, 0, 0), 1, 1, inCarrier));
    set = *withLinkMass(std::move(set), LinkId("3"), massOf(planetMass, triple(35, 0, 0), 1, 1, inPlanet));
    const DynamicsCase worked(std::move(set));
    TrainDynamics dynamics(worked.dynamics.train);
    const double ringTeeth = sunTeeth + 2 * planetTeeth;
    const double carrierRatio = sunTeeth / (sunTeeth + ringTeeth);
    const double planetRatio = carrierRatio * (1 - ringTeeth / planetTeeth);  // absolute speed over the sun's
    const double expected = inSun + inCarrier * carrierRatio * carrierRatio +
                            inPlanet * planetRatio * planetRatio +
                            planetMass * std::pow(0.035 * carrierRatio, 2);
    QCOMPARE(worked.inputs(), 1);
    for (const double angle : {0., 1., 17.}) {
      const Eigen::VectorXd angles = Eigen::VectorXd::Constant(1, angle);
      const EquationOfMotion& equation = dynamics.at(angles, Eigen::VectorXd::Constant(1, 3));
      QVERIFY(std::abs(equation.inertia(0, 0) / expected - 1) < 1e-12);
      QVERIFY(std::abs(equation.bias[0]) < 1e-12);  // balanced, no weight
      QVERIFY(std::abs(equation.kinetic - 0.5 * expected * 9) < 1e-12);
    }
    const Eigen::MatrixXd reflected = dynamics.reflectedInertias(worked.zeros());
    QCOMPARE(reflected.rows(), 4);
    QVERIFY(std::abs(reflected(1, 0) / inSun - 1) < 1e-12);
    QVERIFY(std::abs(reflected(2, 0) / (inCarrier * carrierRatio * carrierRatio) - 1) < 1e-12);
  }

  // Coriolis, centrifugal forces and weight against Lagrange's equation, whose only sources are M and V.
  void theBiasIsThatOfLagrange() {
    std::mt19937 random(1);
    int compared = 0;
    for (const char* const name : {"robot", "bevel-wrist", "three-roll-wrist", "bevel-differential",
                                   "planetary-ring-held", "humpage-reduction"}) {
      const DynamicsCase worked(withRandomMasses(test::example(name), random));
      TrainDynamics dynamics(worked.dynamics.train);
      for (int pose = 0; pose < 5; ++pose) {
        const Eigen::VectorXd angles = randomVector(worked.inputs(), random);
        const Eigen::VectorXd speeds = randomVector(worked.inputs(), random);
        const Eigen::VectorXd bias = dynamics.at(angles, speeds).bias;
        const Eigen::VectorXd expected = lagrangeBias(dynamics, angles, speeds);
        QVERIFY2((bias - expected).norm() <= 1e-5 * (1 + expected.norm()), name);
        QVERIFY(bias.norm() > 1e-3);
        ++compared;
      }
    }
    QCOMPARE(compared, 30);
  }

  void kineticEnergyIsTheQuadraticFormOfTheInertia() {
    std::mt19937 random(2);
    const DynamicsCase worked(withRandomMasses(test::example("robot"), random));
    TrainDynamics dynamics(worked.dynamics.train);
    const Eigen::VectorXd speeds = randomVector(worked.inputs(), random);
    const Eigen::VectorXd angles = randomVector(worked.inputs(), random);
    const EquationOfMotion& equation = dynamics.at(angles, speeds);
    QVERIFY(std::abs(equation.kinetic - 0.5 * speeds.dot(equation.inertia * speeds)) <
            1e-12 * equation.kinetic);
    const Eigen::MatrixXd inertia = equation.inertia;
    const Eigen::MatrixXd reflected = dynamics.reflectedInertias(angles);
    QVERIFY((reflected.colwise().sum().transpose() - inertia.diagonal()).norm() < 1e-12 * inertia.norm());
  }

  // At rest in the reference pose dynamics is statics: the motors hold what (25*) says.
  void atRestTheMotorsHoldWhatStaticsSays() {
    Mechanism robot = test::robot();
    const auto onJoint = [&](const char* joint, const Rational& torque) {
      robot.loads.push_back({{}, JointTorque{JointId(joint), Number(torque)}, {}});
    };
    onJoint("14", Rational(10));
    onJoint("12", Rational(-3));
    robot.loads.push_back({{}, LinkForce{LinkId("3"), triple(10, -20, -50), triple(-30, -60, 130)}, {}});
    robot.loads.push_back({{}, LinkTorque{LinkId("6"), {}, Number(4)}, {}});
    const DynamicsCase worked(std::move(robot));
    StaticsProblem problem;
    addLoads(worked.mechanism, worked.placement, worked.mechanism.loads, problem);
    const LoadPower power = LoadPower::of(worked.mechanism, worked.model, worked.placement, problem);
    Eigen::VectorXd expected = worked.zeros();
    const Eigen::MatrixXd& gains = worked.dynamics.train.gains;
    for (Eigen::Index joint = 0; joint < gains.rows(); ++joint)
      expected += power.byJoint.at(static_cast<int>(joint)).number() * gains.row(joint).transpose();
    TrainDynamics dynamics(worked.dynamics.train);
    const Eigen::VectorXd load = dynamics.at(worked.zeros(), worked.zeros()).load;
    QVERIFY(expected.norm() > 1);
    QVERIFY((load - expected).norm() < 1e-10 * expected.norm());
  }

  // Solids at 7850 kg/m³: an example's masses are of the size of its gears, and a density scales them all.
  void massesComeFromTheSolids() {
    const DynamicsCase steel(test::example("planetary-ring-held"));
    Mechanism lighter = *withDensity(test::example("planetary-ring-held"), Number(Rational(7850, 2)));
    const DynamicsCase half(std::move(lighter));
    int moving = 0;
    for (std::size_t link = 1; link < steel.dynamics.links.size(); ++link) {
      const LinkInertia& inertia = steel.dynamics.links[link];
      QCOMPARE(inertia.source, MassSource::solids);
      double gears = 0;
      for (const TrainGear& gear : steel.gears.gears) {
        if (gear.link != static_cast<int>(link)) continue;
        const double radius = pitchRadius(gear.spec) / 1000;
        if (gear.spec.kind == GearKind::external)
          gears += 7850 * 3.1416 * radius * radius * gear.spec.faceWidth / 1000;
      }
      QVERIFY(inertia.body.mass > 0.3 * gears);  // webs have windows
      QVERIFY(std::abs(half.dynamics.links[link].body.mass / inertia.body.mass - 0.5) < 1e-9);
      ++moving;
    }
    QVERIFY(moving >= 3);
  }

  void aStatedMassIsSpreadAsTheSolids() {
    const DynamicsCase before(test::example("robot"));
    const LinkInertia solids = before.dynamics.links[3];
    LinkMass stated{number(2 * solids.body.mass)};
    const DynamicsCase after(*withLinkMass(test::example("robot"), before.mechanism.links[3].id, stated));
    const LinkInertia scaled = after.dynamics.links[3];
    QCOMPARE(scaled.source, MassSource::scaled);
    QVERIFY((scaled.body.inertia - 2 * solids.body.inertia).norm() < 1e-9 * solids.body.inertia.norm());
    QVERIFY((scaled.body.center - solids.body.center).norm() < 1e-12);
  }

  // The place of a train changes nothing: not the inertia, nor what weight asks of the motors.
  void aFarTrainHasTheSameEquation() {
    std::mt19937 random(3);
    Mechanism near = *withGravity(test::robot(), triple(0, 0, -9.81));
    const DynamicsCase here(near);
    const DynamicsCase there(test::moved(near, test::rotation(1, 0, 0, 0), {1'000'000, -2'000'000, 500'000}));
    TrainDynamics one(here.dynamics.train);
    TrainDynamics other(there.dynamics.train);
    for (int pose = 0; pose < 5; ++pose) {
      const Eigen::VectorXd angles = randomVector(here.inputs(), random);
      const Eigen::VectorXd speeds = randomVector(here.inputs(), random);
      const EquationOfMotion& a = one.at(angles, speeds);
      const EquationOfMotion& b = other.at(angles, speeds);
      QVERIFY((a.inertia - b.inertia).norm() < 1e-5 * a.inertia.norm());  // solids there have float places
      QVERIFY((a.bias - b.bias).norm() < 1e-4 * a.bias.norm());
    }
  }

  void anUnknownUnitIsRejected() {
    Mechanism robot = test::robot();
    robot.unit = "cubits";
    const test::Worked worked(robot);
    const auto result = dynamicsOf(worked.mechanism, worked.model, worked.placement, worked.analysis,
                                   trainOf(worked.mechanism, worked.placement));
    QVERIFY(result.has_value() && !result->has_value());
    QCOMPARE(result->error()[0].code, Code::unknownUnit);
  }

  void theDocumentRejectsMassesThatNoBodyHas() {
    const Mechanism robot = test::robot();
    const LinkId link("3");
    const auto rejected = [&](const LinkMass& mass) {
      const auto edited = withLinkMass(robot, link, mass);
      return !edited && edited.error()[0].code == Code::schema;
    };
    QVERIFY(rejected({number(-1)}));
    QVERIFY(rejected(massOf(1, triple(0, 0, 0), 1, 1, 3)));   // a disc has at most the sum
    QVERIFY(!rejected(massOf(1, triple(0, 0, 0), 1, 1, 2)));  // a disc
    QVERIFY(rejected(massOf(1, triple(0, 0, 0), -1, 1, 1)));
    LinkMass twisted = massOf(1, triple(0, 0, 0), 1, 1, 1);
    (*twisted.inertia)[3] = number(0.6);
    QVERIFY(rejected(twisted));
    (*twisted.inertia)[3] = number(0.5);
    QVERIFY(!rejected(twisted));
    QVERIFY(!withLinkMass(robot, LinkId("none"), LinkMass{1}));
    QVERIFY(!withDensity(robot, Number(0)));
    QVERIFY(!withGravity(robot, triple(0, 0, 1e16)));
  }

  void aStopLeavesNothing() {
    const test::Worked worked(test::example("robot"));
    std::stop_source source;
    source.request_stop();
    QVERIFY(!dynamicsOf(worked.mechanism, worked.model, worked.placement, worked.analysis,
                        trainOf(worked.mechanism, worked.placement), source.get_token())
                 .has_value());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::DynamicsTest)
#include "test_dynamics.moc"
