#include <QTest>
#include <cmath>
#include <numbers>

#include "core/foundations/base/locale.h"
#include "core/machine/measure/measure.h"
#include "core/mechanism/model/edits.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/pseudo_language.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

MeasureSpots spotsIn(Mechanism mechanism) {
  return MeasureSpots(std::make_shared<const DerivedGeometry>(PlacedMechanism(std::move(mechanism))));
}

/// The ground and two links on axes a and b that point so, b through a point; no meshes.
MeasureSpots twoAxes(const std::vector<std::string>& point, const std::vector<std::string>& direction) {
  return spotsIn(TrainSketch(2)
                     .axis("a", {"0", "0", "0"})
                     .axis("b", point, direction)
                     .joint(0, 1, "a")
                     .joint(0, 2, "b")
                     .build());
}

Measurement betweenThem(const MeasureSpots& spots) {
  return measured(*spots.of(AxisId("a")), *spots.of(AxisId("b")));
}

/// Two gears with fixed axes at the distance where teeth 20 and 30 have the module 2.
Mechanism spurPair() {
  return TrainSketch(2)
      .axis("a", {"0", "0", "0"})
      .axis("b", {"50", "0", "0"})
      .joint(0, 1, "a")
      .joint(0, 2, "b")
      .mesh(1, 2, 20, 30)
      .build();
}

}  // namespace

class MeasureTest : public QObject {
  Q_OBJECT

 private slots:
  /// a = m (z1 + z2) / 2, d = m z.
  void spurGearsMeasureAsTheirTeethSay() {
    const MeasureSpots spots = spotsIn(spurPair());
    const Measurement centres = betweenThem(spots);
    QCOMPARE(centres.values.size(), std::size_t{1});
    QVERIFY(centres.values[0].measure == MeasuredKind::centreDistance);
    QVERIFY(centres.values[0].fraction() == Rational(50));
    QCOMPARE(textOf(centres.values[0], "mm"), std::string("50 mm"));

    const Spot* const pitch = spots.of(MeshId("5"));
    QVERIFY(pitch != nullptr && pitch->kind == Spot::Kind::pitchPoint);
    const Measurement diameters = measured(*pitch);
    QCOMPARE(diameters.values.size(), std::size_t{2});
    QVERIFY(diameters.values[0].fraction() == Rational(40));
    QVERIFY(diameters.values[1].fraction() == Rational(60));
    QCOMPARE(nameOf(diameters.values[1]), std::string("pitch diameter of gear 2"));

    const Measurement radius = measured(*spots.of(AxisId("b")), *pitch);
    QVERIFY(radius.values[0].measure == MeasuredKind::pitchRadius);
    QVERIFY(radius.values[0].fraction() == Rational(30));
    QVERIFY(radius.values[1].fraction() == Rational(60));
    QCOMPARE(radius.from[0], 50.0);  // the axis was named first
    QCOMPARE(radius.to[0], 20.0);
  }

  void aWheelTellsItsDiametersAndWidth() {
    Mechanism pair = spurPair();
    pair.gearMeshes[0].faceWidth = *Number::fromText("12");
    const MeasureSpots spots = spotsIn(std::move(pair));
    const Spot* const wheel = spots.of(LinkId("1"));
    QVERIFY(wheel != nullptr && wheel->kind == Spot::Kind::wheelCentre);
    const Measurement sizes = measured(*wheel);
    QCOMPARE(sizes.values.size(), std::size_t{4});
    QVERIFY(sizes.values[0].fraction() == Rational(40));
    QVERIFY(std::abs(sizes.values[1].value - 44) < 1e-9);  // d + 2 m
    QVERIFY(std::abs(sizes.values[2].value - 35) < 1e-9);  // d - 2.5 m
    QCOMPARE(sizes.values[3].value, 12.0);

    const Spot* const face = spots.of(LinkId("1"), Vector3{0, 0, 100});
    const Spot* const other = spots.of(LinkId("2"), Vector3{0, 0, -100});
    QVERIFY(face->kind == Spot::Kind::faceCentre && other->kind == Spot::Kind::faceCentre);
    const Measurement across = measured(*face, *other);
    QVERIFY(std::abs(across.values[0].value - std::hypot(50.0, 12.0)) < 1e-9);
    QVERIFY(across.values[1].measure == MeasuredKind::centreDistance);
    QVERIFY(across.values[1].fraction() == Rational(50));
    QVERIFY(across.values[2].measure == MeasuredKind::along);
    QVERIFY(std::abs(across.values[2].value - 12) < 1e-9);
  }

