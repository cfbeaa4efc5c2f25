#include <QTest>
#include <random>

#include "core/design/synthesis/bevel_sets.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/geometry_edits/axis_drag.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/geometry_edits/wheel_map.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/pins.h"
#include "core/mechanism/model/validate.h"
#include "tests/core/mechanism/geometry_edits/fitted_trains.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

class FittingTest : public QObject {
  Q_OBJECT

 private slots:
  void theRingFollowsTheSun() {
    const Mechanism before = statedPlanetary(3);
    const Mechanism after = *withTeethFitted(before, mesh(before, 0).id, 30, 18);
    for (int planet = 0; planet < 3; ++planet) {
      QCOMPARE(mesh(after, 2 * planet).tailTeeth, 30);
      QCOMPARE(mesh(after, 2 * planet).headTeeth, 18);
      QCOMPARE(mesh(after, 2 * planet + 1).headTeeth, 66);
      QCOMPARE(distanceOfAxis(after, 1 + planet), 48.0);
    }
    QCOMPARE(after.axes[0], before.axes[0]);
    QVERIFY(misfit(after) < 1e-9);
    QVERIFY(std::abs(moduleOf(after, 0) - 2) < 1e-9 && std::abs(moduleOf(after, 1) - 2) < 1e-9);
    // On their rays, exactly.
    QCOMPARE((*after.axes[2].point)[0].exact(), Rational(-144, 5));
    QCOMPARE((*after.axes[2].point)[1].exact(), Rational(192, 5));
  }

  void identicalPlanetsFollow() {
    const Mechanism before = statedPlanetary(3);
    const Mechanism after = *withTeethFitted(before, mesh(before, 3).id, 20, 60);  // planet 5
    for (int planet = 0; planet < 3; ++planet) {
      QCOMPARE(mesh(after, 2 * planet).headTeeth, 20);
      QCOMPARE(mesh(after, 2 * planet + 1).tailTeeth, 20);
      QCOMPARE(mesh(after, 2 * planet + 1).headTeeth, 64);
    }
    QVERIFY(misfit(after) < 1e-9);
  }

  /// The ring cannot follow by whole teeth, and would get as many as the planet.
  void anInternalPairIsNotGivenEqualTeeth() {
    TrainSketch sketch(3);
    sketch.axis("a", {"0", "0", "0"}).axis("b", {"41", "0", "0"});
    sketch.joint(0, 1, "a").joint(0, 2, "a").joint(2, 3, "b");
    sketch.mesh(1, 3, 20, 21, MeshKind::external, {"20", "0", "0"});
    sketch.mesh(3, 0, 21, 60, MeshKind::internal, {"820/13", "0", "0"});
    const Mechanism before = sketch.build();
    const auto after = withTeethFitted(before, mesh(before, 0).id, 20, 60);
    QVERIFY(!after.has_value());
    QCOMPARE(after.error().front().code, Code::teethGeometry);
    QVERIFY(after.error().front().message.find("different tooth counts") != std::string::npos);
    QVERIFY(withTeethFitted(before, mesh(before, 0).id, 20, 40).has_value());
  }

  void anAxisMayBeMovedOntoAnother() {
    const Mechanism before = statedPlanetary(3);
    const Mechanism after = *withAxisMoved(before, before.axes[3].id, *before.axes[1].point);
    QVERIFY(after.axes[3].point == before.axes[1].point);
    QVERIFY(mesh(after, 4).pitchPoint == mesh(before, 0).pitchPoint);
  }

  void anAxisIsNotMovedBeyondTheLimits() {
    const PlacedMechanism before = test::example("reverted-train");
    int moved = 0;
    for (const Axis& axis : before.mechanism().axes) {
      const auto rejected = withAxisMoved(before, axis.id, at(1e200, 0, 0));
      QVERIFY(!rejected);
      QCOMPARE(rejected.error().front().code, Code::schema);
      ++moved;
    }
    QVERIFY(moved > 1);
  }

