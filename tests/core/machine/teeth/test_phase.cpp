#include <Eigen/Geometry>
#include <QTest>
#include <array>
#include <cmath>
#include <numbers>

#include "core/machine/teeth/phase.h"

using namespace geargraph;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

PhaseWheel onZ(const Vector3d& centre, int teeth, double sense = 1) {
  return {centre, sense * Vector3d::UnitZ(), Vector3d::UnitX(), teeth};
}

Vector3d around(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

/// Sun, ring and planets at these angles; the meshes are sun-planet and planet-ring of each.
struct Planetary {
  std::vector<PhaseWheel> wheels;
  std::vector<PhaseMesh> meshes;

  Planetary(int sun, int planet, const std::vector<double>& places) {
    const double radius = (sun + planet) / 2.0;
    wheels = {onZ(Vector3d::Zero(), sun), onZ(Vector3d::Zero(), sun + 2 * planet)};
    for (const double angle : places) {
      const int p = static_cast<int>(wheels.size());
      wheels.push_back(onZ(around(radius, angle), planet));
      meshes.push_back({0, p, around(sun / 2.0, angle)});
      meshes.push_back({p, 1, around(sun / 2.0 + planet, angle)});
    }
  }
  [[nodiscard]] double worstResidual() const {
    double worst = 0;
    for (const double r : solvePhases(wheels, meshes).residuals) worst = std::max(worst, std::abs(r));
    return worst;
  }
};

}  // namespace

class PhaseTest : public QObject {
  Q_OBJECT
 private slots:
  /// A tooth of one wheel points at the pitch point, so a space of the other must.
  void toothMeetsSpaceInAnExternalPair() {
    const PhaseWheel a = onZ(Vector3d::Zero(), 20);
    for (const int teeth : {19, 30}) {
      const PhaseWheel b = onZ({(20 + teeth) / 2.0, 0, 0}, teeth);
      const MeshPhase phase = meshPhase(a, b, {10, 0, 0});
      const double angle = meshingAngle(phase, a, 0, b);
      // Tooth k of b points at pi (towards a) plus half a pitch.
      const double toothAtPi = std::remainder((pi - angle) * teeth / (2 * pi), 1.0);
      QVERIFY(std::abs(std::abs(toothAtPi) - 0.5) < 1e-12);
      QCOMPARE(phase.sign, -1);
    }
  }

  void aRingHasASpaceWhereThePinionHasATooth() {
    const PhaseWheel pinion = onZ({10, 0, 0}, 20);
    const PhaseWheel ring = onZ(Vector3d::Zero(), 40);
    const MeshPhase phase = meshPhase(pinion, ring, {20, 0, 0});
    QCOMPARE(phase.sign, 1);
    const double spaceAtZero = std::remainder(-meshingAngle(phase, pinion, 0, ring) * 40 / (2 * pi), 1.0);
    QVERIFY(std::abs(std::abs(spaceAtZero) - 0.5) < 1e-12);
  }

  void reversedAxesChangeTheSignOnly() {
    const PhaseWheel a = onZ(Vector3d::Zero(), 20);
    const PhaseWheel b = onZ({15, 0, 0}, 10);
    const PhaseWheel turned = onZ({15, 0, 0}, 10, -1);
    QCOMPARE(meshPhase(a, turned, {10, 0, 0}).sign, -meshPhase(a, b, {10, 0, 0}).sign);
  }

  /// Rolling at the ratio of the teeth keeps the phase: phase and kinematics are one equation.
  void phaseStaysWhileTheWheelsRoll() {
    const PhaseWheel a{Vector3d::Zero(), Vector3d(0, 0, 1), Vector3d(1, 0, 0), 20};
    const PhaseWheel b{Vector3d::Zero(), Vector3d(1, 0, 0), Vector3d(0, 1, 0), 30};  // bevel, 90 degrees
    const MeshPhase phase = meshPhase(a, b, {20, 0, 30});
    const double start = meshingAngle(phase, a, 0.1, b);
    for (double turn = 0; turn < 7; turn += 0.37) {
      const double other = start + phase.sign * 20.0 / 30 * turn;
      QVERIFY(std::abs(phaseError(phase, a, 0.1 + turn, b, other)) < 1e-12);
      QVERIFY(std::abs(phaseError(phase, a, 0.1 + turn, b, other + 0.1 * 2 * pi / 30)) > 0.09);
    }
  }

