#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <algorithm>

#include "core/design/fixes/fixes.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/snapshot_of.h"
#include "tests/core/support/toy_result.h"
#include "tests/core/support/train_sketch.h"
#include "ui/models/term_tips.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/matrix_header.h"
#include "ui/panels/matrix_view.h"
#include "ui/panels/problems_panel.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/folding_bar.h"

namespace geargraph {

using test::snapshotOf;

class MatricesPanelTest : public QObject {
  Q_OBJECT

  Selection selection;
  std::unique_ptr<MatricesPanel> panel;

  MatrixView& view() { return panel->view(); }
  QPoint centre(int row, int column) {
    return view().visualRect(panel->model().index(row, column)).center() - QPoint(4, 0);
  }
  QString cardTitle() { return panel->findChild<QLabel*>(QStringLiteral("cellTitle"))->text(); }

 private slots:
  void init() {
    selection.clear();
    selection.unhover();
    panel = std::make_unique<MatricesPanel>(&selection);
    panel->resize(800, 280);
    panel->setSnapshot(snapshotOf(test::robotTopology()));
    panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel.get()));
    QTest::mouseMove(panel.get(), QPoint(3, 3));  // away from where the last test left it
  }
  void cleanup() { panel.reset(); }

  void hoveringACellLightsTheWholeCycle() {
    QTest::mouseMove(view().viewport(), centre(1, 2));
    const std::set<ElementId> cycle{JointId("9"), JointId("10"), JointId("12"), MeshId("16")};
    QTRY_COMPARE(selection.hovered(), cycle);
    QVERIFY(view().isRowHighlighted(1));
    QVERIFY(!view().isRowHighlighted(0));
    for (const int column : {1, 2, 4, 8}) QVERIFY(view().isColumnHighlighted(column));
    QVERIFY(!view().isColumnHighlighted(0));
  }

  void restingOnACellExplainsIt() {
    QSignalSpy rested(&view(), &MatrixView::restedOn);
    QTest::mouseMove(view().viewport(), centre(1, 2));
    QTRY_COMPARE(cardTitle(), QStringLiteral("C16, joint 10: −1"));
    QVERIFY(panel->findChild<QLabel*>(QStringLiteral("cellText"))->text().endsWith("(from 1 to 0). Eq. (5)"));
  }

  void theCardWidensForLargeType() {
    const QWidget* card = panel->findChild<QLabel*>(QStringLiteral("cellText"))->parentWidget();
    const int before = card->width();
    QFont large = panel->font();
    large.setPixelSize(2 * bodyPixels());
    panel->setFont(large);
    QTRY_VERIFY(card->width() > before);
  }

  /// In every matrix that has the entry, wherever it is there.
  void theEntryOfAMeshAndAJointIsFramed() {
    QVERIFY(!view().showFramed());
    view().setFramed(MeshId("16"), JointId("10"));
    const auto framed = [&] {
      std::set<std::pair<int, int>> cells;
      for (int row = 0; row < panel->model().rowCount(); ++row)
        for (int column = 0; column < panel->model().columnCount(); ++column)
          if (view().isFramed(row, column)) cells.emplace(row, column);
      return cells;
    };
    using Cells = std::set<std::pair<int, int>>;
    QVERIFY(framed() == Cells({{1, 2}}));  // C16 below 10
    panel->showResult(resultOf(MatrixKind::spanningTree));
    QVERIFY(framed() == Cells({{1, 2}}));
    panel->showResult(
        resultOf(MatrixKind::cutset));  // row of joint 10, column of mesh 16, behind the 7 joints
    QVERIFY(framed() == Cells({{2, 8}}));
    QVERIFY(view().showFramed());
    QCOMPARE(view().currentIndex(), panel->model().index(2, 8));
    QVERIFY2(!cardTitle().isEmpty() && cardTitle().contains(QLatin1String("16")), qPrintable(cardTitle()));
    // In the T-T graph mesh 16 has two chords; joint 10 is in the circuit of the first, its tail gear's.
    panel->showResult(*resultNamed("tt-cutsets"));
    QVERIFY(framed() == Cells({{2, 9}}));
    panel->showResult(*resultNamed("tt-circuits"));
    QVERIFY(framed() == Cells({{2, 2}}));
    view().setFramed(MeshId("16"), JointId("12"));  // in that of the second, its head gear's
    QVERIFY(framed() == Cells({{3, 4}}));
    panel->showResult(*resultNamed("tt-cutsets"));
    QVERIFY(framed() == Cells({{4, 10}}));
    panel->showResult(resultOf(MatrixKind::path));  // of joints and links
    QVERIFY(framed().empty() && !view().showFramed());
    panel->showResult(resultOf(MatrixKind::cycleBasis));
    view().setFramed({}, {});
    QVERIFY(framed().empty());
  }

  /// No chip is cut off, and no button is beyond the edge; the chosen chip with its parts takes more room.
  void theButtonsTakeTwoRowsInANarrowPanel() {
    const auto* bar = panel->findChild<FoldingBar*>();
    const auto* copy = panel->findChild<QToolButton*>(QStringLiteral("copyMatrix"));
    const auto fits = [&] {
      const QList<QToolButton*> buttons = bar->findChildren<QToolButton*>();
      return std::all_of(buttons.begin(), buttons.end(), [&](const QToolButton* button) {
        const QRect place(button->mapTo(bar, QPoint(0, 0)), button->size());
        return !button->isVisible() ||
               (button->width() >= button->sizeHint().width() && bar->rect().contains(place));
      });
    };
    const auto isBelow = [&] {
      const auto* chip = panel->findChild<QToolButton*>(QStringLiteral("chip.p"));
      return copy->mapTo(bar, QPoint(0, 0)).y() > chip->mapTo(bar, QPoint(0, chip->height() - 1)).y();
    };
    for (const MatrixKind kind : {MatrixKind::path, MatrixKind::cycleBasis}) {
      panel->showResult(resultOf(kind));
      panel->resize(800, 280);
      QTRY_VERIFY(!bar->isFolded() && fits() && !isBelow());
      panel->resize(panel->minimumSizeHint().width(), 280);
      QTRY_VERIFY(bar->isFolded() && fits() && isBelow());
    }
  }

  void theCellUnderTheMouseIsTold() {
    QSignalSpy hovered(&view(), &MatrixView::entryHovered);
    QTest::mouseMove(view().viewport(), centre(1, 2));
    QTRY_VERIFY(!hovered.isEmpty());
    QVERIFY(hovered.last() == (QVariantList{QVariant::fromValue(ElementId(MeshId("16"))),
                                            QVariant::fromValue(ElementId(JointId("10")))}));
    QTest::mouseMove(panel.get(), QPoint(3, 3));
    QTRY_VERIFY(hovered.last().front() == QVariant::fromValue(ElementId()));
  }

  void hoveringHeadersLightsTheirElements() {
    QTest::mouseMove(view().horizontalHeader()->viewport(), QPoint(MatrixView::kColumnWidth * 3 / 2, 10));
    QTRY_COMPARE(selection.hovered(), (std::set<ElementId>{JointId("9")}));
    QTest::mouseMove(view().verticalHeader()->viewport(), QPoint(10, MatrixView::kRowHeight / 2));
    QTRY_COMPARE(selection.hovered(), (std::set<ElementId>{JointId("8"), JointId("10"), MeshId("15")}));
  }

  void whatIsPointedAtElsewhereLightsUpHere() {
    selection.hover(ElementId(JointId("12")));
    QVERIFY(view().isColumnHighlighted(4));
    QVERIFY(view().isColumnTinted(4));
    selection.unhover();
    QVERIFY(!view().isColumnHighlighted(4));
    selection.select({ElementId(MeshId("17"))});
    QVERIFY(view().isRowHighlighted(2));
    QVERIFY(view().isColumnHighlighted(9));
  }

  void aClickSelectsRowAndColumn() {
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, centre(0, 2));
    QCOMPARE(selection.selected(), (std::set<ElementId>{MeshId("15"), JointId("10")}));
  }

  /// The f-circuits and f-cutsets of the T-T graph: linked, told, exported; whole numbers need no form.
  void theMatricesOfTheTtGraph() {
    QTest::mouseClick(panel->findChild<QToolButton*>(QStringLiteral("chip.tt-cutsets")), Qt::LeftButton);
    QVERIFY(panel->model().result().name == "tt-cutsets");
    QCOMPARE(panel->model().rowCount(), 7);
    QCOMPARE(panel->model().columnCount(), 15);
    QCOMPARE(panel->model().partition(), 7);
    QVERIFY(panel->findChild<QToolButton*>(QStringLiteral("entryForm"))->isHidden());
    QCOMPARE(cardTitle(), QStringLiteral("f-cutset matrix of the T–T graph"));
    selection.select({ElementId(MeshId("16"))});
    QVERIFY(view().isColumnHighlighted(9) && view().isColumnHighlighted(10) &&
            !view().isColumnHighlighted(8));
    selection.clear();
    QSignalSpy wanted(panel.get(), &MatricesPanel::exportWanted);
    panel->wantExport();
    QCOMPARE(wanted.size(), 1);
    QTest::mouseClick(panel->findChild<QToolButton*>(QStringLiteral("chip.tt-circuits")), Qt::LeftButton);
    QVERIFY(panel->model().result().name == "tt-circuits");
    QCOMPARE(panel->model().rowCount(), 8);
    panel->showResult(*resultNamed("p"));
    QVERIFY(!panel->findChild<QToolButton*>(QStringLiteral("entryForm"))->isHidden());
    panel->showResult(resultOf(MatrixKind::cycleBasis));
  }

  void chipsChangeTheMatrix() {
    for (const NamedResult* result : namedResults()) {
      auto* chip = panel->findChild<QToolButton*>(QStringLiteral("chip.") + shownText(result->name));
      QCOMPARE(chip != nullptr, !result->symbol.empty());
      if (chip == nullptr) continue;
      QTest::mouseClick(chip, Qt::LeftButton);
      QCOMPARE(&panel->model().result(), result);
      QVERIFY(!chip->toolTip().isEmpty());
    }
  }

  void copiesAsFiveKindsOfText() {
    const QMenu* menu = panel->findChild<QToolButton*>(QStringLiteral("copyMatrix"))->menu();
    QStringList begins;
    QSignalSpy copied(panel.get(), &MatricesPanel::copied);
    for (QAction* action : menu->actions()) {
      action->trigger();
      QTRY_COMPARE(copied.count(), begins.size() + 1);
      begins << QApplication::clipboard()->text().left(13);
    }
    QCOMPARE(begins, (QStringList{"C = [T | U]\t8", "C = [T | U],8", "\\begin{array}", "% Cycle-basis",
                                  "# Cycle-basis"}));
  }

  /// What is new in the catalogue is shown, told, copied and exported without a line in the window.
  void aToyResultHasAChip() {
    const test::ToyResult toy;
    MatricesPanel with(&selection);
    with.setSnapshot(snapshotOf(test::robotTopology()));
    auto* chip = with.findChild<QToolButton*>(QStringLiteral("chip.toy-degrees"));
    QVERIFY(chip != nullptr && chip->toolTip().contains("How many joints and meshes each link has."));
    QCOMPARE(chip->text(), QStringLiteral("D"));
    chip->click();
    QCOMPARE(with.model().rowCount(), 8);
    QCOMPARE(with.model().partition(), 1);
    QCOMPARE(with.model().index(0, 0).data().toString(), QStringLiteral("3"));
    QCOMPARE(with.model().elementsOfCell(4, 0), std::set<ElementId>{LinkId("4")});
    QCOMPARE(with.findChild<QLabel*>(QStringLiteral("cellTitle"))->text(),
             QStringLiteral("Degrees of the links"));
    QVERIFY(with.findChild<QToolButton*>(QStringLiteral("entryForm"))->isHidden());
    QSignalSpy copied(&with, &MatricesPanel::copied);
    with.findChild<QToolButton*>(QStringLiteral("copyMatrix"))->menu()->actions().front()->trigger();
    QTRY_COMPARE(copied.count(), 1);
    QVERIFY(QApplication::clipboard()->text().startsWith("D\tJ\tM\n0\t3\t0\n"));
    QSignalSpy wanted(&with, &MatricesPanel::exportWanted);
    with.wantExport();
    QCOMPARE(wanted.count(), 1);
  }

  void zerosAreDotsOrNot() {
    QTest::mouseMove(view().horizontalHeader()->viewport(), QPoint(2, 2));
    const QImage dots = view().grab().toImage();
    QTest::mouseClick(panel->findChild<QToolButton*>(QStringLiteral("zerosAsDots")), Qt::LeftButton);
    QVERIFY(!view().zerosAsDots());
    QVERIFY(view().grab().toImage() != dots);
  }

  void anEmptyPanelSaysWhatToDo() {
    panel->setSnapshot(snapshotOf(emptyMechanism()));
    const auto says = [this](const QString& words) {
      const auto labels = panel->findChildren<QLabel*>();
      return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
        return label->isVisible() && label->text().contains(words);
      });
    };
    QVERIFY(says("Draw the first link: L, then click."));
    panel->setSnapshot(snapshotOf(withLink(test::robotTopology(), CanvasPoint{}).value()));
    QVERIFY(says("needs the turning joints to be a spanning tree"));
    QVERIFY(!panel->findChild<QToolButton*>(QStringLiteral("exportCsv"))->isEnabled());
    QVERIFY(panel->findChild<QToolButton*>(QStringLiteral("exportCsv"))->toolTip().contains("spanning tree"));
  }

  void theChipsGoOnToTheSolution() {
    const auto chip = [this](const char* name) {
      return panel->findChild<QToolButton*>(QLatin1String(name));
    };
    auto* form = chip("entryForm");
    QVERIFY(!form->isVisible());
    QTest::mouseClick(chip("chip.p"), Qt::LeftButton);
    QVERIFY(chip("chip.p")->isChecked() && !chip("chip.cycle-basis")->isChecked());
    QVERIFY(form->isVisible());
    QCOMPARE(form->text(), QStringLiteral("symbols ▾"));
    QCOMPARE(panel->model().rowCount(), 4);
    QVERIFY(panel->model().index(0, 0).data(MatrixModel::FormulaRole).toBool());
    QTest::mouseMove(view().viewport(), centre(1, 1));
    QTRY_VERIFY(selection.hovered().contains(MeshId("16")));
    QTRY_VERIFY(cardTitle().startsWith("C16, joint"));

    QAction* fractions = form->menu()->actions().at(1);
    QCOMPARE(fractions->text(), QStringLiteral("fractions"));
    fractions->trigger();
    QCOMPARE(form->text(), QStringLiteral("fractions ▾"));
    QVERIFY(!panel->model().index(0, 0).data(MatrixModel::FormulaRole).toBool());

    QTest::mouseClick(chip("chip.solution"), Qt::LeftButton);
    QVERIFY(panel->model().headerData(0, Qt::Horizontal, MatrixModel::RateRole).toBool());
    QTest::mouseMove(view().viewport(), centre(0, 0));
    const std::set<ElementId> row = panel->model().elementsOfCell(0, 0);
    QCOMPARE(row.size(), std::size_t{3});  // the output, its link, the input
    QTRY_COMPARE(selection.hovered(), row);

    QTest::mouseClick(chip("chip.screw"), Qt::LeftButton);
    QCOMPARE(panel->model().columnCount(), 6);
    selection.clear();
    QTest::mouseMove(view().viewport(), centre(2, 3));
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, centre(2, 3));
    QCOMPARE(selection.selected(), std::set<ElementId>{panel->model().rowElement(2)});
    QTest::mouseClick(chip("chip.cycle-basis"), Qt::LeftButton);
    QVERIFY(!form->isVisible());
    QCOMPARE(panel->model().columnCount(), 11);
  }

  void quantitiesAreCopiedAndExported() {
    QTest::mouseClick(panel->findChild<QToolButton*>("chip.solution"), Qt::LeftButton);
    const auto formats = panel->findChild<QToolButton*>("copyMatrix")->menu()->actions();
    formats.at(1)->trigger();
    QTRY_VERIFY(QApplication::clipboard()->text().startsWith("S,"));
    QSignalSpy wanted(panel.get(), &MatricesPanel::exportWanted);
    QTest::mouseClick(panel->findChild<QToolButton*>("exportCsv"), Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.front().front().value<ResultTablePtr>(), panel->model().table());
  }

  void aMatrixThatIsTooLargeForTheClipboardIsNotCopied() {
    QApplication::clipboard()->setText(QStringLiteral("before"));
    panel->setSnapshot(snapshotOf(test::randomTrain(7, 2000, 800)));
    QTest::mouseClick(panel->findChild<QToolButton*>("chip.incidence"), Qt::LeftButton);
    QSignalSpy rejected(panel.get(), &MatricesPanel::rejected);
    panel->findChild<QToolButton*>("copyMatrix")->menu()->actions().front()->trigger();
    QCOMPARE(rejected.size(), qsizetype{1});
    QVERIFY(rejected.front().front().toString().contains("Export it as CSV"));
    QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("before"));
  }

  void problemsLightTheirCulprits() {
    panel->hide();
    ProblemsPanel problems(&selection);
    problems.resize(500, 200);
    AnalysisSnapshot loose = *snapshotOf(test::robotTopology());
    loose.diagnostics = {
        {Code::disconnected, "Links 3 and 7 are loose.", {LinkId("3"), LinkId("7")}, {}, 0, 0}};
    problems.setSnapshot(std::make_shared<const AnalysisSnapshot>(std::move(loose)));
    problems.show();
    QVERIFY(QTest::qWaitForWindowExposed(&problems));
    QListView& list = problems.list();
    QTest::mouseMove(&problems, QPoint(490, 190));
    const QPoint at = list.visualRect(problems.model().index(0)).center();
    QTest::mouseMove(list.viewport(), at);
    const std::set<ElementId> culprits{LinkId("3"), LinkId("7")};
    QTRY_COMPARE(selection.hovered(), culprits);
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, at);
    QCOMPARE(selection.selected(), culprits);
  }

  /// The robot with bevels on the other side of their apex, where links overlap.
  void fixesThatTryBodiesAreFoundInTheBackground() {
    panel->hide();
    const Mechanism robot = test::example("robot");
    for (const GearMesh& mesh : robot.gearMeshes) {
      const Expected<PlacedMechanism> flipped = withBevelSideFlipped(robot, mesh.id, true);
      if (!flipped) continue;
      const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(flipped->mechanism()));
      ProblemsPanel problems(&selection);
      problems.setSnapshot(snapshot);
      const Diagnostics& listed = problems.model().diagnostics();
      const auto found = std::find_if(listed.begin(), listed.end(), [&](const Diagnostic& each) {
        return triesBodies(each) && !fixesFor(each, *snapshot).empty();
      });
      const auto row = static_cast<int>(found - listed.begin());
      if (found == listed.end() || row >= ProblemsPanel::kMaxImmediateFixes) continue;
      const QModelIndex index = problems.model().index(row);
      QVERIFY(problems.list().indexWidget(index) == nullptr);
      QTRY_VERIFY(problems.list().indexWidget(index) != nullptr);
      problems.setSnapshot(snapshot);  // asks again, and is superseded by a document without overlaps
      problems.setSnapshot(snapshotOf(test::robotTopology()));
      QTest::qWait(0);
      return;
    }
    QFAIL("No flipped bevel gives an overlap with a fix.");
  }

  void manyProblemsAreMeasuredInSeveralEvents() {
    panel->hide();
    ProblemsPanel problems(&selection);
    problems.resize(500, 200);
    problems.show();
    QVERIFY(QTest::qWaitForWindowExposed(&problems));
    AnalysisSnapshot loose = *snapshotOf(test::robotTopology());
    loose.diagnostics.assign(5000, {Code::disconnected, "Link 3 is loose.", {LinkId("3")}, {}, 0, 0});
    problems.setSnapshot(std::make_shared<const AnalysisSnapshot>(std::move(loose)));
    const QModelIndex last = problems.model().index(4999);
    QVERIFY(problems.list().visualRect(problems.model().index(0)).isValid());
    QVERIFY(!problems.list().visualRect(last).isValid());
    QTRY_VERIFY(problems.list().visualRect(last).isValid());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::MatricesPanelTest)
#include "test_matrices_panel.moc"
