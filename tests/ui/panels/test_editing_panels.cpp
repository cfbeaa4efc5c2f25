#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QProgressDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QStyle>
#include <QTest>
#include <QTextDocument>
#include <semaphore>
#include <set>

#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/pins.h"
#include "core/mechanism/model/shift_edits.h"
#include "tests/core/support/train_sketch.h"
#include "tests/ui/panels/editing_panels.h"
#include "ui/panels/link_parts.h"
#include "ui/panels/long_edit.h"
#include "ui/panels/speed_slider.h"
#include "ui/panels/teeth_slider.h"

namespace geargraph {

class EditingPanelsTest : public QObject, private EditingPanels {
  Q_OBJECT

  void addBrake() {
    QVERIFY(document->apply(
        {QStringLiteral("Add brake"),
         [](const Mechanism& before) { return withBrake(before, before.links.back().id); }, 0}));
  }

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void typedTeethAreOneStep() {
    selection.select({ElementId(MeshId("15"))});
    type(numberOf("tailTeeth"), QStringLiteral("27"));
    QCOMPARE(mesh("15").tailTeeth, 27);
    QCOMPARE(mesh("15").headTeeth, 36);
    QCOMPARE(document->undoStack().count(), 1);
    document->undoStack().undo();
    QCOMPARE(mesh("15").tailTeeth, 18);
    QCOMPARE(numberOf("tailTeeth")->text(), QStringLiteral("18"));
  }

  /// Screen readers find a spin button with its bounds, and can set it.

  void limitsOfAJointAreTypedAndTakenAway() {
    selection.select({ElementId(JointId("8"))});
    const auto limits = [this] { return document->mechanism()->find(JointId("8"))->limits; };
    type(numberOf("highLimit"), QStringLiteral("170"));
    QCOMPARE(limits(), (JointLimits{std::nullopt, Number(170)}));
    QCOMPARE(document->undoStack().count(), 1);  // one step, however many keys
    type(numberOf("lowLimit"), QStringLiteral("-90"));
    QCOMPARE(limits(), (JointLimits{Number(-90), Number(170)}));
    type(numberOf("lowLimit"), QStringLiteral("90"));  // the reference pose has to be within
    QCOMPARE(limits().low.value_or(Number(1)).value() <= 0, true);
    document->undoStack().undo();
    QCOMPARE(limits(), (JointLimits{std::nullopt, Number(170)}));
    focus(numberOf("highLimit"));
    numberOf("highLimit")->selectAll();
    QTest::keyClick(numberOf("highLimit"), Qt::Key_Delete);
    QTest::keyClick(numberOf("highLimit"), Qt::Key_Return);
    QCOMPARE(limits(), JointLimits());
  }

  void limitsThatAreRejectedLeaveTheFieldWithItsReason() {
    selection.select({ElementId(JointId("8"))});
    const auto limits = [this] { return document->mechanism()->find(JointId("8"))->limits; };
    const auto wrong = [this] { return properties->findChild<QLabel*>(QStringLiteral("wrong")); };
    NumberField* low = numberOf("lowLimit");
    type(low, QStringLiteral("abc"));
    QVERIFY(low->property("wrong").toBool());
    QCOMPARE(limits(), JointLimits());
    type(numberOf("highLimit"), QStringLiteral("-45"));  // would leave the reference pose outside
    QVERIFY(numberOf("highLimit")->property("wrong").toBool());
    QVERIFY(wrong()->isVisible());
    QVERIFY2(wrong()->text().contains(QStringLiteral("the second at least 0")), qPrintable(wrong()->text()));
    QCOMPARE(numberOf("highLimit")->text(), QStringLiteral("-45"));  // to be corrected
    QCOMPARE(limits(), JointLimits());
    focus(low);
    QCOMPARE(numberOf("highLimit")->text(), QString());
    QVERIFY(!numberOf("highLimit")->property("wrong").toBool());
    QVERIFY(!wrong()->isVisible());
    type(numberOf("highLimit"), QStringLiteral("45"));
    type(low, QStringLiteral("50"));  // above the upper end
    QVERIFY(low->property("wrong").toBool());
    QTest::keyClick(low, Qt::Key_Down);  // from the document's value on
    QCOMPARE(limits(), (JointLimits{Number(-5), Number(45)}));
    QVERIFY(!low->property("wrong").toBool());
  }

