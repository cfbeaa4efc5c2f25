#include <QTest>

#include "core/mechanism/geometry_edits/axis_choice.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/geometry_edits/wheel_map.h"
#include "core/mechanism/model/drawn_mesh.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/pins.h"

using namespace geargraph;
using Way = AxisChoice::Way;

namespace {

const LinkId& link(const Mechanism& mechanism, int label) {
  return mechanism.links[static_cast<std::size_t>(label)].id;
}

Mechanism drawn(int links, const std::vector<std::pair<int, int>>& joints,
                const std::vector<std::pair<int, int>>& meshes) {
  Mechanism mechanism = emptyMechanism();
  for (int i = 0; i < links; ++i) mechanism = withLink(mechanism, {100.0 * i, 0}).value();
  for (const auto& [tail, head] : joints)
    mechanism = withTurningJoint(mechanism, link(mechanism, tail), link(mechanism, head)).value();
  for (const auto& [tail, head] : meshes)
    mechanism = withDrawnMesh(mechanism, link(mechanism, tail), link(mechanism, head)).value();
  return mechanism;
}

/// Case 1, wheels 2 and 3, pinions 4 and 5: drawn as one does, and taken for a planetary set.
Mechanism differential() {
  return drawn(5, {{0, 1}, {0, 2}, {0, 3}, {1, 4}, {1, 5}}, {{2, 4}, {4, 3}, {2, 5}, {5, 3}});
}

QStringList kindsOf(const PlacedMechanism& placed) {
  QStringList kinds;
  for (const auto& mesh : placed.placement().meshes)
    kinds << (mesh ? QString::fromStdString(std::string(meshKindName(mesh->kind))) : QStringLiteral("none"));
  return kinds;
}

Vector3 directionOf(const PlacedMechanism& placed, const char* axis) {
  for (std::size_t i = 0; i < placed.mechanism().axes.size(); ++i) {
    if (placed.mechanism().axes[i].id == AxisId(axis)) return placed.placement().axes[i].direction;
  }
  return {};
}

bool isAlong(const Vector3& direction, std::size_t component) {
  return std::abs(std::abs(direction[component]) - 1) < 1e-12;
}

}  // namespace

class AxisChoiceTest : public QObject {
  Q_OBJECT

  static void checkDifferential(const PlacedMechanism& placed) {
    QCOMPARE(kindsOf(placed), QStringList(4, QStringLiteral("bevel")));
    for (const Diagnostic& each : placed.placement().diagnostics)
      QVERIFY2(each.severity() != Severity::error, each.message.c_str());
    const WheelMap wheels(placed.mechanism(), placed.placement());
    QCOMPARE(wheels.count(), 4);  // the one gear of each pinion meshes both wheels
    for (const GearMesh& mesh : placed.mechanism().gearMeshes) {
      QCOMPARE(mesh.tailTeeth, 20);
      QCOMPARE(mesh.headTeeth, 20);
    }
  }

 private slots:
  void aGuessedRingGivesWayToTheKind() {
    const PlacedMechanism before(differential());
    QCOMPARE(kindsOf(before), (QStringList{"external", "internal", "external", "internal"}));
    for (const GearMesh& mesh : before.mechanism().gearMeshes) {
      const auto after = withKindFitted(before, mesh.id, MeshKind::bevel);
      QVERIFY2(after.has_value(), after ? "" : after.error().front().message.c_str());
      checkDifferential(*after);
    }
  }

  void aGuessedRingGivesWayToTheAxis() {
    const PlacedMechanism before(differential());
    QCOMPARE(before.mechanism().axes.size(), std::size_t(3));
    for (const AxisChoice& choice : {AxisChoice{Way::squareTo, AxisId("a")}, AxisChoice{Way::alongY, {}}}) {
      const auto after = withAxisChosen(before, AxisId("b"), choice);
      QVERIFY2(after.has_value(), after ? "" : after.error().front().message.c_str());
      checkDifferential(*after);
      QVERIFY(isAlong(directionOf(*after, "a"), 2));
      QVERIFY(isAlong(directionOf(*after, "b"), 1));
    }
  }

  void anAxisLiesAlongTheFrame() {
    const PlacedMechanism before(drawn(1, {{0, 1}}, {}));
    std::size_t component = 0;
    for (const Way way : {Way::alongX, Way::alongY, Way::alongZ}) {
      const auto after = withAxisChosen(before, AxisId("a"), {way, {}});
      QVERIFY(after.has_value());
      QVERIFY(isAlong(directionOf(*after, "a"), component++));
      QVERIFY(after->mechanism().axes.front().direction.has_value());
    }
  }

  void parallelAndThroughTheIntersection() {
    const PlacedMechanism bevel =
        *withAxisChosen(PlacedMechanism(drawn(3, {{0, 1}, {0, 2}, {2, 3}}, {{1, 3}})), AxisId("b"),
                        {Way::squareTo, AxisId("a")});
    QCOMPARE(kindsOf(bevel), QStringList{"bevel"});
    const Mechanism wider = *withLink(bevel.mechanism(), {0, 0});
    const PlacedMechanism more(*withTurningJoint(wider, link(wider, 2), wider.links.back().id));
    const AxisId added = more.mechanism().axes.back().id;
    const auto parallel = withAxisChosen(more, added, {Way::parallelTo, AxisId("b")});
    QVERIFY(parallel.has_value());
    QVERIFY(isAlong(directionOf(*parallel, "c"), 1));
    const auto through = withAxisChosen(*parallel, added, {Way::throughIntersection, AxisId("a")});
    QVERIFY(through.has_value());
    const Placement& placement = through->placement();
    // The apex: on line a, and on line b.
    const Vector3 apex = toDoubles(exactLine(through->mechanism(), placement, 2).point);
    for (const int axis : {0, 1}) {
      const AxisLine& line = placement.axes[static_cast<std::size_t>(axis)];
      QVERIFY(length(cross(apex - line.point, line.direction)) < 1e-9);
    }
  }

  void aBevelWhoseAxesBecomeParallelIsExternal() {
    const PlacedMechanism pair(drawn(2, {{0, 1}, {0, 2}}, {{1, 2}}));
    const PlacedMechanism bevel = *withAxisChosen(pair, AxisId("b"), {Way::squareTo, AxisId("a")});
    QCOMPARE(kindsOf(bevel), QStringList{"bevel"});
    const auto spur = withAxisChosen(bevel, AxisId("b"), {Way::parallelTo, AxisId("a")});
    QVERIFY2(spur.has_value(), spur ? "" : spur.error().front().message.c_str());
    QCOMPARE(kindsOf(*spur), QStringList{"external"});
  }

  void whatIsPinnedOrUnknownIsRejected() {
    const PlacedMechanism before(differential());
    QVERIFY(withAxisChosen(before, AxisId("z"), {Way::alongX, {}}).error().front().code == Code::unknownId);
    QVERIFY(withAxisChosen(before, AxisId("b"), {Way::squareTo, AxisId("z")}).error().front().code ==
            Code::unknownId);
    const PlacedMechanism pinned = *withPinned(before, AxisId("b"), true);
    QVERIFY(!withAxisChosen(pinned, AxisId("b"), {Way::alongX, {}}).has_value());
  }
};

QTEST_APPLESS_MAIN(AxisChoiceTest)
#include "test_axis_choice.moc"
