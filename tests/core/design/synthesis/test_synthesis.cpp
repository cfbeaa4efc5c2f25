#include <QTest>

#include "core/design/synthesis/bevel_sets.h"
#include "core/design/synthesis/insertion.h"
#include "core/design/synthesis/planets.h"
#include "core/design/synthesis/reverted_train.h"
#include "core/design/synthesis/shifting_sets.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/machine/teeth/phase.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/states/state_solution.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/pseudo_language.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

bool isAboutBodies(const Diagnostic& diagnostic) {
  return diagnostic.detail == Detail::bodiesOverlap;
}

/// Everything a set has to be: well formed, a tree, placed without diagnostics, teeth in phase, of this rank.
/// `crowded`: bodies may find no way past each other, which is said.
bool isSound(const Mechanism& set, int rank, bool crowded = false) {
  if (!wellFormedDiagnostics(set).empty() || !treeDiagnostics(set).empty()) return false;
  const Worked worked(set);
  const GearTrain train = trainOf(set, worked.placement);
  Diagnostics found = trainDiagnostics(set, worked.placement);
  if (crowded) std::erase_if(found, isAboutBodies);
  for (const Diagnostic& diagnostic : worked.placement.diagnostics)
    qWarning("%s", diagnostic.message.c_str());
  for (const Diagnostic& diagnostic : found) qWarning("%s", diagnostic.message.c_str());
  for (const TrainMesh& mesh : train.meshes) {
    if (std::abs(mesh.residual) > kPhaseFits) return false;
  }
  return worked.placement.diagnostics.empty() && found.empty() && worked.analysis.rank == rank &&
         worked.analysis.solution.has_value();
}

std::vector<Rational> ratesOf(const Mechanism& mechanism) {
  const Worked worked(mechanism);
  return solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds)->rates;
}

std::vector<Rational> ratiosOf(const Mechanism& mechanism) {
  const Worked worked(mechanism);
  const auto states = solveStates(worked.mechanism, worked.model, worked.placement);
  std::vector<Rational> ratios;
  for (const StateSolution& state : *states) ratios.push_back(state.ratio.value_or(0));
  return ratios;
}

}  // namespace

class SynthesisTest : public QObject {
  Q_OBJECT

 private slots:
  void planetaryRatiosAreWillis() {
    using enum PlanetaryMember;
    const PlanetaryTeeth teeth{24, 18};
    QCOMPARE(teeth.ring(), 60);
    QCOMPARE(planetaryRatio(teeth, sun, carrier), Rational(84, 24));   // ring held: 1 + ring/sun
    QCOMPARE(planetaryRatio(teeth, ring, carrier), Rational(84, 60));  // sun held: 1 + sun/ring
    QCOMPARE(planetaryRatio(teeth, sun, ring), Rational(-60, 24));     // carrier held
    const Mechanism set = planetarySet(teeth, 3);
    QCOMPARE(ratesOf(set)[2], Rational(24, 84));  // the carrier, the sun at 1
  }

  /// Names of what is inserted are in the current language; ids, which files and scripts read, are not.
  void namesOfSetsAreTranslated() {
    const auto all = [] {
      using enum PlanetaryMember;
      const PlanetaryTeeth teeth{24, 18};
      return std::vector<Mechanism>{planetarySet(teeth, 1),
                                    planetarySet(teeth, 3),
                                    planetarySet(teeth, 3, PlanetaryUse{sun, carrier}),
                                    *bevelDifferentialSet(20, 12, 1),
                                    *bevelDifferentialSet(20, 12, 2),
                                    bevelWrist({}),
                                    revertedTrain({20, 40, 18, 42}),
                                    *ravigneauxSet({}, 3),
                                    *simpsonSet(teeth, 3)};
    };
    const std::vector<Mechanism> english = all();
    QCOMPARE(english[1].links[3].name, std::string("carrier"));
    QCOMPARE(english[1].links[5].name, std::string("planet 2"));
    QCOMPARE(english[0].links[4].name, std::string("planet"));
    QCOMPARE(english.back().links.back().name, std::string("second planet 3"));
    std::vector<Mechanism> translated;
    {
      const PseudoLanguage pseudo;
      translated = all();
    }
    for (std::size_t i = 0; i < english.size(); ++i) {
      QCOMPARE(translated[i].name, PseudoLanguage::accented(english[i].name));
      for (std::size_t link = 1; link < english[i].links.size(); ++link) {  // 0: the document's ground
        Link& there = translated[i].links[link];
        QCOMPARE(there.name, PseudoLanguage::accented(english[i].links[link].name));
        there.name = english[i].links[link].name;
      }
      translated[i].name = english[i].name;
      QVERIFY(translated[i] == english[i]);
    }
  }