  /// On crossed axes the teeth move alike along their normal: n . (v_a - v_b) = 0 at the pitch point is the
  /// ratio of the teeth with the sign of the phase, whichever wheel the normal is taken from.
  void crossedAxesTurnAtTheRatioOfTheirPhase() {
    for (const double helixA : {-1.2, -0.7, -0.2, 0.3, 0.8, 1.3}) {
      for (const double helixB : {-0.9, -0.4, 0.15, 0.6, 1.1}) {
        const int teethA = 3, teethB = 40;
        const double ra = teethA / 2.0 / std::cos(helixA), rb = teethB / 2.0 / std::cos(helixB);
        const double crossing = -helixA - helixB;
        for (const int way : {1, -1}) {  // an axis may be the other way round
          PhaseWheel a{Vector3d::Zero(), Vector3d::UnitZ(), Vector3d::UnitX(), teethA, std::tan(helixA) / ra};
          PhaseWheel b{Vector3d(ra + rb, 0, 0), way * Vector3d(0, -std::sin(crossing), std::cos(crossing)),
                       Vector3d::UnitX(), teethB, std::tan(helixB) / rb};
          const Vector3d point(ra, 0, 0);
          const Vector3d normal = pitchPlaneNormal(a, point);
          QVERIFY(std::abs(std::abs(normal.dot(pitchPlaneNormal(b, point))) - 1) < 1e-12);
          const double speedA = a.axis.cross(point - a.centre).dot(normal);
          const double speedB = b.axis.cross(point - b.centre).dot(normal);
          const MeshPhase phase = meshPhase(a, b, point);
          QVERIFY(std::abs(teethA * speedB - phase.sign * teethB * speedA) < 1e-9);
          QCOMPARE(meshPhase(a, b, point, -normal).sign, phase.sign);
          QCOMPARE(meshPhase(a, b, point, pitchPlaneNormal(b, point)).sign, phase.sign);
          QCOMPARE(meshPhase(b, a, point).sign, phase.sign);
          const double start = meshingAngle(phase, a, 0.1, b);
          QVERIFY(std::abs(phaseError(phase, a, 0.9, b, start + phase.sign * 0.8 * teethA / teethB)) < 1e-12);
          const PhaseMesh mesh{0, 1, point, normal};
          const std::array<PhaseWheel, 2> both{a, b};
          const PhaseSolution solution = solvePhases(both, std::span(&mesh, 1));
          QVERIFY(std::abs(phaseError(phase, a, solution.angles[0], b, solution.angles[1])) < 1e-12);
        }
      }
    }
  }

  void planetsFitWhereTheSumOfTeethIsDivisible() {
    const double third = 2 * pi / 3;
    QVERIFY(Planetary(12, 18, {0, third, 2 * third}).worstResidual() < 1e-12);  // 60 / 3
    const double quarter = pi / 2;
    QVERIFY(Planetary(12, 18, {0, quarter, pi, 3 * quarter}).worstResidual() < 1e-12);  // 60 / 4
    QVERIFY(std::abs(Planetary(13, 18, {0, quarter, pi, 3 * quarter}).worstResidual() - 0.5) <
            1e-9);                                                                                 // 62 / 4
    QVERIFY(std::abs(Planetary(13, 18, {0, third, 2 * third}).worstResidual() - 1.0 / 3) < 1e-9);  // 62 / 3
  }

  void planetsFitAtEveryMultipleOfTheirAngle() {
    const double step = 2 * pi / 62;
    QVERIFY(Planetary(13, 18, {0, 15 * step, 31 * step, 46 * step}).worstResidual() < 1e-12);
    QVERIFY(Planetary(13, 18, {0, 15.25 * step}).worstResidual() > 0.24);
  }