  /// a = m (z2 - z1) / 2, with a ring.
  void planetsAreAsFarFromTheSunAsFromTheRing() {
    const MeasureSpots spots = spotsIn(planetary(24, 18));
    const Spot* const sun = spots.of(JointId("5"));
    const Spot* const planet = spots.of(JointId("8"));
    QVERIFY(sun != nullptr && planet != nullptr && sun != planet);
    QCOMPARE(spots.of(JointId("6")), sun);  // the ring turns about the same axis
    const Rational module = kDefaultModule;
    QVERIFY(measured(*sun, *planet).values[0].fraction() == module * Rational(21));
    const Measurement outer = measured(*spots.of(MeshId("10")));
    QVERIFY(outer.values[0].fraction() == module * Rational(60) ||
            outer.values[1].fraction() == module * Rational(60));
  }

  void centreDistanceComesFirstBetweenWheelsInDifferentPlanes() {
    const Mechanism train = example("reverted-train");
    const MeasureSpots spots = spotsIn(train);
    int apart = 0;
    for (const Link& a : train.links) {
      for (const Link& b : train.links) {
        const Spot* const from = spots.of(a.id);
        const Spot* const to = spots.of(b.id);
        if (from == nullptr || to == nullptr || from->kind != Spot::Kind::wheelCentre ||
            to->kind != Spot::Kind::wheelCentre)
          continue;
        const auto values = measured(*from, *to).values;
        if (values.size() != 3 || values[2].value == 0) continue;
        QVERIFY(values[0].measure == MeasuredKind::centreDistance);
        QVERIFY(values[1].measure == MeasuredKind::distance && values[1].value > values[0].value);
        ++apart;
      }
    }
    QVERIFY(apart > 0);
  }

  void irrationalDistancesAreRoots() {
    const Measurement diagonal = betweenThem(twoAxes({"1", "1", "7"}, {"0", "0", "-3"}));
    QVERIFY(diagonal.values[0].measure == MeasuredKind::centreDistance);
    QVERIFY(diagonal.values[0].square == Rational(2));
    QVERIFY(!diagonal.values[0].fraction());
    QCOMPARE(textOf(diagonal.values[0], "mm"), std::string("√2 mm ≈ 1.41421 mm"));
  }

  void fractionsAndDecimalsAreBothGiven() {
    QCOMPARE(textOf(betweenThem(twoAxes({"125/2", "0", "0"}, {"0", "0", "1"})).values[0], "mm"),
             std::string("125/2 mm = 62.5 mm"));
    QCOMPARE(textOf(betweenThem(twoAxes({"1/3", "0", "0"}, {"0", "0", "1"})).values[0], "mm"),
             std::string("1/3 mm ≈ 0.333333 mm"));
    setDecimalSign(',');
    QCOMPARE(textOf(betweenThem(twoAxes({"125/2", "0", "0"}, {"0", "0", "1"})).values[0], "mm"),
             std::string("125/2 mm = 62,5 mm"));
    setDecimalSign('.');
  }