  /// What takes long for all of a large document is worked out beside the window, and may be cancelled.
  void manyElementsAreChangedBesideTheWindow() {
    document->replace(test::randomTrain(7, 400, 160), {});
    const MechanismPtr before = document->mechanism();
    std::vector<ElementId> all;
    for (const TurningJoint& joint : before->turningJoints) all.emplace_back(joint.id);
    selection.select({all.begin(), all.end()});
    type(numberOf("highLimit"), QStringLiteral("90"));
    QCOMPARE(document->mechanism(), before);  // being worked out
    addBrake();
    QTRY_COMPARE(document->mechanism()->turningJoints.back().limits.high, Number(90));
    QCOMPARE(document->mechanism()->couplings.size(), std::size_t{1});  // what came in between is kept
    QVERIFY(std::all_of(document->mechanism()->turningJoints.begin(),
                        document->mechanism()->turningJoints.end(),
                        [](const TurningJoint& joint) { return joint.limits.high == Number(90); }));
    QCOMPARE(document->undoStack().count(), 2);

    type(numberOf("lowLimit"), QStringLiteral("20"));  // the reference pose has to be within
    auto* wrong = properties->findChild<QLabel*>(QStringLiteral("wrong"));
    QTRY_VERIFY(wrong->isVisible());
    QCOMPARE(document->undoStack().count(), 2);
    QCOMPARE(numberOf("lowLimit")->text(), QString());
  }

  void aLongEditSaysHowFarItIsAndCanBeCancelled() {
    std::binary_semaphore gate(0);
    std::atomic<bool> wasStopped = false;
    QSignalSpy changed(document.get(), &Document::changed);
    auto* edit = new LongEdit(document.get(), properties.get(), QStringLiteral("Change all"), 0, 10,
                              [&](const PlacedMechanism& placed, const LongEdit::Progress& progress) {
                                *progress.done = 4;
                                const std::stop_callback stopped(progress.stop, [&] { gate.release(); });
                                gate.acquire();
                                wasStopped = progress.stop.stop_requested();
                                return Expected<PlacedMechanism>(placed);
                              });
    QSignalSpy ended(edit, &LongEdit::ended);
    QTRY_VERIFY(properties->findChild<QProgressDialog*>() != nullptr);
    auto* dialog = properties->findChild<QProgressDialog*>();
    QVERIFY(dialog->labelText().contains(QStringLiteral("Change all")));
    QTRY_COMPARE(dialog->value(), 4);
    dialog->findChild<QPushButton*>()->click();
    QTRY_COMPARE(ended.count(), 1);
    QTRY_VERIFY(wasStopped);
    QTRY_VERIFY(properties->findChild<QProgressDialog*>() == nullptr);
    QCOMPARE(changed.count(), 0);
  }

  void aLongEditEndsWithItsDocument() {
    std::binary_semaphore gate(0);
    new LongEdit(document.get(), properties.get(), QStringLiteral("Change all"), 0, 10,
                 [&](const PlacedMechanism& placed, const LongEdit::Progress& progress) {
                   const std::stop_callback stopped(progress.stop, [&] { gate.release(); });
                   gate.acquire();
                   return Expected<PlacedMechanism>(placed);
                 });
    close();
  }

  void severalMeshesChangeTogether() {
    selection.select({ElementId(MeshId("15")), ElementId(MeshId("16"))});
    QVERIFY(numberOf("tailTeeth")->text().isEmpty());  // 18 and 20
    type(numberOf("tailTeeth"), QStringLiteral("24"));
    QCOMPARE(mesh("15").tailTeeth, 24);
    QCOMPARE(mesh("16").tailTeeth, 24);
    QCOMPARE(mesh("16").headTeeth, 30);
    QCOMPARE(document->undoStack().count(), 1);
  }

  void axesArePlacedWithExactFractions() {
    selection.select({ElementId(JointId("8"))});
    type(numberOf("axisPoint.y"), QStringLiteral("-22/7"));
    const Axis& axis = *document->mechanism()->find(AxisId("a"));
    QVERIFY(axis.point.has_value());
    QCOMPARE((*axis.point)[1].text(), std::string("-22/7"));
    QVERIFY((*axis.point)[0].exact().isZero());
    type(numberOf("axisDirection.z"), QStringLiteral("0"));
    QCOMPARE(document->mechanism()->find(AxisId("a"))->direction.has_value(), false);  // length 0: rejected
  }