  void theSunFollowsTheRing() {
    const Mechanism before = statedPlanetary(1);
    const Mechanism after = *withTeethFitted(before, mesh(before, 1).id, 18, 72);
    QCOMPARE(mesh(after, 0).tailTeeth, 36);
    QCOMPARE(distanceOfAxis(after, 1), 54.0);
    QVERIFY(misfit(after) < 1e-9);
  }

  void whatCannotBeIsRejectedWithTheCulprits() {
    const Mechanism before = statedPlanetary(1);
    const auto rejected = withTeethFitted(before, mesh(before, 1).id, 18, 38);  // the sun would need 2
    QVERIFY(!rejected);
    QCOMPARE(rejected.error()[0].code, Code::teethGeometry);
    const auto& blamed = rejected.error()[0].elements;
    QVERIFY(std::find(blamed.begin(), blamed.end(), ElementId(mesh(before, 0).id)) != blamed.end());
    QCOMPARE(withTeethFitted(before, mesh(before, 0).id, 0, 18).error()[0].code, Code::schema);
  }

  void openPlacesFollowByThemselves() {
    const Mechanism before = planetary(24, 18, 3);
    const Mechanism after = *withTeethFitted(before, mesh(before, 0).id, 30, 18);
    QCOMPARE(mesh(after, 5).headTeeth, 66);
    QVERIFY(!after.axes[1].point && !mesh(after, 0).pitchPoint);
    QVERIFY(misfit(after) < 1e-9);
  }

  void fergusonsWheelsKeepTheirTeethAndTheirAxis() {
    TrainBuilder train("Ferguson");
    const int a = train.axis({0, 0, 0}, {0, 0, 1});
    const int b = train.axis({60, 0, 0}, {0, 0, 1});
    const int carrier = train.link(0, a);
    const int planet = train.link(carrier, b);
    for (const int teeth : {99, 100, 101}) train.external(planet, b, 20, train.link(0, a), a, teeth);
    const Mechanism before = train.mechanism();
    const Mechanism after = *withTeethFitted(before, mesh(before, 1).id, 20, 102);
    QCOMPARE(mesh(after, 0).headTeeth, 99);
    QCOMPARE(mesh(after, 2).headTeeth, 101);
    QCOMPARE(distanceOfAxis(after, 1), 61.0);
    QVERIFY(misfit(after) < 1e-9);
  }

  void anAxisBetweenTwoGoesWhereBothDistancesMeet() {
    // The Ravigneaux train's short planet lies between the small sun and the long planet.
    TrainBuilder train("Ravigneaux");
    const int a = train.axis({0, 0, 0}, {0, 0, 1});
    const int b = train.axis({30, 40, 0}, {0, 0, 1});
    const int c = train.axis({54, 0, 0}, {0, 0, 1});
    const int small = train.link(0, a);
    const int large = train.link(0, a);
    const int ring = train.link(0, a);
    const int carrier = train.link(0, a);
    const int shorter = train.link(carrier, b);
    const int longer = train.link(carrier, c);
    train.external(small, a, 30, shorter, b, 20);
    train.external(shorter, b, 20, longer, c, 18);
    train.external(large, a, 36, longer, c, 18);
    train.internal(longer, c, 18, ring, a, 72);
    const Mechanism before = train.mechanism();
    const Mechanism after = *withTeethFitted(before, mesh(before, 2).id, 40, 18);
    QCOMPARE(mesh(after, 3).headTeeth, 76);
    QVERIFY(std::abs(distanceOfAxis(after, 2) - 58) < 1e-9);
    QVERIFY(std::abs(distanceOfAxis(after, 1) - 50) < 1e-9);  // 30 and 20 as before
    QVERIFY((*after.axes[1].point)[1].value() > 0);           // on its side
    QVERIFY(misfit(after) < 1e-9);
    const auto apart = withTeethFitted(before, mesh(before, 2).id, 90, 18);
    QVERIFY(!apart);
    QCOMPARE(apart.error()[0].code, Code::teethGeometry);
  }

