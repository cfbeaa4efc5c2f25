#include <QTest>

#include "core/machine/solids/gear_solid.h"
#include "core/presentation/meshfile/assembly.h"
#include "tests/core/presentation/meshfile/assembly_check.h"

using namespace geargraph;
using namespace geargraph::test;
using Eigen::Vector3d;

namespace {

constexpr double kModule = 2;

void addGear(Assembly& assembly, const std::string& name, GearSpec spec, const Eigen::Isometry3d& pose) {
  spec.backlashAllowance = 0.02;
  AssemblyGear& gear = assembly.gears.emplace_back();
  gear.name = name;
  gear.kind = spec.kind;
  gear.teeth = spec.teeth;
  gear.module = spec.module;
  gear.coneAngle = spec.coneAngle;
  gear.solid = std::make_shared<const Solid>(gearSolid(spec, kExportTolerance).value());
  gear.pose = pose;
}

/// Frame with this z at `origin`, and x as near `towards` as it can be, turned on by half a pitch.
Eigen::Isometry3d spaceTowards(const Vector3d& origin, const Vector3d& axis, const Vector3d& towards,
                               int teeth) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  const Vector3d x = (towards - towards.dot(axis) * axis).normalized();
  frame.linear() << x, axis.cross(x), axis;
  frame.translation() = origin;
  frame.rotate(Eigen::AngleAxisd(M_PI / teeth, Vector3d::UnitZ()));
  return frame;
}

/// Turns both gears by ratio through a bit more than one pitch of the first. `sense`: of the second's turn.
void addFrames(Assembly& assembly, double sense) {
  const double ratio = sense * assembly.gears[0].teeth / assembly.gears[1].teeth;
  for (std::size_t i = 0; i < kMinFrames; ++i) {
    const double angle = 1.1 * 2 * M_PI / assembly.gears[0].teeth * static_cast<double>(i) / (kMinFrames - 1);
    Eigen::Isometry3d a = assembly.gears[0].pose;
    Eigen::Isometry3d b = assembly.gears[1].pose;
    a.rotate(Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
    b.rotate(Eigen::AngleAxisd(ratio * angle, Vector3d::UnitZ()));
    assembly.frames.push_back({a, b});
  }
  assembly.meshes = {{0, 1}};
}

Assembly spurPair() {
  Assembly assembly;
  addGear(assembly, "pinion", standardGear(GearKind::external, 18, kModule, 8),
          Eigen::Isometry3d::Identity());
  const Vector3d centre(kModule * (18 + 35) / 2, 0, 0);
  addGear(assembly, "wheel", standardGear(GearKind::external, 35, kModule, 10),
          spaceTowards(centre, Vector3d::UnitZ(), -Vector3d::UnitX(), 35));
  addFrames(assembly, -1);
  return assembly;
}

Assembly ringPair() {
  Assembly assembly;
  addGear(assembly, "pinion", standardGear(GearKind::external, 20, kModule, 8),
          Eigen::Isometry3d::Identity());
  GearSpec ring = standardGear(GearKind::internal, 61, kModule, 8);
  ring.addendum = 0.75;  // stays off the pinion's fillet
  addGear(assembly, "ring", ring,
          spaceTowards({-kModule * (61 - 20) / 2, 0, 0}, Vector3d::UnitZ(), Vector3d::UnitX(), 61));
  addFrames(assembly, 1);
  return assembly;
}

Assembly bevelPair() {
  Assembly assembly;
  const double shafts = M_PI / 2.25;  // 80 degrees
  const double cone = std::atan2(std::sin(shafts), 30.0 / 20 + std::cos(shafts));
  GearSpec first = standardGear(GearKind::bevel, 20, kModule, 8);
  first.coneAngle = cone;
  GearSpec second = standardGear(GearKind::bevel, 30, kModule, 8);
  second.coneAngle = shafts - cone;
  addGear(assembly, "first", first, Eigen::Isometry3d::Identity());
  const Vector3d line(std::sin(cone), 0, std::cos(cone));
  addGear(assembly, "second", second,
          spaceTowards(Vector3d::Zero(), {std::sin(shafts), 0, std::cos(shafts)}, line, 30));
  addFrames(assembly, -1);
  return assembly;
}

AssemblyMeasurements measurements(const Assembly& assembly, const QString& turned = {}, double pitches = 0) {
  const QTemporaryDir folder;
  if (const auto error = writeAssembly(assembly, folder.path().toStdString(), false)) {
    qFatal("%s", error->message.c_str());
  }
  return checkedAssembly(folder.path(), turned, pitches);
}

}  // namespace

class AssemblyCheckTest : public QObject {
  Q_OBJECT
 private slots:
  void goodPairsPass_data() {
    QTest::addColumn<int>("which");
    QTest::newRow("spur") << 0;
    QTest::newRow("ring") << 1;
    QTest::newRow("bevel") << 2;
  }
  void goodPairsPass() {
    QFETCH(int, which);
    const AssemblyMeasurements found = measurements(pair(which));
    QCOMPARE(found.problem, QString());
    QCOMPARE(found.gears, 2);
    QCOMPARE(found.pairs, 1);
    QVERIFY(found.closed);
    QVERIFY(found.leastTravel > 1.09 && found.leastTravel < 1.11);
    QVERIFY2(found.phaseError < 1e-6, qPrintable(QString::number(found.phaseError)));
    QVERIFY2(found.penetration < 0.004, qPrintable(QString::number(found.penetration)));
  }

  void aGearTurnedByATenthOfAPitchIsNoticed_data() { goodPairsPass_data(); }
  void aGearTurnedByATenthOfAPitchIsNoticed() {
    QFETCH(int, which);
    const Assembly assembly = pair(which);
    const AssemblyMeasurements found =
        measurements(assembly, QString::fromStdString(assembly.gears[1].name), 0.1);
    QVERIFY(std::abs(found.phaseError - 0.1) < 1e-6);
    QVERIFY2(found.penetration > 0.05, qPrintable(QString::number(found.penetration)));
  }

  void aWrongSenseOfTurningIsNoticed_data() { goodPairsPass_data(); }
  void aWrongSenseOfTurningIsNoticed() {
    QFETCH(int, which);
    Assembly assembly = pair(which);
    assembly.frames.clear();
    addFrames(assembly, which == 1 ? -1 : 1);
    const AssemblyMeasurements found = measurements(assembly);
    QVERIFY(found.phaseError > 0.35 && found.penetration > 0.1);
  }

  void bevelsMadeAsIfTheirConesWereFlatterAreNoticed() {
    Assembly assembly = bevelPair();
    GearSpec wrong = standardGear(GearKind::bevel, 30, kModule, 8);
    wrong.coneAngle = assembly.gears[1].coneAngle * 1.02;
    assembly.gears[1].solid = std::make_shared<const Solid>(gearSolid(wrong, kExportTolerance).value());
    QVERIFY(measurements(assembly).penetration > 0.02);
  }

  void aHoleIsNoticed() {
    Assembly assembly = spurPair();
    Solid holed = *assembly.gears[0].solid;
    holed.triangles.pop_back();
    assembly.gears[0].solid = std::make_shared<const Solid>(holed);
    QVERIFY(!measurements(assembly).closed);
  }

 private:
  static Assembly pair(int which) { return which == 0 ? spurPair() : which == 1 ? ringPair() : bevelPair(); }
};

QTEST_APPLESS_MAIN(AssemblyCheckTest)
#include "test_assembly_check.moc"
