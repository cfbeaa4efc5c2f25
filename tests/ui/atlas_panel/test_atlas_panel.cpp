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
#include <QTreeWidget>

#include "core/mechanism/model/edits.h"
#include "tests/core/support/example_files.h"
#include "ui/atlas_panel/atlas_panel.h"
#include "ui/atlas_panel/chain_card.h"
#include "ui/atlas_panel/chain_grid.h"
#include "ui/atlas_panel/chain_picture.h"
#include "ui/atlas_panel/filter_chips.h"
#include "ui/atlas_panel/train_details.h"

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

  /// The schematic and the picture in 3D are those of the document that the chain becomes.
  void aChainIsPicturedInThreeWays() {
    ChainPicture& picture = part<ChainPicture>("chainPicture");
    QVERIFY(!picture.drawing().marks.empty());
    const std::size_t marks = picture.drawing().marks.size();
    press("chainSchematic");
    settle();
    QVERIFY(!picture.drawing().marks.empty());
    QVERIFY(picture.drawing().marks.size() != marks);
    QVERIFY(picture.accessibleName().startsWith("Schematic of chain 3-1.1.1"));
    panel->setFilter({.links = 4, .dof = 1});
    settle();
    QVERIFY(picture.accessibleName().startsWith("Schematic of chain 4-1"));
    QVERIFY(!picture.drawing().marks.empty());
    press("chainInSpace");
    settle();
    QVERIFY(picture.drawing().marks.empty());
    if (picture.image().isNull()) {
      QVERIFY2(!picture.toolTip().isEmpty(), "neither a picture nor a reason");
    } else {
      QSet<QRgb> colors;
      const QImage image = picture.image();
      for (int y = 0; y < image.height(); y += 4)
        for (int x = 0; x < image.width(); x += 4) colors << image.pixel(x, y);
      QVERIFY(colors.size() > 20);
    }
    press("chainDigraph");
    QVERIFY(!picture.drawing().marks.empty());
  }

  // As `identify --choices` has them.
  void treesInputsAndFramesAreListed() {
    open(test::example("planetary-ring-held"));
    auto& list = part<QTreeWidget>("choicesList");
    QVERIFY(list.isHidden());
    part<QPushButton>("askChoices").click();
    settle();
    QCOMPARE(list.topLevelItemCount(), 3);
    QCOMPARE(list.topLevelItem(0)->text(0), QString("Trees of turning joints: 3"));
    QCOMPARE(list.topLevelItem(1)->text(0), QString("Valid sets of inputs: 4"));
    QCOMPARE(list.topLevelItem(2)->text(0), QString("Links that differ as the frame: 3"));
    QCOMPARE(list.topLevelItem(0)->child(0)->text(0), QString::fromUtf8("0–1  0–2  2–3"));
    QCOMPARE(list.topLevelItem(2)->childCount(), 3);
    list.setCurrentItem(list.topLevelItem(1)->child(0));
    const Mechanism& train = *document->mechanism();
    QVERIFY(selection.isSelected(train.links[0].id) && selection.isSelected(train.links[1].id));
    QVERIFY(!selection.isSelected(train.links[2].id));
    open(test::example("spur-pair"));
    QCOMPARE(list.topLevelItem(0)->text(0), QString("Trees of turning joints: 1"));
    open(emptyMechanism());
    QCOMPARE(list.topLevelItemCount(), 0);
    QVERIFY(!part<QPushButton>("askChoices").isEnabled());
  }

  // As `identify --with` has it: both wrists are chain 6-2.9.1.
  void anotherDocumentIsComparedLinkByLink() {
    open(test::example("bevel-wrist"));
    TrainDetails& details = *panel->findChild<TrainDetails*>();
    const auto pathOf = [](const char* name) {
      return QString::fromStdString(
          test::sourcePath("resources/examples/" + std::string(name) + ".geargraph"));
    };
    details.compareWith(pathOf("three-roll-wrist"));
    settle();
    QCOMPARE(text("comparison"), QString("three-roll-wrist is the same chain."));
    auto& list = part<QTreeWidget>("matchList");
    QVERIFY(list.isVisibleTo(panel.get()));
    QStringList rows;
    for (int row = 0; row < list.topLevelItemCount(); ++row)
      rows << list.topLevelItem(row)->text(0) + '=' + list.topLevelItem(row)->text(1);
    QVERIFY2(rows.contains("link 2=link 4") && rows.contains("mesh 14=mesh 14"), qPrintable(rows.join(' ')));
    QCOMPARE(rows.size(), 9);
    list.setCurrentItem(list.topLevelItem(1));
    QCOMPARE(selection.selected(), (std::set<ElementId>{document->mechanism()->links[2].id}));
    const auto labels = [&](const char* name) {
      std::vector<std::pair<std::string, std::pair<double, double>>> texts;
      for (const Mark& mark : part<ChainPicture>(name).drawing().marks)
        if (const auto* label = std::get_if<Text>(&mark.what); label && label->bold)
          texts.push_back({label->text, {label->center.x, label->center.y}});
      return texts;
    };
    const auto own = labels("ownChain"), other = labels("otherChain");
    QVERIFY(!own.empty());
    QCOMPARE(own.size(), other.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
      QCOMPARE(own[i].second, other[i].second);  // one drawing, two names
      if (own[i].first == "2") QCOMPARE(other[i].first, std::string("4"));
    }
    details.compareWith(pathOf("simpson"));
    settle();
    QCOMPARE(text("comparison"), QString("simpson is a different chain."));
    QVERIFY(!list.isVisibleTo(panel.get()));
    open(test::example("simpson"));
    QCOMPARE(text("comparison"), QString("simpson is the same chain."));
    details.compareWith(pathOf("no-such-document"));
    settle();
    QVERIFY(text("comparison").startsWith("no-such-document: "));
  }

  // Counts as in Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301.
  void filtersChangeCounts() {
    panel->setFilter({.links = 6, .dof = 1});
    QCOMPARE(model().rowCount(), 81);
    QVERIFY2(text("count").startsWith("81 of ") && text("count").contains("equations: 27"),
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
