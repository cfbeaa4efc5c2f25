#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/machine/body_layout/complete_train.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/phase.h"
#include "core/machine/teeth/tooth_pair.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using std::numbers::pi;

namespace {

Diagnostics diagnosticsFor(const Mechanism& mechanism) {
  return trainDiagnostics(mechanism, placementOf(mechanism));
}

/// Diagnostics of this code that state the value.
int count(const Diagnostics& diagnostics, Code code, const std::string& value = {}) {
  return static_cast<int>(std::count_if(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& d) {
    return d.code == code && d.message.find(value) != std::string::npos;
  }));
}

int count(const Diagnostics& diagnostics, Detail detail, const std::string& value = {}) {
  Diagnostics some;
  std::copy_if(diagnostics.begin(), diagnostics.end(), std::back_inserter(some),
               [detail](const Diagnostic& d) { return d.detail == detail; });
  return count(some, codeOf(detail), value);
}

/// The elements of the diagnostics with this detail, one text a diagnostic: "links:1 links:2".
QStringList blamed(const Diagnostics& diagnostics, Detail detail) {
  QStringList all;
  for (const Diagnostic& d : diagnostics) {
    if (d.detail != detail) continue;
    QStringList elements;
    for (const ElementId& element : d.elements)
      elements << QString::fromStdString(std::string(listName(element.kind)) + ":" + element.id.text());
    all << elements.join(' ');
  }
  return all;
}

QByteArray listed(const Diagnostics& diagnostics) {
  QByteArray text;
  for (const Diagnostic& d : diagnostics) text += QByteArray::fromStdString(d.message) + "\n";
  return text;
}

Mechanism pair(int a, int b, MeshKind kind = MeshKind::external) {
  test::TrainSketch sketch(2);
  sketch.joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, a, b, kind);
  return sketch.build();
}

std::string text(double v) {
  return Number::fromDouble(v).text();
}

/// Wheels of one module on fixed axes with these centres, each meshing with the next and the last with the
/// first; the pitch points divide the distances by the teeth.
Mechanism ring(const std::vector<int>& teeth, const std::vector<std::pair<double, double>>& centres) {
  const int n = static_cast<int>(teeth.size());
  test::TrainSketch sketch(n);
  for (int i = 0; i < n; ++i) {
    sketch.axis("a" + std::to_string(i), {text(centres[i].first), text(centres[i].second), "0"});
    sketch.joint(0, i + 1, "a" + std::to_string(i));
  }
  for (int i = 0; i < n; ++i) {
    const int k = (i + 1) % n;
    const double part = static_cast<double>(teeth[i]) / (teeth[i] + teeth[k]);
    const double x = centres[i].first + part * (centres[k].first - centres[i].first);
    const double y = centres[i].second + part * (centres[k].second - centres[i].second);
    sketch.mesh(i + 1, k + 1, teeth[i], teeth[k], MeshKind::external, {text(x), text(y), "0"});
  }
  return sketch.build();
}

/// Three wheels that touch each other, at the corners of the triangle of their centre distances.
Mechanism triangle(int a, int b, int c, double turn) {
  const double ab = a + b, bc = b + c, ca = c + a;  // module 2
  const double angle = std::acos((ab * ab + ca * ca - bc * bc) / (2 * ab * ca));
  return ring({a, b, c}, {{0, 0},
                          {ab * std::cos(turn), ab * std::sin(turn)},
                          {ca * std::cos(turn + angle), ca * std::sin(turn + angle)}});
}

/// The teeth of a stepped planet and of what it meshes with.
struct Stepped {
  int sun = 20;
  int planet = 26;       ///< with the sun
  int otherPlanet = 15;  ///< with the ring, or a second sun
  int other = 61;
};

/// Sun 1, ring or second sun 2, carrier 3, stepped planets 4.. at equal distances; axes left open.
Mechanism steppedSet(const Stepped& teeth, int planets, MeshKind kind = MeshKind::internal) {
  test::TrainSketch sketch(3 + planets);
  sketch.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a");
  for (int i = 0; i < planets; ++i) sketch.joint(3, 4 + i, "b" + std::to_string(i));
  for (int i = 0; i < planets; ++i) {
    sketch.mesh(1, 4 + i, teeth.sun, teeth.planet, MeshKind::external);
    sketch.mesh(4 + i, 2, teeth.otherPlanet, teeth.other, kind);
  }
  return sketch.build();
}

