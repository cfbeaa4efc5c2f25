#include <QLabel>
#include <QLayout>
#include <QSlider>
#include <QTest>
#include <QUndoStack>

#include "core/mechanism/model/load_edits.h"
#include "tests/core/support/train_sketch.h"
#include "tests/ui/forces/open_forces_panel.h"
#include "ui/forces/efficiency_card.h"
#include "ui/forces/efficiency_page.h"
#include "ui/forces/linked_table.h"

namespace geargraph {

class EfficiencyCardTest : public QObject, private OpenForcesPanel {
  Q_OBJECT

 private slots:
  void init() {
    show();
    panel->showView(ForceView::efficiency);
  }
  void cleanup() { close(); }

  /// The card: in symbols, with the limit of self-locking; a drag of its slider is one undo step.
  void theCardOfTheEfficiency() {
    open(loadedSet());
    auto* slider = panel->findChild<QSlider*>(QStringLiteral("meshEfficiencySlider"));
    const auto stated = [&] {
      const auto& defaults = document->mechanism()->gearDefaults;
      return defaults && defaults->efficiency ? defaults->efficiency->exact() : Rational(0);
    };
    QVERIFY(slider->isEnabled());
    slider->setSliderDown(true);
    for (const int steps : {198, 197, 196}) slider->setValue(steps);
    slider->setSliderDown(false);
    settle();
    QCOMPARE(stated(), Rational(98, 100));
    QCOMPARE(field("meshEfficiency").number()->exact(), Rational(98, 100));
    QCOMPARE(panel->total(QStringLiteral("forward")), QStringLiteral("0.971714"));
    QCOMPARE(panel->findChild<QLabel*>(QStringLiteral("exact.forward"))->text(), QStringLiteral("3401/3500"));
    EfficiencyCard& card = panel->efficiency();
    QCOMPARE(card.locking(), QStringLiteral("Never self-locking, at any efficiency"));
    QVERIFY2(card.formula().contains(QStringLiteral("i<sub>9</sub>")) &&
                 card.formula().contains(QStringLiteral("\u03B7<sub>10</sub>")),
             qPrintable(card.formula()));
    document->undoStack().undo();
    settle();
    QCOMPARE(stated(), Rational(0));
    QCOMPARE(slider->value(), slider->maximum());
    // A key is a step of its own.
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Left);
    QTest::keyClick(slider, Qt::Key_Left);
    QCOMPARE(stated(), Rational(99, 100));
    document->undoStack().undo();
    QCOMPARE(stated(), Rational(199, 200));
    // Of a coefficient of friction it takes the place.
    Mechanism rubbing = loadedSet();
    rubbing.gearDefaults.emplace().friction = Number(Rational(1, 20));
    open(rubbing);
    QVERIFY(slider->toolTip().contains(QLatin1String("replaces the coefficient of friction")));
    slider->setValue(190);
    QVERIFY(!document->mechanism()->gearDefaults->friction);
    // Where all meshes state their own it moves nothing, and says so.
    Mechanism own = loadedSet();
    for (GearMesh& mesh : own.gearMeshes) mesh.efficiency = Number(Rational(9, 10));
    open(own);
    QVERIFY(!slider->isEnabled() && slider->toolTip().startsWith(QLatin1String("Every mesh states")));
  }

  /// A carrier that drives a sun beside a fixed one, nearly equal.
  void whereSelfLockingBegins() {
    Mechanism mechanism = test::TrainSketch(3)
                              .joint(0, 1, "a")
                              .joint(0, 2, "a")
                              .joint(1, 3, "b")
                              .mesh(0, 3, 99, 101, MeshKind::external)
                              .mesh(3, 2, 100, 100, MeshKind::external)
                              .build();
    mechanism.inputs = std::vector<Input>{{mechanism.turningJoints[0].id, Number(1), {}}};
    mechanism.loads = {{{}, JointTorque{mechanism.turningJoints[1].id, Number(1)}}};
    open(mechanism);
    QVERIFY2(panel->efficiency().locking().endsWith(QStringLiteral("below \u03B7 = 0.99")) ||
                 panel->efficiency().locking().endsWith(QStringLiteral("below \u03B7 = 0.9901")),
             qPrintable(panel->efficiency().locking()));
    QVERIFY(panel->efficiency().formula().isEmpty() ||
            panel->efficiency().formula().startsWith(QChar(0x3B7)));
    const auto* label = panel->findChild<QLabel*>(QStringLiteral("selfLocking"));
    QVERIFY2(label->toolTip().contains(QLatin1String("counts as the same in all meshes")) &&
                 label->toolTip().contains(QLatin1String("no choice of driving gears solves it")),
             qPrintable(label->toolTip()));
    // Meshes that state different efficiencies: their losses grow by one factor.
    mechanism.gearMeshes[0].efficiency = Number(Rational(199, 200));
    mechanism.gearMeshes[1].efficiency = Number(Rational(999, 1000));
    open(mechanism);
    const QString text = panel->efficiency().locking();
    QVERIFY2(text.startsWith(QLatin1String("Self-locking")) && text.contains(QLatin1String("from 33")) &&
                 text.endsWith(QLatin1String(" % of these losses on")),
             qPrintable(text));
    QVERIFY(label->toolTip().contains(QLatin1String("multiplied by one factor")));
  }

  /// Where the panel is narrow the card stands above the plot.
  void theCardFindsRoom() {
    open(loadedSet());
    const auto place = [&](const QWidget& part) { return part.mapTo(panel.get(), QPoint(0, 0)); };
    panel->resize(900, 400);
    QTRY_VERIFY(place(panel->plots()).x() > place(panel->efficiency()).x() + 200);
    panel->resize(480, 500);
    QTRY_VERIFY(place(panel->plots()).y() > place(panel->efficiency()).y() + 20);
    QVERIFY(place(panel->plots()).x() < 20);
  }

  /// Friction, and what meshes state themselves, stand by their names.
  void whatMeshesStateIsNamed() {
    open(loadedSet());
    const auto* own = panel->findChild<QLabel*>(QStringLiteral("ownLosses"));
    QVERIFY(!own->isVisible());
    Mechanism mechanism = loadedSet();
    mechanism.gearDefaults.emplace().friction = Number(Rational(1, 20));
    mechanism.gearMeshes[1].efficiency = Number(Rational(99, 100));
    open(mechanism);
    QTRY_VERIFY(own->isVisible());
    QVERIFY2(own->text().contains(QStringLiteral("μ = 0.05")) &&
                 own->text().contains(QStringLiteral("mesh 10: η = 0.99")),
             qPrintable(own->text()));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::EfficiencyCardTest)
#include "test_efficiency_card.moc"
