#include <QTest>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "core/machine/body_layout/complete_train.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/solids/solid.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/involute.h"
#include "core/machine/teeth/phase.h"
#include "core/machine/teeth/tooth_pair.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/toothed_train.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;

namespace {

constexpr double kHelicalDegree = std::numbers::pi / 180;

/// A pair of parallel axes at a distance, with the members of its mesh.
struct HelicalCase {
  int tail = 20;
  int head = 40;
  MeshKind kind = MeshKind::external;
  double module = 2;
  double helix = 0;  ///< degrees, right-hand where positive
  double distance = 0;
  double face = 0;

  [[nodiscard]] Mechanism mechanism() const {
    test::TrainSketch sketch(2);
    sketch.axis("a", {"0", "0", "0"}).axis("b", {Number::fromDouble(distance).text(), "0", "0"});
    sketch.joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, tail, head, kind);
    Mechanism built = sketch.build();
    GearMesh& mesh = built.gearMeshes.front();
    mesh.module = Number::fromDouble(module);
    if (helix != 0) mesh.helixAngle = Number::fromDouble(std::abs(helix));
    if (helix < 0) mesh.hand = Hand::left;
    if (face > 0) mesh.faceWidth = Number::fromDouble(face);
    return built;
  }
  [[nodiscard]] GearTrain train() const {
    const Mechanism built = mechanism();
    return trainOf(built, placementOf(built));
  }
};

}  // namespace

/// Helical wheels are spur wheels in their transverse section. Published numbers, and the twisted solid.
class HelicalTest : public QObject {
  Q_OBJECT

 private slots:
  /// A worked example of profile shift (scribd.com/doc/376176518): z 31/30, m_n 3.5, 21 degrees, a 116.5.
  void aWorkedExample() {
    const GearSpec spec = helical(standardGear(GearKind::external, 31, 3.5, 30), 21 * kHelicalDegree);
    const double standard = spec.module * 61 / 2;
    QVERIFY(std::abs(standard - 114.3447280708) < 1e-9);
    const double working = workingPressureAngle(61, 116.5 / spec.module, spec.pressureAngle);
    QVERIFY(std::abs(working / kHelicalDegree - 23.8707609654) < 1e-9);
    const double sum = shiftSumFor(61, 116.5 / spec.module, spec.pressureAngle) / std::cos(spec.helixAngle);
    QVERIFY2(std::abs(sum - 0.6518771312) < 2e-10, qPrintable(QString::number(sum, 'g', 12)));
    QVERIFY(std::abs(normalModule(spec) - 3.5) < 1e-14);
    QVERIFY(std::abs(normalPressureAngle(spec) - 20 * kHelicalDegree) < 1e-14);
    // Back again: the shifts make the distance.
    QVERIFY(std::abs(spec.module * centreDistance(61, sum * std::cos(spec.helixAngle), spec.pressureAngle) -
                     116.5) < 1e-9);
  }

  /// The teeth as they are cut, and the limits that the message of `undercut` names, say the same.
  void undercutBeginsAtTheNamedLimits() {
    int cut = 0, whole = 0;
    const auto compare = [&](const GearSpec& spec) {
      const bool isUndercut = externalTooth(spec, 0.01).undercut;
      const double margin = spec.teeth - fewestTeethWithoutUndercut(spec);
      QVERIFY(std::abs(margin) > 1e-6);
      QCOMPARE(isUndercut, margin < 0);
      QCOMPARE(isUndercut, spec.profileShift < leastShiftWithoutUndercut(spec));
      ++(isUndercut ? cut : whole);
    };
    for (const double helix : {0.0, 8.0, 20.0, 35.0, 45.0, 60.0}) {
      for (const double pressure : {14.5, 20.0, 25.0}) {
        for (int teeth = 4; teeth <= 24; ++teeth) {
          for (const double shift : {-0.2, 0.0, 0.3}) {
            GearSpec spec = standardGear(GearKind::external, teeth, 2, 10);
            spec.pressureAngle = pressure * kHelicalDegree;
            spec.profileShift = shift;
            compare(helix > 0 ? helical(spec, helix * kHelicalDegree) : spec);
          }
        }
      }
    }
    QVERIFY(cut > 50);
    QVERIFY(whole > 50);
  }