  void bevelsKeepTheirApexAndTheirSides() {
    const Mechanism before = robot();
    for (const auto& [position, tail, head] :
         {std::tuple(1, 24, 30), std::tuple(2, 24, 21), std::tuple(3, 16, 25)}) {
      const Mechanism after = *withTeethFitted(before, mesh(before, position).id, tail, head);
      QCOMPARE(after.axes, before.axes);
      QVERIFY(misfit(after) < 1e-9);
      const Placement was = placementOf(before), now = placementOf(after);
      QCOMPARE(now.meshes[static_cast<std::size_t>(position)]->sign,
               was.meshes[static_cast<std::size_t>(position)]->sign);
    }
  }

  void axesOfLaterStagesGoAlong() {
    // Two stages on fixed axes: the third axis keeps its distance from the second.
    TrainBuilder train("two stages");
    const int a = train.axis({0, 0, 0}, {0, 0, 1});
    const int b = train.axis({40, 0, 0}, {0, 0, 1});
    const int c = train.axis({40, 50, 0}, {0, 0, 1});
    const int one = train.link(0, a);
    const int two = train.link(0, b);
    const int three = train.link(0, c);
    train.external(one, a, 20, two, b, 20);
    train.external(two, b, 15, three, c, 35);
    const Mechanism before = train.mechanism();
    const Mechanism after = *withTeethFitted(before, mesh(before, 0).id, 20, 30);
    QCOMPARE((*after.axes[1].point)[0].exact(), Rational(50));
    QCOMPARE((*after.axes[2].point)[0].exact(), Rational(50));
    QCOMPARE((*after.axes[2].point)[1].exact(), Rational(50));
    QVERIFY(misfit(after) < 1e-9);
  }

  void anExternalPairBecomesInternal() {
    TrainBuilder train("pair");
    const int a = train.axis({0, 0, 0}, {0, 0, 1});
    const int b = train.axis({80, 0, 0}, {0, 0, 1});
    const int one = train.link(0, a);
    train.external(one, a, 20, train.link(0, b), b, 60);
    const Mechanism after =
        *withKindFitted(train.mechanism(), mesh(train.mechanism(), 0).id, MeshKind::internal);
    QCOMPARE(*mesh(after, 0).kind, MeshKind::internal);
    QCOMPARE(distanceOfAxis(after, 1), 40.0);
    QVERIFY(misfit(after) < 1e-9);
    const Mechanism back = *withKindFitted(after, mesh(after, 0).id, MeshKind::external);
    QCOMPARE(back.axes, train.mechanism().axes);
    QVERIFY(!withKindFitted(after, mesh(after, 0).id, MeshKind::bevel));
  }

  void aDraggedAxisTakesTheModuleAndIdenticalPlanetsAlong() {
    const Mechanism before = statedPlanetary(3);
    const Mechanism after = *withAxisMoved(before, before.axes[1].id, at(0, 63, 0));
    QCOMPARE((*after.axes[1].point)[1].value(), 63.0);
    for (int planet = 1; planet <= 3; ++planet) QVERIFY(std::abs(distanceOfAxis(after, planet) - 63) < 1e-9);
    QVERIFY(std::abs(moduleOf(after, 0) - 3) < 1e-9 && std::abs(moduleOf(after, 5) - 3) < 1e-9);
    QCOMPARE(mesh(after, 0).tailTeeth, 24);
    QVERIFY(misfit(after) < 1e-9);
    QCOMPARE(withAxisMoved(before, before.axes[1].id, at(0, 0, 5)).error()[0].code, Code::pitchPointOnAxis);
  }

  void theNearestTeethForADraggedAxisAreOffered() {
    const Mechanism before = statedPlanetary(1);
    const auto offers = teethNear(before, before.axes[1].id, 45.2);
    QVERIFY(!offers.empty());
    QCOMPARE(offers[0].tailTeeth, 24);
    QCOMPARE(offers[0].headTeeth, 21);  // (24 + 21) / 2 * 2 = 45
    QCOMPARE(offers[0].distance, 45.0);
    for (const TeethOffer& offer : offers) {
      const auto taken = withTeethFitted(before, offer.mesh, offer.tailTeeth, offer.headTeeth);
      QVERIFY(std::abs(distanceOfAxis(*taken, 1) - offer.distance) < 1e-9);
    }
  }