  void whyIsSaidBelowTheFields() {
    const auto wrong = [this] { return properties->findChild<QLabel*>("wrong"); };
    selection.select({ElementId(JointId("8"))});
    type(numberOf("axisDirection.z"), QStringLiteral("0"));
    QVERIFY(wrong()->isVisible());
    QVERIFY2(wrong()->text().contains("length 0"), qPrintable(wrong()->text()));
    type(numberOf("axisDirection.z"), QStringLiteral("2"));
    QVERIFY(!wrong()->isVisible());
    type(numberOf("offset"), QStringLiteral("1/0"));
    QVERIFY2(wrong()->text().contains("such as 12, 0.5, 22/7 or 2*3"), qPrintable(wrong()->text()));
    type(numberOf("offset"), QStringLiteral("22/7"));
    QVERIFY(!wrong()->isVisible());
    QCOMPARE(document->mechanism()->find(JointId("8"))->offset.text(), std::string("22/7"));
  }

  void jointsGetANewAxisTogether() {
    selection.select({ElementId(JointId("13")), ElementId(JointId("14"))});
    auto* axis = properties->findChild<QComboBox*>("axis");
    QCOMPARE(axis->currentIndex(), -1);
    QCOMPARE(axis->placeholderText(), QStringLiteral("several"));
    focus(axis);
    QTest::keyClick(axis, Qt::Key_End);
    const AxisId made = document->mechanism()->find(JointId("13"))->axis;
    QCOMPARE(made, AxisId("d"));  // letters run on
    QCOMPARE(document->mechanism()->find(JointId("14"))->axis, made);
    QVERIFY(document->mechanism()->find(AxisId("e")) == nullptr);  // nobody uses it any more
    QCOMPARE(document->mechanism()->axes.size(), std::size_t(4));
    QCOMPARE(axis->currentText(), QStringLiteral("d"));
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
    QCOMPARE(numberOf("axisDirection.x")->text(), QStringLiteral("0"));
    QCOMPARE(numberOf("axisDirection.y")->text(), QString());
    QCOMPARE(lineOf(numberOf("axisDirection.y"))->placeholderText(), QStringLiteral("several"));
    QCOMPARE(lineOf(numberOf("axisPoint.y"))->placeholderText(), QStringLiteral("auto"));
    type(numberOf("axisDirection.z"), QStringLiteral("1/3"));
    const auto now = [this](const char* axis) {
      return *document->mechanism()->find(AxisId(axis))->direction;
    };
    QCOMPARE(now("a")[1].text(), std::string("0"));  // each keeps what was not typed
    QCOMPARE(now("d")[1].text(), std::string("1"));
    QCOMPARE(now("a")[2].text(), std::string("1/3"));
    QCOMPARE(now("d")[2].text(), std::string("1/3"));
  }

  void aLinkTellsItsJointsAndGears() {
    selection.select({ElementId(LinkId("2"))});
    const auto text = [this](const char* name) {
      return properties->findChild<QLabel*>(QLatin1String(name))->text();
    };
    QCOMPARE(text("parts.joints").count(QLatin1String("with")), qsizetype{3});  // 12, 13 and 14
    QVERIFY2(text("parts.gears").startsWith("30 teeth in mesh"), qPrintable(text("parts.gears")));
    QCOMPARE(text("parts.couplings"), QStringLiteral("none"));
    auto* gears = properties->findChild<QLabel*>("parts.gears");
    emit gears->linkHovered(addressOf(MeshId("16")));
    QCOMPARE(selection.hovered(), (std::set<ElementId>{MeshId("16")}));
    emit gears->linkHovered(QString());
    QVERIFY(selection.hovered().empty());
    emit gears->linkActivated(addressOf(MeshId("16")));
    QCOMPARE(selection.selected(), (std::set<ElementId>{MeshId("16")}));
  }

  void anAxisTellsItsJoints() {
    selection.select({ElementId(AxisId("c"))});
    auto* joints = properties->findChild<QLabel*>(QStringLiteral("parts.joints"));
    QVERIFY(joints != nullptr);
    QTextDocument text;
    text.setHtml(joints->text());
    QCOMPARE(text.toPlainText(), QStringLiteral("11: 1 → 6\n12: 1 → 2"));
    emit joints->linkActivated(addressOf(JointId("12")));
    QCOMPARE(selection.selected(), (std::set<ElementId>{JointId("12")}));
  }

  void aBrakeIsEngagedAndReleased() {
    document->apply({QString(), [](const Mechanism& robot) { return withBrake(robot, LinkId("4")); }, 0});
    const ShiftElementId brake = document->mechanism()->couplings.front().id;
    selection.select({ElementId(brake)});
    auto* engage = properties->findChild<QPushButton*>(QStringLiteral("engage"));
    QVERIFY(engage != nullptr);
    QCOMPARE(engage->text(), QStringLiteral("Engage"));
    QTest::mouseClick(engage, Qt::LeftButton);
    QCOMPARE(document->mechanism()->engaged, std::vector<ShiftElementId>{brake});
    QCOMPARE(engage->text(), QStringLiteral("Release"));
    QTest::mouseClick(engage, Qt::LeftButton);
    QVERIFY(document->mechanism()->engaged.empty());
    document->undoStack().setIndex(0);
    QVERIFY(document->mechanism()->couplings.empty());  // and the form of what is gone does no harm
  }

