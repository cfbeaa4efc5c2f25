#include <QAbstractItemModelTester>
#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QScopeGuard>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <set>

#include "core/mechanism/model/edits.h"
#include "tests/core/support/gearboxes.h"
#include "ui/panels/gearbox_panel.h"
#include "ui/panels/number_field.h"
#include "ui/panels/states_table.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/frozen_column.h"

namespace geargraph {

class GearboxPanelTest : public QObject {
  Q_OBJECT

  std::unique_ptr<Document> document;
  Selection selection;
  std::unique_ptr<GearboxPanel> panel;

  void settle() { panel->setSnapshot(analyze(document->mechanism(), document->revision())); }
  QTableView& table() { return *panel->findChild<QTableView*>(QStringLiteral("shiftTable")); }
  void click(int row, int column) {
    const QRect cell = table().visualRect(panel->model().index(row, column));
    QTest::mouseClick(table().viewport(), Qt::LeftButton, Qt::NoModifier, cell.center());
    settle();
  }
  QString text(int row, StatesModel::Tail tail) {
    const int column = panel->model().couplingCount() + 1 + static_cast<int>(tail);
    return panel->model().index(row, column).data().toString();
  }
  void press(const char* button) {
    QTest::mouseClick(panel->findChild<QToolButton*>(QLatin1String(button)), Qt::LeftButton);
    settle();
  }

