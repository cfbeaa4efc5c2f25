#include <QApplication>
#include <QComboBox>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/core/support/example_files.h"
#include "tests/core/support/snapshot_of.h"
#include "tests/core/support/train_sketch.h"
#include "ui/reading/derivation_panel.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

using test::snapshotOf;

Mechanism robot() {
  return test::example("robot");
}

}  // namespace

/// The derivation in the window.
class DerivationPanelTest : public QObject {
  Q_OBJECT

  Selection selection;
  std::unique_ptr<DerivationPanel> panel;

  DerivationView& view() { return panel->view(); }
  void showNow(const SnapshotPtr& snapshot) {
    panel->setSnapshot(snapshot, {});
    panel->setAwake(true);
    QTRY_VERIFY(panel->isUpToDate() && view().report() != nullptr);
  }
  /// Scrolls an equation to the middle; a place on it.
  QPoint bringUp(int number) {
    const QRect place = view().equationPlace(number);
    QScrollBar* bar = view().verticalScrollBar();
    bar->setValue(bar->value() + place.center().y() - view().viewport()->height() / 2);
    return view().equationPlace(number).center();
  }
  void wheel(int delta, Qt::KeyboardModifiers modifiers) {
    const QPointF place = view().viewport()->rect().center();
    QWheelEvent event(place, view().viewport()->mapToGlobal(place), {}, {0, delta}, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(view().viewport(), &event);
  }
  QImage picture() { return view().viewport()->grab().toImage(); }

 private slots:
  void initTestCase() { applyTheme(*qApp, Theme::light); }
  void init() {
    selection.clear();
    selection.unhover();
    panel = std::make_unique<DerivationPanel>(&selection);
    panel->resize(640, 400);
    panel->QWidget::show();
    QVERIFY(QTest::qWaitForWindowExposed(panel.get()));
  }
  void cleanup() { panel.reset(); }

  void aDerivationIsWorkedOutOnceItIsInSight() {
    panel->setSnapshot(snapshotOf(robot()), {});
    QCoreApplication::processEvents();
    QVERIFY(view().report() == nullptr && !panel->isUpToDate());
    QSignalSpy shown(panel.get(), &DerivationPanel::reportShown);
    panel->setAwake(true);
    QVERIFY(!panel->emptyText().isEmpty());
    QVERIFY(shown.wait(60'000));
    QVERIFY(panel->emptyText().isEmpty());
    QCOMPARE(panel->sections().count(), static_cast<int>(view().headings().size()));
    QVERIFY(panel->sections().count() > 8);
  }

  void theNewestSnapshotWins() {
    showNow(snapshotOf(robot()));
    Mechanism other = robot();
    other.name = "Second";
    panel->setSnapshot(snapshotOf(robot()), {});
    panel->setSnapshot(snapshotOf(other), {});
    QTRY_VERIFY(panel->isUpToDate());
    QCOMPARE(view().report()->report().title, std::string("Second"));
  }

  void whatCannotBeDerivedIsSaid() {
    showNow(snapshotOf(robot()));
    panel->setSnapshot(snapshotOf(robot()), QStringLiteral("Too many links."));
    QCOMPARE(panel->emptyText(), QStringLiteral("Too many links."));
    QVERIFY(!panel->sections().isEnabled());
    panel->setSnapshot(snapshotOf(robot()), {});
    QTRY_VERIFY(panel->emptyText().isEmpty());
    QVERIFY(panel->sections().isEnabled());
  }

  void aSectionIsShownAndTold() {
    showNow(snapshotOf(robot()));
    const int last = panel->sections().count() - 3;
    emit panel->sections().activated(last);
    QCOMPARE(view().currentHeading(), last);
    QCOMPARE(panel->sections().currentIndex(), last);
    view().verticalScrollBar()->setValue(0);
    QCOMPARE(panel->sections().currentIndex(), 0);
  }

  // Learn > Compare the methods, before the derivation is worked out and after.
  void aSectionIsBroughtIntoSightOnceItIsThere() {
    const QString comparison = QString::fromLatin1(kComparisonHeading);
    panel->showSection(comparison);
    showNow(snapshotOf(robot()));
    QCOMPARE(panel->sections().currentText(), comparison);
    view().verticalScrollBar()->setValue(0);
    QCOMPARE(panel->sections().currentIndex(), 0);
    panel->showSection(comparison);
    QCOMPARE(panel->sections().currentText(), comparison);
    panel->showSection(QStringLiteral("No such section"));
    QCOMPARE(panel->sections().currentIndex(), 0);
  }

  void theMouseOverAnEquationMeansItsMesh() {
    showNow(snapshotOf(robot()));
    const QPoint place = bringUp(28);
    QTest::mouseMove(view().viewport(), place);
    QCOMPARE(selection.hovered(), std::set<ElementId>{MeshId("16")});
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, place);
    QCOMPARE(selection.selected(), std::set<ElementId>{MeshId("16")});
    QTest::mouseMove(view().viewport(), bringUp(21));
    QVERIFY(selection.hovered().empty());
    QCOMPARE(selection.selected(), std::set<ElementId>{MeshId("16")});
  }

  void aStepMeansTheJointThatItGives() {
    showNow(snapshotOf(robot()));
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, bringUp(40));
    QCOMPARE(selection.selected(), std::set<ElementId>{JointId("12")});
  }

  void equationsOfWhatIsSelectedElsewhereAreTinted() {
    showNow(snapshotOf(robot()));
    const QRect other = view().equationPlace(27);
    bringUp(28);
    const QImage before = picture();
    selection.select({MeshId("16")});
    const QImage after = picture();
    const QRect place = view().equationPlace(28);
    QVERIFY(before.copy(place) != after.copy(place));
    QVERIFY(view().equationPlace(27) != other);
    QCOMPARE(before.copy(view().equationPlace(30)), after.copy(view().equationPlace(30)));
  }

  void whatIsSelectedElsewhereComesIntoSight() {
    showNow(snapshotOf(robot()));
    const QScrollBar& bar = *view().verticalScrollBar();
    QCOMPARE(bar.value(), 0);
    selection.select({MeshId("16")});
    QVERIFY(bar.value() > 0);
    QTest::mouseMove(view().viewport(), QPoint(40, view().viewport()->height() / 3 + 3));
    QCOMPARE(selection.hovered(), std::set<ElementId>{MeshId("16")});
    const int there = bar.value();
    selection.clear();
    selection.select({MeshId("16")});  // in sight already
    QCOMPARE(bar.value(), there);
    selection.select({LinkId("3")});  // no equation is its own
    QCOMPARE(bar.value(), there);
  }

  // Nothing of it lies over the number.
  void theLinesOfOneEquationHaveOneBand() {
    showNow(snapshotOf(robot()));
    view().setZoom(DerivationView::kMaxZoom);
    bringUp(40);
    selection.select({JointId("12")});
    const QImage after = picture();
    const QRect place = view().equationPlace(40);
    const QColor bar = qColor(ColorRole::accent, Theme::light);
    for (int y = place.top() + 2; y < place.bottom() + 100; ++y) QCOMPARE(after.pixelColor(10, y), bar);
    QCOMPARE(after.pixelColor(20, place.bottom()), after.pixelColor(20, place.bottom() + 12));
  }

  void controlAndTheWheelZoomAndStayInTheSection() {
    showNow(snapshotOf(robot()));
    view().showHeading(5);
    wheel(240, Qt::ControlModifier);
    QVERIFY(view().zoom() > 1.2);
    QCOMPARE(view().currentHeading(), 5);
    const int place = view().verticalScrollBar()->value();
    wheel(-120, {});
    QVERIFY(view().verticalScrollBar()->value() > place);
    for (int i = 0; i < 40; ++i) wheel(-240, Qt::ControlModifier);
    QCOMPARE(view().zoom(), DerivationView::kLeastZoom);
  }

  void anEditStaysInTheSection() {
    showNow(snapshotOf(robot()));
    view().showHeading(6);
    Mechanism other = robot();
    other.links[1].name = "another name";
    panel->setSnapshot(snapshotOf(other), {});
    QTRY_VERIFY(panel->isUpToDate());
    QCOMPARE(view().currentHeading(), 6);
  }

  void anEquationIsCopiedAsTex() {
    showNow(snapshotOf(robot()));
    const QPoint place = bringUp(21);
    QVERIFY(view().isEquationAt(place));
    QCOMPARE(view().textAt(place), QStringLiteral("E = t - r = 7 - 4 = 3"));
  }

  void whatIsTooWideEvenInPartsScrolls() {
    showNow(snapshotOf(robot()));
    QCOMPARE(view().horizontalScrollBar()->maximum(), 0);
    panel->resize(220, 300);
    QCOMPARE(view().horizontalScrollBar()->maximum(), 0);
    view().setZoom(DerivationView::kMaxZoom);
    QVERIFY(view().horizontalScrollBar()->maximum() > 0);
    view().setZoom(1);
    panel->resize(1400, 300);
    QCOMPARE(view().horizontalScrollBar()->maximum(), 0);
    QVERIFY(panel->minimumSizeHint().width() < 420);
  }

  /// A window that is resized does not wait for a long derivation.
  void anotherWidthIsLaidOutInATurnOfItsOwn() {
    showNow(snapshotOf(robot()));
    const int before = view().verticalScrollBar()->maximum();
    panel->resize(300, 400);
    QCOMPARE(view().verticalScrollBar()->maximum(), before);
    QTRY_VERIFY(view().verticalScrollBar()->maximum() > before);
  }

  /// Beyond the widest page nothing is laid out anew.
  void aWideViewThatGetsNarrowerDoesNotScrollSideways() {
    showNow(snapshotOf(robot()));
    panel->resize(1600, 400);
    QTRY_COMPARE(view().horizontalScrollBar()->pageStep(), view().viewport()->width());
    panel->resize(1200, 400);
    QTRY_COMPARE(view().horizontalScrollBar()->pageStep(), view().viewport()->width());
    QCOMPARE(view().horizontalScrollBar()->maximum(), 0);
  }

  void aWidthThatChangesMeanwhileCounts() {
    panel->setSnapshot(snapshotOf(robot()), {});
    panel->setAwake(true);
    panel->resize(300, 400);
    QTRY_VERIFY(panel->isUpToDate() && view().report() != nullptr);
    QCoreApplication::processEvents();  // a turn, if one is due
    const int shown = view().verticalScrollBar()->maximum();
    view().setReport(view().report());  // laid out here
    QCOMPARE(view().verticalScrollBar()->maximum(), shown);
  }

  void itFollowsTheTheme() {
    showNow(snapshotOf(robot()));
    QCOMPARE(picture().pixelColor(1, 1), qColor(ColorRole::sheet, Theme::light));
    applyTheme(*qApp, Theme::dark);
    QTRY_COMPARE(picture().pixelColor(1, 1), qColor(ColorRole::sheet, Theme::dark));
    applyTheme(*qApp, Theme::light);
  }

  void aLargeTrainIsShown() {
    showNow(snapshotOf(test::randomTrain(3, 100, 60)));
    view().verticalScrollBar()->setValue(view().verticalScrollBar()->maximum());
    QCOMPARE(view().currentHeading(), static_cast<int>(view().headings().size()) - 1);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::DerivationPanelTest)
#include "test_derivation_panel.moc"
