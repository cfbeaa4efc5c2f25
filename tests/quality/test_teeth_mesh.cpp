#include <QTest>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/machine/body_layout/complete_train.h"
#include "core/machine/solids/gear_mesher.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/tooth_pair.h"
#include "core/mechanism/graph/digraph.h"
#include "core/theory/pose/forward_kinematics.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"
#include "tests/quality/rolling_rates.h"
#include "tests/quality/section_checker.h"

using namespace geargraph;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

constexpr int kFrames = 24;

/// What the train's gears turn out to be when they are measured.
class Measured {
 public:
  explicit Measured(GearTrain train) : m_train(std::move(train)) {
    for (const TrainGear& gear : m_train.gears) {
      const Expected<Solid> solid = gearSolid(gear.spec, kExportTolerance);
      const double sphere =
          gear.spec.kind == GearKind::bevel ? coneDistance(gear.spec) - gear.spec.faceWidth / 2 : 0;
      m_sections.push_back(std::make_unique<test::Section>(
          sphere > 0 ? test::Section::spherical(*solid, sphere) : test::Section::flat(*solid)));
    }
  }

  /// Lengths in modules at the place of the section.
  [[nodiscard]] test::MeshReport report(std::size_t mesh, double turnB = 0, double ratioSign = 1) const {
    const TrainMesh& m = m_train.meshes[mesh];
    const TrainGear& a = gear(m.tailGear);
    const TrainGear& b = gear(m.headGear);
    // The bevels' section lies in the middle of the face: that is where its pitch point is.
    const bool bevel = a.spec.kind == GearKind::bevel;
    const double part = bevel ? 1 - a.spec.faceWidth / 2 / coneDistance(a.spec) : 1;
    const Vector3d apex = a.pose.translation();
    const Vector3d point = bevel ? Vector3d(apex + part * (m.pitchPoint - apex)) : m.pitchPoint;
    const double unit = a.spec.module * part;
    test::MeshReport r =
        test::checkMesh({section(m.tailGear), a.pose},
                        {section(m.headGear), b.pose * Eigen::AngleAxisd(turnB, Vector3d::UnitZ())},
                        a.spec.teeth, b.spec.teeth, point, unit, kFrames, ratioSign);
    r.interpenetration /= unit;
    r.transmissionError /= unit;
    r.leastBacklash /= unit;
    r.mostBacklash /= unit;
    return r;
  }

  [[nodiscard]] const GearTrain& train() const { return m_train; }
  [[nodiscard]] const TrainGear& gear(int g) const { return m_train.gears[static_cast<std::size_t>(g)]; }
  [[nodiscard]] const test::Section* section(int g) const {
    return m_sections[static_cast<std::size_t>(g)].get();
  }

 private:
  GearTrain m_train;
  std::vector<std::unique_ptr<test::Section>> m_sections;
};

GearTrain trainOf(const Mechanism& mechanism) {
  return geargraph::trainOf(mechanism, placementOf(mechanism));
}

GearTrain spurPair(int a, int b, MeshKind kind, const std::string& distance = {}) {
  test::TrainSketch sketch(2);
  if (!distance.empty()) sketch.axis("a", {"0", "0", "0"}).axis("b", {distance, "0", "0"});
  sketch.joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, a, b, kind);
  return trainOf(sketch.build());
}

/// Axes at this angle, through the origin. The pitch point stands in the file.
GearTrain bevelPair(int a, int b, double degrees) {
  const double sigma = degrees * pi / 180;
  const double da = std::atan2(std::sin(sigma), static_cast<double>(b) / a + std::cos(sigma));
  const double reach = a / std::sin(da);  // module 2
  const auto text = [](double v) { return Number::fromDouble(v).text(); };
  test::TrainSketch sketch(2);
  sketch.axis("a", {"0", "0", "0"});
  sketch.axis("b", {"0", "0", "0"}, {text(std::sin(sigma)), "0", text(std::cos(sigma))});
  sketch.joint(0, 1, "a", text(reach)).joint(0, 2, "b", text(reach));
  sketch.mesh(1, 2, a, b, MeshKind::bevel, {text(reach * std::sin(da)), "0", text(reach * std::cos(da))});
  return trainOf(sketch.build());
}