  void anglesOfSimpleShapesAreExact() {
    const std::vector<std::pair<std::vector<std::string>, int>> known{
        {{"1", "0", "0"}, 90}, {{"0", "1", "1"}, 45}, {{"1", "1", "-2"}, -1}, {{"0", "1", "-1"}, 45}};
    for (const auto& [direction, degrees] : known) {
      const Measurement angle = betweenThem(twoAxes({"0", "0", "0"}, direction));
      QCOMPARE(angle.values.size(), std::size_t{1});
      QVERIFY(angle.values[0].measure == MeasuredKind::angle);
      QCOMPARE(angle.values[0].degrees.value_or(-1), degrees);
    }
    // From one space diagonal's face diagonal to another: 60 degrees.
    const MeasureSpots faces = spotsIn(TrainSketch(2)
                                           .axis("a", {"0", "0", "0"}, {"1", "1", "0"})
                                           .axis("b", {"0", "0", "0"}, {"0", "1", "-1"})
                                           .joint(0, 1, "a")
                                           .joint(0, 2, "b")
                                           .build());
    QCOMPARE(betweenThem(faces).values[0].degrees, std::optional(60));
    const double oblique = betweenThem(twoAxes({"0", "0", "0"}, {"1", "1", "-2"})).values[0].value;
    QVERIFY(std::abs(oblique - std::acos(2 / std::sqrt(6.0)) * 180 / std::numbers::pi) < 1e-12);
  }

  void skewAxesHaveADistanceAndAnAngle() {
    const Measurement skew = betweenThem(twoAxes({"5", "40", "9"}, {"1", "0", "0"}));
    QCOMPARE(skew.values.size(), std::size_t{2});
    QVERIFY(skew.values[0].measure == MeasuredKind::distance);
    QVERIFY(skew.values[0].fraction() == Rational(40));
    QCOMPARE(skew.values[1].degrees, std::optional(90));
    QVERIFY(length(skew.from - Vector3{0, 0, 9}) < 1e-12);  // the feet of the common normal
    QVERIFY(length(skew.to - Vector3{0, 40, 9}) < 1e-12);
  }

  /// Table 1 of the paper: axes at right angles, A1 = 60, module 2.
  void theRobotMeasuresAsInTheTable() {
    const MeasureSpots spots = spotsIn(robot());
    const Measurement diameters = measured(*spots.of(MeshId("15")));
    QVERIFY(diameters.values[0].fraction() == Rational(36));
    QVERIFY(diameters.values[1].fraction() == Rational(72));
    const Measurement bevel = measured(*spots.of(MeshId("16")));
    QVERIFY(bevel.values[0].fraction() == Rational(40));
    QVERIFY(bevel.values[1].fraction() == Rational(60));
  }

  void measuringBackwardsGivesTheSame() {
    const MeasureSpots spots = spotsIn(robot());
    QVERIFY(spots.all().size() > 10);
    for (const Spot& a : spots.all()) {
      for (const Spot& b : spots.all()) {
        const Measurement there = measured(a, b), back = measured(b, a);
        QCOMPARE(there.values.size(), back.values.size());
        for (std::size_t i = 0; i < there.values.size(); ++i) {
          QVERIFY(there.values[i].measure == back.values[i].measure);
          QVERIFY(there.values[i].square == back.values[i].square);
          QVERIFY(std::abs(there.values[i].value - back.values[i].value) < 1e-9);
        }
        QVERIFY(length(there.from - back.to) < 1e-9 ||
                there.values[0].measure == MeasuredKind::centreDistance);
      }
    }
  }

  void whatHasNoPlaceIsNoSpot() {
    QCOMPARE(spotsIn(emptyMechanism()).of(LinkId("0")), nullptr);
    const MeasureSpots spots = spotsIn(spurPair());
    QCOMPARE(spots.of(LinkId("0")), nullptr);  // the ground has no wheel here
    QCOMPARE(spots.of(NoteId("1")), nullptr);
  }

  void namesAreInTheLanguageInUse() {
    const MeasureSpots spots = spotsIn(spurPair());
    QCOMPARE(spots.nameOf(*spots.of(MeshId("5"))), std::string("pitch point of mesh 5"));
    QCOMPARE(spots.nameOf(*spots.of(JointId("3"))), std::string("axis a"));
    QCOMPARE(spots.nameOf(*spots.of(LinkId("2"))), std::string("centre of gear 2 in mesh 5"));
    const PseudoLanguage language;
    for (const Spot& spot : spots.all()) {
      QVERIFY(PseudoLanguage::english(spots.nameOf(spot)).empty());
      for (const MeasuredValue& value : measured(spot).values)
        QVERIFY(PseudoLanguage::english(nameOf(value)).empty());
    }
  }
};

QTEST_APPLESS_MAIN(MeasureTest)
#include "test_measure.moc"