  void addressesOfElementsKeepAnyId() {
    const ElementId odd{LinkId("a:b \"<%20")};
    QCOMPARE(elementAt(addressOf(odd)), odd);
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
    type(numberOf("tailTeeth"), QStringLiteral("30"));
    for (int planet = 0; planet < 3; ++planet) {
      QCOMPARE(document->mechanism()->gearMeshes[static_cast<std::size_t>(2 * planet)].tailTeeth, 30);
      QCOMPARE(document->mechanism()->gearMeshes[static_cast<std::size_t>(2 * planet + 1)].headTeeth, 66);
    }
    document->undoStack().undo();
    QCOMPARE(document->mechanism(), before);
  }

  /// The whole train goes along while the slider is dragged, and all of it is one step.
  void slidTeethAreLiveAndOneStep() {
    document->replace(test::planetary(24, 18, 3), {});
    const MechanismPtr before = document->mechanism();
    selection.select({ElementId(before->gearMeshes[0].id)});
    auto* slider = properties->findChild<TeethSlider*>(QStringLiteral("tailTeethSlider"));
    QVERIFY(slider != nullptr && slider->isVisible());
    QCOMPARE(slider->value(), 24);
    const auto sun = [this] { return document->mechanism()->gearMeshes[0].tailTeeth; };
    const auto at = [&](int teeth) {
      const int x =
          QStyle::sliderPositionFromValue(slider->minimum(), slider->maximum(), teeth, slider->width() - 16);
      return QPoint(x + 8, slider->height() / 2);
    };
    QTest::mousePress(slider, Qt::LeftButton, {}, at(24));
    std::set<int> seen;
    for (int teeth = 26; teeth <= 60; teeth += 2) {
      QTest::mouseMove(slider, at(teeth));
      seen.insert(sun());
      QCOMPARE(slider->value(), sun());
      QCOMPARE(numberOf("tailTeeth")->text(), QString::number(sun()));
    }
    QVERIFY2(seen.size() > 10, "the train did not go along");
    QVERIFY(sun() > 50);
    QCOMPARE(document->mechanism()->gearMeshes[1].headTeeth, sun() + 2 * 18);  // the ring
    QTest::mouseRelease(slider, Qt::LeftButton, {}, at(60));
    QCOMPARE(document->undoStack().count(), 1);
    document->undoStack().undo();
    QCOMPARE(document->mechanism(), before);
    QCOMPARE(slider->value(), 24);
    // Esc puts back, and the rest of the drag does nothing.
    QTest::mousePress(slider, Qt::LeftButton, {}, at(24));
    QTest::mouseMove(slider, at(50));
    QVERIFY(sun() != 24);
    QTest::keyClick(slider, Qt::Key_Escape);
    QTest::mouseMove(slider, at(60));
    QCOMPARE(*document->mechanism(), *before);
    QCOMPARE(slider->value(), 24);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, at(60));
    QCOMPARE(*document->mechanism(), *before);
    QVERIFY(!document->undoStack().canUndo());
    // Each key is a step of its own.
    focus(slider);
    QTest::keyClick(slider, Qt::Key_Right);
    QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(sun(), 26);
    QCOMPARE(document->undoStack().count(), 2);
  }

  void slidTeethThatAreRejectedStayAndSayWhy() {
    document->replace(test::planetary(24, 18, 3), {});
    const std::vector<ElementId> held{LinkId("2"), document->mechanism()->gearMeshes[0].head};
    document->apply(
        {"Pin", [held](const PlacedMechanism& before) { return withAllPinned(before, held, true); }, 0});
    const Mechanism before = *document->mechanism();
    selection.select({ElementId(before.gearMeshes[0].id)});
    auto* slider = properties->findChild<TeethSlider*>(QStringLiteral("tailTeethSlider"));
    focus(slider);
    QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(*document->mechanism(), before);
    QCOMPARE(slider->value(), 24);
    QVERIFY(properties->findChild<QLabel*>("wrong")->text().contains("pinned"));
    QCOMPARE(document->undoStack().count(), 1);  // the pins
  }