/// The bevel that an old text book would make: the planar tooth of z teeth, not of z / cos d, laid on the
/// cone.
Solid bevelOfPlainTeeth(const GearSpec& spec) {
  GearSpec flat = standardGear(GearKind::external, spec.teeth, 1, 1);
  flat.backlashAllowance = spec.backlashAllowance;
  const HalfTooth tooth = externalTooth(flat, kExportTolerance);
  const double mu = spec.module / coneDistance(spec);
  GearBlank blank;
  blank.teeth = spec.teeth;
  blank.below.tolerance = 0.01;
  const double small = coneDistance(spec) - spec.faceWidth;
  for (std::size_t i = 0; i < tooth.points.size(); ++i) {
    const ProfilePoint& p = tooth.points[i];
    const double c = spec.coneAngle + std::atan((p.rad - spec.teeth / 2.0) * mu);
    const Vector3d ray = Vector3d(std::sin(c) * std::cos(p.gam), std::sin(c) * std::sin(p.gam), std::cos(c)) /
                         std::cos(c - spec.coneAngle);
    const bool corner = i > 0 && p.rad == tooth.points[i - 1].rad && p.gam == tooth.points[i - 1].gam;
    const Vector3d up = Vector3d(std::sin(spec.coneAngle), 0, std::cos(spec.coneAngle));
    blank.half.push_back({ray * small, ray * coneDistance(spec), Vector3d::UnitY(), -up, up, corner});
  }
  blank.below.body = {{0, 2 * coneDistance(spec)}, {0, 0}};
  return meshed(blank);
}

QString words(const test::MeshReport& r) {
  return QString("interpenetration %1, TE %2, phase %3, backlash %4..%5")
      .arg(r.interpenetration)
      .arg(r.transmissionError)
      .arg(r.phaseError)
      .arg(r.leastBacklash)
      .arg(r.mostBacklash);
}

void compareToBars(const test::MeshReport& r, double backlash = 0.04) {
  QVERIFY2(r.interpenetration <= 0.002, qPrintable(words(r)));
  QVERIFY2(r.transmissionError <= 0.004, qPrintable(words(r)));
  QVERIFY2(r.phaseError <= 0.005, qPrintable(words(r)));
  QVERIFY2(std::abs(r.leastBacklash - backlash) <= 0.01, qPrintable(words(r)));
  QVERIFY2(std::abs(r.mostBacklash - backlash) <= 0.01, qPrintable(words(r)));
}

}  // namespace

class TeethMeshTest : public QObject {
  Q_OBJECT
 private slots:
  void externalPairsMesh_data() {
    QTest::addColumn<int>("a");
    QTest::addColumn<int>("b");
    QTest::newRow("20/40") << 20 << 40;
    QTest::newRow("17/17") << 17 << 17;
    QTest::newRow("12/90") << 12 << 90;
    QTest::newRow("40/41") << 40 << 41;
  }
  void externalPairsMesh() {
    QFETCH(int, a);
    QFETCH(int, b);
    compareToBars(Measured(spurPair(a, b, MeshKind::external)).report(0));
  }

  /// Eight teeth without shift are so undercut that less than one pair is in contact on its flanks at times;
  /// the edges that lead over keep within the bars.
  void thePinionOfEightMeshes() { compareToBars(Measured(spurPair(8, 40, MeshKind::external)).report(0)); }

