#include "core/presentation/schematic/sheet_rims.h"

#include <QTest>

#include "core/presentation/schematic/schematic.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;

class SheetRimsTest : public QObject {
  Q_OBJECT

 private slots:
  /// Both gears of a pair, each on both sides of its axis or on one where only half of it is drawn.
  void everyGearHasItsRims() {
    const Mechanism pair = test::example("spur-pair");
    const SchematicGeometry drawn = schematicGeometry(pair);
    QVERIFY(drawn.rims.size() >= 2);
    std::set<LinkId> links;
    for (const SheetRim& rim : drawn.rims) {
      links.insert(rim.link);
      QVERIFY(rim.height > 0);
      QCOMPARE(rim.meshes, std::vector<MeshId>{pair.gearMeshes.front().id});
      QVERIFY(std::abs(std::hypot(rim.out.x, rim.out.y) - 1) < 1e-9);
    }
    QCOMPARE(links, (std::set<LinkId>{pair.gearMeshes.front().tail, pair.gearMeshes.front().head}));
  }

  void teethFollowTheHeightInWholeSteps() {
    const Mechanism pair = test::example("spur-pair");
    const SchematicGeometry drawn = schematicGeometry(pair);
    const GearMesh& mesh = pair.gearMeshes.front();
    for (const SheetRim& rim : drawn.rims) {
      const bool ofTail = rim.link == mesh.tail;
      const int before = ofTail ? mesh.tailTeeth : mesh.headTeeth;
      const CanvasPoint from = rim.from;
      const auto after = [&](double teeth) {
        const CanvasPoint to = from + (teeth * rim.height / before) * rim.out;
        return teethDragged(pair, rim, from, to).value();
      };
      QCOMPARE(after(0).teeth, before);
      QCOMPARE(after(0.4).teeth, before);
      QCOMPARE(after(0.6).teeth, before + 1);
      QCOMPARE(after(-3.2).teeth, before - 3);
      QCOMPARE(after(-2.0 * before).teeth, kMinTeeth);  // beyond the axis
      QCOMPARE(after(1e9).teeth, kMaxTeeth);
      QCOMPARE(ofTail ? after(5).tailTeeth : after(5).headTeeth, before + 5);
      QCOMPARE(ofTail ? after(5).headTeeth : after(5).tailTeeth, ofTail ? mesh.headTeeth : mesh.tailTeeth);
    }
    QVERIFY(!teethDragged(emptyMechanism(), drawn.rims.front(), {}, {}));
  }

  void theNearestRimIsTaken() {
    SheetRim low{LinkId("1"), {MeshId("3")}, {0, 0}, {10, 0}, {0, -1}, 20};
    SheetRim high = low;
    high.link = LinkId("2");
    high.from.y = high.to.y = 4;
    const std::vector<SheetRim> rims{low, high};
    const std::vector<LinkId> both{LinkId("1"), LinkId("2")};
    QCOMPARE(rimNear(rims, both, {5, 1}, 6), &rims[0]);
    QCOMPARE(rimNear(rims, both, {5, 3}, 6), &rims[1]);
    QCOMPARE(rimNear(rims, {LinkId("2")}, {5, 1}, 6), &rims[1]);
    QVERIFY(rimNear(rims, both, {20, 0}, 6) == nullptr);
  }
};

QTEST_APPLESS_MAIN(SheetRimsTest)
#include "test_sheet_rims.moc"
