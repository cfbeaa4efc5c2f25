#include <QAbstractItemModelTester>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "core/mechanism/model/edits.h"
#include "tests/core/support/example_files.h"
#include "ui/atlas_panel/atlas_panel.h"
#include "ui/atlas_panel/chain_card.h"
#include "ui/atlas_panel/chain_grid.h"
#include "ui/atlas_panel/chain_picture.h"
#include "ui/atlas_panel/filter_chips.h"

namespace geargraph {

class AtlasPanelTest : public QObject {
  Q_OBJECT

  std::unique_ptr<Document> document;
  Selection selection;
  std::unique_ptr<AtlasPanel> panel;

  template <class T>
  T& part(const char* name) {
    return *panel->findChild<T*>(QLatin1String(name));
  }
  QString text(const char* label) { return part<QLabel>(label).text(); }
  ChainGrid& grid() { return part<ChainGrid>("chains"); }
  ChainListModel& model() { return *static_cast<ChainListModel*>(grid().model()); }
  QString chosen() { return QString::fromStdString(grid().current()->number.toString()); }
  FilterChips& chips(const char* choice) {
    return *qobject_cast<FilterChips*>(part<QToolButton>(choice).parentWidget());
  }
  void press(const char* chip) { QTest::mouseClick(&part<QToolButton>(chip), Qt::LeftButton); }
  void follow(const char* label, const QString& link) {
    emit part<QLabel>(label).linkActivated(link);
    settle();
  }
  void settle() { QTRY_VERIFY(panel->isSettled()); }
  void open(const Mechanism& mechanism) {
    document->replace(mechanism, {});
    settle();
  }
  QStringList pictured() {
    QStringList labels;
    for (const Mark& mark : part<ChainPicture>("chainPicture").drawing().marks)
      if (const auto* label = std::get_if<Text>(&mark.what);
          label && mark.role == MarkRole::label && label->bold)
        labels << QString::fromStdString(label->text);
    return labels;
  }