  void anAxisHasItsReach() {
    const Mechanism before = statedPlanetary(3);
    const auto reach = axisReach(before, before.axes[1].id);
    QCOMPARE(reach->from, before.axes[0].id);
    QCOMPARE(reach->distance, 42.0);
    QCOMPARE(reach->module, 2.0);
    const Mechanism after = *withAxisReach(before, before.axes[1].id, Rational(5, 4));
    QCOMPARE(axisReach(after, before.axes[2].id)->module, 2.5);
    QVERIFY(misfit(after) < 1e-9);
  }

  /// The planets' axes lie 42 from the sun's, with module 2.
  void anAxisIsDraggedAlongItsRayAndSnaps() {
    const Mechanism before = statedPlanetary(3);
    const AxisId axis = before.axes[1].id;
    const AxisReach reach = *axisReach(before, axis);
    QVERIFY(std::abs(length(reach.outward) - 1) < 1e-12);
    const Mechanism snapped = *withAxisDragged(before, axis, 10.4 * reach.outward, true);
    QCOMPARE(axisReach(snapped, axis)->module, 2.5);  // 52.4 / 42 * 2 = 2.495
    QVERIFY(misfit(snapped) < 1e-9);
    const Mechanism free = *withAxisDragged(before, axis, 10.4 * reach.outward, false);
    QVERIFY(std::abs(axisReach(free, axis)->distance - 52.4) < 1e-9);
    // Square to the ray it does not move, and never onto the other axis.
    const Vector3 aside = cross(reach.outward, Vector3{0, 0, 1});
    QCOMPARE(axisReach(*withAxisDragged(before, axis, 9.0 * aside, false), axis)->distance, 42.0);
    QVERIFY(axisReach(*withAxisDragged(before, axis, -100.0 * reach.outward, false), axis)->distance > 0.5);
    QCOMPARE(withAxisDragged(before, AxisId("none"), {}, true).error()[0].code, Code::unknownId);
  }

  void anAxisWithoutMeshesGoesWhereItIsDragged() {
    Mechanism before = emptyMechanism();
    before = *withLink(std::move(before), {});
    before = *withTurningJoint(before, before.links[0].id, before.links[1].id);
    const AxisId axis = before.axes[0].id;
    before = *withAxisPlaced(std::move(before), axis, NumberTriple{Number(1), Number(2), Number(3)},
                             NumberTriple{Number(0), Number(0), Number(1)});
    const auto point = [&](bool snapped) {
      const Mechanism after = *withAxisDragged(before, axis, {4.3, -2.6, 50}, snapped);
      const NumberTriple& at = *after.axes[0].point;
      return std::array{at[0].value(), at[1].value(), at[2].value()};
    };
    QCOMPARE(point(true), (std::array{5.0, -1.0, 3.0}));  // not along itself
    QVERIFY(std::abs(point(false)[0] - 5.3) < 1e-9 && std::abs(point(false)[1] + 0.6) < 1e-9);
  }

  // --- bevels ---

  void aBevelGoesToTheOtherSideOfItsApex() {
    const Mechanism before = robot();
    for (const int position : {1, 2, 3}) {
      for (const bool ofTail : {true, false}) {
        const MeshId id = mesh(before, position).id;
        const auto flipped = withBevelSideFlipped(before, id, ofTail);
        QVERIFY(flipped.has_value());
        const Placement was = placementOf(before), now = placementOf(*flipped);
        const auto& old = *was.meshes[static_cast<std::size_t>(position)];
        const auto& is = *now.meshes[static_cast<std::size_t>(position)];
        QCOMPARE(is.sign, -old.sign);  // it turns the other way
        QCOMPARE(flipped->mechanism().axes, before.axes);
        QVERIFY(misfit(*flipped) < 1e-9);
        QVERIFY(std::abs(moduleOf(*flipped, position) - moduleOf(before, position)) < 1e-9);
        const Mechanism back = *withBevelSideFlipped(*flipped, id, ofTail);
        const Vector3 place = placementOf(back).meshes[static_cast<std::size_t>(position)]->pitchPoint;
        QVERIFY(length(place - old.pitchPoint) < 1e-9);
      }
    }
    QCOMPARE(withBevelSideFlipped(before, mesh(before, 0).id, true).error()[0].code, Code::pitchGeometry);
    QCOMPARE(withBevelSideFlipped(before, MeshId("none"), true).error()[0].code, Code::unknownId);
  }