/// The same with the planets' axes on the ground, and `turn` (rad) added to the place of the last.
Mechanism steppedStar(const Stepped& teeth, int planets, double turn = 0) {
  test::TrainSketch sketch(2 + planets);
  sketch.axis("a", {"0", "0", "0"});
  sketch.joint(0, 1, "a").joint(0, 2, "a");
  const double distance = teeth.sun + teeth.planet;  // module 2
  for (int i = 0; i < planets; ++i) {
    const double angle = 2 * pi * i / planets + (i == planets - 1 ? turn : 0);
    const std::string axis = "b" + std::to_string(i);
    sketch.axis(axis, {text(distance * std::cos(angle)), text(distance * std::sin(angle)), "0"});
    sketch.joint(0, 3 + i, axis);
  }
  for (int i = 0; i < planets; ++i) {
    sketch.mesh(1, 3 + i, teeth.sun, teeth.planet, MeshKind::external);
    sketch.mesh(3 + i, 2, teeth.otherPlanet, teeth.other, MeshKind::internal);
  }
  return sketch.build();
}

/// Sun 1 meshes with a stepped planet, whose other gear meshes with a second planet in ring 2; both planets
/// are on carrier 3, on one line with the centre: 20 + 30 teeth, 18 + 16, ring 100.
Mechanism meshingSteppedPlanets(int groups) {
  test::TrainSketch sketch(3 + 2 * groups);
  sketch.axis("a", {"0", "0", "0"});
  sketch.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a");
  for (int i = 0; i < groups; ++i) {
    const double angle = 2 * pi * i / groups;
    const auto at = [&](double radius) -> std::vector<std::string> {
      return {text(radius * std::cos(angle)), text(radius * std::sin(angle)), "0"};
    };
    const std::string inner = "p" + std::to_string(i), outer = "q" + std::to_string(i);
    sketch.axis(inner, at(50)).axis(outer, at(84));
    sketch.joint(3, 4 + 2 * i, inner).joint(3, 5 + 2 * i, outer);
  }
  for (int i = 0; i < groups; ++i) {
    sketch.mesh(1, 4 + 2 * i, 20, 30, MeshKind::external);
    sketch.mesh(4 + 2 * i, 5 + 2 * i, 18, 16, MeshKind::external);
    sketch.mesh(5 + 2 * i, 2, 16, 100, MeshKind::internal);
  }
  return sketch.build();
}

}  // namespace

class TrainDiagnosticsTest : public QObject {
  Q_OBJECT
 private slots:
  void undercutSaysHowManyTeethAndWhatShiftWouldDo() {
    const Diagnostics found = diagnosticsFor(pair(12, 40));
    QCOMPARE(count(found, Code::undercut), 1);
    QVERIFY(found.front().elements == (std::vector<ElementId>{MeshId("5"), LinkId("1")}));
    QCOMPARE(count(found, Code::undercut, "17.1"), 1);
    QCOMPARE(count(found, Code::undercut, "0.30"), 1);
    QCOMPARE(count(diagnosticsFor(pair(18, 40)), Code::undercut), 0);
  }