  void aTrainOfTooManyMeshesSaysThatNothingFollows() {
    Mechanism many = test::planetary(24, 18, 3);
    while (many.c() < kMaxFittedMeshes) {
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
    type(numberOf("tailTeeth"), QStringLiteral("30"));  // and so it is
    QCOMPARE(document->mechanism()->gearMeshes[0].tailTeeth, 30);
    QCOMPARE(document->mechanism()->gearMeshes[2].tailTeeth, 24);
  }

  void theModuleOfAMeshIsTypedAndPinned() {
    document->replace(test::planetary(24, 18, 3), {});
    selection.select({ElementId(document->mechanism()->gearMeshes[0].id)});
    QCOMPARE(numberOf("module")->text(), QStringLiteral("2"));
    type(numberOf("module"), QStringLiteral("2.5"));
    const Mechanism after = *document->mechanism();
    const NumberTriple& planet = *after.axes[1].point;
    QCOMPARE(std::hypot(planet[0].value(), planet[1].value()), 52.5);
    selection.select({ElementId(after.gearMeshes[0].id), ElementId(after.gearMeshes[5].id)});
    QCOMPARE(numberOf("module")->text(), QStringLiteral("2.5"));  // the ring's, too
    selection.select({ElementId(after.gearMeshes[0].id)});
    type(numberOf("module"), QStringLiteral("0"));
    QVERIFY(!properties->findChild<QLabel*>("wrong")->text().isEmpty());
    QCOMPARE(document->mechanism()->axes, after.axes);

    auto* box = properties->findChild<QCheckBox*>("pinModule");
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    QVERIFY(box->isChecked() && isPinned(document->mechanism()->gearMeshes[0]));
    QVERIFY(!numberOf("module")->isEnabled() && !numberOf("pitchPoint.x")->isEnabled());
    const Mechanism held = *document->mechanism();
    selection.select({ElementId(after.gearMeshes[1].id)});
    type(numberOf("module"), QStringLiteral("3"));  // of the same wheels
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
    type(numberOf("tailTeeth"), QStringLiteral("30"));
    QCOMPARE(document->mechanism()->gearMeshes[0].headTeeth, 15);  // the planets give way
    QCOMPARE(document->mechanism()->gearMeshes[1].headTeeth, 60);
    pin("pinHead");
    type(numberOf("tailTeeth"), QStringLiteral("24"));
    auto* wrong = properties->findChild<QLabel*>("wrong");
    QVERIFY2(wrong->text().contains("gear 2") && wrong->text().contains("pinned"), qPrintable(wrong->text()));
    QCOMPARE(document->mechanism()->gearMeshes[0].tailTeeth, 30);

    document->replace(test::planetary(24, 18, 3), {});
    selection.select({ElementId(document->mechanism()->turningJoints[3].id)});
    auto* box = pin("pinAxis");
    QVERIFY(box->isChecked() && isPinned(document->mechanism()->axes[1]));
    QVERIFY(!numberOf("axisPoint.x")->isEnabled());
    document->undoStack().undo();
    QVERIFY(!box->isChecked() && numberOf("axisPoint.x")->isEnabled());
  }

  void anAxisIsLaidByItsButton() {
    const Mechanism links = *withLink(*withLink(emptyMechanism(), {0, 0}), {100, 0});
    const Mechanism one = *withTurningJoint(links, links.links[0].id, links.links[1].id);
    document->replace(*withTurningJoint(one, links.links[0].id, links.links[2].id), {});
    selection.select({ElementId(document->mechanism()->turningJoints[1].id)});
    const auto choose = [this](const QString& text, const QString& other = {}) {
      QMenu* menu = properties->findChild<QPushButton*>(QStringLiteral("layAxis"))->menu();
      menu->popup(QPoint(0, 0));
      for (const QString& wanted : {text, other}) {
        if (wanted.isEmpty()) break;
        for (QAction* action : menu->actions()) {
          if (action->text() != wanted) continue;
          if (action->menu() != nullptr) {
            menu = action->menu();
          } else {
            action->trigger();
          }
          break;
        }
      }
      properties->findChild<QPushButton*>(QStringLiteral("layAxis"))->menu()->close();
    };
    const auto along = [this](std::size_t axis, std::size_t component) {
      return std::abs(document->placed().placement().axes[axis].direction[component]) > 1 - 1e-12;
    };
    choose(QStringLiteral("Along x"));
    QVERIFY(along(0, 2) && along(1, 0));
    choose(QStringLiteral("Parallel to"), QStringLiteral("Axis a"));
    QVERIFY(along(1, 2));
    choose(QStringLiteral("Square to"), QStringLiteral("Axis a"));
    QVERIFY(along(1, 1));
    QCOMPARE(document->undoStack().index(), 3);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::EditingPanelsTest)
#include "test_editing_panels.moc"
