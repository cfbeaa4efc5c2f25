#include <QAccessible>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QScopeGuard>
#include <QTest>
#include <QWheelEvent>

#include "core/mechanism/fitting/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/pins.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/train_sketch.h"
#include "ui/panels/inputs_panel.h"
#include "ui/panels/number_field.h"
#include "ui/panels/properties_panel.h"
#include "ui/panels/speed_slider.h"

namespace geargraph {

class EditingPanelsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<Document> document;
  Selection selection;
  std::unique_ptr<PropertiesPanel> properties;
  std::unique_ptr<InputsPanel> inputs;

  NumberField* field(QWidget& panel, const char* name) {
    for (auto* found : panel.findChildren<NumberField*>(QLatin1String(name))) {
      if (found->isVisible()) return found;
    }
    return nullptr;
  }
  NumberField* property(const char* name) { return field(*properties, name); }
  const GearMesh& mesh(const char* id) { return *document->mechanism()->find(MeshId(id)); }
  static void focus(QWidget* widget) {
    widget->window()->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(widget->window()));
    widget->setFocus();
  }
  static QLineEdit* lineOf(NumberField* field) { return field->findChild<QLineEdit*>(); }
  template <class Field>
  static void type(Field* into, const QString& text) {
    focus(into);
    into->selectAll();
    QTest::keyClicks(into, text);
    QTest::keyClick(into, Qt::Key_Return);
  }

 private slots:
  void init() {
    selection.clear();
    document = std::make_unique<Document>();
    Mechanism robot = test::robotTopology();
    robot.inputs = std::vector<Input>{{JointId("8"), Number(1), {}}, {JointId("9"), Number(0), {}}};
    document->replace(std::move(robot), {});
    properties = std::make_unique<PropertiesPanel>(document.get(), &selection);
    inputs = std::make_unique<InputsPanel>(document.get(), &selection);
    for (QWidget* panel : {static_cast<QWidget*>(properties.get()), static_cast<QWidget*>(inputs.get())}) {
      panel->resize(500, 300);
      panel->show();
      QVERIFY(QTest::qWaitForWindowExposed(panel));
    }
  }
  void cleanup() {
    properties.reset();
    inputs.reset();
    document.reset();
  }

  void typedTeethAreOneStep() {
    selection.select({ElementId(MeshId("15"))});
    type(property("tailTeeth"), QStringLiteral("27"));
    QCOMPARE(mesh("15").tailTeeth, 27);
    QCOMPARE(mesh("15").headTeeth, 36);
    QCOMPARE(document->undoStack().count(), 1);
    document->undoStack().undo();
    QCOMPARE(mesh("15").tailTeeth, 18);
    QCOMPARE(property("tailTeeth")->text(), QStringLiteral("18"));
  }

  void arrowKeysSpin() {
    selection.select({ElementId(MeshId("15"))});
    NumberField* teeth = property("headTeeth");
    focus(teeth);
    QTest::keyClick(teeth, Qt::Key_Up);
    QTest::keyClick(teeth, Qt::Key_Up);
    QTest::keyClick(teeth, Qt::Key_Down, Qt::ControlModifier);
    QCOMPARE(mesh("15").headTeeth, 28);
    QCOMPARE(document->undoStack().count(), 1);
  }

  void pagesWheelAndArrowsSpin() {
    selection.select({ElementId(MeshId("15"))});
    NumberField* teeth = property("headTeeth");
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

  /// Screen readers find a spin button with its bounds, and can set it.
  void aNumberIsAccessible() {
    selection.select({ElementId(MeshId("15"))});
    NumberField* teeth = property("tailTeeth");
    QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(teeth);
    QVERIFY(seen != nullptr);
    QCOMPARE(seen->role(), QAccessible::SpinBox);
    QAccessibleValueInterface* number = seen->valueInterface();
    QVERIFY(number != nullptr);
    QCOMPARE(number->currentValue().toInt(), 18);
    QCOMPARE(number->minimumValue().toInt(), kFewestTeeth);
    QCOMPARE(number->minimumStepSize().toDouble(), 1.0);
    number->setCurrentValue(24);
    QCOMPARE(mesh("15").tailTeeth, 24);
    number->setCurrentValue(2.5);
    QCOMPARE(mesh("15").tailTeeth, 24);
    QVERIFY(teeth->QObject::property("wrong").toBool());
  }

  void whatIsNoNumberChangesNothing() {
    selection.select({ElementId(MeshId("15"))});
    NumberField* teeth = property("tailTeeth");
    type(teeth, QStringLiteral("x"));
    QVERIFY(teeth->QObject::property("wrong").toBool());
    QVERIFY(!teeth->toolTip().isEmpty());
    QCOMPARE(mesh("15").tailTeeth, 18);
    type(teeth, QStringLiteral("100001"));
    QVERIFY(teeth->QObject::property("wrong").toBool());
    QCOMPARE(mesh("15").tailTeeth, 10000);  // as long as it was in range, it was followed
    teeth->clearFocus();
    QCOMPARE(teeth->text(), QStringLiteral("10000"));
    QVERIFY(!teeth->QObject::property("wrong").toBool());
  }

  void lengthsMayBeTypedInOtherUnits() {
    selection.select({ElementId(JointId("8"))});
    NumberField* offset = property("offset");
    QVERIFY2(offset->toolTip().contains(QStringLiteral("mm")), qPrintable(offset->toolTip()));
    const auto value = [this] { return document->mechanism()->find(JointId("8"))->offset.exact(); };
    type(offset, QStringLiteral("1/2 in"));
    QCOMPARE(value(), Rational(127, 10));
    QCOMPARE(offset->text(), QStringLiteral("1/2 in"));  // what is typed stays until the field is left
    type(offset, QStringLiteral("2.5cm"));
    QCOMPARE(value(), Rational(25));
    type(offset, QStringLiteral("3 parsec"));
    QVERIFY(offset->QObject::property("wrong").toBool());
    offset->clearFocus();
    QCOMPARE(offset->text(), QStringLiteral("3"));
    type(property("axisDirection.x"), QStringLiteral("1 in"));
    QVERIFY(property("axisDirection.x")->QObject::property("wrong").toBool());  // is no length
  }

  void limitsOfAJointAreTypedAndTakenAway() {
    selection.select({ElementId(JointId("8"))});
    const auto limits = [this] { return document->mechanism()->find(JointId("8"))->limits; };
    type(property("highLimit"), QStringLiteral("170"));
    QCOMPARE(limits(), (JointLimits{std::nullopt, Number(170)}));
    QCOMPARE(document->undoStack().count(), 1);  // one step, however many keys
    type(property("lowLimit"), QStringLiteral("-90"));
    QCOMPARE(limits(), (JointLimits{Number(-90), Number(170)}));
    type(property("lowLimit"), QStringLiteral("90"));  // the reference pose has to be within
    QCOMPARE(limits().low.value_or(Number(1)).value() <= 0, true);
    document->undoStack().undo();
    QCOMPARE(limits(), (JointLimits{std::nullopt, Number(170)}));
    focus(property("highLimit"));
    property("highLimit")->selectAll();
    QTest::keyClick(property("highLimit"), Qt::Key_Delete);
    QCOMPARE(limits(), JointLimits());
  }

  void limitsThatAreRejectedLeaveTheFieldWithItsReason() {
    selection.select({ElementId(JointId("8"))});
    const auto limits = [this] { return document->mechanism()->find(JointId("8"))->limits; };
    const auto wrong = [this] { return properties->findChild<QLabel*>(QStringLiteral("wrong")); };
    NumberField* low = property("lowLimit");
    type(low, QStringLiteral("abc"));
    QVERIFY(low->QObject::property("wrong").toBool());
    QCOMPARE(limits(), JointLimits());
    type(property("highLimit"), QStringLiteral("-45"));  // would leave the reference pose outside
    QVERIFY(property("highLimit")->QObject::property("wrong").toBool());
    QVERIFY(wrong()->isVisible());
    QVERIFY2(wrong()->text().contains(QStringLiteral("the second at least 0")), qPrintable(wrong()->text()));
    QCOMPARE(property("highLimit")->text(), QStringLiteral("-45"));  // to be corrected
    QCOMPARE(limits(), JointLimits());
    focus(low);
    QCOMPARE(property("highLimit")->text(), QString());
    QVERIFY(!property("highLimit")->QObject::property("wrong").toBool());
    QVERIFY(!wrong()->isVisible());
    type(property("highLimit"), QStringLiteral("45"));
    type(low, QStringLiteral("50"));  // above the upper end
    QVERIFY(low->QObject::property("wrong").toBool());
    QTest::keyClick(low, Qt::Key_Down);  // from the document's value on
    QCOMPARE(limits(), (JointLimits{Number(-5), Number(45)}));
    QVERIFY(!low->QObject::property("wrong").toBool());
  }

  void decimalCommasMayBeTypedWhereTheyAreUnambiguous() {
    selection.select({ElementId(JointId("8"))});
    const auto high = [this] { return document->mechanism()->find(JointId("8"))->limits.high; };
    NumberField* field = property("highLimit");
    const auto restored = qScopeGuard([before = QLocale()] { QLocale::setDefault(before); });
    QLocale::setDefault(QLocale(QLocale::German));
    type(field, QStringLiteral("170,5"));
    QVERIFY(!field->QObject::property("wrong").toBool());
    QCOMPARE(high().value_or(Number(0)).exact(), Rational(341, 2));
    type(field, QStringLiteral("1,7,5"));
    QVERIFY(field->QObject::property("wrong").toBool());
    QLocale::setDefault(QLocale::c());
    type(field, QStringLiteral("1,500"));  // it could mean a thousand and a half
    QVERIFY(field->QObject::property("wrong").toBool());
    QCOMPARE(high().value_or(Number(0)).exact(), Rational(341, 2));
    type(field, QStringLiteral("0,75"));
    QCOMPARE(high().value_or(Number(0)).exact(), Rational(3, 4));
  }

  void severalMeshesChangeTogether() {
    selection.select({ElementId(MeshId("15")), ElementId(MeshId("16"))});
    QVERIFY(property("tailTeeth")->text().isEmpty());  // 18 and 20
    type(property("tailTeeth"), QStringLiteral("24"));
    QCOMPARE(mesh("15").tailTeeth, 24);
    QCOMPARE(mesh("16").tailTeeth, 24);
    QCOMPARE(mesh("16").headTeeth, 30);
    QCOMPARE(document->undoStack().count(), 1);
  }

  void axesArePlacedWithExactFractions() {
    selection.select({ElementId(JointId("8"))});
    type(property("axisPoint.y"), QStringLiteral("-22/7"));
    const Axis& axis = *document->mechanism()->find(AxisId("a"));
    QVERIFY(axis.point.has_value());
    QCOMPARE((*axis.point)[1].text(), std::string("-22/7"));
    QVERIFY((*axis.point)[0].exact().isZero());
    type(property("axisDirection.z"), QStringLiteral("0"));
    QCOMPARE(document->mechanism()->find(AxisId("a"))->direction.has_value(), false);  // length 0: refused
  }

  void whyIsSaidBelowTheFields() {
    const auto wrong = [this] { return properties->findChild<QLabel*>("wrong"); };
    selection.select({ElementId(JointId("8"))});
    type(property("axisDirection.z"), QStringLiteral("0"));
    QVERIFY(wrong()->isVisible());
    QVERIFY2(wrong()->text().contains("length 0"), qPrintable(wrong()->text()));
    type(property("axisDirection.z"), QStringLiteral("2"));
    QVERIFY(!wrong()->isVisible());
    type(property("offset"), QStringLiteral("1/0"));
    QVERIFY2(wrong()->text().contains("such as 12, 0.5 or 22/7"), qPrintable(wrong()->text()));
    type(property("offset"), QStringLiteral("22/7"));
    QVERIFY(!wrong()->isVisible());
    QCOMPARE(document->mechanism()->find(JointId("8"))->offset.text(), std::string("22/7"));
  }

  void whatIsTypedIsCommittedOnce() {
    selection.select({ElementId(MeshId("15"))});
    NumberField* teeth = property("tailTeeth");
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
    NumberField* tail = property("tailTeeth");
    NumberField* head = property("headTeeth");
    const int before = mesh("15").tailTeeth;
    focus(tail);
    tail->selectAll();
    QTest::keyClicks(tail, QStringLiteral("2.5"));
    focus(head);
    QCOMPARE(mesh("15").tailTeeth, before);
    QCOMPARE(tail->text(), QString::number(before));
    QVERIFY(!tail->QObject::property("wrong").toBool());
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
    NumberField* teeth = property("tailTeeth");
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
    NumberField* teeth = property("tailTeeth");
    QLineEdit* line = lineOf(teeth);
    QTest::mouseClick(line, Qt::LeftButton, {}, QPoint(4, line->height() / 2));
    QCOMPARE(line->selectedText(), QStringLiteral("18"));
    QTest::keyClicks(teeth, QStringLiteral("25"));
    QCOMPARE(mesh("15").tailTeeth, 18);  // not yet
    QTRY_COMPARE(mesh("15").tailTeeth, 25);
  }

  void jointsGetANewAxisTogether() {
    selection.select({ElementId(JointId("13")), ElementId(JointId("14"))});
    auto* axis = properties->findChild<QComboBox*>("axis");
    QCOMPARE(axis->currentIndex(), -1);
    QCOMPARE(axis->placeholderText(), QStringLiteral("several"));
    focus(axis);
    QTest::keyClick(axis, Qt::Key_End);
    const AxisId made = document->mechanism()->find(JointId("13"))->axis;
    QCOMPARE(made, AxisId("f"));
    QCOMPARE(document->mechanism()->find(JointId("14"))->axis, made);
    QVERIFY(document->mechanism()->find(AxisId("d")) == nullptr);  // nobody uses it any more
    QCOMPARE(axis->currentText(), QStringLiteral("f"));
    QCOMPARE(document->undoStack().count(), 1);
  }

  void severalAxesAreTurnedTogether() {
    const auto point = [](const char* axis, int y, int z) {
      return [=](const Mechanism& before) {
        return withAxisPlaced(before, AxisId(axis), {}, NumberTriple{Number(0), Number(y), Number(z)});
      };
    };
    document->apply({QString(), point("a", 0, 1), 0});
    document->apply({QString(), point("d", 1, 0), 0});
    selection.select({ElementId(JointId("8")), ElementId(JointId("13"))});
    QCOMPARE(property("axisDirection.x")->text(), QStringLiteral("0"));
    QCOMPARE(property("axisDirection.y")->text(), QString());
    QCOMPARE(lineOf(property("axisDirection.y"))->placeholderText(), QStringLiteral("several"));
    QCOMPARE(lineOf(property("axisPoint.y"))->placeholderText(), QStringLiteral("auto"));
    type(property("axisDirection.z"), QStringLiteral("1/3"));
    const auto now = [this](const char* axis) {
      return *document->mechanism()->find(AxisId(axis))->direction;
    };
    QCOMPARE(now("a")[1].text(), std::string("0"));  // each keeps what was not typed
    QCOMPARE(now("d")[1].text(), std::string("1"));
    QCOMPARE(now("a")[2].text(), std::string("1/3"));
    QCOMPARE(now("d")[2].text(), std::string("1/3"));
  }

  void linksAreNamedAndGrounded() {
    selection.select({ElementId(LinkId("4"))});
    auto* name = properties->findChild<QLineEdit*>(QStringLiteral("linkName"));
    type(name, QStringLiteral("sun"));
    QCOMPARE(document->mechanism()->find(LinkId("4"))->name, std::string("sun"));
    QCOMPARE(document->undoStack().count(), 1);
    QTest::mouseClick(properties->findChild<QPushButton*>(QStringLiteral("makeGround")), Qt::LeftButton);
    QCOMPARE(document->mechanism()->links.front().id, LinkId("4"));
    auto* again = properties->findChild<QPushButton*>(QStringLiteral("makeGround"));
    QVERIFY(!again->isEnabled());
    QVERIFY(again->toolTip().contains("ground already"));
  }

  void kindsOfMeshesAreChosen() {
    selection.select({ElementId(MeshId("15"))});
    auto* kind = properties->findChild<QComboBox*>(QStringLiteral("meshKind"));
    focus(kind);
    QTest::keyClick(kind, Qt::Key_Down);
    QCOMPARE(mesh("15").kind, std::optional(MeshKind::external));
    QTest::keyClick(kind, Qt::Key_Up);
    QCOMPARE(mesh("15").kind, std::nullopt);
  }

  void aVanishedElementLeavesTheForm() {
    selection.select({ElementId(MeshId("15"))});
    const ElementId gone[] = {ElementId(MeshId("15"))};
    QVERIFY(
        document->apply({QStringLiteral("Delete"),
                         [&](const Mechanism& mechanism) { return withoutElements(mechanism, gone); }, 0}));
    selection.keepOnly([](const ElementId&) { return false; });
    QVERIFY(properties->findChild<QLineEdit*>(QStringLiteral("documentName")) != nullptr);
  }

  void slidersAndFieldsSetSpeeds() {
    auto* slider = inputs->findChild<SpeedSlider*>(QStringLiteral("slider.9"));
    const QPoint middle = slider->rect().center();
    QTest::mousePress(slider, Qt::LeftButton, {}, middle);
    for (int x = 10; x <= 60; x += 10) QTest::mouseMove(slider, middle + QPoint(x, 0));
    QTest::mouseRelease(slider, Qt::LeftButton, {}, middle + QPoint(60, 0));
    const auto speed = [this](std::size_t i) { return (*document->mechanism()->inputs)[i].speed; };
    QVERIFY(speed(1).value() > 0);
    QCOMPARE(document->undoStack().count(), 1);
    type(field(*inputs, "speed.8"), QStringLiteral("-3/2"));
    QCOMPARE(speed(0).text(), std::string("-3/2"));
    QCOMPARE(document->undoStack().count(), 2);
    QVERIFY(inputs->findChild<SpeedSlider*>(QStringLiteral("slider.8"))->value() < 0);
  }

  void withoutInputsThePanelSaysWhatToDo() {
    document->replace(emptyMechanism(), {});
    const auto labels = inputs->findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text().contains("No joint is driven yet");
    }));
  }

  void theRingFollowsTheTeethOfTheSunInOneUndoStep() {
    document->replace(test::planetary(24, 18, 3), {});
    const MechanismPtr before = document->mechanism();
    selection.select({ElementId(before->gearMeshes[0].id)});
    type(property("tailTeeth"), QStringLiteral("30"));
    for (int planet = 0; planet < 3; ++planet) {
      QCOMPARE(document->mechanism()->gearMeshes[static_cast<std::size_t>(2 * planet)].tailTeeth, 30);
      QCOMPARE(document->mechanism()->gearMeshes[static_cast<std::size_t>(2 * planet + 1)].headTeeth, 66);
    }
    document->undoStack().undo();
    QCOMPARE(document->mechanism(), before);
  }

  void aTrainOfTooManyMeshesSaysThatNothingFollows() {
    Mechanism many = test::planetary(24, 18, 3);
    while (many.c() < kMostFittedMeshes) {
      many.gearMeshes.push_back(many.gearMeshes.front());
      many.gearMeshes.back().id = MeshId("m" + std::to_string(many.c()));
    }
    const ElementId first(many.gearMeshes[0].id);
    const auto isSaid = [&](const Mechanism& shown) {
      document->replace(shown, {});
      selection.select({first});
      const auto texts = properties->findChildren<QLabel*>();
      return std::any_of(texts.begin(), texts.end(), [](const QLabel* text) {
        return text->isVisible() && text->text().contains("500 meshes") &&
               text->text().contains("do not follow");
      });
    };
    QVERIFY(!isSaid(many));
    many.gearMeshes.push_back(many.gearMeshes.front());
    many.gearMeshes.back().id = MeshId("one more");
    QVERIFY(isSaid(many));
    type(property("tailTeeth"), QStringLiteral("30"));  // and so it is
    QCOMPARE(document->mechanism()->gearMeshes[0].tailTeeth, 30);
    QCOMPARE(document->mechanism()->gearMeshes[2].tailTeeth, 24);
  }

  void theModuleOfAMeshIsTypedAndPinned() {
    document->replace(test::planetary(24, 18, 3), {});
    selection.select({ElementId(document->mechanism()->gearMeshes[0].id)});
    QCOMPARE(property("module")->text(), QStringLiteral("2"));
    type(property("module"), QStringLiteral("2.5"));
    const Mechanism after = *document->mechanism();
    const NumberTriple& planet = *after.axes[1].point;
    QCOMPARE(std::hypot(planet[0].value(), planet[1].value()), 52.5);
    selection.select({ElementId(after.gearMeshes[0].id), ElementId(after.gearMeshes[5].id)});
    QCOMPARE(property("module")->text(), QStringLiteral("2.5"));  // the ring's, too
    selection.select({ElementId(after.gearMeshes[0].id)});
    type(property("module"), QStringLiteral("0"));
    QVERIFY(!properties->findChild<QLabel*>("wrong")->text().isEmpty());
    QCOMPARE(document->mechanism()->axes, after.axes);

    auto* box = properties->findChild<QCheckBox*>("pinModule");
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    QVERIFY(box->isChecked() && isPinned(document->mechanism()->gearMeshes[0]));
    QVERIFY(!property("module")->isEnabled() && !property("pitchPoint.x")->isEnabled());
    const Mechanism held = *document->mechanism();
    selection.select({ElementId(after.gearMeshes[1].id)});
    type(property("module"), QStringLiteral("3"));  // of the same wheels
    QVERIFY(properties->findChild<QLabel*>("wrong")->text().contains("pinned"));
    QCOMPARE(*document->mechanism(), held);
  }

  void whatIsPinnedStaysAndIsBlamed() {
    const auto pin = [this](const char* name) {
      auto* box = properties->findChild<QCheckBox*>(QLatin1String(name));
      QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
      return box;
    };
    document->replace(test::planetary(24, 18, 3), {});
    selection.select({ElementId(LinkId("2"))});
    QVERIFY(pin("pinTeeth")->isChecked());  // the ring
    selection.select({ElementId(document->mechanism()->gearMeshes[0].id)});
    type(property("tailTeeth"), QStringLiteral("30"));
    QCOMPARE(document->mechanism()->gearMeshes[0].headTeeth, 15);  // the planets give way
    QCOMPARE(document->mechanism()->gearMeshes[1].headTeeth, 60);
    pin("pinHead");
    type(property("tailTeeth"), QStringLiteral("24"));
    auto* wrong = properties->findChild<QLabel*>("wrong");
    QVERIFY2(wrong->text().contains("gear 2") && wrong->text().contains("pinned"), qPrintable(wrong->text()));
    QCOMPARE(document->mechanism()->gearMeshes[0].tailTeeth, 30);

    document->replace(test::planetary(24, 18, 3), {});
    selection.select({ElementId(document->mechanism()->turningJoints[3].id)});
    auto* box = pin("pinAxis");
    QVERIFY(box->isChecked() && isPinned(document->mechanism()->axes[1]));
    QVERIFY(!property("axisPoint.x")->isEnabled());
    document->undoStack().undo();
    QVERIFY(!box->isChecked() && property("axisPoint.x")->isEnabled());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::EditingPanelsTest)
#include "test_editing_panels.moc"