  /// A standard pair's ratio by the formula of every text book; 20/40 at 20 degrees has 1.64.
  void theContactRatioIsThatOfTheTextBook() {
    const auto ratio = [](int z1, int z2, MeshKind kind) {
      const bool inner = kind == MeshKind::internal;
      const GearSpec a = standardGear(GearKind::external, z1, 1, 1);
      const GearSpec b = standardGear(inner ? GearKind::internal : GearKind::external, z2, 1, 1);
      const HalfTooth tooth = inner ? ringTooth(b, 0.1) : externalTooth(b, 0.1);
      return contactRatio(a, externalTooth(a, 0.1), b, tooth, (inner ? z2 - z1 : z1 + z2) / 2.0);
    };
    const double alpha = pi / 9;
    const auto expected = [&](double z1, double z2) {
      const auto reach = [&](double z) {
        return std::sqrt(std::pow(z / 2 + 1, 2) - std::pow(z / 2 * std::cos(alpha), 2));
      };
      return (reach(z1) + reach(z2) - (z1 + z2) / 2 * std::sin(alpha)) / (pi * std::cos(alpha));
    };
    QVERIFY(std::abs(ratio(20, 40, MeshKind::external) - expected(20, 40)) < 1e-9);
    QVERIFY(std::abs(ratio(20, 40, MeshKind::external) - 1.64) < 0.01);
    QVERIFY(std::abs(ratio(40, 40, MeshKind::external) - expected(40, 40)) < 1e-9);
    QVERIFY(ratio(8, 40, MeshKind::external) < expected(8, 40) - 0.3);  // undercut shortens the flank
    // The ring's tip begins the contact, or the end of the pinion's flank above its fillet does.
    const double z1 = 30, z2 = 80;
    const double inner = std::sqrt(std::pow(z2 / 2 - 1, 2) - std::pow(z2 / 2 * std::cos(alpha), 2));
    const double outer = std::sqrt(std::pow(z1 / 2 + 1, 2) - std::pow(z1 / 2 * std::cos(alpha), 2));
    const double begin =
        std::max(inner - (z2 - z1) / 2 * std::sin(alpha), z1 / 2 * std::sin(alpha) - 1 / std::sin(alpha));
    const double ringRatio = (outer - begin) / (pi * std::cos(alpha));
    QVERIFY(std::abs(ratio(30, 80, MeshKind::internal) - ringRatio) <
            1e-4);  // rho is 0.38, not c/(1 - sin a)
  }

  /// On the sphere it is nearly that of the virtual gears z / cos d.
  void theContactRatioOfBevelsIsNearlyThatOfTheirVirtualGears() {
    GearSpec a = standardGear(GearKind::bevel, 20, 1, 5);
    GearSpec b = standardGear(GearKind::bevel, 40, 1, 5);
    a.coneAngle = std::atan2(20.0, 40.0);
    b.coneAngle = pi / 2 - a.coneAngle;
    const double exact = contactRatio(a, bevelTooth(a, 0.1), b, bevelTooth(b, 0.1), 0);
    const double alpha = pi / 9;
    const auto reach = [&](double r) {
      return std::sqrt(std::pow(r + 1, 2) - std::pow(r * std::cos(alpha), 2));
    };
    const double r1 = 10 / std::cos(a.coneAngle), r2 = 20 / std::cos(b.coneAngle);
    const double flat = (reach(r1) + reach(r2) - (r1 + r2) * std::sin(alpha)) / (pi * std::cos(alpha));
    QVERIFY2(std::abs(exact - flat) < 0.02, qPrintable(QString("%1 %2").arg(exact).arg(flat)));
  }

  /// A crown gear is nearly a rack, an internal cone nearly a ring of z / cos d teeth.
  void crownsAndInternalConesHaveAContactRatio() {
    const double alpha = pi / 9;
    const auto ratio = [](double sum, double crownOrRing) {
      GearSpec a = standardGear(GearKind::bevel, 24, 1, 5);
      GearSpec b = standardGear(GearKind::bevel, 48, 1, 5);
      b.coneAngle = crownOrRing;
      a.coneAngle = sum - crownOrRing;
      return contactRatio(a, bevelTooth(a, 0.1), b, bevelTooth(b, 0.1), 0);
    };
    const auto reach = [&](double r, double height) {
      return std::sqrt(std::pow(r + height, 2) - std::pow(r * std::cos(alpha), 2));
    };
    const double pitch = pi * std::cos(alpha);
    const double r1 = 12 / std::cos(pi / 6);
    const double rack = (reach(r1, 1) - r1 * std::sin(alpha) + 1 / std::sin(alpha)) / pitch;
    const double crown = ratio(2 * pi / 3, pi / 2);
    QVERIFY2(std::abs(crown - rack) < 0.05, qPrintable(QString("%1 %2").arg(crown).arg(rack)));
    const double cone = 2 * pi / 3;
    const double own = std::asin(std::sin(cone) / 2);
    const double p = 12 / std::cos(own), r = -24 / std::cos(cone);
    const double flat = (reach(p, 1) - std::max(reach(r, -1) - (r - p) * std::sin(alpha), 0.0)) / pitch;
    const double inner = ratio(cone + own, cone);
    QVERIFY2(std::abs(inner - flat) < 0.15, qPrintable(QString("%1 %2").arg(inner).arg(flat)));
    QVERIFY(inner > crown);
  }

