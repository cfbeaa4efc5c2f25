#include <QTest>
#include <cmath>
#include <set>

#include "core/design/synthesis/planetary_set.h"
#include "core/design/synthesis/planets.h"
#include "core/design/synthesis/reverted_train.h"
#include "core/design/synthesis/set_sketch.h"
#include "core/design/synthesis/shifting_sets.h"
#include "core/design/teeth_check/teeth_check.h"
#include "core/design/teeth_search/meant_teeth.h"
#include "core/design/teeth_search/teeth_certificate.h"
#include "core/design/teeth_search/teeth_json.h"
#include "core/machine/train/toothed_train.h"
#include "core/machine/train/train_diagnostics.h"
#include "core/mechanism/model/pins.h"

using namespace geargraph;

namespace {

/// Sun 1, ring 2, ring 3, carrier 4, planets 5..: each planet has a gear between sun and ring 2, and one in
/// ring 3.
Mechanism twoRings(int sun, int planet, int other, int planets) {
  SetSketch set("two rings");
  const int sunLink = set.link(0, "a", "sun");
  const int ring = set.link(0, "a", "ring");
  const int otherRing = set.link(0, "a", "other ring");
  const LinkOrdinal carrier = set.link(0, "a", "carrier");
  for (int i = 0; i < planets; ++i) {
    const int link = set.link(carrier, "b" + std::to_string(i), "planet");
    const WheelId one = set.wheel("p" + std::to_string(i), link);
    const WheelId second = set.wheel("q" + std::to_string(i), link);
    set.mesh(sunLink, link, sun, planet, MeshKind::external).headWheel = one;
    set.mesh(link, ring, planet, sun + 2 * planet, MeshKind::internal).tailWheel = one;
    set.mesh(link, otherRing, other, sun + planet + other, MeshKind::internal).tailWheel = second;
  }
  set.brake("A", ring);
  set.state("1", {"A"}, sunLink, otherRing);
  return std::move(set).build();
}

/// Two pairs on three axes: no centre distance is shared.
Mechanism twoPairs() {
  SetSketch set("two pairs");
  const int input = set.link(0, "a", "input");
  const int counter = set.link(0, "b", "countershaft");
  const int output = set.link(0, "c", "output");
  set.mesh(input, counter, 20, 50, MeshKind::external);
  set.mesh(counter, output, 21, 60, MeshKind::external);
  return std::move(set).build();
}

/// A pair at its standard distance, without profile shifts; degrees.
Mechanism spurPairOf(int tail, int head, int angle, int helix) {
  SetSketch set("pair");
  const int input = set.link(0, "a", "input");
  const int output = set.link(0, "b", "output");
  GearMesh& mesh = set.mesh(input, output, tail, head, MeshKind::external);
  if (helix != 0) mesh.helixAngle = Number(helix);
  Mechanism train = std::move(set).build();
  train.gearDefaults.emplace();
  train.gearDefaults->pressureAngle = Number(angle);
  return train;
}

TeethWish wishFor(const Mechanism& mechanism, const std::string& json) {
  auto wish = readTeethWish(json, mechanism);
  if (!wish)
    for (const Diagnostic& each : wish.error()) qWarning("%s %s", each.pointer.c_str(), each.message.c_str());
  return *std::move(wish);
}

TeethAnswer answerFor(const Mechanism& mechanism, const std::string& json, std::size_t most = 20) {
  TeethSearchOptions options;
  options.most = most;
  auto answer = teethFor(mechanism, wishFor(mechanism, json), options);
  if (!answer)
    for (const Diagnostic& each : answer.error()) qWarning("%s", each.message.c_str());
  return *std::move(answer);
}

constexpr const char* kTwoRingWish =
    R"({"ratios": [{"state": "1", "ratio": "64", "tolerance": "1/200"}],
        "fewest": 17, "most": 60, "mostRing": 120, "planets": 3,
        "efficiency": {"mesh": 0.98}})";

constexpr const char* kTwoPairWish =
    R"({"ratios": [{"drive": "3", "driven": "1", "ratio": "1000/6931", "tolerance": "1/1000"}],
        "fewest": 12, "most": 60})";

