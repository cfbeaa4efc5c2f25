#include <QTest>

#include "core/design/synthesis/insertion.h"
#include "core/design/synthesis/planetary_set.h"
#include "core/mechanism/model/link_edits.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/states/weld_edits.h"

namespace geargraph {
namespace {

/// Sun drives, ring held by its brake: 1 + 60/24 = 7/2 from sun to carrier.
Mechanism stage() {
  return planetarySet({24, 18}, 3, PlanetaryUse{});
}

SnapshotPtr analysisOfGearbox(const Mechanism& mechanism) {
  return analyze(std::make_shared<const Mechanism>(mechanism));
}

bool hasProblems(const AnalysisSnapshot& snapshot) {
  for (const Diagnostic& each : snapshot.diagnostics) {
    if (severityOf(each.code) != Severity::info) qWarning("%s", each.message.c_str());
  }
  return std::any_of(snapshot.diagnostics.begin(), snapshot.diagnostics.end(), [](const Diagnostic& each) {
    return severityOf(each.code) != Severity::info && each.detail != Detail::equalPlanets;
  });
}

/// The speed of a link on the ground.
Rational speedOf(const AnalysisSnapshot& snapshot, LinkId link) {
  const Mechanism& mechanism = *snapshot.mechanism;
  for (JointOrdinal joint = 0; joint < mechanism.t(); ++joint) {
    if (mechanism.turningJoints[joint].head == link) return snapshot.solved->exact->rates[joint];
  }
  return Rational(-1);
}

struct TwoStages {
  Mechanism mechanism;
  LinkId sun1, ring1, carrier1, sun2, ring2, carrier2;
};
TwoStages twoStages() {
  TwoStages made{withInserted(stage(), stage(), {400, 0}), {}, {}, {}, {}, {}, {}};
  const auto& links = made.mechanism.links;
  made.sun1 = links[1].id, made.ring1 = links[2].id, made.carrier1 = links[3].id;
  made.sun2 = links[7].id, made.ring2 = links[8].id, made.carrier2 = links[9].id;
  return made;
}

}  // namespace

/// Sets that are joined by a weld are one gearbox.
class WeldedSetsTest : public QObject {
  Q_OBJECT

 private slots:
  void twoStagesInARow() {
    const TwoStages two = twoStages();
    QCOMPARE(two.mechanism.inputs->size(), std::size_t{2});
    const auto gearbox = withLinksWelded(two.mechanism, two.carrier1, two.sun2);
    QVERIFY(gearbox.has_value());
    QVERIFY(wellFormedDiagnostics(*gearbox).empty());
    QCOMPARE(gearbox->inputs->size(), std::size_t{1});
    const SnapshotPtr snapshot = analysisOfGearbox(*gearbox);
    QVERIFY(!hasProblems(*snapshot));
    QCOMPARE(speedOf(*snapshot, two.sun1), Rational(1));
    QCOMPARE(speedOf(*snapshot, two.carrier2), Rational(4, 49));
  }

  void theOrderOfTheTwoDoesNotMatter() {
    const TwoStages two = twoStages();
    const auto gearbox = withLinksWelded(two.mechanism, two.sun2, two.carrier1);
    QVERIFY(gearbox.has_value());
    QCOMPARE(gearbox->inputs->size(), std::size_t{1});
    const SnapshotPtr snapshot = analysisOfGearbox(*gearbox);
    QVERIFY(!hasProblems(*snapshot));
    QCOMPARE(speedOf(*snapshot, two.carrier2), Rational(4, 49));
  }

  void simpsonsTrainOfTwoSets() {
    // Common sun, the carrier of the first is the ring of the second. Two sets have four freedoms.
    TwoStages two = twoStages();
    two.mechanism.engaged.clear();
    two.mechanism.inputs.reset();
    auto train = withLinksWelded(two.mechanism, two.sun1, two.sun2);
    QVERIFY(train.has_value());
    train = withLinksWelded(*train, two.carrier1, two.ring2);
    QVERIFY(train.has_value());
    const SnapshotPtr snapshot = analysisOfGearbox(*train);
    QVERIFY(snapshot->matroid() != nullptr);
    QCOMPARE(snapshot->matroid()->dof, 2);
    QCOMPARE(train->axes.size(), std::size_t{7});
  }

  void aPlanetLockedOnItsCarrierTurnsTheSetAsOne() {
    // No brake: sun and ring are driven, of which one is left.
    const Mechanism set = planetarySet({24, 18}, 1);
    const auto locked = withLinksWelded(set, set.links[1].id, set.links[2].id);  // sun and ring
    QVERIFY(locked.has_value());
    QCOMPARE(locked->inputs->size(), std::size_t{1});
    const SnapshotPtr snapshot = analysisOfGearbox(*locked);
    QCOMPARE(snapshot->matroid()->dof, 1);
    QCOMPARE(speedOf(*snapshot, set.links[3].id), Rational(1));
  }

  void aSplitKeepsTheMotion() {
    const TwoStages two = twoStages();
    const Mechanism gearbox = withLinksWelded(two.mechanism, two.carrier1, two.sun2).value();
    const std::vector<ElementId> side = lastSideOf(gearbox, two.carrier1);
    QCOMPARE(side.size(), std::size_t{3});  // the meshes with the planets of the second set
    const auto parts = withLinkDivided(gearbox, two.carrier1, side);
    QVERIFY(parts.has_value());
    QCOMPARE(parts->inputs->size(), std::size_t{2});
    QCOMPARE(parts->inputs->back().joint, parts->turningJoints.back().id);  // what has come free is driven
    QCOMPARE(parts->inputs->back().speed, Number(Rational(2, 7)));
    const SnapshotPtr snapshot = analysisOfGearbox(*parts);
    QVERIFY(!hasProblems(*snapshot));
    QCOMPARE(snapshot->matroid()->dof, 2);
    QCOMPARE(speedOf(*snapshot, two.carrier2), Rational(4, 49));
    QCOMPARE(speedOf(*snapshot, parts->links.back().id), Rational(2, 7));
  }

  void inputsThatTheProgramChoosesStayItsOwn() {
    TwoStages two = twoStages();
    two.mechanism.inputs.reset();
    QVERIFY(!withLinksWelded(two.mechanism, two.carrier1, two.sun2)->inputs);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::WeldedSetsTest)
#include "test_welded_sets.moc"