  void everyUseOfAPlanetarySetHasItsRatio() {
    using enum PlanetaryMember;
    const PlanetaryTeeth teeth{24, 18};
    const std::map<PlanetaryMember, std::string> names{{sun, "sun"}, {ring, "ring"}, {carrier, "carrier"}};
    int uses = 0;
    for (const PlanetaryMember drive : {sun, ring, carrier}) {
      for (const PlanetaryMember driven : {sun, ring, carrier}) {
        if (drive == driven) continue;
        for (const PlanetaryHolding holding : {PlanetaryHolding::brake, PlanetaryHolding::ground}) {
          const bool isCut = holding == PlanetaryHolding::ground;
          const Mechanism set =
              withInserted(emptyMechanism(), planetarySet(teeth, 3, {drive, driven, holding}), {0, 0});
          QVERIFY(wellFormedDiagnostics(set).empty() && treeDiagnostics(set).empty());
          QCOMPARE(set.n(), isCut ? 5 : 6);
          QCOMPARE(set.engaged.size(), std::size_t(isCut ? 0 : 1));
          const SnapshotPtr live = analyze(std::make_shared<const Mechanism>(set));
          QVERIFY(live->matroid() != nullptr && live->matroid()->solution);
          QCOMPARE(live->matroid()->dof, 1);
          const auto jointOf = [&](PlanetaryMember member) {
            for (int joint = 0; joint < set.t(); ++joint) {
              const LinkId& head = set.turningJoints[static_cast<std::size_t>(joint)].head;
              if (set.find(head)->name == names.at(member)) return joint;
            }
            return -1;
          };
          QCOMPARE(live->matroid()->choice.joints, std::vector<int>{jointOf(drive)});
          const auto exact =
              solveExact(*live->kinematics->model, live->matroid()->choice.joints, live->matroid()->speeds);
          const Rational& turns = exact->rates.at(static_cast<std::size_t>(jointOf(driven)));
          QCOMPARE(turns * planetaryRatio(teeth, drive, driven), Rational(1));
          ++uses;
        }
      }
    }
    QCOMPARE(uses, 12);
  }

  void aSetGoesInWithItsBrakeEngaged() {
    const Mechanism set = planetarySet({24, 18}, 3, PlanetaryUse{});
    const Mechanism both = withInserted(withInserted(emptyMechanism(), set, {0, 0}), set, {500, 0});
    QVERIFY(wellFormedDiagnostics(both).empty());
    QCOMPARE(both.couplings.size(), std::size_t(2));
    QCOMPARE(both.engaged, (std::vector<ShiftElementId>{both.couplings[0].id, both.couplings[1].id}));
  }

  void planetaryChoicesAssembleAndClearAndComeNear() {
    PlanetaryRequirements requirements;
    requirements.ratio = Rational(4);
    requirements.planets = 4;
    const auto choices = planetaryChoices(requirements);
    QVERIFY(!choices.empty());
    QCOMPARE(choices[0].ratio, Rational(4));
    for (std::size_t i = 0; i < choices.size(); ++i) {
      const PlanetaryTeeth& teeth = choices[i].teeth;
      QVERIFY(assembles(teeth, 4) && neighboursClear(teeth, 4));
      QVERIFY(teeth.sun >= 17 && teeth.planet >= 17 && teeth.ring() <= 120);
      QVERIFY(i == 0 || choices[i - 1].error <= choices[i].error);
      QCOMPARE(choices[i].ratio, planetaryRatio(teeth, requirements.drive, requirements.driven));
    }
    requirements.ratio = Rational(-4);  // sun to carrier never reverses
    QVERIFY(planetaryChoices(requirements).empty());
    requirements.driven = PlanetaryMember::ring;
    QVERIFY(!planetaryChoices(requirements).empty());
  }

