#include <QTest>
#include <random>

#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// A random tree with axes named at random, so that most meshes have no carrier and some are coaxial.
Mechanism scribble(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Mechanism mechanism =
      randomTree(seed, 3 + static_cast<int>(random() % 12), static_cast<int>(random() % 10));
  mechanism.axes.clear();
  for (int i = 0; i < 5; ++i) {
    Axis axis{AxisId(std::to_string(i)), {}, {}, {}};
    if (random() % 2 == 0)
      axis.point = NumberTriple{static_cast<int>(random() % 3), 0, static_cast<int>(random() % 3)};
    if (random() % 2 == 0) axis.direction = NumberTriple{0, random() % 2 == 0 ? 1 : 0, 1};
    mechanism.axes.push_back(axis);
  }
  for (TurningJoint& joint : mechanism.turningJoints) joint.axis = mechanism.axes[random() % 5].id;
  for (GearMesh& mesh : mechanism.gearMeshes) {
    if (random() % 2 == 0) mesh.kind = static_cast<MeshKind>(random() % 3);
    if (random() % 4 == 0) mesh.pitchPoint = NumberTriple{static_cast<int>(random() % 5), 1, 0};
  }
  return mechanism;
}

}  // namespace

class MatroidRobustnessTest : public QObject {
  Q_OBJECT
 private slots:
  void whateverIsDrawnEveryMeshIsPlacedOrBlamed() {
    int analysed = 0;
    for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
      const Mechanism mechanism = scribble(seed);
      const Placement placement = placementOf(mechanism);
      bool complete = true;
      for (int i = 0; i < mechanism.c(); ++i) {
        const bool blamed =
            std::any_of(placement.diagnostics.begin(), placement.diagnostics.end(), [&](const Diagnostic& d) {
              return d.severity() == Severity::error && !d.elements.empty() &&
                     d.elements.front() == ElementId(mechanism.gearMeshes[i].id);
            });
        QCOMPARE(placement.meshes[i].has_value(), !blamed);
        complete = complete && placement.meshes[i].has_value();
      }
      for (const AxisLine& line : placement.axes) QVERIFY(std::abs(length(line.direction) - 1) < 1e-9);
      if (!complete) continue;
      const Worked worked(mechanism);
      QCOMPARE(static_cast<int>(worked.analysis.choice.joints.size()), worked.analysis.dof);
      QVERIFY(worked.analysis.solution.has_value());
      ++analysed;
    }
    QVERIFY(analysed > 300);
  }

  void thousandsOfFreeJointsAreStillQuick() {
    TrainSketch train(5000);
    for (int v = 1; v <= 5000; ++v)
      train.joint(v % 7 == 0 ? v / 7 : v - 1, v, "x" + std::to_string(v % 3 == 0 ? v / 3 : v));
    const Worked worked(train.build());
    QCOMPARE(worked.analysis.dof, 5000);
    QVERIFY(worked.analysis.solution->matrix.empty());
  }

  void aMechanismWithoutLinksHasNothingToSolve() {
    const Worked worked(emptyMechanism());
    QCOMPARE(worked.analysis.dof, 0);
    QVERIFY(worked.analysis.diagnostics.empty());
    QVERIFY(worked.analysis.solution.has_value());
  }
};

QTEST_APPLESS_MAIN(MatroidRobustnessTest)
#include "test_matroid_robustness.moc"
