#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "core/mechanism/model/load_edits.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/train_sketch.h"
#include "tests/ui/forces/open_forces_panel.h"
#include "ui/forces/torque_rows.h"

namespace geargraph {

class TorqueRowsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<Document> document;
  Selection selection;
  std::unique_ptr<ForcesService> service;
  std::unique_ptr<TorqueRows> rows;

  void settle() {
    service->follow(analyze(document->mechanism(), document->revision()));
    QTRY_VERIFY(service->isComplete());
    QCoreApplication::processEvents();  // new rows are shown by an event
  }
  void open(Mechanism mechanism) {
    document->replace(std::move(mechanism), {});
    settle();
  }
  template <class Widget>
  Widget* find(const char* name) {
    for (Widget* each : rows->findChildren<Widget*>(QLatin1String(name)))
      if (!each->isHidden()) return each;
    return nullptr;
  }
  QString name(int row) {
    return find<QToolButton>(qPrintable(QStringLiteral("torque.%1").arg(row)))->text();
  }
  QString value(int row) {
    return find<QLabel>(qPrintable(QStringLiteral("torqueValue.%1").arg(row)))->text();
  }

 private slots:
  void init() {
    selection.clear();
    document = std::make_unique<Document>();
    service = std::make_unique<ForcesService>();
    rows = std::make_unique<TorqueRows>(document.get(), &selection, service.get());
  }
  void cleanup() {
    rows.reset();
    service.reset();
  }

  void loadsAndWhatHoldsThem() {
    QVERIFY(rows->isHidden());
    open(loadedSet());
    QVERIFY(!rows->isHidden());
    QCOMPARE(name(0), QStringLiteral("T in joint 5, link 1"));
    auto* torque = find<NumberField>("torqueOfLoad.0");
    QCOMPARE(torque->number()->exact(), Rational(10));
    QCOMPARE(value(1), QStringLiteral("25 N m, found"));
    QCOMPARE(value(2), QStringLiteral("\u221235 N m, found"));
    for (const QWidget* each : rows->findChildren<QWidget*>()) {
      if (qobject_cast<const QLabel*>(each) == nullptr && qobject_cast<const QToolButton*>(each) == nullptr)
        continue;
      if (!each->isHidden()) QVERIFY2(each->toolTip().size() > 10, qPrintable(each->objectName()));
    }
    // With losses the exact torque is in the tooltip.
    Mechanism lossy = *withDefaultLosses(loadedSet(), Number(Rational(98, 100)), std::nullopt);
    open(lossy);
    QCOMPARE(value(1), QStringLiteral("24.01 N m, found"));
    QVERIFY(find<QLabel>("torqueValue.1")->toolTip().endsWith(QLatin1String("Exactly 2401/100")));
  }

  void aRowIsEditedSelectsAndGoes() {
    open(loadedSet());
    auto* torque = find<NumberField>("torqueOfLoad.0");
    torque->setValue(20);
    QCOMPARE(std::get<JointTorque>(document->mechanism()->loads[0].action).torque.exact(), Rational(20));
    QCOMPARE(value(1), QStringLiteral("25 N m, found"));  // the former one until it is solved anew
    settle();
    QCOMPARE(value(1), QStringLiteral("50 N m, found"));
    document->undoStack().undo();
    settle();
    QCOMPARE(torque->number()->exact(), Rational(10));
    QCOMPARE(value(1), QStringLiteral("25 N m, found"));
    find<QToolButton>("torque.2")->click();
    QVERIFY(selection.isSelected(document->mechanism()->turningJoints[2].id));
    find<QToolButton>("removeTorque.0")->click();
    settle();
    QVERIFY(document->mechanism()->loads.empty());
    QVERIFY(rows->isHidden());
  }

  void whatBrakesAndClutchesCarry() {
    Mechanism gearbox = test::eightSpeed();
    gearbox.engaged = gearbox.states[0].engaged;
    gearbox.inputs = std::vector<Input>{{gearbox.turningJoints[0].id, Number(1), {}}};
    gearbox.loads = {{{}, LinkTorque{gearbox.links[1].id, {}, Number(1)}}};
    gearbox.balances = std::vector<HoldingTorque>{{HoldingTorque::OnLink{gearbox.links[2].id, {}}}};
    open(gearbox);
    QCOMPARE(name(0), QStringLiteral("T on link 1"));
    QVERIFY2(name(1).contains(QLatin1String("held by brake A")), qPrintable(name(1)));
    QVERIFY2(value(1).startsWith(QStringLiteral("carries ")) && value(1).endsWith(QStringLiteral(" N m")),
             qPrintable(value(1)));
    find<QToolButton>("torque.1")->click();
    QVERIFY(selection.isSelected(ShiftElementId("A")));
  }

  /// Only what the document itself holds can be let go, in a step that can be undone.
  void whatIsHeldCanBeLetGo() {
    open(loadedSet());
    QCOMPARE(document->mechanism()->balances->size(), std::size_t{2});
    QVERIFY(find<QToolButton>("letGo.0") == nullptr);  // a load: it is removed
    find<QToolButton>("letGo.2")->click();
    QCOMPARE(document->mechanism()->balances->size(), std::size_t{1});
    QVERIFY(document->mechanism()->balances->front() ==
            HoldingTorque{document->mechanism()->turningJoints[1].id});
    document->undoStack().undo();
    QCOMPARE(document->mechanism()->balances->size(), std::size_t{2});
    // The last one leaves the choice to the program, whose own torques cannot be let go.
    Mechanism one = test::planetary(24, 18);
    one.inputs = std::vector<Input>{{one.turningJoints[0].id, Number(100), {}},
                                    {one.turningJoints[1].id, Number(0), {}}};
    one.loads = {{{}, JointTorque{one.turningJoints[2].id, Number(10)}}};
    open(one);
    QVERIFY(value(1).endsWith(QLatin1String("found")));
    QVERIFY(find<QToolButton>("letGo.1") == nullptr);

    Mechanism gearbox = test::eightSpeed();
    gearbox.engaged = gearbox.states[0].engaged;
    gearbox.inputs = std::vector<Input>{{gearbox.turningJoints[0].id, Number(1), {}}};
    gearbox.loads = {{{}, LinkTorque{gearbox.links[1].id, {}, Number(1)}}};
    gearbox.balances = std::vector<HoldingTorque>{{HoldingTorque::OnLink{gearbox.links[2].id, {}}}};
    open(gearbox);
    const auto engaged = document->mechanism()->engaged;
    find<QToolButton>("letGo.1")->click();
    QCOMPARE(document->mechanism()->engaged.size(), engaged.size() - 1);
    QVERIFY(std::find(document->mechanism()->engaged.begin(), document->mechanism()->engaged.end(),
                      ShiftElementId("A")) == document->mechanism()->engaged.end());
    document->undoStack().undo();
    QVERIFY(document->mechanism()->engaged == engaged);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::TorqueRowsTest)
#include "test_torque_rows.moc"
