#include <QTest>
#include <cmath>
#include <map>
#include <numbers>

#include "core/machine/body_layout/body_recipe.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/teeth/phase.h"
#include "tests/core/machine/solids/topology.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;

namespace {

GearTrain trainOf(const Mechanism& mechanism) {
  return geargraph::trainOf(mechanism, placementOf(mechanism));
}

Diagnostics diagnosticsOf(const Mechanism& mechanism) {
  return trainDiagnostics(mechanism, placementOf(mechanism));
}

const TrainGear* gearNamed(const GearTrain& train, const std::string& name) {
  for (const TrainGear& gear : train.gears) {
    if (gear.name == name) return &gear;
  }
  return nullptr;
}

/// Tooth in space at the pitch point of every mesh, measured from the poses that are drawn.
double worstPhase(const GearTrain& train) {
  double worst = 0;
  for (const TrainMesh& mesh : train.meshes) {
    const auto wheel = [&](int g) {
      const TrainGear& gear = train.gears[static_cast<std::size_t>(g)];
      return PhaseWheel{gear.pose.translation(), gear.pose.linear().col(2), gear.pose.linear().col(0),
                        gear.spec.teeth};
    };
    const PhaseWheel a = wheel(mesh.tailGear);
    const PhaseWheel b = wheel(mesh.headGear);
    worst = std::max(worst, std::abs(phaseError(meshPhase(a, b, mesh.pitchPoint), a, 0, b, 0)));
  }
  return worst;
}

/// Every edge between two triangles, every vertex in one fan, when equal positions are one vertex.
bool isStrictlyManifold(const Solid& solid) {
  const test::Topology topology = test::topologyOf(solid);
  return topology.closed && topology.manifold && topology.degenerate == 0;
}

int codeCount(const Diagnostics& diagnostics, Code code) {
  int n = 0;
  for (const Diagnostic& d : diagnostics) n += d.code == code ? 1 : 0;
  return n;
}

}  // namespace

class TrainTest : public QObject {
  Q_OBJECT
 private slots:
  void robotHasTheEightWheelsOfFigureOne() {
    const GearTrain train = trainOf(test::example("robot"));
    QCOMPARE(train.gears.size(), std::size_t(8));
    QCOMPARE(train.meshes.size(), std::size_t(4));
    QVERIFY(diagnosticsOf(test::example("robot")).empty());
    QVERIFY(worstPhase(train) < 1e-9);
    const TrainGear* five = gearNamed(train, "16:tail");
    QVERIFY(five != nullptr);
    QCOMPARE(five->spec.kind, GearKind::bevel);
    QCOMPARE(five->spec.teeth, 20);
    QVERIFY(std::abs(five->spec.coneAngle - std::atan2(20.0, 30.0)) < 1e-7);
    QVERIFY((five->pose.translation() - Eigen::Vector3d(0, 0, 60)).norm() < 1e-9);   // the apex
    QVERIFY((five->pose.linear().col(2) + Eigen::Vector3d::UnitZ()).norm() < 1e-9);  // the gear lies below it
    for (const TrainGear& gear : train.gears) {
      QVERIFY(std::abs(gear.spec.module - 2) < 1e-9);
      QVERIFY(gearSolid(gear.spec, 0.01).has_value());
    }
  }

  void everyMovingLinkOfTheRobotHasABody() {
    const GearTrain train = trainOf(test::example("robot"));
    QCOMPARE(train.bodies.size(), std::size_t(8));
    for (const LinkBody& body : train.bodies) {
      QVERIFY(isStrictlyManifold(body.solid()));
      QVERIFY(signedVolume(body.solid()) > 0);
    }
  }

  /// What a link is exported as: its gears and its body in one file, equal positions welded.
  void everyLinkOfTheExamplesIsAManifold() {
    const std::vector<std::string> names = test::exampleNames();
    QVERIFY(names.size() >= 12);
    for (const std::string& name : names) {
      const GearTrain train = trainOf(test::example(name));
      std::map<int, Solid> links;
      for (const TrainGear& gear : train.gears) {
        append(links[gear.link], *gearSolid(gear.spec, kScreenTolerance), gear.pose);
      }
      for (const LinkBody& body : train.bodies) append(links[body.link], body.solid());
      for (const auto& [link, solid] : links) {
        QVERIFY2(isStrictlyManifold(solid), qPrintable(QString("%1, link %2").arg(name.c_str()).arg(link)));
      }
    }
  }