  void shortContactIsReported() {
    QCOMPARE(blamed(diagnosticsFor(pair(8, 40)), Detail::contactRatio), QStringList("gearMeshes:5"));
    QCOMPARE(count(diagnosticsFor(pair(8, 40)), Detail::contactRatio, " 0."), 1);  // below 1
    QCOMPARE(count(diagnosticsFor(pair(20, 40)), Detail::contactRatio), 0);
  }

  void facesWiderThanAThirdOfTheConeDistanceAreReported() {
    test::TrainSketch sketch(2);
    sketch.axis("a", {"0", "0", "0"}).axis("b", {"0", "0", "0"}, {"1", "0", "0"});
    sketch.joint(0, 1, "a", "30").joint(0, 2, "b", "40");
    sketch.mesh(1, 2, 40, 30, MeshKind::bevel, {"40", "0", "30"});  // cone distance 50
    Mechanism mechanism = sketch.build();
    mechanism.gearMeshes.front().faceWidth = Number(16);
    QCOMPARE(count(diagnosticsFor(mechanism), Code::interference), 0);
    mechanism.gearMeshes.front().faceWidth = Number(18);
    const Diagnostics found = diagnosticsFor(mechanism);
    QCOMPARE(count(found, Detail::faceTooWide, "18.0"), 1);
    QCOMPARE(count(found, Detail::faceTooWide, "16.7"), 1);  // a third of the cone distance
    QCOMPARE(count(found, Code::interference), 1);
  }

  /// 2 a sin(pi / n) against the tips' diameter: 24 and 18 teeth leave room for five planets, not for seven.
  void planetsThatRunIntoEachOtherAreReportedOnce() {
    for (int n = 3; n <= 8; ++n) {
      const Diagnostics found = diagnosticsFor(test::planetary(24, 18, n));
      const bool meet = (24 + 18) * std::sin(pi / n) < 18 + 2;
      QVERIFY2(count(found, Detail::planetsOverlap) == (meet ? n : 0), listed(found));  // once a pair
      if (meet) QCOMPARE(count(found, Detail::planetsOverlap, " 6 "), n);               // as many would fit
    }
  }

  /// The spiders of a differential, on cones: tips of 45 + some degrees do not fit four times.
  void bevelPlanetsThatRunIntoEachOtherAreReported() {
    const auto differential = [](int spiders) {
      test::TrainSketch sketch(3 + spiders);
      sketch.axis("a", {"0", "0", "0"}, {"1", "0", "0"});
      sketch.joint(0, 1, "a", "20").joint(0, 2, "a", "-20").joint(0, 3, "a");
      for (int i = 0; i < spiders; ++i) {
        const double angle = 2 * pi * i / spiders;
        const std::string id = "s" + std::to_string(i);
        sketch.axis(id, {"0", "0", "0"}, {"0", text(std::cos(angle)), text(std::sin(angle))});
        sketch.joint(3, 4 + i, id, "20");
        for (const int side : {1, -1}) {
          sketch.mesh(side > 0 ? 1 : 2, 4 + i, 20, 20, MeshKind::bevel,
                      {text(20 * side), text(20 * std::cos(angle)), text(20 * std::sin(angle))});
        }
      }
      return sketch.build();
    };
    QCOMPARE(count(diagnosticsFor(differential(2)), Detail::planetsOverlap), 0);
    QCOMPARE(count(diagnosticsFor(differential(4)), Detail::planetsOverlap), 4);
  }

  /// An odd ring of external wheels cannot turn, but it can be put together: wherever its first wheel stands,
  /// the others follow. It is locked, not impossible to assemble.
  void lockedOddRingsCanBeAssembled() {
    for (const double turn : {0.0, 0.1, 0.7, 2.0}) {
      for (const auto& [a, b, c] : {std::tuple{20, 30, 40}, {21, 34, 27}, {17, 18, 19}}) {
        const Diagnostics found = diagnosticsFor(triangle(a, b, c, turn));
        QVERIFY2(count(found, Code::assembly) == 0, listed(found));
      }
    }
  }

