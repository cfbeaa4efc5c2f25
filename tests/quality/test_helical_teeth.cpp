#include <QTest>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/machine/body_layout/complete_train.h"
#include "core/machine/solids/gear_solid.h"
#include "tests/core/support/train_sketch.h"
#include "tests/quality/section_checker.h"

using namespace geargraph;
using Eigen::Vector3d;

namespace {

/// What a helical pair turns out to be when its solids are cut square to their axes, at three places of the
/// face.
class HelicalSections {
 public:
  explicit HelicalSections(GearTrain train) : m_train(std::move(train)) {
    for (const TrainGear& gear : m_train.gears) m_solids.push_back(*gearSolid(gear.spec, kExportTolerance));
  }

  /// `along`: how far the section is from the pitch point, along the tail's axis, in half face widths of the
  /// narrower wheel. Lengths in transverse modules.
  [[nodiscard]] test::MeshReport report(std::size_t mesh, double along, double turnB = 0) const {
    const TrainMesh& m = m_train.meshes[mesh];
    const TrainGear& a = m_train.gears[m.tailGear];
    const TrainGear& b = m_train.gears[m.headGear];
    const double face = std::min(a.spec.faceWidth, b.spec.faceWidth);
    const Vector3d at = m.pitchPoint + along * face / 2 * a.pose.linear().col(2);
    const test::Section sectionA = cut(m.tailGear, at);
    const test::Section sectionB = cut(m.headGear, at);
    constexpr int kSteps = 16;
    test::MeshReport r = test::checkMesh({&sectionA, a.pose},
                                         {&sectionB, b.pose * Eigen::AngleAxisd(turnB, Vector3d::UnitZ())},
                                         a.spec.teeth, b.spec.teeth, m.pitchPoint, a.spec.module, kSteps);
    for (double* length : {&r.interpenetration, &r.transmissionError, &r.leastBacklash, &r.mostBacklash})
      *length /= a.spec.module;
    return r;
  }
  [[nodiscard]] const GearTrain& train() const { return m_train; }

 private:
  [[nodiscard]] test::Section cut(GearOrdinal gear, const Vector3d& at) const {
    const Eigen::Isometry3d& pose = m_train.gears[gear].pose;
    return test::Section::flat(m_solids[static_cast<std::size_t>(gear)], (pose.inverse() * at).z());
  }

  GearTrain m_train;
  std::vector<Solid> m_solids;
};

GearTrain helicalTrainOf(const Mechanism& mechanism) {
  return trainOf(mechanism, placementOf(mechanism));
}

/// Parallel axes at a distance; the second one turned round where `reversed`.
Mechanism helicalPair(int a, int b, MeshKind kind, double module, double degrees, double distance,
                      bool reversed = false) {
  test::TrainSketch sketch(2);
  sketch.axis("a", {"0", "0", "0"});
  sketch.axis("b", {Number::fromDouble(distance).text(), "0", "0"}, {"0", "0", reversed ? "-1" : "1"});
  sketch.joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, a, b, kind);
  Mechanism mechanism = sketch.build();
  GearMesh& mesh = mechanism.gearMeshes.front();
  mesh.module = Number::fromDouble(module);
  mesh.helixAngle = Number::fromDouble(std::abs(degrees));
  if (degrees < 0) mesh.hand = Hand::left;
  return mechanism;
}

double helicalDistance(int teeth, double module, double degrees) {
  return module * teeth / 2 / std::cos(degrees * std::numbers::pi / 180);
}

void compareHelicalToBars(const HelicalSections& measured, std::size_t mesh) {
  for (const double along : {-0.83, 0.037, 0.79}) {
    const test::MeshReport r = measured.report(mesh, along);
    const QString words = QString("at %1: interpenetration %2, TE %3, phase %4, backlash %5..%6")
                              .arg(along)
                              .arg(r.interpenetration)
                              .arg(r.transmissionError)
                              .arg(r.phaseError)
                              .arg(r.leastBacklash)
                              .arg(r.mostBacklash);
    QVERIFY2(r.interpenetration <= 0.004, qPrintable(words));
    QVERIFY2(r.transmissionError <= 0.004, qPrintable(words));
    QVERIFY2(r.phaseError <= 0.005, qPrintable(words));
    QVERIFY2(std::abs(r.leastBacklash - 0.04) <= 0.01, qPrintable(words));
    QVERIFY2(std::abs(r.mostBacklash - 0.04) <= 0.01, qPrintable(words));
  }
}

}  // namespace