  void everyPlanetarySetIsInPhase() {
    for (int planets = 1; planets <= 5; ++planets) {
      PlanetaryRequirements requirements;
      requirements.planets = planets;
      const auto choices = planetaryChoices(requirements, 3);
      QVERIFY(!choices.empty());
      for (const PlanetaryChoice& choice : choices)
        QVERIFY(isSound(planetarySet(choice.teeth, planets), planets + 1));
    }
    QVERIFY(!neighboursClear({20, 40}, 5));
    QVERIFY(!assembles({20, 17}, 3));
  }

  void revertedTrainsComeNearestToTheRequirements() {
    RevertedRequirements requirements;
    requirements.ratio = Rational(355, 113);  // pi
    requirements.mostTeeth = 60;
    const auto choices = revertedChoices(requirements);
    // Against all there are.
    double best = 1;
    for (int sum = 34; sum <= 120; ++sum) {
      for (int first = 17; first <= 60; ++first) {
        for (int third = 17; third <= 60; ++third) {
          const int second = sum - first, fourth = sum - third;
          if (std::min(second, fourth) < 17 || std::max(second, fourth) > 60) continue;
          const double ratio = static_cast<double>(second) * fourth / (first * third);
          best =
              std::min(best, std::abs(ratio - requirements.ratio.toDouble()) / requirements.ratio.toDouble());
        }
      }
    }
    QVERIFY(std::abs(choices[0].error - best) < 1e-12);
    for (const RevertedChoice& choice : choices) {
      const RevertedTeeth& teeth = choice.teeth;
      QCOMPARE(teeth.first + teeth.second, teeth.third + teeth.fourth);
      QCOMPARE(choice.ratio, teeth.ratio());
    }
    const Mechanism train = revertedTrain(choices[0].teeth);
    QVERIFY(isSound(train, 2));
    QCOMPARE(ratesOf(train)[2].inverse(), choices[0].ratio);
    requirements.ratio = Rational(-2);
    QVERIFY(revertedChoices(requirements).empty());
  }

  void theBevelDifferentialSharesTheCasesSpeed() {
    for (int pinions = 1; pinions <= 4; ++pinions) {
      const Mechanism set = *bevelDifferentialSet(24, 18, pinions);
      QVERIFY(isSound(set, pinions + 1));
      QCOMPARE(ratesOf(set)[1] + ratesOf(set)[2], Rational(2));  // the case at 1
    }
    QCOMPARE(bevelDifferentialSet(20, 16, 3).error()[0].code, Code::assembly);
  }

  void theRavigneauxSetHasItsFourStates() {
    for (const int pairs : {1, 3}) {
      const Mechanism set = *ravigneauxSet({}, pairs);
      QVERIFY(isSound(set, 2 + 2 * pairs));
      QCOMPARE(ratiosOf(set), (std::vector<Rational>{{12, 5}, {22, 15}, 1, -2}));
    }
    const Mechanism three = *ravigneauxSet({}, 3);
    QCOMPARE(trainOf(three, placementOf(three)).gears.size(), std::size_t{9});  // long planets are one wheel
    QCOMPARE(ravigneauxSet({34, 36, 20, 18}, 1).error()[0].code,
             Code::teethGeometry);  // 4 teeth or more apart
    QVERIFY(ravigneauxSet({32, 36, 20, 18}, 1).has_value());
    QCOMPARE(ravigneauxSet({31, 36, 20, 18}, 3).error()[0].code, Code::assembly);
    QCOMPARE(ravigneauxSet({30, 90, 20, 18}, 1).error()[0].code, Code::teethGeometry);
    QCOMPARE(ravigneauxSet({}, 6).error()[0].code, Code::teethGeometry);
  }

