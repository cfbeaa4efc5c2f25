#include <QAccessible>
#include <QCheckBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "core/theory/states/state_edits.h"
#include "tests/core/support/example_files.h"
#include "ui/canvas/drawing_accessible.h"
#include "ui/lever_views/levers_bar.h"
#include "ui/lever_views/levers_view.h"
#include "ui/lever_views/point_offers.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// The view with a document and its analysis, and a hand on it.
struct LeversDriver {
  Document document;
  Selection selection;
  LeversView view{&document, &selection};

  explicit LeversDriver(const Mechanism& mechanism) {
    QObject::connect(&document, &Document::changed, &view, [this] { analyze(); });
    view.resize(1100, 700);
    view.show();
    static_cast<void>(QTest::qWaitForWindowActive(&view));
    document.replace(mechanism, "test.geargraph");
    analyze();
    wait();
  }

  void analyze() { view.setSnapshot(geargraph::analyze(document.mechanism())); }
  void wait() const { QTRY_VERIFY(view.isUpToDate()); }
  void choose(LeversPage page) {
    view.setPage(page);
    wait();
  }

  /// The point of this link on the bar of this lever.
  [[nodiscard]] LeverSpot spot(int lever, int label) const {
    const LeverPicture picture = *leverPictureOf(*geargraph::analyze(document.mechanism()));
    for (const LeverSpot& each : view.spots()) {
      const auto& links = picture.plan.levers[static_cast<std::size_t>(each.lever)]
                              .points[static_cast<std::size_t>(each.point)]
                              .links;
      if (each.lever == lever && std::find(links.begin(), links.end(), LinkOrdinal(label)) != links.end())
        return each;
    }
    qFatal("no such point");
  }
  [[nodiscard]] QPoint onScreen(CanvasPoint p) const { return view.mapFromScene(QPointF(p.x, p.y)); }
  void press(QPoint at) { QTest::mousePress(view.viewport(), Qt::LeftButton, {}, at); }
  void move(QPoint at, Qt::MouseButton button = Qt::LeftButton) {
    QMouseEvent event(QEvent::MouseMove, at, view.viewport()->mapToGlobal(at), Qt::NoButton, button, {});
    QCoreApplication::sendEvent(view.viewport(), &event);
  }
  void release(QPoint at) { QTest::mouseRelease(view.viewport(), Qt::LeftButton, {}, at); }
  void click(QPoint at) {
    press(at);
    release(at);
  }
  void key(Qt::Key code, Qt::KeyboardModifiers keys = {}) { QTest::keyClick(&view, code, keys); }
  [[nodiscard]] int steps() { return document.undoStack().index(); }
  [[nodiscard]] double inputSpeed() const { return document.mechanism()->inputs->front().speed.value(); }
  [[nodiscard]] std::set<ElementId> link(int label) const {
    return {document.mechanism()->links[static_cast<std::size_t>(label)].id};
  }
  [[nodiscard]] bool isEngaged(const char* coupling) const {
    const auto& engaged = document.mechanism()->engaged;
    return std::find(engaged.begin(), engaged.end(), ShiftElementId(coupling)) != engaged.end();
  }
  [[nodiscard]] bool says(const QString& words) const {
    for (const Mark& mark : view.displayList().marks) {
      const auto* const text = std::get_if<Text>(&mark.what);
      if (text != nullptr && QString::fromStdString(text->text).contains(words)) return true;
    }
    return false;
  }
  [[nodiscard]] int marksOf(ColorRole role) const {
    int count = 0;
    for (const Mark& mark : view.displayList().marks) {
      const auto* const stroke = std::get_if<Stroke>(&mark.what);
      count += stroke != nullptr && !stroke->tint.link && stroke->tint.role == role ? 1 : 0;
    }
    return count;
  }
};

Mechanism engaged(const char* name, int state) {
  return *withStateEngaged(example(name), state);
}

}  // namespace

class LeversViewTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { installDrawingAccessibility(); }

  void leversOfTheEngagedStateAreDrawnAndFit() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    QVERIFY(driver.view.emptyText().isEmpty());
    QCOMPARE(driver.view.spots().size(), std::size_t(12));  // three on each bar
    QVERIFY(driver.says("set 1") && driver.says("0.719"));
    const QRectF drawn = static_cast<DrawingScene*>(driver.view.scene())->drawnRect();
    const QRectF seen = driver.view.mapToScene(driver.view.viewport()->rect()).boundingRect();
    QVERIFY(seen.contains(drawn));
  }

  void speedsAndTorquesCanBeLeftOut() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    auto* speeds = driver.view.findChild<QCheckBox*>("leverSpeeds");
    auto* torques = driver.view.findChild<QCheckBox*>("leverTorques");
    QVERIFY(driver.says("0.719") && driver.says("−0.427"));
    speeds->click();
    QVERIFY(!driver.says("0.719") && driver.says("−0.427"));
    torques->click();
    QVERIFY(!driver.says("−0.427"));
    for (const LeverSpot& spot : driver.view.spots()) QCOMPARE(spot.tip.x, spot.at.x);
    speeds->click();
    QVERIFY(driver.says("0.719") && !driver.says("−0.427"));
  }

  void clickAndHoverAreThoseOfAllViews() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    const LeverSpot four = driver.spot(0, 4);
    driver.move(driver.onScreen(four.center), Qt::NoButton);
    QCOMPARE(driver.selection.hovered(), driver.link(4));
    const int before = driver.marksOf(ColorRole::accent);
    driver.click(driver.onScreen(four.center));
    QCOMPARE(driver.selection.selected(), driver.link(4));
    QVERIFY(driver.marksOf(ColorRole::accent) > before);  // on both bars that it is on
    driver.selection.select(driver.link(2));              // as another view does
    QCOMPARE(driver.marksOf(ColorRole::accent), before + 2);
  }

  void theCardTellsPlaceSpeedTorqueAndWhatIf() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    const QString held = driver.view.cardOf(driver.spot(0, 3));
    QVERIFY2(held.contains("held by brake B"), qPrintable(held));
    QVERIFY2(held.contains("4 divides"), qPrintable(held));
    QVERIFY2(held.contains("96 : 48 teeth") || held.contains("48 : 96 teeth"), qPrintable(held));
    QVERIFY2(held.contains("1955/6871 = 0.285 N m"), qPrintable(held));
    QVERIFY2(held.contains("A for B: state 7, ratio 120/143 = 0.839"), qPrintable(held));
    QVERIFY2(held.contains("let go of B: 2 freedoms"), qPrintable(held));
    const QString free = driver.view.cardOf(driver.spot(0, 4));
    QVERIFY2(free.contains("1057/1471 = 0.719 rad/s"), qPrintable(free));
    QVERIFY2(free.contains("nothing turns any more"), qPrintable(free));
  }

  // The tip of 4 follows the mouse, so the input turns as many times quicker as the tip is farther out.
  void draggingATipTurnsTheTrainInOneStep() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    const int before = driver.steps();
    const LeverSpot four = driver.spot(0, 4);
    const QPoint from = driver.onScreen(four.tip);
    const QPoint zero = driver.onScreen(four.at);
    const int reach = from.x() - zero.x();
    QVERIFY(reach > 20);
    driver.press(from);
    driver.move(from + QPoint(reach / 2, 0));
    driver.wait();
    driver.move(QPoint(zero.x() + 2 * reach, from.y()));
    driver.wait();
    const QPoint shown = driver.onScreen(driver.spot(0, 4).tip);
    QVERIFY2(std::abs(shown.x() - (zero.x() + 2 * reach)) <= 3, qPrintable(QString::number(shown.x())));
    driver.release(QPoint(zero.x() + 2 * reach, from.y()));
    driver.wait();
    QCOMPARE(driver.steps(), before + 1);
    QVERIFY2(std::abs(driver.inputSpeed() - 2) < 0.1, qPrintable(QString::number(driver.inputSpeed())));
    QCOMPARE(driver.selection.selected(), driver.link(4));
    driver.document.undoStack().undo();
    QCOMPARE(driver.inputSpeed(), 1.0);
  }

  void escapePutsTheSpeedBack() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    const QPoint from = driver.onScreen(driver.spot(0, 4).tip);
    driver.press(from);
    driver.move(from + QPoint(30, 0));
    QVERIFY(driver.inputSpeed() != 1.0);
    driver.key(Qt::Key_Escape);
    QCOMPARE(driver.inputSpeed(), 1.0);
    driver.release(from);
    QCOMPARE(driver.inputSpeed(), 1.0);
  }

  // 4 turns at 1057/1471 of the input: to turn at 1057 the input has to at 1471.
  void aTypedSpeedIsExact() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    driver.click(driver.onScreen(driver.spot(0, 4).center));
    driver.key(Qt::Key_Return);
    auto* field = driver.view.viewport()->findChild<QLineEdit*>();
    QVERIFY(field != nullptr);
    field->setText("1057/10");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(driver.document.mechanism()->inputs->front().speed.exact(), Rational(1471, 10));
    driver.wait();
    driver.view.setFocus();
    driver.key(Qt::Key_Return);
    field = driver.view.viewport()->findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
    QVERIFY(field != nullptr);
    field->setText("fast");
    const int before = driver.steps();
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(driver.steps(), before);
    QVERIFY(driver.view.hint().contains("fast"));
  }

  void brakesAreLetGoAndHeldAndDiscsTied() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    driver.click(driver.onScreen(driver.spot(0, 3).center));
    QVERIFY(driver.isEngaged("B"));
    driver.view.toggleBrake();
    QVERIFY(!driver.isEngaged("B"));
    driver.wait();
    driver.view.toggleBrake();
    QVERIFY(driver.isEngaged("B"));
    driver.wait();
    driver.view.toggleBrake();
    driver.wait();
    // 5 and 6 have the clutch E.
    QVERIFY(!driver.isEngaged("E"));
    const QPoint five = driver.onScreen(driver.spot(2, 5).center);
    const QPoint six = driver.onScreen(driver.spot(2, 6).center);
    driver.press(five);
    driver.move((five + six) / 2);
    driver.move(six);
    driver.release(six);
    QVERIFY(driver.isEngaged("E"));
  }

  void keysWalkAlongABarAndToTheNext() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    driver.view.setFocus();
    driver.key(Qt::Key_Down);
    const int first = driver.view.spots().front().bar;
    QCOMPARE(first, 0);
    const auto labelOfSpot = [&](std::size_t i) {
      for (int label = 0; label < 9; ++label) {
        const LeverSpot at = driver.view.spots()[i];
        const LeverPicture picture = *leverPictureOf(*geargraph::analyze(driver.document.mechanism()));
        if (picture.plan.levers[static_cast<std::size_t>(at.lever)]
                .points[static_cast<std::size_t>(at.point)]
                .links.front() == LinkOrdinal(label))
          return label;
      }
      return -1;
    };
    QCOMPARE(driver.selection.selected(), driver.link(labelOfSpot(0)));
    driver.key(Qt::Key_Down);
    QCOMPARE(driver.selection.selected(), driver.link(labelOfSpot(1)));
    driver.key(Qt::Key_Down);
    driver.key(Qt::Key_Down);  // the end of the bar
    QCOMPARE(driver.selection.selected(), driver.link(labelOfSpot(2)));
    driver.key(Qt::Key_Up);
    QCOMPARE(driver.selection.selected(), driver.link(labelOfSpot(1)));
    QVERIFY2(driver.view.hint().contains("rad/s"), qPrintable(driver.view.hint()));
    driver.key(Qt::Key_Tab);
    QVERIFY(driver.view.hasFocus());
    QVERIFY(driver.view.hint().contains("set"));
    for (int i = 0; i < 3; ++i) driver.key(Qt::Key_Tab);
    QVERIFY2(!driver.view.hasFocus(), "after the last bar Tab goes on");
  }

  void readersAreToldThePoints() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    const QString four = driver.view.describe(*driver.link(4).begin());
    QVERIFY2(four.contains("of the way from"), qPrintable(four));
    QVERIFY2(four.contains("0.719 rad/s"), qPrintable(four));
    QAccessibleInterface* reader = QAccessible::queryAccessibleInterface(&driver.view);
    QVERIFY(reader != nullptr);
    QStringList names;
    for (int i = 0; i < reader->childCount(); ++i) names << reader->child(i)->text(QAccessible::Name);
    QVERIFY(names.contains(four));
    QCOMPARE(reader->indexOfChild(QAccessible::queryAccessibleInterface(&driver.view.bar())) >= 0, true);
  }

  void aClickInTheNomogramEngagesTheState() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    driver.choose(LeversPage::nomogram);
    QVERIFY(driver.view.emptyText().isEmpty());
    QVERIFY(driver.view.nomogram().lines.size() >= 9);
    const auto& tags = driver.view.nomogram().tags;
    const auto tag = std::find_if(tags.begin(), tags.end(), [](const NomogramSheet::Tag& each) {
      return each.states == std::vector<int>{0};
    });
    QVERIFY(tag != tags.end());
    const QPoint at = driver.onScreen(tag->box.center);
    driver.move(at, Qt::NoButton);
    QCOMPARE(driver.view.stateLookedAt(), std::optional(0));
    QVERIFY2(driver.view.hint().contains("State 1") && driver.view.hint().contains("108/23"),
             qPrintable(driver.view.hint()));
    const int before = driver.steps();
    driver.click(at);
    QCOMPARE(driver.steps(), before + 1);
    QVERIFY(driver.isEngaged("A") && driver.isEngaged("B") && driver.isEngaged("C") &&
            !driver.isEngaged("D"));
    driver.wait();
    driver.view.setFocus();
    driver.move(QPoint(2, driver.view.viewport()->height() - 2), Qt::NoButton);
    driver.key(Qt::Key_Down);
    QCOMPARE(driver.view.stateLookedAt(), std::optional(1));
    driver.key(Qt::Key_Return);
    QVERIFY(driver.isEngaged("A") && driver.isEngaged("B") && driver.isEngaged("E"));
  }

  void planOfTwoFreedoms() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    driver.choose(LeversPage::plan);
    QVERIFY(driver.view.emptyText().isEmpty());
    QVERIFY(driver.view.spots().empty() && !driver.view.displayList().marks.empty());
    LeversDriver robot(example("spur-pair"));
    robot.choose(LeversPage::plan);
    QVERIFY2(robot.view.emptyText().contains("two freedoms"), qPrintable(robot.view.emptyText()));
  }

  void whereThereIsNoLeverItSaysWhy() {
    LeversDriver driver(example("robot"));
    QVERIFY2(driver.view.emptyText().contains("Bevel pinions have no place on a lever"),
             qPrintable(driver.view.emptyText()));
    QCOMPARE(driver.view.whyNoPicture(), driver.view.emptyText());
    QVERIFY(driver.view.displayList().marks.empty() && driver.view.spots().empty());
    LeversDriver drawn(example("planetary-ring-held"));
    QVERIFY(drawn.view.whyNoPicture().isEmpty() && !drawn.view.picture().marks.empty());
    driver.choose(LeversPage::nomogram);
    QVERIFY(!driver.view.emptyText().isEmpty());
  }

  void lessonsCloseTheAnswer() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    driver.view.setAnswersOpen(false);
    QVERIFY(driver.view.displayList().marks.empty() && driver.view.emptyText().contains("answer"));
    driver.view.setAnswersOpen(true);
    QVERIFY(driver.says("0.719") && driver.view.emptyText().isEmpty());
  }

  /// A lesson's step reads the drawing: it is there without numbers, and nothing of it can be moved.
  void aStepReadsTheLeversWithoutNumbers() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    driver.view.setRead(true);
    driver.view.setAnswersOpen(false);
    QVERIFY(driver.view.emptyText().isEmpty());
    QCOMPARE(driver.view.spots().size(), std::size_t(12));
    QVERIFY(!driver.says("0.719") && !driver.says("−0.427"));
    const LeverSpot input = driver.spot(0, 2);
    driver.press(driver.onScreen(input.tip));
    driver.move(driver.onScreen(input.tip) + QPoint(40, 0));
    driver.release(driver.onScreen(input.tip) + QPoint(40, 0));
    driver.click(driver.onScreen(driver.spot(0, 4).center));
    QVERIFY(!driver.view.offers().isVisible());
    QCOMPARE(driver.steps(), 0);
    driver.choose(LeversPage::nomogram);
    QVERIFY(driver.view.emptyText().isEmpty());
    QCOMPARE(driver.marksOf(ColorRole::halo), 0);  // no state stands out
    driver.view.setAnswersOpen(true);
    QVERIFY(driver.marksOf(ColorRole::halo) > 0);
    driver.choose(LeversPage::levers);
    QVERIFY(driver.says("0.719"));
    driver.view.setRead(false);
    driver.view.setAnswersOpen(false);
    QVERIFY(driver.view.spots().empty());
  }

  void aClickedPointOffersToHoldAndToLock() {
    LeversDriver driver(example("simpson"));
    driver.click(driver.onScreen(driver.spot(0, 4).center));
    PointOffers& offers = driver.view.offers();
    QVERIFY(offers.isVisible());
    QVERIFY(driver.view.viewport()->rect().contains(offers.geometry()));
    QCOMPARE(offers.hold().text(), LeversView::tr("Hold (B)"));
    offers.hold().click();
    QVERIFY(driver.isEngaged("B2") && !offers.isVisible());
    QCOMPARE(driver.steps(), 1);
    driver.wait();
    driver.click(driver.onScreen(driver.spot(0, 4).center));
    QCOMPARE(offers.hold().text(), LeversView::tr("Let go (B)"));
    offers.hold().click();
    QVERIFY(!driver.isEngaged("B2"));
    driver.wait();
    // Locked with the next point that is clicked: the clutch of both is there already.
    driver.click(driver.onScreen(driver.spot(0, 1).center));
    offers.lockWith().click();
    QVERIFY(!offers.isVisible());
    driver.click(driver.onScreen(driver.spot(0, 2).center));
    QVERIFY(driver.isEngaged("C"));
    driver.wait();
    const int steps = driver.steps();
    driver.click(driver.onScreen(driver.spot(0, 4).center));
    offers.lockWith().click();
    driver.key(Qt::Key_Escape);
    driver.click(driver.onScreen(driver.spot(0, 3).center));
    QCOMPARE(driver.steps(), steps);
    driver.key(Qt::Key_Escape);
    QVERIFY(!offers.isVisible());
  }

  /// The points move to one line, and stay there.
  void engagingABrakeProjectsThePlan() {
    LeversDriver driver(example("simpson"));
    driver.choose(LeversPage::plan);
    QCOMPARE(driver.view.planSpots().size(), std::size_t(5));
    const auto placeOf = [&](int label) {
      for (const PointPlanSheet::Spot& spot : driver.view.planSpots()) {
        if (std::find(spot.links.begin(), spot.links.end(), LinkOrdinal(label)) != spot.links.end())
          return spot.center;
      }
      qFatal("no such point");
    };
    driver.click(driver.onScreen(placeOf(4)));
    QVERIFY(driver.view.offers().isVisible());
    driver.view.offers().hold().click();
    QVERIFY(driver.isEngaged("B2"));
    QTRY_VERIFY(driver.view.isUpToDate() && driver.view.planSpots().size() == 4);
    QCOMPARE(placeOf(4), placeOf(0));
    const double output = distance(placeOf(3), placeOf(0));
    QVERIFY(std::abs(distance(placeOf(2), placeOf(0)) / output - 61.0 / 25) < 1e-9);
    driver.document.undoStack().undo();
    QTRY_COMPARE(driver.view.planSpots().size(), std::size_t(5));
  }

  void theSpeedPlanIsAPage() {
    LeversDriver driver(example("planetary-ring-held"));
    driver.choose(LeversPage::speedPlan);
    QVERIFY(driver.view.emptyText().isEmpty());
    QVERIFY(driver.says("0.286") && driver.says("mm/s"));
    driver.document.replace(example("robot"), "robot.geargraph");
    driver.analyze();
    driver.wait();
    QVERIFY(driver.view.emptyText().contains("parallel"));
  }

  void theStateThatIsLookedAtIsTold() {
    LeversDriver driver(example("simpson"));
    driver.choose(LeversPage::nomogram);
    const QSignalSpy told(&driver.view, &LeversView::stateLookedAtChanged);
    const NomogramSheet::Tag tag = driver.view.nomogram().tags.front();
    driver.move(driver.onScreen(tag.box.center), Qt::NoButton);
    QCOMPARE(told.size(), 1);
    QCOMPARE(told.back().front().toInt(), tag.states.front());
    driver.view.lookAtState(2);
    QCOMPARE(driver.view.stateLookedAt(), std::optional(2));
    driver.view.lookAtState(-1);
    QVERIFY(!driver.view.stateLookedAt());
    QCOMPARE(told.back().front().toInt(), -1);
  }

  void ahiddenViewDrawsWhenItIsShown() {
    LeversDriver driver(engaged("eight-speed-gearbox", 4));
    driver.view.hide();
    QVERIFY(driver.document.apply(
        {"Engage", [](const Mechanism& before) { return withStateEngaged(before, 0); }, 0}));
    QVERIFY(!driver.view.isUpToDate() && driver.view.isSettled());
    driver.view.show();
    QTRY_VERIFY(driver.view.isUpToDate());
    QVERIFY(!driver.says("0.719"));
  }
};

QTEST_MAIN(LeversViewTest)

#include "test_levers_view.moc"