  void aFlippedWheelTakesItsOtherMeshesAlong() {
    // A differential's planet meshes with both sides: its one wheel goes to the other side with both meshes.
    const Mechanism before = bevelDifferentialSet(20, 12, 1).value();
    const Placement was = placementOf(before);
    const WheelMap wheels(before, was);
    int planetEnd = -1;
    for (int end = 0; end < 2 * before.c(); ++end) {
      if (wheels.ends(wheels.wheelOf(end)).size() > 1) planetEnd = end;
    }
    QVERIFY(planetEnd >= 0);
    const Mechanism after =
        *withBevelSideFlipped(before, mesh(before, planetEnd / 2).id, isTailEnd(planetEnd));
    const Placement now = placementOf(after);
    for (const int end : wheels.ends(wheels.wheelOf(planetEnd))) {
      QCOMPARE(now.meshes[static_cast<std::size_t>(end / 2)]->sign,
               -was.meshes[static_cast<std::size_t>(end / 2)]->sign);
    }
    QVERIFY(misfit(after) < 1e-9);
  }

  void everyEditOfRandomSequencesLeavesEverythingFitting() {
    int applied = 0;
    int rejected = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      std::mt19937_64 random(seed);
      const auto below = [&random](int limit) {
        return static_cast<int>(random() % static_cast<std::uint64_t>(limit));
      };
      Mechanism mechanism = seed % 3 == 0   ? statedPlanetary(1 + below(3))
                            : seed % 3 == 1 ? planetary(18 + 6 * below(4), 12 + below(12), 1 + below(3))
                                            : randomTrain(seed, 6, 6);
      if (misfit(mechanism) > 1e-9) continue;
      for (int step = 0; step < 25 && mechanism.c() > 0; ++step) {
        const GearMesh edited = mesh(mechanism, below(mechanism.c()));
        auto next = [&]() -> Expected<PlacedMechanism> {
          const int change = below(7) - 3;
          switch (below(5)) {
            case 0: {
              const Axis& axis =
                  mechanism.axes[static_cast<std::size_t>(below(static_cast<int>(mechanism.axes.size())))];
              if (!axis.point) return PlacedMechanism(mechanism);
              NumberTriple point = *axis.point;
              point[static_cast<std::size_t>(below(3))] = Number::fromDouble(point[0].value() + 5 * change);
              return withAxisMoved(mechanism, axis.id, point);
            }
            case 1:
              return withKindFitted(mechanism, edited.id,
                                    below(2) == 0 ? MeshKind::internal : MeshKind::external);
            case 2:
              return withTeethFitted(mechanism, edited.id, edited.tailTeeth + change, edited.headTeeth);
            default:
              return withTeethFitted(mechanism, edited.id, edited.tailTeeth, edited.headTeeth + change);
          }
        }();
        if (!next) {
          ++rejected;
          QVERIFY(!next.error()[0].elements.empty() || next.error()[0].code == Code::schema);
          continue;
        }
        QVERIFY2(misfit(*next) < 1e-9, std::to_string(seed).c_str());
        QVERIFY(wellFormedDiagnostics(*next).empty());
        mechanism = std::move(next).value();
        ++applied;
      }
    }
    QVERIFY2(applied > 300 && rejected > 5,
             (std::to_string(applied) + " " + std::to_string(rejected)).c_str());
  }
};

QTEST_APPLESS_MAIN(FittingTest)
#include "test_fitting.moc"