  /// The NREL 5 MW reference gearbox (A. R. Nejad et al., Wind Energy 2016, doi 10.1002/we.1884): sums of the
  /// profile shifts; of a ring its shift less the planet's, positive away from the axis.
  void theReferenceGearbox_data() {
    QTest::addColumn<int>("tail");
    QTest::addColumn<int>("head");
    QTest::addColumn<bool>("isRing");
    QTest::addColumn<double>("module");
    QTest::addColumn<double>("helix");
    QTest::addColumn<double>("distance");
    QTest::addColumn<double>("sum");
    QTest::newRow("sun and planet 1") << 19 << 17 << false << 45.0 << 0.0 << 863.0 << 1.419;
    QTest::newRow("planet and ring 1") << 17 << 56 << true << 45.0 << 0.0 << 863.0 << -0.301;
    QTest::newRow("sun and planet 2") << 18 << 36 << false << 21.0 << 0.0 << 584.0 << 0.893;
    QTest::newRow("planet and ring 2") << 36 << 93 << true << 21.0 << 0.0 << 584.0 << -0.621;
    QTest::newRow("high speed") << 24 << 95 << false << 14.0 << 10.0 << 861.0 << 1.149;
  }
  void theReferenceGearbox() {
    QFETCH(int, tail);
    QFETCH(int, head);
    QFETCH(bool, isRing);
    QFETCH(double, module);
    QFETCH(double, helix);
    QFETCH(double, distance);
    QFETCH(double, sum);
    const HelicalCase pair{.tail = tail,
                           .head = head,
                           .kind = isRing ? MeshKind::internal : MeshKind::external,
                           .module = module,
                           .helix = helix,
                           .distance = distance};
    const GearTrain train = pair.train();
    QCOMPARE(train.gears.size(), std::size_t{2});
    const double found =
        normalShift(train.gears[1].spec) + (isRing ? -1 : 1) * normalShift(train.gears[0].spec);
    QVERIFY2(std::abs(found - sum) < 6e-4, qPrintable(QString::number(found)));
    QVERIFY(std::abs(normalModule(train.gears[0].spec) / module - 1) < 1e-12);
  }

  /// The high-speed stage of the same gearbox with its published shifts: 1.463 and, by a face of 360, 1.421.
  void contactRatios() {
    HelicalCase pair{.tail = 95, .head = 24, .module = 14, .helix = 10, .distance = 861, .face = 360};
    Mechanism mechanism = pair.mechanism();
    for (const auto& [id, link, shift] : {std::tuple{"w", "1", "0.669"}, std::tuple{"p", "2", "0.480"}}) {
      Wheel wheel;
      wheel.id = WheelId(id);
      wheel.link = LinkId(link);
      wheel.profileShift = *Number::fromText(shift);
      mechanism.wheels.push_back(wheel);
    }
    mechanism.gearMeshes.front().tailWheel = WheelId("w");
    mechanism.gearMeshes.front().headWheel = WheelId("p");
    const GearTrain train = trainOf(mechanism, placementOf(mechanism));
    const GearSpec& a = train.gears[0].spec;
    const GearSpec& b = train.gears[1].spec;
    const double transverse = contactRatio(a, toothOf(a, 0.01), b, toothOf(b, 0.01), 861 / a.module);
    QVERIFY2(std::abs(transverse - 1.463) < 0.004, qPrintable(QString::number(transverse)));
    const double overlap = 360 * std::sin(a.helixAngle) / (std::numbers::pi * normalModule(a));
    QVERIFY(std::abs(overlap - 1.421) < 5e-4);
  }

  /// Opposite hands beside each other, the same in a ring; an axis that is turned round keeps the hand.
  void handsOfPartners() {
    for (const double helix : {20.0, -20.0}) {
      for (const MeshKind kind : {MeshKind::external, MeshKind::internal}) {
        const double teeth = kind == MeshKind::internal ? 40 : 60;
        HelicalCase pair{.tail = 20, .head = 60, .kind = kind, .helix = helix};
        if (kind == MeshKind::external) pair.head = 40;
        pair.distance = teeth / std::cos(helix * kHelicalDegree);
        Mechanism mechanism = pair.mechanism();
        for (const char* direction : {"1", "-1"}) {
          mechanism.axes[1].direction = NumberTriple{Number(0), Number(0), *Number::fromText(direction)};
          const GearTrain train = trainOf(mechanism, placementOf(mechanism));
          QVERIFY(std::abs(train.gears[0].spec.helixAngle - helix * kHelicalDegree) < 1e-12);
          QVERIFY(std::abs(train.gears[1].spec.helixAngle -
                           (kind == MeshKind::internal ? 1 : -1) * helix * kHelicalDegree) < 1e-12);
          QVERIFY(train.gears[0].spec.profileShift == 0 && train.gears[1].spec.profileShift == 0);
        }
      }
    }
  }