  void theSimpsonSetHasItsFourStates() {
    for (const int planets : {1, 3}) {
      const Mechanism set = *simpsonSet({33, 21}, planets);
      QVERIFY(isSound(set, 2 + 2 * planets));
      QCOMPARE(ratiosOf(set), (std::vector<Rational>{{61, 25}, {36, 25}, 1, {-25, 11}}));
    }
    QCOMPARE(simpsonSet({33, 20}, 3).error()[0].code, Code::assembly);
  }

  void theBevelWristTurnsAsItsFormulasSay() {
    Mechanism wrist = bevelWrist({});
    QVERIFY(isSound(wrist, 3));
    (*wrist.inputs)[0].speed = Number(1);
    (*wrist.inputs)[1].speed = Number(4);
    (*wrist.inputs)[2].speed = Number(-3);
    const auto rates = ratesOf(wrist);
    QCOMPARE(rates[2], Rational(-2));     // -(20/30)(4 - 1)
    QCOMPARE(rates[4], Rational(-5, 2));  // (25/40)(-3 - 1)
    QCOMPARE(rates[5], Rational(2, 3));   // -(24/18)(-5/2 + 2)
  }

  void aSetGoesIntoADocumentBesideWhatIsThere() {
    const Mechanism first = withInserted(emptyMechanism(), planetarySet({24, 18}, 3), {100, 100});
    QCOMPARE(first.n(), 6);
    QCOMPARE(first.name, std::string("Planetary set"));
    QVERIFY(isSound(first, 4));
    Mechanism both = first;
    for (const Mechanism& set :
         {*simpsonSet({33, 21}, 1), *ravigneauxSet({}, 1), bevelWrist({}), *simpsonSet({33, 21}, 1)}) {
      const int before = both.n();
      both = withInserted(both, set, freePlace(both));
      QCOMPARE(both.n(), before + set.n());
      QVERIFY(wellFormedDiagnostics(both).empty());
    }
    // The plates of the ground between the sets run into the fork of the wrist.
    QVERIFY(isSound(both, 4 + 4 + 4 + 3 + 4, true));
    QCOMPARE(both.states.size(), std::size_t(12));
    QCOMPARE(both.states[4].name, std::string("1.2"));
    QCOMPARE(both.name, std::string("Planetary set"));
  }

  void aDrawnPlanetGetsCompanions() {
    const Mechanism open = withInserted(emptyMechanism(), planetarySet({24, 18}, 1), {0, 0});
    const Mechanism three = *withPlanets(open, open.links[4].id, 3);
    QCOMPARE(three.n(), 6);
    QVERIFY(isSound(three, 4));
    const auto five = withPlanets(open, open.links[4].id, 5);  // 84 / 5
    QVERIFY(!five);
    QCOMPARE(five.error()[0].code, Code::assembly);
    QVERIFY(!withPlanets(open, open.links[3].id, 3));  // the carrier
    QVERIFY(!withPlanets(open, open.links[1].id, 3));  // the sun
  }

  void companionsOfAStatedPlanetAreTurnedRound() {
    TrainBuilder train("stated");
    const int a = train.axis({5, 0, 0}, {0, 0, 1});
    const int b = train.axis({47, 0, 0}, {0, 0, 1});
    const int sun = train.link(0, a);
    const int ring = train.link(0, a);
    const int carrier = train.link(0, a);
    const int planet = train.link(carrier, b);
    train.external(sun, a, 24, planet, b, 18);
    train.internal(planet, b, 18, ring, a, 60);
    train.input(0);
    train.input(1, 0);
    const Mechanism three = *withPlanets(train.mechanism(), train.mechanism().links[4].id, 3);
    QVERIFY(isSound(three, 4));
    QCOMPARE((*three.axes[2].point)[0].value(), -16.0);
    const Mechanism two = *withPlanets(bevelDifferentialSet(24, 18, 1).value(), LinkId("4"), 2);
    QVERIFY(isSound(two, 3));
  }
};

QTEST_APPLESS_MAIN(SynthesisTest)
#include "test_synthesis.moc"
