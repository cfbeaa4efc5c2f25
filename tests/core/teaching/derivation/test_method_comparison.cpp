#include <QTest>
#include <memory>

#include "core/teaching/derivation/comparison_families.h"
#include "core/theory/analysis/analysis.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

namespace geargraph {
namespace {

SnapshotPtr analyzed(Mechanism mechanism) {
  return analyze(std::make_shared<const Mechanism>(std::move(mechanism)));
}

/// What both methods agree on in every comparison.
void checkAgreement(const MethodComparison& comparison, const std::string& name) {
  QVERIFY2(comparison.isEqual, name.c_str());
  QCOMPARE(comparison.perMesh.size(), static_cast<std::size_t>(comparison.meshes));
  for (const ComparedMesh& mesh : comparison.perMesh) {
    QVERIFY2(mesh.isEqual, (name + ", mesh " + std::to_string(mesh.mesh)).c_str());
    QVERIFY(mesh.terms.size() >= 2);
    QVERIFY(mesh.sign == 1 || mesh.sign == -1);
  }
}

}  // namespace

class MethodComparisonTest : public QObject {
  Q_OBJECT

 private slots:
  // By hand, Eqs. (24), (25) against (39)-(42). The chain multiplies for w21 once, for w72 twice, for w32
  // three times. The inverse of P_r takes three products, its product with P_E six.
  void theRobotIsCountedAsByHand() {
    const auto comparison = compareMethods(*analyzed(test::robot()));
    QVERIFY(comparison.has_value());
    checkAgreement(*comparison, "robot");
    QCOMPARE(comparison->ttGraph.numbers, (Operations{6, 0}));
    QCOMPARE(comparison->matroid.numbers, (Operations{9, 0}));
    QCOMPARE(*comparison->ttGraph.symbols, comparison->ttGraph.numbers);
    QCOMPARE(*comparison->matroid.symbols, comparison->matroid.numbers);
    QCOMPARE(comparison->matroid.unknowns, 7);
    QCOMPARE(comparison->matroid.equations, 4);
    QCOMPARE(comparison->matroid.nonZeros, 10LL);  // (19)
    QCOMPARE(comparison->ttGraph.unknowns, 15);    // seven branches, eight chords
    QCOMPARE(comparison->ttGraph.equations, 12);   // (27)-(38)
    QCOMPARE(comparison->ttGraph.setUp, (Operations{4, 0}));
    // All axes lie along those of the frame: differences of coordinates, and a quotient a mesh.
    QCOMPARE(comparison->matroid.setUp, (Operations{4, 7}));
  }

  void theRowsOfAMeshAreTheSame() {
    const auto comparison = compareMethods(*analyzed(test::robot()));
    const ComparedMesh& mesh = comparison->perMesh[1];  // 16: joints 9, 10, 12
    QCOMPARE(mesh.terms.size(), std::size_t{3});
    QCOMPARE(mesh.terms[0].matroid.toString() + " " + mesh.terms[1].matroid.toString() + " " +
                 mesh.terms[2].matroid.toString(),
             std::string("2/3 -2/3 1"));
    for (const ComparedMesh::Term& term : mesh.terms) QVERIFY(term.matroid == term.ttGraph);
  }

  void everyExampleIsTheSameByBoth() {
    int compared = 0;
    for (const std::string& name : test::exampleNames()) {
      const auto comparison = compareMethods(*analyzed(test::example(name)));
      if (!comparison) continue;
      checkAgreement(*comparison, name);
      ++compared;
    }
    QVERIFY2(compared >= 14, qPrintable(QString::number(compared)));
  }

  void randomTrainsAreTheSameByBoth() {
    int compared = 0;
    int coupled = 0;
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
      const SnapshotPtr snapshot =
          analyzed(test::randomTrain(seed, 6 + static_cast<int>(seed % 18), 3 + static_cast<int>(seed % 11)));
      const auto comparison = compareMethods(*snapshot);
      if (!comparison) continue;
      checkAgreement(*comparison, "seed " + std::to_string(seed));
      ++compared;
      if (!snapshot->solved->ttPlan.coupledEquations.empty()) ++coupled;
    }
    QVERIFY2(compared >= 100, qPrintable(QString::number(compared)));
    QVERIFY2(coupled >= 5, qPrintable(QString::number(coupled)));
  }

  void familiesGrowAsTheirNamesSay() {
    const std::vector<FamilyCount>& counts = familyCounts();
    QCOMPARE(counts.size(), std::size_t{15});
    for (std::size_t i = 1; i < counts.size(); ++i) {
      if (counts[i].family != counts[i - 1].family) continue;
      QVERIFY(counts[i].links > counts[i - 1].links && counts[i].meshes > counts[i - 1].meshes);
      QVERIFY(counts[i].ttGraph.products >= counts[i - 1].ttGraph.products);
      QVERIFY(counts[i].matroidSetUp.products > counts[i - 1].matroidSetUp.products);
    }
    // A row of n gears: the chain multiplies each ratio but the first by what came before, the inverse has
    // all products of neighbouring ratios.
    for (const FamilyCount& count : counts) {
      if (count.family != TrainFamily::chain) continue;
      QCOMPARE(count.ttGraph, (Operations{count.size - 2, 0}));
      QCOMPARE(count.matroid, (Operations{(count.size - 1) * (count.size - 2) / 2, 0}));
      QCOMPARE(count.links, count.size);
    }
    for (const TrainFamily family : {TrainFamily::chain, TrainFamily::stack, TrainFamily::wrist}) {
      const SnapshotPtr snapshot = analyzed(familyTrain(family, 4));
      const std::string name = familyName(family);
      QVERIFY2(!hasErrors(snapshot->diagnostics), name.c_str());
      checkAgreement(*compareMethods(*snapshot), name.c_str());
    }
  }

  void thereIsNoneWhereAMethodHasNoSolution() {
    QVERIFY(!compareMethods(*analyzed(emptyMechanism())));
    QVERIFY(!compareMethods(*analyzed(test::example("robot-to-mend"))));
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!compareMethods(*analyzed(test::robot()), ComparisonDepth::symbols, stop.get_token()));
  }

  void claimsHaveEvidenceOnBothSides() {
    const std::vector<ComparedClaim> claims = claimsOf(*compareMethods(*analyzed(test::robot())));
    QCOMPARE(claims.size(), std::size_t{3});
    for (const ComparedClaim& claim : claims)
      QVERIFY(!claim.evidenceFor.empty() && !claim.evidenceAgainst.empty());
    QVERIFY(claims[0].evidenceFor[0].find("6 products and 0 sums") != std::string::npos);
    for (const ComparedStep& step : comparedSteps())
      QVERIFY(!step.matroid.empty() && !step.relationWords.empty());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::MethodComparisonTest)
#include "test_method_comparison.moc"
