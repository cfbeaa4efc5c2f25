#include <QTest>

#include "core/mechanism/placement/placement.h"
#include "core/mechanism/placement/tolerance.h"
#include "tests/core/support/diagnostic_codes.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// Two shafts on the ground that mesh, at these points, along z.
Mechanism shafts(const std::vector<std::string>& one, const std::vector<std::string>& other) {
  return TrainSketch(2)
      .axis("a", one)
      .axis("b", other)
      .joint(0, 1, "a")
      .joint(0, 2, "b")
      .mesh(1, 2, 20, 40)
      .build();
}

/// Sun 1 and arm 2 on the ground on axes a and b, planet 3 on the arm on c.
Mechanism planetOn(const std::vector<std::string>& sun, const std::vector<std::string>& arm,
                   const std::vector<std::string>& planet) {
  return TrainSketch(3)
      .axis("a", sun)
      .axis("b", arm)
      .axis("c", planet)
      .joint(0, 1, "a")
      .joint(0, 2, "b")
      .joint(2, 3, "c")
      .mesh(1, 3, 20, 40)
      .build();
}

std::vector<Code> placementCodes(const Mechanism& mechanism) {
  return codesOf(placementOf(mechanism).diagnostics);
}

const std::vector<Code> kFits;
const std::vector<Code> kMerged{Code::mergedAxes};

}  // namespace

class LineComparisonTest : public QObject {
  Q_OBJECT
 private slots:
  void shaftsAsFarApartAsAMicrometreAreTwoWhereverTheyAre() {
    for (const char* x : {"0", "1000000000", "-1e12", "1/3", "1e-12"}) {
      const std::string far = (Rational::fromText(x).value() + Rational(1, 1'000'000'000'000)).toString();
      QCOMPARE(placementCodes(shafts({x, "0", "0"}, {far, "0", "0"})), kFits);
      const Placement placement = placementOf(shafts({x, "0", "0"}, {far, "0", "0"}));
      QVERIFY(std::abs(std::abs(placement.meshes[0]->tailRadius) * 3e12 - 1) < 1e-9);
    }
  }

  void linesThatAreExactlyOneAreOneWhereverTheyAre() {
    // The point of b is that of a, moved along the direction (1/3, 2/3, 2/3) of both.
    for (const char* x : {"0", "1e12", "1e-12", "123456789.123456789"}) {
      const Rational at = Rational::fromText(x).value();
      Mechanism train =
          planetOn({x, "0", "0"}, {(at + Rational(700, 3)).toString(), "1400/3", "1400/3"}, {x, "2e-9", "0"});
      for (Axis& axis : train.axes) axis.direction = NumberTriple{Number(1), Number(2), Number(2)};
      QCOMPARE(placementCodes(train), kMerged);
    }
  }

  void decimalsThatRoundMissByLittleOfTheTrainsSize() {
    QCOMPARE(placementCodes(planetOn({"27", "46.7653718", "0"}, {"27", "46.76537", "90"}, {"27", "0", "0"})),
             kMerged);
    // The same train a thousand million times smaller, and far away.
    QCOMPARE(placementCodes(planetOn({"27e-9", "46.7653718e-9", "0"}, {"27e-9", "46.76537e-9", "90e-9"},
                                     {"27e-9", "0", "0"})),
             kMerged);
    QCOMPARE(placementCodes(planetOn({"1000000027", "46.7653718", "0"}, {"1000000027", "46.76537", "90"},
                                     {"1000000027", "0", "0"})),
             kMerged);
  }

  void twoTrainsFarApartInOneDocumentStayThemselves() {
    Mechanism both = TrainSketch(4)
                         .axis("a", {"0", "0", "0"})
                         .axis("b", {"0", "60", "0"})
                         .axis("c", {"1e9", "0", "0"})
                         .axis("d", {"1e9", "60", "0"})
                         .joint(0, 1, "a")
                         .joint(0, 2, "b")
                         .joint(0, 3, "c")
                         .joint(0, 4, "d")
                         .mesh(1, 2, 20, 40)
                         .mesh(3, 4, 20, 40)
                         .build();
    QCOMPARE(placementCodes(both), kFits);
  }

  void oneMistypedCoordinateDoesNotMergeTheOthers() {
    Mechanism train = TrainSketch(4)
                          .axis("a", {"0", "0", "0"})
                          .axis("b", {"0", "60", "0"})
                          .axis("c", {"0", "120", "0"})
                          .axis("d", {"0", "18000000000", "0"})
                          .joint(0, 1, "a")
                          .joint(0, 2, "b")
                          .joint(0, 3, "c")
                          .joint(0, 4, "d")
                          .mesh(1, 2, 20, 40)
                          .mesh(2, 3, 40, 20)
                          .mesh(3, 4, 20, 40)
                          .build();
    QCOMPARE(placementCodes(train), kFits);
  }

  void directionsOfAnyLengthHaveLengthOne() {
    for (const char* size : {"1e-300", "1e300", "1e-4000", "7", "1/3"}) {
      const Number component = Number::fromText(size).value();
      const Vector3 unit = unitDirection(NumberTriple{component, component, Number()});
      QVERIFY2(std::abs(unit[0] - std::sqrt(0.5)) < 1e-15 && unit[0] == unit[1] && unit[2] == 0, size);
    }
  }
};

QTEST_APPLESS_MAIN(LineComparisonTest)
#include "test_line_comparison.moc"
