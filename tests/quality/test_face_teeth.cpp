#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/machine/body_layout/complete_train.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/solids/spec_diagnostics.h"
#include "core/machine/teeth/wheel_kind.h"
#include "tests/core/machine/solids/topology.h"
#include "tests/core/support/train_sketch.h"
#include "tests/quality/section_checker.h"

using namespace geargraph;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

/// Gears 1 and 2 on axes through the origin: z, and one at this angle to it.
Mechanism meetingPair(int a, int b, MeshKind kind, double degrees, double spiralAngle = 0,
                      bool reversed = false) {
  const double sigma = degrees * pi / 180;
  const double way = reversed ? -1 : 1;
  const auto text = [](double v) { return Number::fromDouble(v).text(); };
  test::TrainSketch sketch(2);
  sketch.axis("a", {"0", "0", "0"});
  sketch.axis("b", {"0", "0", "0"}, {text(way * std::sin(sigma)), "0", text(way * std::cos(sigma))});
  sketch.joint(0, 1, "a", "40").joint(0, 2, "b", text(way * 40)).mesh(1, 2, a, b, kind);
  Mechanism mechanism = sketch.build();
  GearMesh& mesh = mechanism.gearMeshes.front();
  mesh.module = Number(2);
  if (spiralAngle != 0) mesh.helixAngle = Number::fromDouble(std::abs(spiralAngle));
  if (spiralAngle < 0) mesh.hand = Hand::left;
  return mechanism;
}

GearTrain meetingTrain(const Mechanism& mechanism) {
  return trainOf(mechanism, placementOf(mechanism));
}

/// A spiral bevel pair cut by the sphere at this part of its face, 0 the small end and 1 the large one.
/// Lengths in transverse modules of that sphere.
test::MeshReport spiralReport(const GearTrain& train, double part) {
  const TrainMesh& mesh = train.meshes.front();
  const TrainGear &a = train.gears[mesh.tailGear], &b = train.gears[mesh.headGear];
  const double large = coneDistance(a.spec);
  const double radius = large - (1 - part) * a.spec.faceWidth;
  const test::Section cutA = test::Section::spherical(*gearSolid(a.spec, kExportTolerance), radius);
  const test::Section cutB = test::Section::spherical(*gearSolid(b.spec, kExportTolerance), radius);
  const Vector3d apex = a.pose.translation();
  const Vector3d point = apex + radius / large * (mesh.pitchPoint - apex);
  const double unit = a.spec.module * radius / large;
  constexpr int kSteps = 12;
  test::MeshReport r =
      test::checkMesh({&cutA, a.pose}, {&cutB, b.pose}, a.spec.teeth, b.spec.teeth, point, unit, kSteps);
  for (double* length : {&r.interpenetration, &r.transmissionError, &r.leastBacklash, &r.mostBacklash})
    *length /= unit;
  return r;
}

QString wordsOf(const test::MeshReport& r) {
  return QString("interpenetration %1, TE %2, phase %3, backlash %4..%5")
      .arg(r.interpenetration)
      .arg(r.transmissionError)
      .arg(r.phaseError)
      .arg(r.leastBacklash)
      .arg(r.mostBacklash);
}

/// What a face gear and its pinion turn out to be in planes square to the pinion's axis. Lengths in modules,
/// at the pitch circle of the face gear.
struct FaceReport {
  double overlap = 0;
  double transmissionError = 0;
  double offCentre = 0;
  double leastPlay = 1e300;
  double mostPlay = 0;
};

class FaceSections {
 public:
  explicit FaceSections(GearTrain train)
      : m_train(std::move(train)),
        m_pinion(m_train.gears[isFaceGear(m_train.gears[0].spec) ? 1 : 0]),
        m_face(m_train.gears[isFaceGear(m_train.gears[0].spec) ? 0 : 1]),
        m_pinionSolid(gearSolid(m_pinion.spec, kExportTolerance).value()),
        m_faceSolid(gearSolid(m_face.spec, kExportTolerance).value()) {
    // The section's origin is on the pinion's axis, its z along that.
    m_toSection = m_pinion.pose.inverse();
    m_point = m_toSection * m_train.meshes.front().pitchPoint;
    const double half = m_pinion.spec.faceWidth / 2;
    for (const double share : {-0.9, -0.43, 0.0, 0.38, 0.87}) m_heights.push_back(share * half + 0.00131);
    // Turning the pinion by + moves its teeth at the pitch point the way of `moves`, and so the face gear.
    const Vector3d moves =
        m_pinion.pose.linear().col(2).cross(m_pinion.pose * m_point - m_pinion.pose.translation());
    const Vector3d arm = m_train.meshes.front().pitchPoint - m_face.pose.translation();
    m_sign = m_face.pose.linear().col(2).cross(arm).dot(moves) > 0 ? 1 : -1;
  }