  /// Two odd rings on one pair of wheels: each alone fits somewhere, both only where the places agree.
  void twoLockedRingsThatDisagreeCannotBeAssembled() {
    const auto wheel = [](double x, double y, int teeth) {
      return PhaseWheel{{x, y, 0}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), teeth};
    };
    const auto worst = [&](int teeth) {  // two equilateral triangles, one the other's mirror image
      const double height = std::sqrt(3.0) * teeth;
      const std::vector<PhaseWheel> wheels{wheel(0, 0, teeth), wheel(2 * teeth, 0, teeth),
                                           wheel(teeth, height, teeth), wheel(teeth, -height, teeth)};
      const auto touch = [&](int i, int j) {
        return PhaseMesh{i, j, 0.5 * (wheels[i].centre + wheels[j].centre)};
      };
      const std::vector<PhaseMesh> meshes{touch(0, 1), touch(1, 2), touch(2, 0), touch(1, 3), touch(3, 0)};
      double most = 0;
      for (const double r : solvePhases(wheels, meshes).residuals) most = std::max(most, std::abs(r));
      return most;
    };
    QVERIFY(worst(24) < 1e-9);  // a sixth of a turn is whole teeth
    QVERIFY(worst(20) > 0.01);
  }

  void planetsThatDoNotFitAreToldWhatDoes() {
    const Diagnostics found = diagnosticsFor(test::planetary(20, 20, 3));  // 80 / 3
    QVERIFY2(count(found, Code::assembly) == 2, listed(found));
    QCOMPARE(count(found, Code::assembly, "360/80 = 4.500 degrees"), 2);
    QCOMPARE(count(found, Code::assembly, "58 teeth and the planets 19"), 2);  // 78 / 3
    QCOMPARE(count(found, Code::assembly, "use 4 planets"), 2);
    QCOMPARE(count(diagnosticsFor(test::planetary(20, 20, 4)), Code::assembly), 0);
    QCOMPARE(count(diagnosticsFor(test::planetary(20, 19, 3)), Code::assembly), 0);
  }

  /// 46 * 41 / 3 is no whole number: the planets' gears have to be turned against each other by a third of
  /// 360 / lcm(26, 15) degrees.
  void steppedPlanetsThatHaveToDifferSayByHowMuch() {
    const Diagnostics found = diagnosticsFor(steppedSet({}, 3));
    QVERIFY2(count(found, Detail::unequalPlanets) == 1, listed(found));
    QCOMPARE(blamed(found, Detail::unequalPlanets), QStringList("links:4 links:5 links:6"));
    for (const char* part :
         {"gear with 15 teeth", "that with 26 teeth", "compared with link 4", "0.308 degrees on link 5",
          "0.308 degrees on link 6", "360/1886 = 0.191 degrees", "use 2 planets at equal distances"})
      QVERIFY2(count(found, Detail::unequalPlanets, part) == 1, listed(found));
    QCOMPARE(count(diagnosticsFor(steppedSet({}, 2)), Code::assembly), 0);
    const Diagnostics star = diagnosticsFor(steppedStar({}, 3));
    QVERIFY2(count(star, Detail::unequalPlanets, "0.308 degrees on link 4") == 1, listed(star));
    // At a multiple of 360/1886 degrees an equal planet fits.
    QCOMPARE(count(diagnosticsFor(steppedStar({}, 2, 2 * pi * 100 / 1886)), Detail::unequalPlanets), 0);
    QCOMPARE(count(diagnosticsFor(steppedStar({}, 2, 2 * pi * 100.5 / 1886)), Detail::unequalPlanets), 1);
  }

  /// The closed form, (P1 Nr + P2 Ns) / (n gcd(P1, P2)), and |P1 N2 - P2 N1| / (n gcd(P1, P2)) for two suns.
  void steppedPlanetsAreEqualByTheClosedForm() {
    int fitting = 0, misfits = 0;
    for (int planets = 2; planets <= 5; ++planets) {
      for (int sun = 17; sun <= 22; ++sun) {
        for (int planet = 18; planet <= 30; planet += 3) {
          for (const int other : {14, 15, 17}) {
            const auto isEqual = [&](int places) { return places % planets == 0; };
            const auto judge = [&](const Mechanism& set, int places) {
              const Diagnostics found = diagnosticsFor(set);
              const bool fits = isEqual(places / std::gcd(planet, other));
              QVERIFY2(count(found, Detail::unequalPlanets) == (fits ? 0 : 1),
                       listed(found) + QByteArray::number(places));
              ++(fits ? fitting : misfits);
            };
            const int ring = sun + planet + other;  // one module
            judge(steppedSet({sun, planet, other, ring}, planets), planet * ring + other * sun);
            const int second = sun + planet - other;
            judge(steppedSet({sun, planet, other, second}, planets, MeshKind::external),
                  std::abs(planet * second - other * sun));
          }
        }
      }
    }
    QVERIFY2(fitting > 100 && misfits > 100, qPrintable(QString("%1 %2").arg(fitting).arg(misfits)));
  }

  /// Humpage's gear with two planets of 56 and 24 teeth: 168 |76/56 - 35/24| = 17 places for these gears, 96
  /// for the sun of 20 and the fixed wheel of 76, so that two equal planets fit nowhere.
  void bevelPlanetsThatFitNowhereElseAreNotToldToMove() {
    test::TrainSketch sketch(5);
    sketch.axis("a", {"0", "0", "0"});
    sketch.axis("b", {"0", "0", "0"}, {"0", text(std::sqrt(0.75)), "0.5"});
    sketch.axis("c", {"0", "0", "0"}, {"0", text(-std::sqrt(0.75)), "0.5"});
    sketch.joint(0, 1, "a", "90").joint(0, 2, "a").joint(2, 3, "b", "60").joint(2, 5, "c", "60");
    sketch.joint(0, 4, "a", "-60");
    for (const int planet : {3, 5}) {
      const auto at = [&](double y, double z) -> std::vector<std::string> {
        return {"0", text(planet == 3 ? y : -y), text(z)};
      };
      sketch.mesh(1, planet, 20, 56, MeshKind::bevel, at(20, 76.210236));
      sketch.mesh(0, planet, 76, 56, MeshKind::bevel, at(76, -20.78461));
      sketch.mesh(planet, 4, 24, 35, MeshKind::bevel, at(35, -7.505553));
    }
    const Diagnostics found = diagnosticsFor(sketch.build());
    QVERIFY2(count(found, Detail::unequalPlanets, "1.071 degrees on link 5") == 1, listed(found));
    QCOMPARE(count(found, Detail::unequalPlanets, "fewer places for equal planets (1)"), 1);
    QCOMPARE(count(found, Detail::unequalPlanets, "move the axis"), 0);
  }

  /// A group of two planets that mesh: (30 * 100 - 18 * 20) / gcd(30, 18) = 440 places.
  void meshingSteppedPlanetsAreChecked() {
    for (const int groups : {2, 4, 5}) {
      const Diagnostics found = diagnosticsFor(meshingSteppedPlanets(groups));
      QVERIFY2(count(found, Detail::unequalPlanets) == 0, listed(found));
    }
    const Diagnostics found = diagnosticsFor(meshingSteppedPlanets(3));
    QVERIFY2(count(found, Detail::unequalPlanets, "360/440") == 1, listed(found));
    QCOMPARE(blamed(found, Detail::unequalPlanets), QStringList("links:4 links:6 links:8"));
  }

  /// A rectangle of wheels (core/machine/teeth/README.md, section 4): 15 teeth close the loop, 16 miss by a
  /// quarter of a pitch.
  void aRectangleOfWheelsMissesByTheClosedForm() {
    const auto residual = [](int last) {
      const std::vector<int> teeth{25, 35, 45, last};
      const std::vector<Eigen::Vector3d> corners{{0, 0, 0}, {60, 0, 0}, {60, 70, 0}, {0, 70, 0}};
      std::vector<PhaseWheel> wheels;
      std::vector<PhaseMesh> meshes;
      for (int i = 0; i < 4; ++i) {
        wheels.push_back({corners[i], Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), teeth[i]});
        meshes.push_back({i, (i + 1) % 4, 0.5 * (corners[i] + corners[(i + 1) % 4])});
      }
      double most = 0;
      for (const double r : solvePhases(wheels, meshes).residuals) most = std::max(most, std::abs(r));
      return most;
    };
    QVERIFY(residual(15) < 1e-9);
    QVERIFY(std::abs(residual(16) - 0.25) < 1e-9);
  }

  /// A square of 21, 30, 21 and 30 teeth misses by half a pitch; what is proposed fits on the same axes.
  void aSquareOfWheelsProposesToothCountsThatFit() {
    const std::vector<std::pair<double, double>> corners{{0, 0}, {51, 0}, {51, 51}, {0, 51}};
    const Diagnostics found = diagnosticsFor(ring({21, 30, 21, 30}, corners));
    QVERIFY2(count(found, Code::assembly, "0.500 of a pitch") == 1, listed(found));
    QVERIFY2(count(found, Code::assembly, "19 instead of 21 teeth") == 1, listed(found));
    QVERIFY2(count(found, Code::assembly, "28 instead of 30 teeth") == 1, listed(found));
    for (const std::vector<int>& teeth : {std::vector{19, 30, 21, 30}, {21, 28, 21, 30}}) {
      QCOMPARE(count(diagnosticsFor(ring(teeth, corners)), Code::assembly), 0);
    }
    QCOMPARE(count(diagnosticsFor(ring({20, 30, 21, 30}, corners)), Code::assembly), 1);
  }

  void gearsWithoutAToothFormAreReported() {
    const Diagnostics found = diagnosticsFor(pair(2, 40));
    QVERIFY2(count(found, Detail::noToothForm) == 1, listed(found));
    QVERIFY(!gearSolid(standardGear(GearKind::external, 2, 1, 1), 0.01).has_value());
  }

  /// Tips that collide outside of the mesh: 54 teeth in a ring of 60; and tips of a ring that a small pinion
  /// shortens.
  void internalPairsWithCloseToothCountsInterfere() {
    QCOMPARE(blamed(diagnosticsFor(pair(54, 60, MeshKind::internal)), Detail::tipInterference),
             QStringList("gearMeshes:5"));
    QCOMPARE(count(diagnosticsFor(pair(30, 60, MeshKind::internal)), Detail::tipInterference), 0);
    QCOMPARE(blamed(diagnosticsFor(pair(12, 60, MeshKind::internal)), Detail::ringTipsLowered),
             QStringList("gearMeshes:5"));
    QCOMPARE(count(diagnosticsFor(pair(30, 60, MeshKind::internal)), Detail::ringTipsLowered), 0);
  }

  void pointedTeethAreReported() {
    Mechanism shifted = pair(12, 40);
    shifted.wheels.push_back({WheelId("w"), LinkId("1"), Number::fromText("0.9"), {}, {}, {}});
    shifted.gearMeshes.front().tailWheel = WheelId("w");
    QCOMPARE(blamed(diagnosticsFor(shifted), Detail::pointedTeeth),
             QStringList("gearMeshes:5 links:1 wheels:w"));
    QCOMPARE(count(diagnosticsFor(pair(12, 40)), Detail::pointedTeeth), 0);
  }

  /// The pitch points of two links on one axis put their wheels into each other, and each into the other's
  /// partner.
  void overlappingWheelsAreReported() {
    test::TrainSketch sketch(4);
    sketch.axis("a", {"0", "0", "0"}).axis("b", {"40", "0", "0"}).axis("c", {"0", "40", "0"});
    sketch.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "b").joint(0, 4, "c");
    sketch.mesh(1, 3, 20, 20, MeshKind::external, {"20", "0", "0"});
    sketch.mesh(2, 4, 20, 20, MeshKind::external, {"0", "20", "0"});
    const Mechanism mechanism = sketch.build();
    const Diagnostics found = diagnosticsFor(mechanism);
    QStringList pairs = blamed(found, Detail::wheelsOverlap);
    pairs.sort();
    QCOMPARE(pairs, (QStringList{"links:1 links:2", "links:1 links:4", "links:3 links:2"}));
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(trainDiagnostics(mechanism, placementOf(mechanism), stop.get_token()).empty());
  }

  /// Advice is only what the document does not do already: random trains leave their pitch points open.
  void overlapsOfOpenPlacesAreNotAdvisedToBeLeftOpen() {
    int overlaps = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const Diagnostics found = diagnosticsFor(test::randomTrain(seed, 9, 6));
      overlaps += count(found, Detail::wheelsOverlap) + count(found, Detail::bodiesOverlap);
      QVERIFY2(count(found, Code::interference, "open") == 0, listed(found));
    }
    QVERIFY(overlaps > 0);
  }

  void oneToothIsTooFew() {
    const Diagnostics found = diagnosticsFor(pair(1, 40));
    QVERIFY2(count(found, Detail::noToothForm, "One tooth is too few") == 1, listed(found));
    QCOMPARE(count(found, Detail::noToothForm, "module"), 0);
  }

  /// A shaft with wheels at both ends lies across another wheel.
  void bodiesWithoutARouteAreReported() {
    test::TrainSketch sketch(4);
    sketch.axis("a", {"0", "0", "0"}).axis("b", {"0", "-40", "0"});
    sketch.axis("c", {"0", "5", "0"}, {"1", "0", "0"}).axis("d", {"0", "45", "0"}, {"1", "0", "0"});
    sketch.joint(0, 1, "a").joint(0, 2, "c").joint(0, 3, "b").joint(0, 4, "d");
    sketch.mesh(1, 3, 20, 20, MeshKind::external, {"0", "-20", "0"});
    sketch.mesh(2, 4, 20, 20, MeshKind::external, {"40", "25", "0"});
    sketch.mesh(2, 4, 20, 20, MeshKind::external, {"-40", "25", "0"});
    const Mechanism mechanism = sketch.build();
    const Diagnostics found = diagnosticsFor(mechanism);
    QCOMPARE(blamed(found, Detail::bodiesOverlap), QStringList("links:1 links:2"));
  }

  /// A default has to fit: the robot's bevels become shorter where their wheels would stand in each other.
  /// What somebody states stays, and is said.
  void onlyStatedFacesOfBevelsCollide() {
    Mechanism robot = test::robot();
    const auto trainNow = [&] { return trainOf(robot, placementOf(robot)); };
    const auto faceOf = [&](const char* name) {
      for (const TrainGear& gear : trainNow().gears) {
        if (gear.name == name) return gear.spec.faceWidth;
      }
      return 0.0;
    };
    QVERIFY2(diagnosticsFor(robot).empty(), listed(diagnosticsFor(robot)));
    QVERIFY(faceOf("16:head") < 11 && faceOf("16:head") > 4);
    QVERIFY(std::abs(faceOf("16:tail") - faceOf("16:head")) < 1e-6);
    for (const auto& [name, radius, height] : {std::tuple{"17:tail", 18, 24}, {"18:tail", 16, 24}})
      QVERIFY(std::abs(faceOf(name) - std::hypot(radius, height) / 3) < 1e-6);
    for (const std::size_t mesh : {1, 2}) robot.gearMeshes[mesh].faceWidth = Number(11);
    const Diagnostics found = diagnosticsFor(robot);
    QVERIFY2(count(found, Detail::wheelsOverlap) > 0, listed(found));
    QCOMPARE(faceOf("16:head"), 11.0);
  }

  /// The same train in finer and finer teeth has the same wheels that stand in each other: what is looked at
  /// of them does not grow with the teeth.
  void bevelsOfManyTeethAreComparedToo() {
    for (const int factor : {1, 20, 500, 5000}) {
      Mechanism robot = test::robot();
      for (GearMesh& mesh : robot.gearMeshes) {
        mesh.tailTeeth *= factor;
        mesh.headTeeth *= factor;
      }
      for (const std::size_t mesh : {1, 2}) robot.gearMeshes[mesh].faceWidth = Number(11);
      const Diagnostics found = diagnosticsFor(robot);
      QVERIFY2(count(found, Code::interference, "do not mesh. Use smaller face widths") > 0, listed(found));
    }
  }

  /// One wheel far from all others: the ways of sleeves to it are sought on a grid that stays as small.
  void wheelsFarAwayOnTheirAxisEndTheSearch() {
    for (const double far : {1e6, 1e9, 1e12, 1e15, 1e17}) {
      Mechanism simpson = test::example("simpson");
      (*simpson.gearMeshes.front().pitchPoint)[2] = Number::fromDouble(far);
      QVERIFY(!diagnosticsFor(simpson).empty());
    }
  }

  void aSoundTrainHasNoDiagnostics() {
    QVERIFY(diagnosticsFor(pair(20, 40)).empty());
    QVERIFY(diagnosticsFor(test::planetary(20, 19, 3)).empty());
  }
};

QTEST_APPLESS_MAIN(TrainDiagnosticsTest)
#include "test_train_diagnostics.moc"