/// Helical teeth mesh all along their face: measured in sections by the independent checker.
class HelicalTeethTest : public QObject {
  Q_OBJECT
 private slots:
  void pairsMesh_data() {
    QTest::addColumn<int>("a");
    QTest::addColumn<int>("b");
    QTest::addColumn<bool>("isRing");
    QTest::addColumn<double>("module");
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("distance");  // 0: the standard one
    QTest::addColumn<bool>("reversed");
    QTest::addColumn<bool>("herringbone");
    QTest::newRow("right") << 20 << 40 << false << 2.0 << 15.0 << 0.0 << false << false;
    QTest::newRow("left") << 23 << 31 << false << 2.0 << -30.0 << 0.0 << false << false;
    QTest::newRow("an axis turned round") << 20 << 41 << false << 2.0 << 20.0 << 0.0 << true << false;
    QTest::newRow("shifted") << 31 << 30 << false << 3.5 << 21.0 << 116.5 << false << false;
    QTest::newRow("shifted, axis turned round")
        << 30 << 31 << false << 3.5 << -21.0 << 116.5 << true << false;
    QTest::newRow("ring") << 20 << 60 << true << 2.0 << 20.0 << 0.0 << false << false;
    QTest::newRow("ring, axis turned round") << 21 << 70 << true << 2.0 << -18.0 << 0.0 << true << false;
    QTest::newRow("herringbone") << 24 << 36 << false << 2.0 << 25.0 << 0.0 << false << true;
    QTest::newRow("herringbone, axis turned round")
        << 24 << 37 << false << 2.0 << 25.0 << 0.0 << true << true;
    QTest::newRow("herringbone ring") << 22 << 64 << true << 2.0 << -25.0 << 0.0 << true << true;
  }
  void pairsMesh() {
    QFETCH(int, a);
    QFETCH(int, b);
    QFETCH(bool, isRing);
    QFETCH(double, module);
    QFETCH(double, degrees);
    QFETCH(double, distance);
    QFETCH(bool, reversed);
    QFETCH(bool, herringbone);
    if (distance == 0) distance = helicalDistance(isRing ? b - a : a + b, module, degrees);
    Mechanism mechanism = helicalPair(a, b, isRing ? MeshKind::internal : MeshKind::external, module, degrees,
                                      distance, reversed);
    mechanism.gearMeshes.front().herringbone = herringbone;
    compareHelicalToBars(HelicalSections(helicalTrainOf(mechanism)), 0);
  }

  /// Sun, three planets and ring: the planet is left-hand, because the sun is right-hand.
  void planetariesMesh() {
    Mechanism mechanism = test::planetary(24, 18, 3);
    for (std::size_t m = 0; m < mechanism.gearMeshes.size(); ++m) {
      GearMesh& mesh = mechanism.gearMeshes[m];
      mesh.helixAngle = Number(18);
      mesh.module = Number(2);
      mesh.hand = m % 2 == 0 ? Hand::right : Hand::left;
    }
    const HelicalSections measured(helicalTrainOf(mechanism));
    QCOMPARE(measured.train().gears.size(), std::size_t{5});
    for (std::size_t m = 0; m < mechanism.gearMeshes.size(); ++m) compareHelicalToBars(measured, m);
  }

  /// A long pinion that meshes with two wheels at different places of its face: its mid face is in neither
  /// pitch plane.
  void aLongPinionMeshesAtBothEnds() {
    const double distance = helicalDistance(60, 2, 20);
    test::TrainSketch sketch(3);
    sketch.axis("a", {"0", "0", "0"});
    sketch.axis("b", {Number::fromDouble(distance).text(), "0", "0"});
    sketch.axis("c", {Number::fromDouble(-distance).text(), "0", "0"});
    sketch.joint(0, 1, "a").joint(0, 2, "b").joint(0, 3, "c");
    const double r = distance / 3;
    sketch.mesh(1, 2, 20, 40, MeshKind::external, {Number::fromDouble(r).text(), "0", "0"});
    sketch.mesh(1, 3, 20, 40, MeshKind::external, {Number::fromDouble(-r).text(), "0", "23"});
    Mechanism mechanism = sketch.build();
    Wheel pinion;
    pinion.id = WheelId("p");
    pinion.link = LinkId("1");
    mechanism.wheels.push_back(pinion);
    for (GearMesh& mesh : mechanism.gearMeshes) {
      mesh.tailWheel = WheelId("p");
      mesh.module = Number(2);
      mesh.helixAngle = Number(20);
    }
    const HelicalSections measured(helicalTrainOf(mechanism));
    QCOMPARE(measured.train().gears.size(), std::size_t{3});
    QVERIFY(measured.train().gears[0].spec.faceWidth > 30);
    for (std::size_t m = 0; m < 2; ++m) compareHelicalToBars(measured, m);
  }

  /// The check has to be able to fail: with one hand for both, sections off the middle do not fit.
  void wrongHandsAreCaught() {
    GearTrain train =
        helicalTrainOf(helicalPair(20, 40, MeshKind::external, 2, 15, helicalDistance(60, 2, 15)));
    train.gears[1].spec.helixAngle *= -1;
    const HelicalSections measured(std::move(train));
    QVERIFY(measured.report(0, 0.79).interpenetration > 0.05);
  }
};

QTEST_APPLESS_MAIN(HelicalTeethTest)
#include "test_helical_teeth.moc"