  /// With the face gear off by so many pitches, modules.
  [[nodiscard]] double overlapAt(double wrong) const {
    return depth(0, wrong * 2 * pi / m_face.spec.teeth) / m_face.spec.module;
  }

  [[nodiscard]] FaceReport report(int steps) const {
    FaceReport report;
    std::array<double, 2> least{1e300, 1e300}, most{-1e300, -1e300};
    const double unit = pitchRadius(m_face.spec) / m_face.spec.module;
    for (int step = 0; step < steps; ++step) {
      const double turn = 2 * pi / m_pinion.spec.teeth * (step + 0.29) / steps;
      const double angle = m_sign * m_pinion.spec.teeth * turn / m_face.spec.teeth;
      report.overlap = std::max(report.overlap, depth(turn, angle) / m_face.spec.module);
      std::array<double, 2> play{};
      for (const int side : {0, 1}) {
        double low = 0, high = 0.1 * 2 * pi / m_face.spec.teeth;
        for (int i = 0; i < 11; ++i) {
          const double middle = 0.5 * (low + high);
          (depth(turn, angle + (side == 0 ? middle : -middle)) > 1e-5 * m_face.spec.module ? high : low) =
              middle;
        }
        play[side] = low * unit;
        least[side] = std::min(least[side], play[side]);
        most[side] = std::max(most[side], play[side]);
      }
      report.leastPlay = std::min(report.leastPlay, play[0] + play[1]);
      report.mostPlay = std::max(report.mostPlay, play[0] + play[1]);
      report.offCentre = std::max(report.offCentre, std::abs(play[0] - play[1]) / 2);
    }
    report.transmissionError = std::max(most[0] - least[0], most[1] - least[1]);
    return report;
  }

 private:
  [[nodiscard]] double depth(double turn, double angle) const {
    double deepest = 0;
    const Solid pinion = moved(m_pinionSolid, Isometry3d(Eigen::AngleAxisd(turn, Vector3d::UnitZ())));
    const Solid face =
        moved(m_faceSolid, m_toSection * m_face.pose * Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
    for (const double height : m_heights) {
      const test::Section one = test::Section::flat(pinion, height),
                          other = test::Section::flat(face, height);
      deepest = std::max(
          deepest, test::interpenetration({&one, Isometry3d::Identity()}, {&other, Isometry3d::Identity()},
                                          m_point, 3 * m_face.spec.module));
    }
    return deepest;
  }

  GearTrain m_train;
  const TrainGear &m_pinion, &m_face;
  Solid m_pinionSolid, m_faceSolid;
  Isometry3d m_toSection;
  Vector3d m_point;
  std::vector<double> m_heights;
  int m_sign = 1;
};

}  // namespace

/// Spiral bevels and face gears mesh all over their faces: measured in sections by the independent checker.
class TestFaceTeeth : public QObject {
  Q_OBJECT
 private slots:
  void spiralBevelsMesh_data() {
    QTest::addColumn<int>("a");
    QTest::addColumn<int>("b");
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("spiralAngle");
    QTest::addColumn<bool>("reversed");
    QTest::newRow("right") << 17 << 31 << 90.0 << 35.0 << false;
    QTest::newRow("left") << 20 << 20 << 90.0 << -30.0 << false;
    QTest::newRow("at 60 degrees") << 16 << 40 << 60.0 << 25.0 << false;
    QTest::newRow("at 120 degrees") << 19 << 23 << 120.0 << -20.0 << false;
    QTest::newRow("an axis turned round") << 18 << 37 << 90.0 << 35.0 << true;
    QTest::newRow("zerol") << 18 << 37 << 90.0 << 0.0 << false;
  }
  void spiralBevelsMesh() {
    QFETCH(int, a);
    QFETCH(int, b);
    QFETCH(double, degrees);
    QFETCH(double, spiralAngle);
    QFETCH(bool, reversed);
    const GearTrain train = meetingTrain(meetingPair(a, b, MeshKind::bevel, degrees, spiralAngle, reversed));
    QCOMPARE(train.gears.size(), std::size_t{2});
    QVERIFY(std::abs(train.gears[0].spec.helixAngle - spiralAngle * pi / 180) < 1e-12);
    QVERIFY(std::abs(train.gears[1].spec.helixAngle + spiralAngle * pi / 180) < 1e-12);
    for (const double part : {0.13, 0.5, 0.88}) {
      const test::MeshReport r = spiralReport(train, part);
      QVERIFY2(r.interpenetration <= 0.004, qPrintable(wordsOf(r)));
      QVERIFY2(r.transmissionError <= 0.004, qPrintable(wordsOf(r)));
      QVERIFY2(r.phaseError <= 0.005, qPrintable(wordsOf(r)));
      QVERIFY2(std::abs(r.leastBacklash - 0.04) <= 0.01, qPrintable(wordsOf(r)));
      QVERIFY2(std::abs(r.mostBacklash - 0.04) <= 0.01, qPrintable(wordsOf(r)));
    }
  }