 private slots:
  void init() {
    selection.clear();
    document = std::make_unique<Document>();
    document->replace(test::example("robot"), {});
    panel = std::make_unique<AtlasPanel>(document.get(), &selection);
    panel->resize(900, 600);
    panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel.get()));
    panel->setAwake(true);
    settle();
  }
  void cleanup() { panel.reset(); }

  void theListKeepsTheRulesOfItemModels() {
    QAbstractItemModelTester tester(&model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    press("links.6");
    press("dof.2");
    QVERIFY(model().rowCount() > 0);
  }

  // [AU, Fig. 2]: two gear pairs, and one part of four links.
  void theRobotIsThreeChains() {
    const QString train = text("train");
    QVERIFY2(train.contains("3 chains"), qPrintable(train));
    QCOMPARE(train.count("chain:3-1.1.1\""), 2);
    QCOMPARE(train.count("chain:4-1.1.2\""), 1);
    QCOMPARE(chosen(), QString("3-1.1.1"));
    QVERIFY(model().isOwn(grid().current()));
  }

  void whatWasLeftOutIsSaid() {
    open(test::example("redundant-planetary"));
    const QString train = text("train");
    QVERIFY2(train.contains("chain:4-1.1.1\""), qPrintable(train));
    QVERIFY2(train.contains("in no gear pair: 0") && train.contains("repeat another: 5, 6, 7, 8"),
             qPrintable(train));
    QCOMPARE(chosen(), QString("4-1.1.1"));
  }

  void theTrainFollowsTheDocument() {
    open(emptyMechanism());
    QVERIFY2(text("train").contains("no gear pair yet"), qPrintable(text("train")));
    open(test::example("simpson"));
    QVERIFY(text("train").contains("6-1.12.1"));
    QCOMPARE(chosen(), QString("6-1.12.1"));
    // One whose links are not joined yet.
    document->apply({"Add link",
                     [](const Mechanism& before) {
                       return withLink(before, CanvasPoint{90, 90});
                     },
                     0});
    settle();
    QVERIFY2(text("train").contains("unfinished"), qPrintable(text("train")));
    document->undoStack().undo();
    settle();
    QVERIFY(text("train").contains("6-1.12.1"));
  }

  void outOfSightNothingIsIdentified() {
    panel->setAwake(false);
    document->replace(test::example("simpson"), {});
    QVERIFY(text("train").contains("3 chains"));
    panel->setAwake(true);
    settle();
    QVERIFY(text("train").contains("6-1.12.1"));
  }

  // Counts as in Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301.
  void filtersChangeCounts() {
    panel->setFilter({.links = 6, .dof = 1});
    QCOMPARE(model().rowCount(), 81);
    QVERIFY2(text("count").startsWith("81 of ") && text("count").contains("27 equations"),
             qPrintable(text("count")));
    FilterChips& axes = chips("axes.3");
    QCOMPARE(axes.countOf(2) + axes.countOf(3) + axes.countOf(4) + axes.countOf(5), 81);
    const int three = axes.countOf(3);
    QCOMPARE(chips("links.7").countOf(7), 647);
    press("axes.3");
    QCOMPARE(model().rowCount(), three);
    for (const AtlasChain* chain : model().chains()) QCOMPARE(chain->chain.axes.size(), std::size_t{3});
    QVERIFY(chips("links.7").countOf(7) < 647);  // with three axes, too
    QCOMPARE(chips("links.6").countOf(6), three);
    press("axes.3");
    press("links.6");
    QCOMPARE(model().rowCount(), 1 + 3 + 13 + 81 + 647);
    press("dof.2");
    QCheckBox& whole = part<QCheckBox>("nonfractionated");
    const int all = model().rowCount();
    whole.click();
    QVERIFY(model().rowCount() > 0 && model().rowCount() < all);
    QVERIFY(whole.text().contains(whole.locale().toString(model().rowCount())));
    for (const AtlasChain* chain : model().chains()) QVERIFY(isNonfractionated(chain->chain));
  }

  void noRowOfChoicesIsCutOff() {
    const QWidget& chip = part<QToolButton>("dof.2");
    const QWidget* column = chip.window();
    for (const QWidget* each = chip.parentWidget(); each != nullptr; each = each->parentWidget())
      if (each->inherits("QAbstractScrollArea")) column = each;
    QTRY_VERIFY(chip.mapTo(column, QPoint(chip.width(), 0)).x() <= column->width());
  }

  void whatIsCountedIsExplained() {
    QVERIFY(text("source").contains("043301"));
    QVERIFY(part<QLabel>("definition").isHidden());
    emit part<QLabel>("whatIsCounted").linkActivated("definition");
    QVERIFY(part<QLabel>("definition").isVisible());
    QVERIFY(text("definition").contains("rotation graphs"));
  }

  void trainsThatCannotTurnSayWhy() {
    emit part<QLabel>("cannotTurn").linkActivated("locked");
    settle();
    QVERIFY(model().rowCount() >= 40);
    QCOMPARE(chosen(), QString("4-0.1.1"));
    QVERIFY(part<QLabel>("reason").isVisible());
    QVERIFY2(text("reason").contains("3 gear pairs") && text("reason").contains("4 links"),
             qPrintable(text("reason")));
    QVERIFY(panel->showChain({4, 1, 1, 1}));
    settle();
    QVERIFY(!part<QLabel>("reason").isVisible());
  }

  void aRelativeIsALinkThatSelectsIt() {
    follow("train", "chain:4-1.1.2");
    QCOMPARE(chosen(), QString("4-1.1.2"));
    QVERIFY2(text("relatives").contains("chain:4-1.1.1\""), qPrintable(text("relatives")));
    follow("relatives", "chain:4-1.1.1");
    QCOMPARE(chosen(), QString("4-1.1.1"));
    QCOMPARE(text("chainTitle"), QString("4-1.1.1"));
    // One that the filters hide: they are let go of.
    press("axes.2");
    follow("relatives", "chain:5-1.1.3");
    QCOMPARE(chosen(), QString("5-1.1.3"));
    QVERIFY(!panel->filter().axes && panel->filter().links == 5);
  }

  void aChosenChainStaysWhateverIsEdited() {
    follow("train", "chain:4-1.1.2");
    document->apply({"Add link",
                     [](const Mechanism& before) {
                       return withLink(before, CanvasPoint{90, 90});
                     },
                     0});
    settle();
    QCOMPARE(chosen(), QString("4-1.1.2"));
  }

  void ownChainsHaveTheNumbersOfTheTrainAndAreShownInIt() {
    follow("train", "chain:4-1.1.2");
    QStringList labels = pictured();
    QCOMPARE(labels.size(), 4);
    part<QPushButton>("showChain").click();
    QStringList selected;
    for (const ElementId& element : selection.selected())
      if (element.kind == ElementKind::link)
        for (std::size_t i = 0; i < document->mechanism()->links.size(); ++i)
          if (ElementId(document->mechanism()->links[i].id) == element) selected << QString::number(i);
    labels.sort();
    selected.sort();
    QCOMPARE(selected, labels);
    QCOMPARE(selection.selected().size(), std::size_t{6});  // and two gear pairs
    follow("relatives", "chain:4-1.1.1");
    QVERIFY(!part<QPushButton>("showChain").isEnabled());
    labels = pictured();
    labels.sort();
    QCOMPARE(labels, (QStringList{"1", "2", "3", "4"}));
  }

  void keysWalkFindAndOpen() {
    panel->setFilter({.links = 5, .dof = 1});
    QCOMPARE(model().rowCount(), 13);
    grid().setFocus();
    const QString first = chosen();
    QTest::keyClick(&grid(), Qt::Key_Right);
    QVERIFY(chosen() != first);
    QTest::keyClick(&grid(), '/');
    QLineEdit& field = part<QLineEdit>("findChain");
    QTRY_VERIFY(field.hasFocus());
    QTest::keyClicks(&field, "6-1.5");
    QTest::keyClick(&field, Qt::Key_Return);
    settle();
    QVERIFY(model().rowCount() >= 1);
    for (const AtlasChain* chain : model().chains()) QCOMPARE(chain->number.rotation, 5);
    QSignalSpy rejected(panel.get(), &AtlasPanel::rejected);
    field.setText("9-9.9");
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(rejected.count(), 1);

    QVERIFY(panel->showChain({6, 1, 12, 1}));
    settle();
    part<QPushButton>("copyNumber").click();
    QCOMPARE(QApplication::clipboard()->text(), QString("6-1.12.1"));
    QSignalSpy wanted(panel.get(), &AtlasPanel::documentWanted);
    QTest::keyClick(&grid(), Qt::Key_Return);
    settle();
    QCOMPARE(wanted.count(), 1);
    const auto made = wanted.front().front().value<MechanismPtr>();
    QCOMPARE(made->links.size(), std::size_t{6});
    QCOMPARE(made->gearMeshes.size(), std::size_t{4});
    // It is what was asked for: identified, it has the same number.
    open(*made);
    QVERIFY(text("train").contains("6-1.12.1"));
  }

  // Not before, and each once: a filter with many chains stays quick.
  void picturesAreDrawnWhenTheyScrollIn() {
    panel->setFilter({.links = 7, .dof = 1});
    const AtlasChain* first = model().chains().front();
    const AtlasChain* last = model().chains().back();
    QTRY_VERIFY(!model().picture(first, Theme::light, grid().devicePixelRatioF()).isNull());
    settle();
    QVERIFY(model().picture(last, Theme::light, grid().devicePixelRatioF()).isNull());  // begins to be drawn
    settle();
    QVERIFY(!model().picture(last, Theme::light, grid().devicePixelRatioF()).isNull());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::AtlasPanelTest)

#include "test_atlas_panel.moc"