  /// An even loop of external wheels in directions a_k (turns) closes where the sum of
  /// (-1)^k [N_k a_k + N_k+1 (a_k + 1/2) - 1/2] is whole (core/machine/teeth/README.md, section 4).
  void loopsOfFourWheelsMissByTheClosedForm() {
    const auto check = [](int last) {
      // Centres of a quadrilateral, built so that all four pairs touch.
      const double ab = 30, bc = 40, cd = (45 + last) / 2.0, da = (25 + last) / 2.0;
      const double diagonal = std::hypot(ab, bc);
      const Vector3d a(0, 0, 0), b(ab, 0, 0), c(ab, bc, 0);
      const double along = (diagonal * diagonal + da * da - cd * cd) / (2 * diagonal);
      const double up = std::sqrt(da * da - along * along);
      const Vector3d line = (c - a) / diagonal;
      const Vector3d d = a + along * line + up * Vector3d(-line.y(), line.x(), 0);
      const std::vector<PhaseWheel> wheels{onZ(a, 25), onZ(b, 35), onZ(c, 45), onZ(d, last)};
      const auto touch = [&](int i, int j) {
        const Vector3d p = wheels[i].centre, q = wheels[j].centre;
        return PhaseMesh{i, j, p + (q - p) * wheels[i].teeth / double(wheels[i].teeth + wheels[j].teeth)};
      };
      const std::vector<PhaseMesh> meshes{touch(0, 1), touch(1, 2), touch(2, 3), touch(3, 0)};
      double sum = 0;
      for (int k = 0; k < 4; ++k) {
        const PhaseWheel& from = wheels[k];
        const PhaseWheel& to = wheels[(k + 1) % 4];
        const Vector3d side = to.centre - from.centre;
        const double turns = std::atan2(side.y(), side.x()) / (2 * pi);
        sum += (k % 2 == 0 ? 1 : -1) * (from.teeth * turns + to.teeth * (turns + 0.5) - 0.5);
      }
      double residual = 0;  // of the one mesh that closes the loop
      for (const double r : solvePhases(wheels, meshes).residuals) residual += r;
      return std::pair{std::abs(residual), std::abs(std::remainder(sum, 1.0))};
    };
    for (int last = 17; last < 40; ++last) {
      const auto [residual, expected] = check(last);
      QVERIFY2(std::abs(residual - expected) < 1e-9, qPrintable(QString::number(last)));
    }

    QVERIFY(check(20).first > 0.01);
  }

  /// A differential: (N_A + N_B) / n is whole.
  void bevelSpidersFitByTheSumOfTheSideGears() {
    const auto residual = [](int side, int pinion, int spiders) {
      std::vector<PhaseWheel> wheels{{Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY(), side},
                                     {Vector3d::Zero(), -Vector3d::UnitX(), Vector3d::UnitY(), side}};
      std::vector<PhaseMesh> meshes;
      for (int i = 0; i < spiders; ++i) {
        const double angle = 2 * pi * i / spiders;
        const Vector3d out(0, std::cos(angle), std::sin(angle));
        wheels.push_back({Vector3d::Zero(), out, Vector3d::UnitX(), pinion});
        meshes.push_back({0, static_cast<int>(wheels.size()) - 1, side * out + pinion * Vector3d::UnitX()});
        meshes.push_back({static_cast<int>(wheels.size()) - 1, 1, side * out - pinion * Vector3d::UnitX()});
      }
      double worst = 0;
      for (const double r : solvePhases(wheels, meshes).residuals) worst = std::max(worst, std::abs(r));
      return worst;
    };
    QVERIFY(residual(16, 10, 2) < 1e-12);
    QVERIFY(residual(16, 10, 4) < 1e-12);
    QVERIFY(std::abs(residual(16, 10, 3) - 1.0 / 3) < 1e-9);
    QVERIFY(residual(15, 10, 3) < 1e-12);
  }
};

QTEST_APPLESS_MAIN(PhaseTest)
#include "test_phase.moc"