  /// The check has to be able to fail: with one hand for both, sections off the large end do not fit.
  void wrongHandsOfBevelsAreCaught() {
    GearTrain train = meetingTrain(meetingPair(17, 31, MeshKind::bevel, 90, 35));
    train.gears[1].spec.helixAngle *= -1;
    QVERIFY(spiralReport(train, 0.5).interpenetration > 0.05);
  }

  void faceGearsMesh_data() {
    QTest::addColumn<int>("pinion");
    QTest::addColumn<int>("face");
    QTest::addColumn<bool>("reversed");
    QTest::newRow("18/40") << 18 << 40 << false;
    QTest::newRow("20/60") << 20 << 60 << false;
    QTest::newRow("24/32") << 24 << 32 << false;
    QTest::newRow("face gear first") << 55 << 20 << false;
    QTest::newRow("an axis turned round") << 21 << 48 << true;
  }
  void faceGearsMesh() {
    QFETCH(int, pinion);
    QFETCH(int, face);
    QFETCH(bool, reversed);
    const FaceSections measured(meetingTrain(meetingPair(pinion, face, MeshKind::faceGear, 90, 0, reversed)));
    const FaceReport r = measured.report(4);
    const QString words = QString("overlap %1, TE %2, off centre %3, play %4..%5")
                              .arg(r.overlap)
                              .arg(r.transmissionError)
                              .arg(r.offCentre)
                              .arg(r.leastPlay)
                              .arg(r.mostPlay);
    QVERIFY2(r.overlap <= 0.004, qPrintable(words));
    QVERIFY2(r.transmissionError <= 0.004, qPrintable(words));
    QVERIFY2(r.offCentre <= 0.005, qPrintable(words));
    QVERIFY2(std::abs(r.leastPlay - 0.04) <= 0.01, qPrintable(words));
    QVERIFY2(std::abs(r.mostPlay - 0.04) <= 0.01, qPrintable(words));
  }

  /// The check has to be able to fail: a face gear off by a tenth of a pitch.
  void wrongFaceGearsAreCaught() {
    const FaceSections measured(meetingTrain(meetingPair(18, 40, MeshKind::faceGear, 90)));
    QVERIFY(measured.overlapAt(0.1) > 0.1);
    QVERIFY(measured.overlapAt(0) < 0.004);
  }

  void solidsAreClosed_data() {
    QTest::addColumn<int>("a");
    QTest::addColumn<int>("b");
    QTest::addColumn<bool>("isFace");
    QTest::addColumn<double>("spiralAngle");
    QTest::newRow("spiral") << 17 << 31 << false << 35.0;
    QTest::newRow("steep spiral") << 12 << 45 << false << -60.0;
    QTest::newRow("undercut spiral") << 8 << 20 << false << 10.0;
    QTest::newRow("face gear") << 18 << 40 << true << 0.0;
    QTest::newRow("face gear of a small pinion") << 10 << 70 << true << 0.0;
    QTest::newRow("face gear 3 : 4") << 18 << 24 << true << 0.0;
  }
  void solidsAreClosed() {
    QFETCH(int, a);
    QFETCH(int, b);
    QFETCH(bool, isFace);
    QFETCH(double, spiralAngle);
    const GearTrain train =
        meetingTrain(meetingPair(a, b, isFace ? MeshKind::faceGear : MeshKind::bevel, 90, spiralAngle));
    for (const TrainGear& gear : train.gears) {
      const Diagnostics wrong = specDiagnostics(gear.spec);
      QVERIFY2(wrong.empty(), wrong.empty() ? "" : wrong.front().message.c_str());
      for (const double tolerance : {kExportTolerance, kScreenTolerance}) {
        const Solid solid = *gearSolid(gear.spec, tolerance);
        const test::Topology topology = test::topologyOf(solid);
        QVERIFY(topology.closed);
        QVERIFY(topology.manifold);
        QCOMPARE(topology.degenerate, 0);
        QCOMPARE(topology.pieces, 1);
        QVERIFY(signedVolume(solid) > 0);
      }
    }
  }
};

QTEST_APPLESS_MAIN(TestFaceTeeth)
#include "test_face_teeth.moc"