  /// The same pinion with the shift that spares it the undercut, its mate with the opposite: one pair is
  /// always in contact. Without the shift it is not, and the contact ratio says so.
  void theShiftedPinionOfEightDrivesEvenly() {
    const auto pair = [](const char* shift) {
      test::TrainSketch sketch(2);
      sketch.joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, 8, 40, MeshKind::external);
      Mechanism mechanism = sketch.build();
      for (const auto& [id, link, sign] : {std::tuple{"p", "1", ""}, std::tuple{"w", "2", "-"}}) {
        Wheel wheel;
        wheel.id = WheelId(id);
        wheel.link = LinkId(link);
        wheel.profileShift = *Number::fromText(std::string(sign) + shift);
        mechanism.wheels.push_back(wheel);
      }
      mechanism.gearMeshes.front().tailWheel = WheelId("p");
      mechanism.gearMeshes.front().headWheel = WheelId("w");
      return trainOf(mechanism);
    };
    compareToBars(Measured(pair("0.53")).report(0));
    const auto ratioOf = [](const GearTrain& train) {
      const GearSpec& a = train.gears[0].spec;
      const GearSpec& b = train.gears[1].spec;
      return contactRatio(a, externalTooth(a, 0.01), b, externalTooth(b, 0.01), 24);
    };
    QVERIFY(ratioOf(pair("0.53")) > 1.2);
    QVERIFY(ratioOf(pair("0")) < 1);
  }

  /// At a wider distance the shifts that fit keep play and contact.
  void shiftedPairsMeshAtTheirDistance_data() {
    QTest::addColumn<int>("a");
    QTest::addColumn<int>("b");
    QTest::addColumn<QString>("distance");
    QTest::newRow("wider") << 12 << 30 << "42.8";
    QTest::newRow("closer") << 30 << 40 << "69.5";
  }
  void shiftedPairsMeshAtTheirDistance() {
    QFETCH(int, a);
    QFETCH(int, b);
    QFETCH(QString, distance);
    // A second pair of standard distance on the same wheel holds the module at 2.
    test::TrainSketch sketch(3);
    const double standard = a + 25;
    sketch.axis("a", {"0", "0", "0"}).axis("b", {distance.toStdString(), "0", "0"});
    sketch.axis("c", {Number::fromDouble(-standard).text(), "0", "0"});
    sketch.joint(0, 1, "a").joint(0, 2, "b").joint(0, 3, "c");
    sketch.mesh(1, 2, a, b, MeshKind::external).mesh(1, 3, a, 25, MeshKind::external);
    const Measured measured(trainOf(sketch.build()));
    compareToBars(measured.report(0));
    compareToBars(measured.report(1));
  }

  void ringsMesh_data() {
    QTest::addColumn<int>("pinion");
    QTest::addColumn<int>("ring");
    QTest::newRow("60/20") << 20 << 60;
    QTest::newRow("60/52") << 52 << 60;
    QTest::newRow("48/18") << 18 << 48;
    QTest::newRow("100/30") << 30 << 100;
  }
  void ringsMesh() {
    QFETCH(int, pinion);
    QFETCH(int, ring);
    compareToBars(Measured(spurPair(pinion, ring, MeshKind::internal)).report(0));
  }

  void bevelsMesh_data() {
    QTest::addColumn<int>("a");
    QTest::addColumn<int>("b");
    QTest::addColumn<double>("angle");
    QTest::newRow("20/40 at 90") << 20 << 40 << 90.0;
    QTest::newRow("20/30 at 60") << 20 << 30 << 60.0;
    QTest::newRow("20/30 at 120") << 20 << 30 << 120.0;
    QTest::newRow("20/40 at 120: a crown") << 20 << 40 << 120.0;
    QTest::newRow("16/16 at 90") << 16 << 16 << 90.0;
    QTest::newRow("20/50 at 135: an internal cone") << 20 << 50 << 135.0;
  }
  void bevelsMesh() {
    QFETCH(int, a);
    QFETCH(int, b);
    QFETCH(double, angle);
    compareToBars(Measured(bevelPair(a, b, angle)).report(0));
  }

  /// Without any play chords of concave flanks cut in by less than the tolerance.
  void withoutBacklashNothingOverlapsByMoreThanTheTolerance() {
    for (GearTrain train :
         {spurPair(20, 40, MeshKind::external), spurPair(20, 60, MeshKind::internal),
          spurPair(52, 60, MeshKind::internal), bevelPair(20, 40, 90), bevelPair(20, 30, 60)}) {
      for (TrainGear& gear : train.gears) gear.spec.backlashAllowance = 0;
      const test::MeshReport r = Measured(std::move(train)).report(0);
      QVERIFY2(r.interpenetration <= 0.002, qPrintable(words(r)));
      QVERIFY2(r.mostBacklash <= 0.01, qPrintable(words(r)));
    }
  }

  void planetariesMesh() {
    const Measured measured(trainOf(test::planetary(12, 18, 3)));
    for (std::size_t m = 0; m < measured.train().meshes.size(); ++m) compareToBars(measured.report(m));
  }

  /// Sun 12, planets 17, ring 48: neither distance is standard, shifts make up for both.
  void shiftedPlanetariesMesh() {
    test::TrainSketch sketch(6);
    sketch.axis("a", {"0", "0", "0"});
    const double radius = 30;
    sketch.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a");
    for (int i = 0; i < 3; ++i) {
      const std::string id = "p" + std::to_string(i);
      sketch.axis(id, {Number::fromDouble(radius * std::cos(2 * pi * i / 3)).text(),
                       Number::fromDouble(radius * std::sin(2 * pi * i / 3)).text(), "0"});
      sketch.joint(3, 4 + i, id);
      sketch.mesh(1, 4 + i, 12, 17, MeshKind::external).mesh(4 + i, 2, 17, 48, MeshKind::internal);
    }
    const Mechanism mechanism = sketch.build();
    const Measured measured(trainOf(mechanism));
    QCOMPARE(measured.train().gears.size(), std::size_t(5));
    for (const Diagnostic& d : trainDiagnostics(mechanism, placementOf(mechanism)))
      QVERIFY(d.code != Code::assembly);
    for (std::size_t m = 0; m < 6; ++m) {
      const test::MeshReport r = measured.report(m);
      QVERIFY2(r.interpenetration <= 0.002, qPrintable(words(r)));
      QVERIFY2(r.phaseError <= 0.005, qPrintable(words(r)));
      QVERIFY2(r.transmissionError <= 0.004, qPrintable(words(r)));
      QVERIFY2(std::abs(r.leastBacklash - 0.04) <= 0.01, qPrintable(words(r)));
    }
  }

  void theRobotMeshes() {
    const Measured measured(geargraph::trainOf(test::example("robot"), placementOf(test::example("robot"))));
    QCOMPARE(measured.train().meshes.size(), std::size_t(4));
    for (std::size_t m = 0; m < 4; ++m) compareToBars(measured.report(m));
  }

  /// Carriers moving, all joints turning: nothing ever overlaps, with no play to hide anything.
  void movingTrainsStayInMesh_data() {
    QTest::addColumn<bool>("isRobot");
    QTest::newRow("planetary 12/18/48") << false;
    QTest::newRow("robot") << true;
  }
  void movingTrainsStayInMesh() {
    QFETCH(bool, isRobot);
    const Mechanism mechanism = isRobot ? test::example("robot") : test::planetary(12, 18, 3);
    const Placement placement = placementOf(mechanism);
    GearTrain train = geargraph::trainOf(mechanism, placement);
    for (TrainGear& gear : train.gears) gear.spec.backlashAllowance = 0;
    const Eigen::VectorXd rates = test::rollingRates(mechanism, placement, train, {1, 0.3, -0.4, 0.7, 0.2});
    QVERIFY(rates.cwiseAbs().minCoeff() > 0.01);
    const Measured measured(train);
    const Digraph graph(mechanism);
    const std::optional<SpanningTree> tree = SpanningTree::of(graph);
    std::vector<TurningLine> lines;
    for (const int a : placement.tree->axisOf) {
      const AxisLine& line = placement.axes[static_cast<std::size_t>(a)];
      lines.push_back({Vector3d(line.point.data()), Vector3d(line.direction.data())});
    }
    const ForwardKinematics kinematics(*tree, lines);
    double worst = 0;
    double turned = 1e300;  // least depth of a mesh at its worst with a wheel turned by a tenth of a pitch
    for (int frame = 0; frame < 24; ++frame) {
      const Eigen::VectorXd angles = rates * (0.731 * frame);
      const auto poses = kinematics.poses({angles.data(), static_cast<std::size_t>(angles.size())});
      for (const TrainMesh& m : train.meshes) {
        const TrainGear& a = measured.gear(m.tailGear);
        const TrainGear& b = measured.gear(m.headGear);
        const MeshGeometry& geometry = *placement.meshes[static_cast<std::size_t>(m.mesh)];
        const Eigen::Isometry3d& carrier = poses[static_cast<std::size_t>(geometry.carrier)];
        const bool bevel = a.spec.kind == GearKind::bevel;
        const double part = bevel ? 1 - a.spec.faceWidth / 2 / coneDistance(a.spec) : 1;
        const Vector3d apex = a.pose.translation();
        const Vector3d point = bevel ? Vector3d(apex + part * (m.pitchPoint - apex)) : m.pitchPoint;
        const auto depth = [&](double turn) {
          const Eigen::AngleAxisd more(turn, Vector3d::UnitZ());
          return test::interpenetration(
                     {measured.section(m.tailGear), poses[static_cast<std::size_t>(a.link)] * a.pose},
                     {measured.section(m.headGear), poses[static_cast<std::size_t>(b.link)] * b.pose * more},
                     carrier * point, 3.2 * a.spec.module) /
                 (a.spec.module * part);
        };
        worst = std::max(worst, depth(0));
        turned = std::min(turned, depth(0.1 * 2 * pi / b.spec.teeth));
      }
    }
    QVERIFY2(worst <= 0.003, qPrintable(QString::number(worst)));
    QVERIFY2(turned > 0.05, qPrintable(QString::number(turned)));  // in every frame: it is really measured
  }

  void volumeOfASectionIsThatOfTheSolid() {
    const GearSpec spec = standardGear(GearKind::external, 30, 2, 10);
    const Expected<Solid> solid = gearSolid(spec, kExportTolerance);
    QVERIFY(std::abs(test::Section::flat(*solid).area() * 10 / signedVolume(*solid) - 1) < 1e-4);
  }

  // The test of the test: what is wrong has to show.

  void aTenthOfAPitchShows() {
    const auto train = [] { return bevelPair(20, 40, 90); };
    for (const double part : {0.1, -0.1}) {
      const test::MeshReport spur =
          Measured(spurPair(20, 40, MeshKind::external)).report(0, part * 2 * pi / 40);
      QVERIFY2(spur.interpenetration > 0.05, qPrintable(words(spur)));
      const test::MeshReport ring =
          Measured(spurPair(20, 60, MeshKind::internal)).report(0, part * 2 * pi / 60);
      QVERIFY2(ring.interpenetration > 0.05, qPrintable(words(ring)));
      const test::MeshReport bevel = Measured(train()).report(0, part * 2 * pi / 40);
      QVERIFY2(bevel.interpenetration > 0.05, qPrintable(words(bevel)));
    }
  }

  void aFlippedSignShows() {
    for (GearTrain train : {spurPair(20, 40, MeshKind::external), spurPair(20, 60, MeshKind::internal),
                            bevelPair(20, 40, 90)}) {
      QVERIFY(Measured(std::move(train)).report(0, 0, -1).interpenetration > 0.2);
    }
  }

  void theWrongVirtualToothNumberShows() {
    GearTrain train = bevelPair(20, 40, 90);
    for (TrainGear& gear : train.gears) gear.spec.backlashAllowance = 0;
    const TrainMesh& m = train.meshes.front();
    const GearSpec& spec = train.gears.front().spec;
    const double radius = coneDistance(spec) - spec.faceWidth / 2;
    const test::Section a = test::Section::spherical(bevelOfPlainTeeth(train.gears[0].spec), radius);
    const test::Section b = test::Section::spherical(bevelOfPlainTeeth(train.gears[1].spec), radius);
    const double part = radius / coneDistance(spec);
    const test::MeshReport r = test::checkMesh({&a, train.gears[0].pose}, {&b, train.gears[1].pose}, 20, 40,
                                               part * m.pitchPoint, part * spec.module, kFrames);
    const double unit = part * spec.module;
    QVERIFY2(r.interpenetration / unit > 0.004 || r.transmissionError / unit > 0.004, qPrintable(words(r)));
  }
};

QTEST_APPLESS_MAIN(TeethMeshTest)
#include "test_teeth_mesh.moc"