 private slots:
  void init() {
    selection.clear();
    document = std::make_unique<Document>();
    document->replace(test::eightSpeed(), {});
    panel = std::make_unique<GearboxPanel>(document.get(), &selection);
    panel->resize(640, 420);
    panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel.get()));
    settle();
  }
  void cleanup() { panel.reset(); }

  void theModelKeepsTheRulesOfItemModels() {
    QAbstractItemModelTester tester(&panel->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    document->undoStack().clear();
    press("addState");
    document->undoStack().undo();
  }

  void theShiftTableShowsRatiosAndSteps() {
    QCOMPARE(text(0, StatesModel::Tail::ratio), QStringLiteral("108/23"));
    QCOMPARE(text(0, StatesModel::Tail::decimal), QStringLiteral("4.6957"));
    QCOMPARE(text(1, StatesModel::Tail::step), QStringLiteral("1.500"));
    QCOMPARE(text(8, StatesModel::Tail::decimal), QStringLiteral("−3.2968"));
    QCOMPARE(text(8, StatesModel::Tail::step), QString());
    QVERIFY(panel->model().index(0, 1).data(StatesModel::EngagedRole).toBool());
    QVERIFY(!panel->model().index(0, 4).data(StatesModel::EngagedRole).toBool());
  }

  /// That none are wanted any more is answered at once, while the document changes.
  void aDocumentWithoutStatesNeedsNoTorques() {
    panel->setAwake(true);
    click(8, 0);
    QSignalSpy wanted(panel.get(), &GearboxPanel::torquesWanted);
    connect(panel.get(), &GearboxPanel::torquesWanted, panel.get(),
            [this] { panel->setTorques(nullptr, document->mechanism()); });
    document->replace(emptyMechanism(), {});
    QCOMPARE(wanted.size(), 1);
    QVERIFY(!wanted.front().front().toBool());
  }

  /// Torques, efficiency and circulating power appear in the table as soon as they are solved, for these
  /// states.
  void theShiftTableShowsTorques() {
    const int couplings = panel->model().couplingCount();
    const int efficiency = couplings + 1 + static_cast<int>(StatesModel::Tail::efficiency);
    QVERIFY(!table().isColumnHidden(efficiency));
    auto torques = std::make_shared<ForceTable>(shiftTable(*document->mechanism(), {}));
    for (const ShiftState& state : document->mechanism()->states) {
      ForceRow& row = torques->rows.emplace_back();
      row.cells.resize(torques->columns.size());
      row.cells.front().text = state.name;
    }
    const auto cell = [&](int row, std::size_t column) -> ForceCell& {
      return torques->rows[static_cast<std::size_t>(row)].cells[column];
    };
    const auto first = static_cast<std::size_t>(couplings) + 1;
    cell(0, 1) = {"1.23188", 85.0 / 69, "85/69"};
    cell(8, 1) = {"-1.65406", -1.65406, {}};
    cell(0, first + static_cast<std::size_t>(ShiftColumn::efficiency)) = {"0.9688", 0.96876, {}};
    cell(8, first + static_cast<std::size_t>(ShiftColumn::backward)) = {"locks", std::nullopt, {}};
    cell(0, first + static_cast<std::size_t>(ShiftColumn::circulating)) = {"0", 0.0, {}};
    cell(8, first + static_cast<std::size_t>(ShiftColumn::circulating)) = {"0.528", 0.528, {}};
    QAbstractItemModelTester tester(&panel->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    panel->setTorques(torques, document->mechanism());
    QCOMPARE(panel->model().index(0, 1).data().toString(), QStringLiteral("1.232"));
    QVERIFY(panel->model().index(0, 1).data(Qt::ToolTipRole).toString().contains(QLatin1String("85/69 N m")));
    QCOMPARE(panel->model().index(8, 1).data().toString(), QStringLiteral("−1.654"));
    QCOMPARE(text(0, StatesModel::Tail::efficiency), QStringLiteral("0.9688"));
    QCOMPARE(text(8, StatesModel::Tail::backward), QStringLiteral("locks"));
    QCOMPARE(text(0, StatesModel::Tail::circulating), QStringLiteral("·"));
    QCOMPARE(text(8, StatesModel::Tail::circulating), QStringLiteral("0.528"));
    QVERIFY(panel->remark().contains(QLatin1String("for 1 N m at the drive")));
    // Where there is no room the table scrolls; nothing of it is left out.
    panel->resize(1100, 420);
    const int wide = table().columnWidth(1);
    panel->resize(380, 420);
    QCOMPARE(table().columnWidth(1), wide);
    QTRY_VERIFY(table().horizontalScrollBar()->maximum() > 0);
    QVERIFY(!table().isColumnHidden(efficiency));
    // The names of the states stay.
    auto* names = table().findChild<FrozenColumn*>();
    table().horizontalScrollBar()->setValue(table().horizontalScrollBar()->maximum());
    QTRY_VERIFY(names->isVisible());
    QCOMPARE(names->columnWidth(0), table().columnWidth(0));
    QCOMPARE(names->horizontalHeader()->height(), table().horizontalHeader()->height());
    table().horizontalScrollBar()->setValue(0);
    QTRY_VERIFY(!names->isVisible());
    // The file has what each state engages, and between which links.
    QSignalSpy wanted(panel.get(), &GearboxPanel::exportWanted);
    QTest::mouseClick(panel->findChild<QToolButton*>(QStringLiteral("exportStates")), Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    const QString csv = wanted[0][1].toString();
    QVERIFY2(csv.startsWith(QLatin1String("state,drive,driven,engaged,A [N m]")), qPrintable(csv));
    QVERIFY2(csv.contains(QLatin1String("\n1,1,2,A B C,1.23188")), qPrintable(csv));
    // They belong to these states only.
    press("addState");
    QCOMPARE(panel->model().index(0, 1).data().toString(), QString());
    QVERIFY(!panel->findChild<QToolButton*>(QStringLiteral("exportStates"))->isEnabled());
  }

  /// The efficiency of the meshes is set here, too, and the spread of the ratios is told.
  void whatTheTorquesAreUnder() {
    auto* efficiency = panel->findChild<NumberField*>(QStringLiteral("gearboxEfficiency"));
    efficiency->setValue(QStringLiteral("0.98"));
    QCOMPARE(document->mechanism()->gearDefaults->efficiency->exact(), Rational(98, 100));
    document->undoStack().undo();
    QVERIFY(!efficiency->number());
    auto* spread = panel->findChild<QLabel*>(QStringLiteral("spread"));
    auto* share = panel->findChild<QToolButton*>(QStringLiteral("shareInStates"));
    QVERIFY(!spread->isVisible() && !share->isVisible());
    auto torques = std::make_shared<ForceTable>(shiftTable(*document->mechanism(), {}));
    torques->rows.resize(document->mechanism()->states.size());
    for (ForceRow& row : torques->rows) row.cells.resize(torques->columns.size());
    const std::size_t ratio =
        1 + document->mechanism()->couplings.size() + static_cast<std::size_t>(ShiftColumn::ratio);
    torques->rows[0].cells[ratio] = {"4.5", 4.5, {}};
    torques->rows[1].cells[ratio] = {"1.5", 1.5, {}};
    torques->rows[2].cells[ratio] = {"-9", -9.0, {}};
    torques->rows[0].cells[1] = {"shared", std::nullopt, {}};
    panel->setTorques(torques, document->mechanism());
    QVERIFY(spread->isVisible());
    QCOMPARE(spread->text(), QStringLiteral("spread 3.000"));
    QVERIFY(share->isVisible());
    QTest::mouseClick(share, Qt::LeftButton);
    QCOMPARE(document->mechanism()->sharing, std::optional(LoadSharing::stiffness));
  }

  /// Two states side by side; what differs is bold.
  void statesAreCompared() {
    click(3, 0);
    press("compareStates");
    auto* compared = panel->findChild<QTableView*>(QStringLiteral("comparedStates"));
    QVERIFY(compared->isVisible() && !table().isVisible());
    const QAbstractItemModel& values = *compared->model();
    const auto row = [&](const char* name) {
      for (int i = 0; i < values.rowCount(); ++i)
        if (values.index(i, 0).data().toString() == QLatin1String(name)) return i;
      return -1;
    };
    QCOMPARE(values.headerData(1, Qt::Horizontal).toString(), QStringLiteral("state 4"));
    QCOMPARE(values.headerData(2, Qt::Horizontal).toString(), QStringLiteral("state 5"));
    QCOMPARE(values.index(row("ratio"), 1).data().toString(), QStringLiteral("5/3"));
    QVERIFY(values.index(row("ratio"), 1).data(Qt::FontRole).value<QFont>().bold());
    QVERIFY(row("engaged") >= 0 && row("A, N m") >= 0 && row("step") >= 0);
    auto* other = panel->findChild<QComboBox*>(QStringLiteral("otherState"));
    other->setFocus();
    QTest::keyClick(other, Qt::Key_Up);
    QCOMPARE(values.index(row("ratio"), 2).data().toString(), QStringLiteral("5/3"));
    QVERIFY(!values.index(row("ratio"), 2).data(Qt::FontRole).value<QFont>().bold());
    press("compareStates");
    QVERIFY(table().isVisible());
    press("compareStates");
    document->replace(Mechanism(), {});
    settle();
    QVERIFY(!compared->isVisible());
    QVERIFY(!panel->emptyText().isEmpty());
  }

  /// Larger type has higher rows and heads, and wider columns.
  void theTableFollowsTheType() {
    const int head = table().horizontalHeader()->height();
    const int width = table().columnWidth(0);
    applyTheme(*qApp, Theme::light, 1.5);
    const auto restore = qScopeGuard([] { applyTheme(*qApp, Theme::light); });
    QTRY_VERIFY(table().horizontalHeader()->height() >= head * 14 / 10);
    QTRY_VERIFY(table().columnWidth(0) > width);
    QTRY_VERIFY(table().rowHeight(0) >= table().fontMetrics().height());
  }

  /// The field is the document's member; empty it shows what acts then. Loads beside it are named.
  void oneTorqueAtTheDrive() {
    auto* field = panel->findChild<NumberField*>(QStringLiteral("driveTorque"));
    QVERIFY(field->isVisibleTo(panel.get()) && !field->number());
    field->setValue(QStringLiteral("100"));
    QCOMPARE(document->mechanism()->driveTorque->exact(), Rational(100));
    auto torques = std::make_shared<ForceTable>(shiftTable(*document->mechanism(), {}));
    torques->rows.resize(document->mechanism()->states.size());
    for (ForceRow& row : torques->rows) row.cells.resize(torques->columns.size());
    torques->note = "The loads on link 9 act as well.";
    panel->setTorques(torques, document->mechanism());
    QVERIFY2(
        panel->remark().endsWith(QLatin1String("for 100 N m at the drive. The loads on link 9 act as well.")),
        qPrintable(panel->remark()));
    document->undoStack().undo();
    QVERIFY(!document->mechanism()->driveTorque && !field->number());
    document->replace(Mechanism(), {});
    QVERIFY(!field->isVisibleTo(panel.get()));
  }

  /// Nothing is solved for a gearbox out of sight, or a document that is none.
  void torquesAreWantedInSight() {
    QSignalSpy wanted(panel.get(), &GearboxPanel::torquesWanted);
    panel->setAwake(true);
    QCOMPARE(wanted.count(), 1);
    document->replace(test::eightSpeed(), {});
    QCOMPARE(wanted.count(), 1);
    document->replace(Mechanism(), {});
    QCOMPARE(wanted.takeLast()[0].toBool(), false);
    document->replace(test::eightSpeed(), {});
    panel->setAwake(false);
    QCOMPARE(wanted.takeLast()[0].toBool(), false);
  }

  /// What a step of a drag leaves as it is, is not painted again: names, dots, links, and equal ratios.
  void onlyRatiosThatChangeAreTold() {
    QSignalSpy told(&panel->model(), &QAbstractItemModel::dataChanged);
    settle();
    QCOMPARE(told.count(), 0);
    const auto ratios = [&] {
      QStringList all;
      for (int row = 0; row < panel->model().rowCount(); ++row) all << text(row, StatesModel::Tail::ratio);
      return all;
    };
    const QStringList before = ratios();
    const MeshId mesh("25");
    const GearMesh& drawn = *document->mechanism()->find(mesh);
    const int tail = drawn.tailTeeth, head = drawn.headTeeth + 2;
    document->apply({"teeth", [=](const Mechanism& m) { return withTeeth(m, mesh, tail, head); }, 0});
    settle();
    const QStringList after = ratios();
    QVERIFY(before != after);
    std::set<int> rows;
    for (const QList<QVariant>& change : told) {
      const QModelIndex cell = change[0].toModelIndex();
      QCOMPARE(change[1].toModelIndex(), cell);
      if (panel->model().isTail(cell.column(), StatesModel::Tail::ratio)) rows.insert(cell.row());
    }
    for (int row = 0; row < before.size(); ++row) QCOMPARE(rows.contains(row), before[row] != after[row]);
  }

  /// The first step of an analysis has no ratios yet: those before stay, until the second brings its own.
  void ratiosDoNotBlinkWhileTeethAreDragged() {
    const MeshId mesh("25");
    const GearMesh& drawn = *document->mechanism()->find(mesh);
    const int tail = drawn.tailTeeth, head = drawn.headTeeth + 2;
    document->apply({"teeth", [=](const Mechanism& m) { return withTeeth(m, mesh, tail, head); }, 0});
    const auto ratios = [&] {
      QStringList all;
      for (int row = 0; row < panel->model().rowCount(); ++row) all << text(row, StatesModel::Tail::ratio);
      return all;
    };
    const QStringList before = ratios();
    panel->setSnapshot(analyzeLive(document->mechanism(), document->revision()));
    QCOMPARE(ratios(), before);
    settle();
    QVERIFY(ratios() != before);
    QVERIFY(!ratios().contains(QStringLiteral("…")));
  }

  void aClickOnAStateEngagesIt() {
    click(0, panel->model().couplingCount() + 2);
    QVERIFY(panel->model().isRunning(0));
    QVERIFY(!panel->model().isRunning(1));
    QCOMPARE(document->undoStack().count(), 1);
    QCOMPARE(document->mechanism()->engaged, document->mechanism()->states[0].engaged);
    const SnapshotPtr snapshot = analyze(document->mechanism());
    QCOMPARE(snapshot->matroid()->dof, 1);
    QCOMPARE(snapshot->solved->exact->rates[1], Rational(23, 108));
    click(8, 0);
    QVERIFY(panel->model().isRunning(8) && !panel->model().isRunning(0));
    document->undoStack().undo();
    settle();
    QVERIFY(panel->model().isRunning(0));
  }

  /// Before, a state was a copy of speeds: it was over after the next change of teeth.
  void anEditKeepsTheStateThatIsEngaged() {
    click(0, 0);
    const MeshId mesh("25");
    const GearMesh& drawn = *document->mechanism()->find(mesh);
    const int tail = drawn.tailTeeth, head = drawn.headTeeth + 2;
    document->apply({"teeth", [=](const Mechanism& m) { return withTeeth(m, mesh, tail, head); }, 0});
    settle();
    QVERIFY(panel->model().isRunning(0));
    const SnapshotPtr snapshot = analyze(document->mechanism());
    const StateSolution& state = (*snapshot->states)[0];
    QCOMPARE(snapshot->solved->exact->rates, state.rates);
    QVERIFY(snapshot->solved->agreement->equal);
  }

  void oneClickReleasesEverything() {
    auto* release = panel->findChild<QToolButton*>(QStringLiteral("releaseAll"));
    QVERIFY(!release->isEnabled());
    click(3, 0);
    const SnapshotPtr engaged = analyze(document->mechanism());
    QVERIFY(release->isEnabled());
    press("releaseAll");
    QVERIFY(document->mechanism()->engaged.empty());
    QVERIFY(!panel->model().isRunning(3) && !release->isEnabled());
    const SnapshotPtr released = analyze(document->mechanism());
    QVERIFY(!hasErrors(released->diagnostics));
    QCOMPARE(released->solved->exact->rates, engaged->solved->exact->rates);  // the motion goes on
  }

  void aLetterEngagesItsCouplingAlone() {
    QHeaderView& heads = *table().horizontalHeader();
    const auto press = [&](int section) {
      const QPoint at(heads.sectionViewportPosition(section) + heads.sectionSize(section) / 2, 12);
      QTest::mouseClick(heads.viewport(), Qt::LeftButton, Qt::NoModifier, at);
      settle();
    };
    press(2);  // brake B
    QCOMPARE(document->mechanism()->engaged, std::vector{ShiftElementId("B")});
    QVERIFY(panel->model().headerData(2, Qt::Horizontal, StatesModel::EngagedRole).toBool());
    QVERIFY(!panel->model().headerData(1, Qt::Horizontal, StatesModel::EngagedRole).toBool());
    press(1);
    QCOMPARE(document->mechanism()->engaged, (std::vector{ShiftElementId("A"), ShiftElementId("B")}));
    press(2);
    QCOMPARE(document->mechanism()->engaged, std::vector{ShiftElementId("A")});
    QCOMPARE(document->undoStack().count(), 3);
  }

  void aStateThatCannotRunSaysWhy() {
    click(0, 4);  // D, on top of A, B and C
    click(0, 0);
    QVERIFY(panel->remark().contains(QStringLiteral("locks its drive")));
    QCOMPARE(analyze(document->mechanism())->matroid()->dof, 0);
  }

  /// The menu that asks for a link; none where nothing is asked.
  QMenu* question() {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    return menu != nullptr && menu->objectName() == QLatin1String("askLinks") ? menu : nullptr;
  }
  void answer(const QString& link) {
    QMenu* menu = question();
    QVERIFY(menu != nullptr);
    for (QAction* action : menu->actions()) {
      if (!action->text().startsWith(link)) continue;
      menu->setActiveAction(action);
      QTest::keyClick(menu, Qt::Key_Return);
      return settle();
    }
    QFAIL("no such link is offered");
  }
  void openWithoutLinks() {
    Mechanism without = test::eightSpeed();
    for (ShiftState& state : without.states) state.drive = state.driven = std::nullopt;
    document->replace(without, {});
    settle();
  }

  void aStateWithoutLinksAsksForThem() {
    const MechanismPtr whole = document->mechanism();
    const auto label = [&](const LinkId& link) {
      return tr("Link %1").arg(QString::fromStdString(*labelOf(*whole, link)));
    };
    openWithoutLinks();
    const int ratio = panel->model().couplingCount() + 1 + static_cast<int>(StatesModel::Tail::ratio);
    QCOMPARE(text(0, StatesModel::Tail::links), QStringLiteral("choose…"));
    QCOMPARE(text(0, StatesModel::Tail::ratio), QStringLiteral("–"));
    // Given up, nothing has changed.
    click(0, ratio);
    QVERIFY(question() != nullptr);
    QTest::keyClick(question(), Qt::Key_Escape);
    QTRY_VERIFY(question() == nullptr);
    QCOMPARE(document->undoStack().count(), 0);
    // The input, then the output; both are one step, for all states that had none.
    click(0, ratio);
    answer(label(*whole->states[0].drive));
    QTRY_VERIFY(question() != nullptr && question()->actions().front()->text().contains("output"));
    answer(label(*whole->states[0].driven));
    QTRY_VERIFY(question() == nullptr);
    QCOMPARE(*document->mechanism(), *whole);
    QCOMPARE(text(0, StatesModel::Tail::ratio), QStringLiteral("108/23"));
    QCOMPARE(document->undoStack().count(), 1);
    document->undoStack().undo();
    QVERIFY(!document->mechanism()->states[0].drive && !document->mechanism()->states[8].driven);
    // A state that has them is engaged instead.
    document->undoStack().redo();
    settle();
    click(0, ratio);
    QVERIFY(question() == nullptr && panel->model().isRunning(0));
  }

  void aStateThatIsEngagedWithoutLinksSaysWhatItLacks() {
    openWithoutLinks();
    click(0, 0);
    QCOMPARE(document->mechanism()->engaged, document->mechanism()->states[0].engaged);
    QVERIFY2(panel->remark().contains(QStringLiteral("no ratio yet")), qPrintable(panel->remark()));
  }

  void theEngagementFollowsTheDotsOfItsState() {
    click(0, 0);
    click(0, 4);
    QCOMPARE(document->mechanism()->engaged.size(), std::size_t(4));
    click(0, 4);
    QCOMPARE(document->mechanism()->engaged, document->mechanism()->states[0].engaged);
    click(5, 1);  // of another state
    QVERIFY(panel->model().isRunning(0));
  }

  void aClickOnADotEngagesAndUndoReleases() {
    click(0, 4);  // D, on top of A, B and C
    QCOMPARE(document->mechanism()->states[0].engaged.size(), std::size_t(4));
    QCOMPARE(text(0, StatesModel::Tail::ratio), QStringLiteral("locked"));
    QVERIFY(panel->remark().contains(QStringLiteral("locks its drive")));
    document->undoStack().undo();
    settle();
    QCOMPARE(text(0, StatesModel::Tail::ratio), QStringLiteral("108/23"));
    click(0, 1);  // without A there are two freedoms
    QCOMPARE(text(0, StatesModel::Tail::ratio), QStringLiteral("2 free"));
    QVERIFY(panel->remark().contains(QStringLiteral("2 degrees of freedom")));
  }

  void couplingsAreMadeOfTheSelectedLinks() {
    selection.select({ElementId(LinkId("6"))});
    press("addBrake");
    QCOMPARE(document->mechanism()->couplings.back().kind, ShiftElementKind::brake);
    QCOMPARE(document->mechanism()->couplings.back().links, std::vector{LinkId("6")});
    selection.select({ElementId(LinkId("1")), ElementId(LinkId("8"))});
    press("addClutch");
    QCOMPARE(document->mechanism()->couplings.back().id, ShiftElementId("G"));
    QCOMPARE(document->mechanism()->couplings.back().links, (std::vector{LinkId("1"), LinkId("8")}));
    press("addState");
    QCOMPARE(panel->model().rowCount(), 10);
    QCOMPARE(document->undoStack().count(), 3);
  }

  void aStateIsRenamedInItsCell() {
    panel->model().setData(panel->model().index(8, 0), QStringLiteral("Reverse"));
    QCOMPARE(document->mechanism()->states[8].name, std::string("Reverse"));
  }

  void pointingAtADotLightsUpWhatItHolds() {
    emit table().entered(panel->model().index(0, 3));
    QVERIFY(selection.isHovered(ElementId(LinkId("1"))) && selection.isHovered(ElementId(LinkId("5"))));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::GearboxPanelTest)
#include "test_gearbox_panel.moc"