std::vector<std::string> pointersOf(const Mechanism& mechanism, const std::string& json) {
  const auto wish = readTeethWish(json, mechanism);
  std::vector<std::string> pointers;
  if (!wish)
    for (const Diagnostic& each : wish.error()) pointers.push_back(each.pointer);
  return pointers;
}

}  // namespace

class TeethSearchTest : public QObject {
  Q_OBJECT

 private slots:
  /// The reducer of ratio 64: every filter in its order, as counted by three plain loops.
  void countsOfATwoRingReducer() {
    const TeethAnswer answer = answerFor(twoRings(24, 30, 26, 3), kTwoRingWish);
    QVERIFY(answer.found.isComplete);
    const TeethCounts& counts = answer.found.counts;
    QCOMPARE(counts.tried, std::int64_t{38'997});
    QCOMPARE(counts.turns, std::int64_t{37'919});
    QCOMPARE(counts.clears, std::int64_t{30'372});
    QCOMPARE(counts.assembles, std::int64_t{10'112});
    QCOMPARE(counts.accepted, std::int64_t{12});
    QCOMPARE(answer.choices.size(), std::size_t{12});
    QCOMPARE(answer.choices[0].found.ratios[0], Rational(64));
    QVERIFY(answer.choices[2].found.error.isZero() && !answer.choices[3].found.error.isZero());
    const std::vector<MeshTeeth>& best = answer.choices[0].teeth;
    QCOMPARE(best[0].tailTeeth, 17);
    QCOMPARE(best[0].headTeeth, 34);
    QCOMPARE(best[1].headTeeth, 85);
    QCOMPARE(best[2].tailTeeth, 29);
    QCOMPARE(best[2].headTeeth, 80);
    QCOMPARE(answer.choices[0].planets, (std::vector<int>{3}));
    QCOMPARE(answer.choices[1].planets, (std::vector<int>{2, 3}));
    QCOMPARE(answer.choices[0].undercut, (std::vector<std::string>{answer.problem->wheels[0].name}));
    std::int64_t branches = 0;
    for (const TeethBranch& branch : answer.found.branches) branches += branch.counts.tried;
    QCOMPARE(branches, counts.tried);
  }

  /// One planet is drawn, three are asked for: the same train.
  void drawnCopiesChangeNothing() {
    const TeethAnswer one = answerFor(twoRings(24, 30, 26, 1), kTwoRingWish);
    QCOMPARE(one.found.counts.assembles, std::int64_t{10'112});
    QCOMPARE(one.found.counts.accepted, std::int64_t{12});
  }

  /// Every ratio is that of the states' own elimination.
  void ratiosAreThoseOfTheStates() {
    const Mechanism ravigneaux = *ravigneauxSet({}, 1);
    const TeethAnswer answer = answerFor(
        ravigneaux,
        R"({"ratios": [{"state": "1", "between": ["2", "3"]}, {"state": "2", "between": ["1.2", "2"]}],
                       "fewest": 17, "most": 40, "mostRing": 90, "planets": 3})");
    QVERIFY(answer.found.counts.accepted > 0);
    for (const TeethChoice& choice : answer.choices) {
      for (std::size_t ratio = 0; ratio < 2; ++ratio)
        QCOMPARE(*solvedRatio(*answer.problem, ratio, choice.found.teeth), choice.found.ratios[ratio]);
    }
  }

  /// Against the phases of the drawn teeth: three planets are put in, or rejected.
  void assemblyIsThatOfTheTeeth() {
    int going = 0, rejected = 0;
    for (int sun = 18; sun <= 24; ++sun) {
      for (int planet = 20; planet <= 22; ++planet) {
        for (int other = 18; other <= 20; ++other) {
          const Mechanism drawn = twoRings(sun, planet, other, 1);
          const auto problem = teethProblemOf(drawn, wishFor(drawn, kTwoRingWish));
          std::vector<int> teeth;
          for (const SearchedWheel& wheel : problem->wheels) teeth.push_back(wheel.drawn);
          const bool goesIn = problem->planets.front().assembles(teeth, 3);
          (goesIn ? going : rejected) += 1;
          QCOMPARE(goesIn, withPlanets(drawn, drawn.links[5].id, 3).has_value());
        }
      }
    }
    QVERIFY(going > 5 && rejected > 5);
  }

  /// Sandgren's gear train: 1/6.931 with 12 to 60 teeth.
  void gearTrainOfSandgren() {
    const TeethAnswer answer = answerFor(twoPairs(), kTwoPairWish);
    QVERIFY(answer.found.isComplete);
    QCOMPARE(answer.found.counts.tried, std::int64_t{49} * 49 * 49 * 49);
    const Rational best = answer.choices.front().found.ratios[0];
    QCOMPARE(best, Rational(304, 2107));
    const Rational error = best - Rational(1000, 6931);
    // As published, from doubles: its last digit is lost.
    QVERIFY(std::abs((error * error).toDouble() / 2.70085714883e-12 - 1) < 1e-10);
    std::int64_t within = 0;
    for (std::int64_t a = 12; a <= 60; ++a) {
      for (std::int64_t b = 12; b <= 60; ++b) {
        for (std::int64_t c = 12; c <= 60; ++c) {
          for (std::int64_t d = 12; d <= 60; ++d) {
            // |a b / (c d) - 1000/6931| <= 1/6931
            const std::int64_t apart = 6931 * a * b - 1000 * c * d;
            if (apart <= c * d && -apart <= c * d) ++within;
          }
        }
      }
    }
    QCOMPARE(answer.found.counts.accepted, within);
  }

  /// The going train of a clock with two outputs that share its first pair, from a drawer of wheels: as
  /// counted by six plain loops.
  void aClockWithTwoOutputs() {
    SetSketch set("clock");
    const int barrel = set.link(0, "a", "barrel");
    const int minutes = set.link(0, "b", "minutes");
    const int third = set.link(0, "c", "third");
    const int seconds = set.link(0, "d", "seconds");
    set.mesh(barrel, minutes, 80, 10, MeshKind::external);
    set.mesh(minutes, third, 75, 12, MeshKind::external);
    set.mesh(third, seconds, 72, 8, MeshKind::external);
    const TeethAnswer answer = answerFor(
        std::move(set).build(),
        R"({"ratios": [{"drive": "1", "driven": "2", "ratio": "-1/8"}, {"drive": "1", "driven": "4", "ratio": "-1/480"}],
            "fewest": 1, "wheels": [8, 10, 12, 60, 64, 72, 75, 80]})",
        1000);
    QVERIFY(answer.found.isComplete);
    const std::vector<std::int64_t> stock{8, 10, 12, 60, 64, 72, 75, 80};
    std::int64_t expected = 0;
    for (const std::int64_t a : stock) {
      for (const std::int64_t b : stock) {
        if (a != 8 * b) continue;
        for (const std::int64_t c : stock) {
          for (const std::int64_t d : stock) {
            for (const std::int64_t e : stock) {
              for (const std::int64_t f : stock) expected += c * e == 60 * d * f ? 1 : 0;
            }
          }
        }
      }
    }
    QVERIFY(expected > 2);
    QCOMPARE(answer.found.counts.accepted, expected);
    for (const TeethChoice& choice : answer.choices)
      QCOMPARE(choice.found.ratios, (std::vector<Rational>{Rational(-1, 8), Rational(-1, 480)}));
  }

  /// A published gearbox whose teeth, 33 : 75 in both sets, miss its published ratios 2.45 and 1.45: which
  /// teeth were meant?
  void statedTeethThatMissTheStatedRatios() {
    const Mechanism drawn = *simpsonSet({33, 21}, 1);
    const std::string ratios =
        R"({"ratios": [{"state": "1", "ratio": "2.45"}, {"state": "2", "ratio": "1.45"}], "fewest": 17, "most": 60, "mostRing": 90, "planets": 3)";
    std::string kept;
    const auto problem = teethProblemOf(drawn, wishFor(drawn, ratios + "}"));
    for (const SearchedWheel& wheel : problem->wheels)
      kept += (kept.empty() ? "\"" : ", \"") + wheel.name + '"';
    const TeethAnswer stated = answerFor(drawn, ratios + ", \"kept\": [" + kept + "]}");
    QCOMPARE(stated.found.counts.accepted, std::int64_t{0});
    QVERIFY(!stated.conflicts.empty());
    const TeethAnswer meant = answerFor(drawn, ratios + "}");
    QVERIFY(meant.found.isComplete && meant.found.counts.accepted > 0);
    for (const TeethChoice& choice : meant.choices) {
      QVERIFY(Rational(2445, 1000) <= choice.found.ratios[0] &&
              choice.found.ratios[0] < Rational(2455, 1000));
      QVERIFY(Rational(1445, 1000) <= choice.found.ratios[1] &&
              choice.found.ratios[1] < Rational(1455, 1000));
      QCOMPARE(*solvedRatio(*meant.problem, 0, choice.found.teeth), choice.found.ratios[0]);
    }
  }

  /// Sun over carrier is 1 + R/S, ring over carrier 1 + S/R: both follow from one quotient.
  void conflictingWishesAreNamed() {
    const Mechanism drawn = planetarySet({24, 18}, 1);
    const auto conflictsOf = [&](const std::string& first, const std::string& second,
                                 const std::string& third) {
      std::string wish = R"({"ratios": [{"drive": "1", "driven": "3", "held": ["2"], "ratio": "FIRST"},
                                        {"drive": "2", "driven": "3", "held": ["1"], "ratio": "SECOND"},
                                        {"drive": "3", "driven": "1", "held": ["2"], "ratio": "THIRD"}],
                             "most": 60})";
      for (const auto& [place, ratio] :
           {std::pair("FIRST", first), std::pair("SECOND", second), std::pair("THIRD", third)})
        wish.replace(wish.find(place), std::string(place).size(), ratio);
      const TeethAnswer answer = answerFor(drawn, wish);
      if (answer.found.counts.accepted > 0 && !answer.conflicts.empty())
        qFatal("conflicts of what was found");
      return answer.conflicts;
    };
    using Conflicts = std::vector<std::vector<int>>;
    QCOMPARE(conflictsOf("4", "4/3", "1/4"), Conflicts{});
    QCOMPARE(conflictsOf("4", "2", "1/4"), (Conflicts{{1}}));  // S = R is no ring
    QCOMPARE(conflictsOf("4", "3/2", "1/4"), (Conflicts{{0, 1}, {1, 2}}));
    const TeethAnswer answer = answerFor(
        drawn,
        R"({"ratios": [{"drive": "1", "driven": "3", "held": ["2"], "ratio": "4"}, {"drive": "2", "driven": "3", "held": ["1"], "ratio": "3/2"}], "most": 60})");
    QCOMPARE(
        conflictSentences(answer),
        (std::vector<std::string>{"No choice within the limits has both ratio 1 (4) and ratio 2 (3/2)."}));
    QVERIFY(teethJson(answer).find("\"conflicts\": [[0, 1]]") != std::string::npos);
  }

  void certificatesHold() {
    for (
        const auto& [train, wish] :
        {std::pair(twoRings(24, 30, 26, 3), std::string(kTwoRingWish)),
         std::pair(
             revertedTrain({}),
             std::string(
                 R"({"ratios": [{"drive": "1", "driven": "3", "ratio": "4.03"}], "most": 60, "slack": 1})"))}) {
      const TeethAnswer answer = answerFor(train, wish);
      QVERIFY(answer.found.counts.accepted > 0);
      const auto certificate = teethCertificate(answer, wish, "test");
      QVERIFY(certificate.has_value());
      const auto verdict = checkTeeth(*certificate);
      QVERIFY(verdict.has_value());
      for (const std::string& fault : verdict->faults) qWarning("%s", fault.c_str());
      QVERIFY(verdict->holds());
      QCOMPARE(verdict->tried, answer.found.counts.tried);
      QCOMPARE(verdict->within, answer.found.counts.within);
    }
  }

  /// What is marked is what the drawn teeth are said to be, at every angle and helix; and the checker, which
  /// has formulas of its own, leaves out the same choices.
  void undercutIsThatOfTheTeethAsCut() {
    std::set<int> limits;
    for (const int angle : {15, 20, 25}) {
      for (const int helix : {0, 20, 35}) {
        Mechanism train = spurPairOf(20, 60, angle, helix);
        const std::string wish =
            R"({"ratios": [{"drive": "1", "driven": "2", "between": ["-3", "-2"]}], "fewest": 5, "most": 70,
                "undercut": false})";
        const TeethAnswer answer = answerFor(train, wish, 5'000);
        int fewest = 70;
        for (const TeethChoice& choice : answer.choices) {
          QVERIFY(choice.undercut.empty());
          fewest = std::min(fewest, choice.found.teeth[0]);
        }
        const auto isUndercut = [&](int teeth) {
          const PlacedMechanism drawn = spurPairOf(teeth, 3 * teeth, angle, helix);
          TrainWheels wheels = wheelsOf(drawn, drawn.placement());
          shapeWheels(drawn, wheels);
          const Diagnostics found = toothDiagnostics(drawn, toothedTrain(drawn, wheels));
          return std::any_of(found.begin(), found.end(),
                             [](const Diagnostic& each) { return each.code == Code::undercut; });
        };
        QVERIFY2(!isUndercut(fewest) && isUndercut(fewest - 1),
                 qPrintable(QString("%1 teeth at %2, %3 degrees").arg(fewest).arg(angle).arg(helix)));
        const auto verdict = checkTeeth(*teethCertificate(answer, wish, "test"));
        QVERIFY(verdict.has_value());
        for (const std::string& fault : verdict->faults) qWarning("%s", fault.c_str());
        QVERIFY(verdict->holds());
        limits.insert(fewest);
      }
    }
    QVERIFY(limits.contains(18));  // 17.1 at 20 degrees without a helix
    QVERIFY(limits.size() > 5);
  }

  /// A claim that is not true is found, whichever it is.
  void falseCertificatesFail() {
    const TeethAnswer answer = answerFor(twoRings(24, 30, 26, 3), kTwoRingWish);
    const std::string right = *teethCertificate(answer, kTwoRingWish, "test");
    const auto isCaught = [&](const std::string& from, const std::string& to) {
      std::string wrong = right;
      const std::size_t at = wrong.rfind(from);
      if (at == std::string::npos) return false;
      wrong.replace(at, from.size(), to);
      const auto verdict = checkTeeth(wrong);
      return !verdict || !verdict->holds();
    };
    QVERIFY(isCaught("38997, 37919", "38998, 37919"));
    QVERIFY(isCaught("10112", "10113"));
    QVERIFY(isCaught("\"64\"", "\"65\""));
    QVERIFY(isCaught("\"mostRing\": 120", "\"mostRing\": 121"));
    QVERIFY(isCaught("\"1/200\"", "\"1/100\""));
    QVERIFY(isCaught("[1, [", "[2, ["));
  }

  /// What is chosen is drawn: the teeth, the ratio, nothing wrong with the geometry.
  void choicesAreApplied() {
    const PlacedMechanism drawn = twoRings(24, 30, 26, 3);
    const TeethAnswer answer = answerFor(drawn, kTwoRingWish);
    const auto applied = withTeethChosen(drawn, answer.choices.front());
    QVERIFY(applied.has_value());
    QVERIFY(applied->placement().diagnostics.empty());
    QCOMPARE(applied->mechanism().gearMeshes[7].headTeeth, 85);
    const TeethAnswer again = answerFor(
        *applied,
        R"({"ratios": [{"state": "1", "ratio": "64"}], "fewest": 17, "most": 17, "kept": ["15:tail", "18:head", "16:head", "17:tail", "17:head"]})");
    QCOMPARE(again.found.counts.accepted, std::int64_t{1});
  }

  /// A pinned link keeps its teeth, and so do wheels that are named.
  void pinsAreKept() {
    Mechanism drawn = planetarySet({24, 18}, 1);
    drawn.links[1].pinned = true;
    const TeethAnswer answer = answerFor(
        drawn, R"({"ratios": [{"drive": "1", "driven": "3", "held": ["2"], "between": [3, 5]}], "most": 60})",
        1000);
    QVERIFY(answer.found.counts.accepted > 1);
    for (const TeethChoice& choice : answer.choices) QCOMPARE(choice.teeth[0].tailTeeth, 24);
    const auto applied = withTeethChosen(drawn, answer.choices.front());
    QVERIFY(applied.has_value());
  }

  /// Each wheel of a drawer once: no two of a choice are the same piece.
  void stockIsUsedOnce() {
    const std::string once =
        R"({"ratios": [{"drive": "1", "driven": "3", "between": ["0.1", "10"]}], "fewest": 1,
            "wheels": [20, 20, 30, 40, 50], "once": true})";
    const TeethAnswer answer = answerFor(twoPairs(), once, 1000);
    std::int64_t expected = 0;
    const std::vector<int> stock{20, 20, 30, 40, 50};
    std::set<std::vector<int>> seen;
    for (std::size_t a = 0; a < 5; ++a) {
      for (std::size_t b = 0; b < 5; ++b) {
        for (std::size_t c = 0; c < 5; ++c) {
          for (std::size_t d = 0; d < 5; ++d) {
            if (std::set<std::size_t>{a, b, c, d}.size() < 4) continue;
            if (seen.insert({stock[a], stock[b], stock[c], stock[d]}).second) ++expected;
          }
        }
      }
    }
    QCOMPARE(answer.found.counts.tried, expected);
  }

  void slackLetsSumsMiss() {
    const Mechanism drawn = revertedTrain({});
    const std::string wish =
        R"({"ratios": [{"drive": "1", "driven": "3", "between": [3, 5]}], "most": 40, "slack": %})";
    std::int64_t tried[3] = {};
    for (int slack = 0; slack <= 2; ++slack) {
      std::string text = wish;
      text.replace(text.find('%'), 1, std::to_string(slack));
      tried[slack] = answerFor(drawn, text).found.counts.tried;
      std::int64_t expected = 0;
      for (int a = 17; a <= 40; ++a)
        for (int b = 17; b <= 40; ++b)
          for (int c = 17; c <= 40; ++c)
            for (int d = 17; d <= 40; ++d) expected += std::abs(a + b - c - d) <= slack ? 1 : 0;
      QCOMPARE(tried[slack], expected);
    }
  }

  /// "0.632" is what rounds to it: the lower end belongs to it, the upper one does not.
  void decimalsAreRounded() {
    const auto bounds = boundsOf("0.632");
    QCOMPARE(bounds->low, Rational(6315, 10000));
    QCOMPARE(bounds->high, Rational(6325, 10000));
    QVERIFY(bounds->contains(Rational(6315, 10000)) && !bounds->contains(Rational(6325, 10000)));
    QCOMPARE(boundsOf("6.32e-1")->high, Rational(6325, 10000));
    QCOMPARE(boundsOf("9/2")->low, Rational(9, 2));
    QVERIFY(!boundsOf("0") && !boundsOf("4/0") && !boundsOf("0.0"));
  }

  void nothingFoundNamesTheNearest() {
    const TeethAnswer answer = answerFor(
        twoRings(24, 30, 26, 3),
        R"({"ratios": [{"state": "1", "ratio": "100", "tolerance": "1/1000"}], "most": 60, "mostRing": 120, "planets": 3})");
    QCOMPARE(answer.found.counts.accepted, std::int64_t{0});
    QVERIFY(answer.found.isComplete);
    QCOMPARE(answer.nearest->found.ratios[0], Rational(5512, 55));
  }

  /// A published tooth count that does not give the published ratio.
  void aMisprintIsFound() {
    Mechanism train = twoPairs();
    const std::string wish = R"({"ratios": [{"drive": "1", "driven": "3", "ratio": "7.143"}]})";
    const auto right = meantTeeth(train, wishFor(train, wish));
    QCOMPARE(right->changed, 0);
    QVERIFY(right->fits[0] != 0 && *right->drawn[0] == Rational(50, 7));
    train.gearMeshes[1].headTeeth = 61;
    const auto meant = meantTeeth(train, wishFor(train, wish));
    QVERIFY(meant->fits[0] == 0);
    QCOMPARE(meant->changed, 1);
    QCOMPARE(meant->choices.size(), 1U);
    const MeantChoice& only = meant->choices.front();
    const auto wheel = static_cast<std::size_t>(only.changed.front());
    QCOMPARE(meant->problem->wheels[wheel].name, std::string("8:head"));
    QCOMPARE(only.found.teeth[wheel], 60);
    QCOMPARE(only.found.ratios.front(), Rational(50, 7));
    const std::string json = meantTeethJson(*meant, 20);
    QVERIFY(json.find(R"("changes": [{"wheel": "8:head", "drawn": 61, "meant": 60}])") != std::string::npos);
  }

  /// Where one wheel cannot be wrong by itself, because the ring would not fit: the nearest pair of wheels
  /// first.
  void aMisprintOfAPlanetarySetKeepsItsCentreDistances() {
    const Mechanism train = planetarySet({26, 17}, 1);  // 24, 18 and 60 are meant: 1 + 60/24
    const std::string wish = R"({"ratios": [{"drive": "1", "driven": "3", "held": ["2"], "ratio": "3.5"}]})";
    const auto meant = meantTeeth(train, wishFor(train, wish));
    QCOMPARE(meant->changed, 2);
    std::set<int> teeth(meant->choices.front().found.teeth.begin(), meant->choices.front().found.teeth.end());
    QCOMPARE(teeth, (std::set<int>{18, 24, 60}));
    for (const MeantChoice& each : meant->choices) {
      const Rational ratio = each.found.ratios.front();
      QVERIFY(ratio >= Rational(69, 20) && ratio < Rational(71, 20));
      QCOMPARE(each.changed.size(), 2U);
    }
    MeantTeethOptions options;
    options.by = 1;
    options.wheels = 1;
    QCOMPARE(meantTeeth(train, wishFor(train, wish), options)->changed, -1);
  }

  void stoppedSearchesAreNotComplete() {
    std::stop_source stop;
    const Mechanism drawn = twoPairs();
    TeethSearchOptions options;
    int branches = 0;
    options.progress = [&](double share, std::int64_t /*found*/) {
      QVERIFY(share > 0 && share <= 1);
      if (++branches == 3) stop.request_stop();
    };
    const auto answer = teethFor(drawn, wishFor(drawn, kTwoPairWish), options, stop.get_token());
    QVERIFY(!answer->found.isComplete);
    QCOMPARE(branches, 3);
    QVERIFY(!teethCertificate(*answer, kTwoPairWish, "test"));
  }

  /// Whatever is wrong with a wish is an error with its place.
  void wrongWishesAreRejected() {
    const Mechanism drawn = twoRings(24, 30, 26, 1);
    using Pointers = std::vector<std::string>;
    QCOMPARE(pointersOf(drawn, R"({})"), (Pointers{"/ratios"}));
    QCOMPARE(pointersOf(drawn, R"({"ratios": []})"), (Pointers{"/ratios"}));
    QCOMPARE(pointersOf(drawn, R"({"ratios": [{"drive": "1", "driven": "1", "held": ["2"], "ratio": "2"}]})"),
             (Pointers{"/ratios/0/driven"}));
    for (const char* ratio : {"0", "\"0\"", "\"4/0\"", "\"x\"", "true"})
      QCOMPARE(pointersOf(drawn, std::string(R"({"ratios": [{"state": "1", "ratio": )") + ratio + "}]}"),
               (Pointers{"/ratios/0/ratio"}));
    QCOMPARE(pointersOf(drawn, R"({"ratios": [{"state": "1", "held": ["2"], "ratio": 2}]})"),
             (Pointers{"/ratios/0/held"}));
    QCOMPARE(pointersOf(drawn, R"({"ratios": [{"state": "7", "drive": 1, "driven": 3, "ratio": 2}]})"),
             (Pointers{"/ratios/0/state"}));
    QCOMPARE(pointersOf(drawn, R"({"ratios": [{"drive": 1, "driven": 33, "ratio": 2}]})"),
             (Pointers{"/ratios/0/driven"}));
    QCOMPARE(pointersOf(drawn, R"({"ratios": [{"state": "1", "ratio": 2, "exact": 1}]})"),
             (Pointers{"/ratios/0/exact"}));
    const std::string one = R"({"ratios": [{"state": "1", "ratio": 2}], )";
    QCOMPARE(pointersOf(drawn, one + R"("fewest": 30, "most": 20})"), (Pointers{"/fewest"}));
    QCOMPARE(pointersOf(drawn, one + R"("wheels": []})"), (Pointers{"/wheels"}));
    QCOMPARE(pointersOf(drawn, one + R"("wheels": [20, -3]})"), (Pointers{"/wheels"}));
    QCOMPARE(pointersOf(drawn, one + R"("slack": 3})"), (Pointers{"/slack"}));
    QCOMPARE(pointersOf(drawn, one + R"("efficiency": {"mesh": 2}})"), (Pointers{"/efficiency/mesh"}));
    QCOMPARE(pointersOf(drawn, one + R"("planet": 3})"), (Pointers{"/planet"}));
  }
};

QTEST_APPLESS_MAIN(TeethSearchTest)
#include "test_teeth_search.moc"
