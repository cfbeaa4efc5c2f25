#include <QAccessible>
#include <QApplication>
#include <QLabel>
#include <QLocale>
#include <QScopeGuard>
#include <QTest>
#include <QWheelEvent>
#include <numbers>

#include "core/foundations/base/locale.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "tests/ui/panels/editing_panels.h"

namespace geargraph {

/// Numbers that are typed and spun, in the panels that hold them.
class NumberFieldTest : public QObject, private EditingPanels {
  Q_OBJECT

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void arrowKeysSpin() {
    selection.select({ElementId(MeshId("15"))});
    NumberField* teeth = numberOf("headTeeth");
    focus(teeth);
    QTest::keyClick(teeth, Qt::Key_Up);
    QTest::keyClick(teeth, Qt::Key_Up);
    QTest::keyClick(teeth, Qt::Key_Down, Qt::ControlModifier);
    QCOMPARE(mesh("15").headTeeth, 28);
    QCOMPARE(document->undoStack().count(), 1);
  }

  void pagesWheelAndArrowsSpin() {
    selection.select({ElementId(MeshId("15"))});
    NumberField* teeth = numberOf("headTeeth");
    const int before = mesh("15").headTeeth;
    const auto wheel = [teeth](int turns) {
      const QPointF at = teeth->rect().center();
      QWheelEvent event(at, teeth->mapToGlobal(at), {}, QPoint(0, 120 * turns), Qt::NoButton, Qt::NoModifier,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(teeth, &event);
      return event.isAccepted();
    };
    focus(properties.get());
    QVERIFY(!wheel(1));  // the panel scrolls
    QCOMPARE(mesh("15").headTeeth, before);
    focus(teeth);
    QTest::keyClick(teeth, Qt::Key_PageUp);
    QCOMPARE(mesh("15").headTeeth, before + 10);
    QVERIFY(wheel(-2));
    QCOMPARE(mesh("15").headTeeth, before + 8);
    QTest::mouseClick(teeth, Qt::LeftButton, {}, QPoint(teeth->width() - 8, 5));
    QCOMPARE(mesh("15").headTeeth, before + 9);
    QTest::mouseClick(teeth, Qt::LeftButton, {}, QPoint(teeth->width() - 8, teeth->height() - 5));
    QTest::mouseClick(teeth, Qt::LeftButton, {}, QPoint(teeth->width() - 8, teeth->height() - 5));
    QCOMPARE(mesh("15").headTeeth, before + 7);
    QCOMPARE(document->undoStack().count(), 1);
  }

  void aNumberIsAccessible() {
    selection.select({ElementId(MeshId("15"))});
    NumberField* teeth = numberOf("tailTeeth");
    QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(teeth);
    QVERIFY(seen != nullptr);
    QCOMPARE(seen->role(), QAccessible::SpinBox);
    QAccessibleValueInterface* number = seen->valueInterface();
    QVERIFY(number != nullptr);
    QCOMPARE(number->currentValue().toInt(), 18);
    QCOMPARE(number->minimumValue().toInt(), kMinTeeth);
    QCOMPARE(number->minimumStepSize().toDouble(), 1.0);
    number->setCurrentValue(24);
    QCOMPARE(mesh("15").tailTeeth, 24);
    number->setCurrentValue(2.5);
    QCOMPARE(mesh("15").tailTeeth, 24);
    QVERIFY(teeth->property("wrong").toBool());
  }

  void whatIsNoNumberChangesNothing() {
    selection.select({ElementId(MeshId("15"))});
    NumberField* teeth = numberOf("tailTeeth");
    type(teeth, QStringLiteral("x"));
    QVERIFY(teeth->property("wrong").toBool());
    QVERIFY(!teeth->toolTip().isEmpty());
    QCOMPARE(mesh("15").tailTeeth, 18);
    type(teeth, QStringLiteral("100001"));
    QVERIFY(teeth->property("wrong").toBool());
    QCOMPARE(mesh("15").tailTeeth, 18);  // nor 10000, which was in range on the way
    teeth->clearFocus();
    QCOMPARE(teeth->text(), QStringLiteral("18"));
    QVERIFY(!teeth->property("wrong").toBool());
  }

  void lengthsMayBeTypedInOtherUnits() {
    selection.select({ElementId(JointId("8"))});
    NumberField* offset = numberOf("offset");
    QVERIFY2(offset->toolTip().contains(QStringLiteral("mm")), qPrintable(offset->toolTip()));
    const auto value = [this] { return document->mechanism()->find(JointId("8"))->offset.exact(); };
    type(offset, QStringLiteral("1/2 in"));
    QCOMPARE(value(), Rational(127, 10));
    QCOMPARE(offset->text(), QStringLiteral("1/2 in"));  // what is typed stays until the field is left
    type(offset, QStringLiteral("2.5cm"));
    QCOMPARE(value(), Rational(25));
    type(offset, QStringLiteral("3 parsec"));
    QVERIFY(offset->property("wrong").toBool());
    offset->clearFocus();
    QCOMPARE(value(), Rational(25));
    type(numberOf("axisDirection.x"), QStringLiteral("1 in"));
    QVERIFY(numberOf("axisDirection.x")->property("wrong").toBool());  // is no length
  }

  void expressionsMayBeTyped() {
    selection.select({ElementId(MeshId("15"))});
    NumberField* teeth = numberOf("tailTeeth");
    type(teeth, QStringLiteral("2*12"));
    QCOMPARE(mesh("15").tailTeeth, 24);
    QCOMPARE(teeth->text(), QStringLiteral("2*12"));  // what is typed stays until the field is left
    teeth->clearFocus();
    QCOMPARE(teeth->text(), QStringLiteral("24"));
    type(teeth, QStringLiteral("5/2"));
    QVERIFY(teeth->property("wrong").toBool());
    selection.select({ElementId(JointId("8"))});
    type(numberOf("offset"), QStringLiteral("(1 + 1/2) in"));
    QCOMPARE(document->mechanism()->find(JointId("8"))->offset.exact(), Rational(381, 10));
    type(numberOf("axisDirection.x"), QStringLiteral("1/3+1/5"));
    const AxisId axis = document->mechanism()->find(JointId("8"))->axis;
    QCOMPARE((*document->mechanism()->find(axis)->direction)[0].exact(), Rational(8, 15));
  }

  void anglesMayBeTypedInOtherUnits() {
    selection.select({ElementId(JointId("8"))});
    const auto high = [this] { return document->mechanism()->find(JointId("8"))->limits.high; };
    NumberField* field = numberOf("highLimit");
    type(field, QStringLiteral("3/4 turns"));
    QCOMPARE(high().value_or(Number(0)).exact(), Rational(270));
    type(field, QStringLiteral("90 deg"));
    QCOMPARE(high().value_or(Number(0)).exact(), Rational(90));
    type(field, QStringLiteral("90 rpm"));
    QVERIFY(field->property("wrong").toBool());
    QVERIFY2(field->toolTip().contains(QStringLiteral("turns")), qPrintable(field->toolTip()));
    QCOMPARE(high().value_or(Number(0)).exact(), Rational(90));
  }

  /// A number with a unit is converted to the one that the field shows, a bare one is in it.
  void quantitiesHaveTheUnitOfTheirField() {
    NumberField torque;
    torque.show();
    torque.setQuantity(Quantity::torque, Rational(1, 1000));  // shown in N mm
    type(&torque, QStringLiteral("2*3"));
    torque.commit();
    QCOMPARE(torque.number().value_or(Number(0)).exact(), Rational(6));
    type(&torque, QStringLiteral("0.5 Nm"));
    torque.commit();
    QCOMPARE(torque.number().value_or(Number(0)).exact(), Rational(500));
    NumberField speed;
    speed.show();
    speed.setQuantity(Quantity::speed);
    type(&speed, QStringLiteral("60 rpm"));
    speed.commit();
    QCOMPARE(speed.number().value_or(Number(0)).value(), 2 * std::numbers::pi);
    type(&speed, QStringLiteral("5 Nm"));
    speed.commit();
    QVERIFY(speed.property("wrong").toBool());
  }

  void decimalCommasMayBeTypedWhereTheyAreUnambiguous() {
    selection.select({ElementId(JointId("8"))});
    const auto high = [this] { return document->mechanism()->find(JointId("8"))->limits.high; };
    NumberField* field = numberOf("highLimit");
    const auto restored = qScopeGuard([before = QLocale()] { QLocale::setDefault(before); });
    QLocale::setDefault(QLocale(QLocale::German));
    type(field, QStringLiteral("170,5"));
    QVERIFY(!field->property("wrong").toBool());
    QCOMPARE(high().value_or(Number(0)).exact(), Rational(341, 2));
    type(field, QStringLiteral("1,7,5"));
    QVERIFY(field->property("wrong").toBool());
    QLocale::setDefault(QLocale::c());
    type(field, QStringLiteral("1,500"));  // it could mean a thousand and a half
    QVERIFY(field->property("wrong").toBool());
    QCOMPARE(high().value_or(Number(0)).exact(), Rational(341, 2));
    type(field, QStringLiteral("0,75"));
    QCOMPARE(high().value_or(Number(0)).exact(), Rational(3, 4));
  }

  void numbersHaveTheDecimalSignOfTheLanguage() {
    const auto restored = qScopeGuard([before = QLocale()] {
      QLocale::setDefault(before);
      setDecimalSign('.');
    });
    QLocale::setDefault(QLocale(QLocale::German));
    setDecimalSign(',');
    selection.select({ElementId(JointId("8"))});
    NumberField* field = numberOf("highLimit");
    for (const auto& [number, shown] : {std::pair(Rational(3, 2), "1,5"), std::pair(Rational(9, 8), "1,125"),
                                        std::pair(Rational(-1, 3), "-1/3")}) {
      field->setNumber(Number(number));
      QCOMPARE(field->text(), QLatin1String(shown));
    }
    type(field, QStringLiteral("1,125"));
    QCOMPARE(document->mechanism()->find(JointId("8"))->limits.high.value_or(Number(0)).exact(),
             Rational(9, 8));
    QCOMPARE(field->text(), QStringLiteral("1,125"));
    field->setStep(Rational(1, 10));
    QTest::keyClick(field, Qt::Key_Up);
    QCOMPARE(field->text(), QStringLiteral("1,225"));
  }

  void whatIsTypedIsCommittedOnce() {
    selection.select({ElementId(MeshId("15"))});
    NumberField* teeth = numberOf("tailTeeth");
    focus(teeth);
    teeth->selectAll();
    QTest::keyClicks(teeth, QStringLiteral("120"));
    QCOMPARE(document->undoStack().count(), 0);  // neither 1 nor 12 teeth on the way
    QTest::keyClick(teeth, Qt::Key_Return);
    QCOMPARE(mesh("15").tailTeeth, 120);
    QCOMPARE(document->undoStack().count(), 1);
    teeth->selectAll();
    QTest::keyClicks(teeth, QStringLiteral("30"));
    QTest::keyClick(teeth, Qt::Key_Escape);
    QCOMPARE(teeth->text(), QStringLiteral("120"));
    QTRY_COMPARE(teeth->text(), QStringLiteral("120"));
    type(teeth, QStringLiteral("31"));
    QCOMPARE(document->undoStack().count(), 2);  // Return ended the step before
  }

  void leavingAFieldCommitsItAndAReasonStays() {
    const auto wrong = [this] { return properties->findChild<QLabel*>("wrong"); };
    selection.select({ElementId(MeshId("15"))});
    NumberField* tail = numberOf("tailTeeth");
    NumberField* head = numberOf("headTeeth");
    const int before = mesh("15").tailTeeth;
    focus(tail);
    tail->selectAll();
    QTest::keyClicks(tail, QStringLiteral("2.5"));
    focus(head);
    QCOMPARE(mesh("15").tailTeeth, before);
    QCOMPARE(tail->text(), QString::number(before));
    QVERIFY(!tail->property("wrong").toBool());
    QVERIFY(wrong()->isVisible());
    QVERIFY2(wrong()->text().contains("whole number"), qPrintable(wrong()->text()));
    head->selectAll();
    QTest::keyClicks(head, QStringLiteral("44"));
    focus(tail);
    QCOMPARE(mesh("15").headTeeth, 44);
    QVERIFY(!wrong()->isVisible());
  }

  void undoIsTheDocumentsOnceTheNumberIsCommitted() {
    selection.select({ElementId(MeshId("15"))});
    NumberField* teeth = numberOf("tailTeeth");
    focus(teeth);
    const auto isTakenByTheField = [teeth] {
      QKeyEvent ask(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
      ask.ignore();
      QApplication::sendEvent(teeth, &ask);
      return ask.isAccepted();
    };
    teeth->selectAll();
    QTest::keyClicks(teeth, QStringLiteral("25"));
    QVERIFY(isTakenByTheField());
    QTest::keyClick(teeth, Qt::Key_Return);
    QVERIFY(!isTakenByTheField());
    QCOMPARE(mesh("15").tailTeeth, 25);
    document->undoStack().undo();
    QCOMPARE(teeth->text(), QStringLiteral("18"));
  }

  void aClickSelectsTheWholeNumber() {
    selection.select({ElementId(MeshId("15"))});
    focus(properties.get());
    NumberField* teeth = numberOf("tailTeeth");
    QLineEdit* line = lineOf(teeth);
    QTest::mouseClick(line, Qt::LeftButton, {}, QPoint(4, line->height() / 2));
    QCOMPARE(line->selectedText(), QStringLiteral("18"));
    QTest::keyClicks(teeth, QStringLiteral("25"));
    QCOMPARE(mesh("15").tailTeeth, 18);  // not yet
    QTRY_COMPARE(mesh("15").tailTeeth, 25);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::NumberFieldTest)
#include "test_number_field.moc"