  void planetaryGearsShareTheirWheels() {
    const Mechanism mechanism = test::planetary(12, 18, 3);
    const GearTrain train = trainOf(mechanism);
    QCOMPARE(train.gears.size(), std::size_t(5));  // sun, ring, three planets
    QCOMPARE(train.meshes.size(), std::size_t(6));
    QVERIFY2(worstPhase(train) < 1e-5, qPrintable(QString::number(worstPhase(train))));
    const Diagnostics found = diagnosticsOf(mechanism);
    QCOMPARE(codeCount(found, Code::assembly), 0);
    QCOMPARE(codeCount(found, Code::undercut), 1);  // the sun of 12
  }

  /// Planets of one set are one solid, although their coordinates are rounded each for itself.
  /// The long planet of a Ravigneaux set runs through the planes of both suns: one wheel as wide as these,
  /// and in phase with all three that it meshes with.
  void aNamedWheelRunsThroughThePlanesOfItsMeshes() {
    const GearTrain train = trainOf(test::example("ravigneaux"));
    QCOMPARE(train.gears.size(), std::size_t{5});
    for (const TrainGear& gear : train.gears) {
      const bool isLong = gear.wheel == WheelId("6'");
      QCOMPARE(gear.meshes.size(), isLong           ? std::size_t{3}
                                   : gear.link == 5 ? std::size_t{2}
                                                    : std::size_t{1});
      QCOMPARE(gear.spec.faceWidth, isLong ? 32.0 : 12.0);  // planes at 0 and 20
      if (isLong) QCOMPARE(gear.pose.translation().z(), 10.0);
    }
    QVERIFY(worstPhase(train) < 1e-5);
    QVERIFY(diagnosticsOf(test::example("ravigneaux")).empty());
  }

  void equalPlanetsHaveEqualSpecs() {
    const GearTrain train = trainOf(test::planetary(20, 15, 5));
    std::vector<GearSpec> planets;
    for (const TrainGear& gear : train.gears) {
      if (gear.spec.teeth == 15) planets.push_back(gear.spec);
    }
    QCOMPARE(planets.size(), std::size_t(5));
    for (const GearSpec& planet : planets) QVERIFY(planet == planets.front());
    QVERIFY(train.gears.front().spec.profileShift == 0);
  }

  void planetsThatDoNotFitAreReportedWithWhatDoes() {
    const Diagnostics found = diagnosticsOf(test::planetary(13, 18, 4));
    QCOMPARE(codeCount(found, Code::assembly), 2);
    for (const Diagnostic& d : found) {
      if (d.code != Code::assembly) continue;
      QVERIFY(d.message.find("0.500") != std::string::npos);
      QVERIFY(d.message.find("360/62") != std::string::npos);
      QVERIFY(d.message.find("2.903") != std::string::npos);
      QVERIFY(d.message.find(" 51 ") != std::string::npos);  // 13 + 51 = 64 = 4 * 16
      QCOMPARE(d.elements.size(), std::size_t(4));
    }
  }

  /// 12 + 2 * 18 = 48; a ring of 49 asks for shifts. The distances are what the axes have.
  void shiftsMakeUpForCentreDistances() {
    test::TrainSketch sketch(4);
    sketch.axis("a", {"0", "0", "0"}).axis("p", {"31", "0", "0"});
    sketch.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a").joint(3, 4, "p");
    sketch.mesh(1, 4, 12, 18, MeshKind::external).mesh(4, 2, 18, 49, MeshKind::internal);
    const GearTrain train = trainOf(sketch.build());
    QCOMPARE(train.gears.size(), std::size_t(4 - 1));
    const double module = train.gears[0].spec.module;
    QVERIFY(std::abs(module - 2) < 1e-9);  // 62 / 31, smaller than 62 / 30
    const double alpha = train.gears[0].spec.pressureAngle;
    const double sum = train.gears[0].spec.profileShift + train.gears[1].spec.profileShift;
    // inv aw = inv a + 2 tan a sum / 30 and cos aw = 15 cos a / 15.5
    const double working = std::acos(15 * std::cos(alpha) / 15.5);
    const double inv = std::tan(working) - working - (std::tan(alpha) - alpha);
    QVERIFY(std::abs(inv - 2 * std::tan(alpha) * sum / 30) < 5e-6);  // shifts in steps of 0.0001
    QVERIFY(std::abs(train.gears[2].spec.profileShift - train.gears[1].spec.profileShift) < 1e-9);
    QVERIFY(worstPhase(train) < 1e-9);
  }

