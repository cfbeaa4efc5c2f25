#include <QTest>

#include "core/mechanism/model/validate.h"
#include "core/presentation/schematic/schematic.h"
#include "core/presentation/schematic/sheet_edits.h"

using namespace geargraph;

namespace {

/// Draws on the schematic as it stands after every step.
struct MouseHand {
  Mechanism mechanism = emptyMechanism();

  [[nodiscard]] CanvasFrame frame() const { return schematicGeometry(mechanism).frame; }
  /// A place by the coordinates of space that the sheet shows: along to the right, height upward.
  [[nodiscard]] CanvasPoint place(double along, double height) const {
    const CanvasFrame f = frame();
    return f.origin + CanvasPoint{along * f.scale, -height * f.scale};
  }
  void shaft(CanvasPoint from, CanvasPoint to, LinkId carrier = {}) {
    mechanism = withShaftOnSheet(mechanism, frame(), {from, to, carrier}).value();
  }
  void mesh(int tail, int head, CanvasPoint from, CanvasPoint to) {
    mechanism = withMeshOnSheet(mechanism, frame(), {link(tail), link(head), from, to}).value();
  }
  [[nodiscard]] LinkId link(int label) const { return mechanism.links[static_cast<std::size_t>(label)].id; }
  [[nodiscard]] CanvasPoint on(int joint) const {
    const CanvasFrame f = frame();
    return f.line(mechanism.turningJoints[static_cast<std::size_t>(joint)].axis)->at;
  }
};

QString triple(const std::optional<NumberTriple>& numbers) {
  QStringList words;
  for (const Number& number : *numbers) words << QString::number(number.value());
  return words.join(' ');
}

}  // namespace

/// What is drawn on the sheet becomes an ordinary document.
class SheetEditsTest : public QObject {
  Q_OBJECT
 private slots:
  void theFirstShaftLiesOnAnAxisThroughTheOrigin() {
    MouseHand hand;
    hand.shaft({100, 80}, {180, 84});
    QCOMPARE(hand.mechanism.n(), 1);
    QCOMPARE(triple(hand.mechanism.axes[0].point), QString("0 0 0"));
    QCOMPARE(triple(hand.mechanism.axes[0].direction), QString("0 0 1"));
    QCOMPARE(hand.mechanism.turningJoints[0].tail, hand.mechanism.links[0].id);
    QVERIFY(treeDiagnostics(hand.mechanism).empty());
  }

  void aShaftOnAnAxisSharesIt() {
    MouseHand hand;
    hand.shaft({0, 0}, {80, 0});
    hand.shaft(hand.on(0) + CanvasPoint{60, 3}, hand.on(0) + CanvasPoint{120, 3});
    QCOMPARE(hand.mechanism.axes.size(), std::size_t{1});
    QCOMPARE(hand.mechanism.turningJoints[1].axis, hand.mechanism.turningJoints[0].axis);
  }

  void aShaftBesideItGetsAnAxisAtThatDistance() {
    MouseHand hand;
    hand.shaft({0, 0}, {80, 0});
    hand.shaft(hand.place(0, 50), hand.place(20, 50));
    QCOMPARE(hand.mechanism.axes.size(), std::size_t{2});
    QCOMPARE(triple(hand.mechanism.axes[1].point), QString("50 0 0"));
    QCOMPARE(triple(hand.mechanism.axes[1].direction), QString("0 0 1"));
  }

  void anUprightShaftMakesAnAxisAcross() {
    MouseHand hand;
    hand.shaft({0, 0}, {80, 0});
    hand.shaft(hand.place(40, 20), hand.place(40, 60));
    QCOMPARE(triple(hand.mechanism.axes[1].direction), QString("1 0 0"));
    QCOMPARE(triple(hand.mechanism.axes[1].point), QString("0 0 40"));
    hand.mesh(1, 2, hand.on(0), hand.on(1));
    QCOMPARE(placementOf(hand.mechanism).meshes[0]->kind, MeshKind::bevel);
  }

  void aPlanetarySetIsDrawnInFiveSteps() {
    MouseHand hand;
    hand.shaft({0, 0}, {60, 0});                                     // 1: sun
    hand.shaft(hand.on(0), hand.on(0) + CanvasPoint{60, 0});         // 2: carrier
    hand.shaft(hand.place(0, 42), hand.place(0, 42), hand.link(2));  // 3: planet
    QCOMPARE(hand.mechanism.turningJoints[2].tail, hand.link(2));
    hand.mesh(1, 3, hand.on(0), hand.on(2));
    QCOMPARE(hand.mechanism.gearMeshes[0].tailTeeth + hand.mechanism.gearMeshes[0].headTeeth, 42);
    hand.mesh(3, 0, hand.on(2), hand.on(2) - CanvasPoint{0, 80});
    const GearMesh& ring = hand.mechanism.gearMeshes[1];
    QCOMPARE(ring.kind, std::optional(MeshKind::internal));
    QCOMPARE(ring.tailTeeth, hand.mechanism.gearMeshes[0].headTeeth);
    QCOMPARE(ring.headTeeth - ring.tailTeeth, 42);
    const Placement placement = placementOf(hand.mechanism);
    QVERIFY(placement.diagnostics.empty());
    QVERIFY(placement.meshes[0] && placement.meshes[1]);
  }

  void aShaftThatAnotherLinkCarriesGetsAnAxisOfItsOwn() {
    MouseHand hand;
    hand.shaft({0, 0}, {60, 0});
    hand.shaft(hand.place(0, 40), hand.place(20, 40));
    hand.shaft(hand.on(1), hand.on(1), hand.link(1));
    QCOMPARE(hand.mechanism.axes.size(), std::size_t{3});
    QCOMPARE(triple(hand.mechanism.axes[2].point), triple(hand.mechanism.axes[1].point));
  }

  void aPairFillsTheDistanceOfItsAxes() {
    MouseHand hand;
    hand.shaft({0, 0}, {60, 0});
    hand.shaft(hand.place(0, 50), hand.place(20, 50));
    hand.mesh(1, 2, hand.on(0), hand.on(1));
    QCOMPARE(hand.mechanism.gearMeshes[0].tailTeeth, 25);
    QCOMPARE(hand.mechanism.gearMeshes[0].headTeeth, 25);
    QVERIFY(!hand.mechanism.gearMeshes[0].kind);
    const Expected<PlacedMechanism> self =
        withMeshOnSheet(hand.mechanism, hand.frame(), {hand.link(1), hand.link(1), {}, {}});
    QVERIFY(!self.has_value());
  }
};

QTEST_APPLESS_MAIN(SheetEditsTest)
#include "test_sheet_edits.moc"