  /// A twisted wheel has the volume of the straight one of its transverse section, and is closed, whatever
  /// the hand; herringbone too, of which no point is turned at both faces the same way as in the middle.
  void theTwistedSolid_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("helix");
    QTest::addColumn<bool>("herringbone");
    QTest::newRow("right") << int(GearKind::external) << 15.0 << false;
    QTest::newRow("left") << int(GearKind::external) << -35.0 << false;
    QTest::newRow("steep") << int(GearKind::external) << 45.0 << false;
    QTest::newRow("herringbone") << int(GearKind::external) << 30.0 << true;
    QTest::newRow("ring") << int(GearKind::internal) << 20.0 << false;
    QTest::newRow("herringbone ring") << int(GearKind::internal) << -20.0 << true;
  }
  void theTwistedSolid() {
    QFETCH(int, kind);
    QFETCH(double, helix);
    QFETCH(bool, herringbone);
    GearSpec spec = helical(standardGear(static_cast<GearKind>(kind), 40, 2, 16), helix * kHelicalDegree);
    spec.herringbone = herringbone;
    GearSpec straight = spec;
    straight.helixAngle = 0;
    straight.herringbone = false;
    const Solid twisted = *gearSolid(spec, kExportTolerance);
    const Solid plain = *gearSolid(straight, kExportTolerance);
    const double share = signedVolume(twisted) / signedVolume(plain);
    QVERIFY2(std::abs(share - 1) < 1e-3, qPrintable(QString::number(share, 'g', 9)));
    QVERIFY(openEdges(twisted) == 0);
    QVERIFY(twisted.triangles.size() > plain.triangles.size());
    const double turn = twistOf(spec, spec.faceWidth / 2);
    QVERIFY(std::abs(turn - (herringbone ? -1 : 1) * 8 * std::tan(helix * kHelicalDegree) /
                                pitchRadius(spec)) < 1e-12);
    QCOMPARE(twistOf(spec, -spec.faceWidth / 2), herringbone ? turn : -turn);
  }

  /// A pinion whose halves of the face lie in two meshes is longer than either: its mid face is at neither
  /// pitch point, and the twist up to there belongs to the phase.
  void theTwistUpToThePitchPointBelongsToThePhase() {
    const GearSpec spec = helical(standardGear(GearKind::external, 20, 2, 40), 20 * kHelicalDegree);
    const GearSpec mate = helical(standardGear(GearKind::external, 40, 2, 20), -20 * kHelicalDegree);
    const double r = pitchRadius(spec);
    const PhaseWheel a = phaseWheelOf(spec, {0, 0, 7}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX());
    const PhaseWheel b =
        phaseWheelOf(mate, {3 * r, 0, 0}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX());
    const MeshPhase phase = meshPhase(a, b, {r, 0, 0});
    QVERIFY(std::abs(phase.psiA - 7 * std::tan(spec.helixAngle) / r) < 1e-12);
    QCOMPARE(phase.psiB, std::numbers::pi);
    // The same contact seen 4 further along: both have turned by the same teeth.
    const MeshPhase along = meshPhase(a, b, {r, 0, 4});
    const double teeth = 20 * (along.psiA - phase.psiA) - phase.sign * 40 * (along.psiB - phase.psiB);
    QVERIFY(std::abs(teeth) < 1e-12);
  }

  /// Errors by code, and what they name.
  void whatContradictsIsReported() {
    const auto found = [](const Mechanism& mechanism) {
      const Placement placement = placementOf(mechanism);
      Diagnostics all = placement.diagnostics;
      append(all, trainDiagnostics(mechanism, placement));
      QStringList codes;
      for (const Diagnostic& each : all)
        codes << QString::fromStdString(
            std::string(each.detail == Detail::none ? codeName(each.code) : detailName(each.detail)));
      return codes;
    };
    const double distance = 60 / std::cos(20 * kHelicalDegree);
    HelicalCase pair{.helix = 20, .distance = distance};
    QCOMPARE(found(pair.mechanism()), QStringList());
    pair.module = 1.9;  // within what shifts make up for
    QVERIFY(!found(pair.mechanism()).contains("teeth-geometry/ratio"));
    pair.module = 1.5;
    QCOMPARE(found(pair.mechanism()), QStringList("teeth-geometry/ratio"));

    test::TrainSketch bevel(2);
    bevel.axis("a", {"0", "0", "0"}).axis("b", {"0", "0", "0"}, {"1", "0", "0"});
    bevel.joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, 20, 30, MeshKind::bevel);
    Mechanism meeting = bevel.build();
    QVERIFY(found(meeting).isEmpty());
    meeting.gearMeshes[0].helixAngle = Number(20);  // a spiral bevel
    QCOMPARE(found(meeting), QStringList());

    Mechanism set = test::planetary(24, 18, 1);
    for (GearMesh& mesh : set.gearMeshes) mesh.helixAngle = Number(20);
    QCOMPARE(found(set), QStringList("teeth-geometry/helix"));  // the planet cannot have both hands
    set.gearMeshes[1].hand = Hand::left;
    QCOMPARE(found(set), QStringList());
    set.gearMeshes[1].helixAngle = Number(19);
    QCOMPARE(found(set), QStringList("teeth-geometry/helix"));
    set.gearMeshes[1].helixAngle = Number(20);
    set.gearMeshes[0].module = Number(2);
    set.gearMeshes[1].module = *Number::fromText("2.01");
    QVERIFY(found(set).contains("teeth-geometry/ratio"));
  }

 private:
  /// Edges, by the places of their ends, that do not have two triangles, one each way.
  static int openEdges(const Solid& solid) {
    const auto key = [&](std::uint32_t v) {
      const Float3& p = solid.positions[v];
      return std::array<float, 3>{p[0], p[1], p[2]};
    };
    std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, int> edges;
    for (const Triangle& t : solid.triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++edges[{key(t[i]), key(t[(i + 1) % 3])}];
    }
    int open = 0;
    for (const auto& [edge, count] : edges) {
      const auto back = edges.find({edge.second, edge.first});
      if (back == edges.end() || back->second != count) ++open;
    }
    return open;
  }
};

QTEST_APPLESS_MAIN(HelicalTest)
#include "test_helical.moc"