  /// How the shift is divided between sun, planets and ring does not depend on the number of planets.
  void shiftsDoNotDependOnTheNumberOfPlanets() {
    const auto shifts = [](int planets) {
      test::TrainSketch sketch(3 + planets);
      sketch.axis("a", {"0", "0", "0"});
      sketch.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a");
      for (int i = 0; i < planets; ++i) {
        const double angle = 2 * std::numbers::pi * i / planets;
        const auto text = [](double v) { return Number::fromDouble(v).text(); };
        sketch.axis("p" + std::to_string(i), {text(31 * std::cos(angle)), text(31 * std::sin(angle)), "0"});
        sketch.joint(3, 4 + i, "p" + std::to_string(i));
      }
      for (int i = 0; i < planets; ++i)
        sketch.mesh(1, 4 + i, 12, 18, MeshKind::external).mesh(4 + i, 2, 18, 49, MeshKind::internal);
      std::map<int, double> byTeeth;
      for (const TrainGear& gear : trainOf(sketch.build()).gears) {
        const auto known = byTeeth.try_emplace(gear.spec.teeth, gear.spec.profileShift).first;
        if (known->second != gear.spec.profileShift) return std::map<int, double>();
      }
      return byTeeth;
    };
    const std::map<int, double> one = shifts(1);
    QCOMPARE(one.size(), std::size_t(3));
    QVERIFY(std::abs(one.at(12)) > 0.05);
    for (int planets = 2; planets <= 5; ++planets) QVERIFY(shifts(planets) == one);
  }

  /// Two equal wheels at 41 instead of 40 mm between two others at their standard distance: half the shift
  /// each.
  void equalWheelsThatMeshShareAShift() {
    test::TrainSketch sketch(4);
    sketch.axis("a", {"0", "0", "0"}).axis("b", {"50", "0", "0"}).axis("c", {"91", "0", "0"});
    sketch.axis("d", {"141", "0", "0"});
    sketch.joint(0, 1, "a").joint(0, 2, "b").joint(0, 3, "c").joint(0, 4, "d");
    sketch.mesh(1, 2, 30, 20, MeshKind::external).mesh(2, 3, 20, 20, MeshKind::external);
    sketch.mesh(3, 4, 20, 30, MeshKind::external);
    std::vector<double> shifts;
    for (const TrainGear& gear : trainOf(sketch.build()).gears) shifts.push_back(gear.spec.profileShift);
    QCOMPARE(shifts.size(), std::size_t(4));
    QVERIFY(shifts[1] > 0.2 && shifts[1] == shifts[2] && shifts[0] == shifts[3]);
    QVERIFY(std::abs(shifts[0] + shifts[1]) < 1e-8);
  }

  /// A stepped planet: two wheels of one link that would stand in one place are stacked.
  void compoundPlanetsAreStacked() {
    test::TrainSketch sketch(4);
    sketch.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a").joint(3, 4, "p");
    sketch.mesh(1, 4, 20, 25, MeshKind::external).mesh(4, 2, 15, 60, MeshKind::internal);
    const GearTrain train = trainOf(sketch.build());
    QCOMPARE(train.gears.size(), std::size_t(4));
    const double apart =
        std::abs(train.gears[1].pose.translation().z() - train.gears[2].pose.translation().z());
    QVERIFY(apart >= train.gears[1].spec.faceWidth);
    QVERIFY(worstPhase(train) < 1e-9);
  }

  void ringsTooCloseToTheirPinionAreReported() {
    test::TrainSketch sketch(2);
    sketch.axis("a", {"0", "0", "0"}).axis("b", {"6", "0", "0"});
    sketch.joint(0, 1, "a").joint(0, 2, "b");
    sketch.mesh(2, 1, 54, 60, MeshKind::internal);
    const Diagnostics found = diagnosticsOf(sketch.build());
    QVERIFY(std::any_of(found.begin(), found.end(),
                        [](const Diagnostic& d) { return d.detail == Detail::tipInterference; }));
  }

  void aMechanismWithoutATreeHasNoTrain() {
    Mechanism mechanism = emptyMechanism();
    Link loose;
    loose.id = LinkId("x");
    mechanism.links.push_back(loose);
    QVERIFY(trainOf(mechanism).gears.empty());
  }

  void trainsAreDeterministic() {
    const GearTrain a = trainOf(test::example("robot"));
    const GearTrain b = trainOf(test::example("robot"));
    for (std::size_t i = 0; i < a.bodies.size(); ++i) QVERIFY(a.bodies[i].solid() == b.bodies[i].solid());
  }

  /// Whatever a random train of nested carriers looks like, every mesh engages, or its loop is reported.
  void randomTrainsEngage() {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const Mechanism mechanism = test::randomTrain(seed, 12, 8);
      const GearTrain train = trainOf(mechanism);
      const int misfits = codeCount(diagnosticsOf(mechanism), Code::assembly);
      for (const TrainMesh& mesh : train.meshes) {
        if (std::abs(mesh.residual) > kPhaseFits) QVERIFY(misfits > 0);
      }
      if (misfits == 0) QVERIFY(worstPhase(train) < kPhaseFits);
      for (const LinkBody& body : train.bodies) QVERIFY(isStrictlyManifold(body.solid()));
    }
  }
};

QTEST_APPLESS_MAIN(TrainTest)
#include "test_train.moc"
