#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QScrollBar>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>
#include <optional>
#include <set>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/load_edits.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"
#include "tests/ui/forces/open_forces_panel.h"
#include "ui/forces/duality_line.h"
#include "ui/forces/efficiency_card.h"
#include "ui/forces/efficiency_page.h"
#include "ui/forces/force_table_model.h"
#include "ui/forces/linked_table.h"
#include "ui/forces/loads_list.h"
#include "ui/forces/question_bar.h"
#include "ui/settings/languages.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/frozen_column.h"
#include "ui/theme/sideways_scroll.h"

namespace geargraph {

class ForcesPanelTest : public QObject, private OpenForcesPanel {
  Q_OBJECT

  void press(const char* button) {
    QTest::mouseClick(panel->findChild<QToolButton*>(QLatin1String(button)), Qt::LeftButton);
    settle();
  }
  void type(const char* name, const char* text) {
    if (QLatin1String(name) == QLatin1String("meshEfficiency")) panel->showView(ForceView::efficiency);
    field(name).setFocus();
    field(name).selectAll();
    QTest::keyClicks(&field(name), QLatin1String(text));
    QTest::keyClick(&field(name), Qt::Key_Return);
    settle();
  }
  /// The text under a head of the table that is shown.
  QString cell(int row, const char* head) {
    const ForceTableModel& model = panel->model();
    for (int column = 0; column < model.columnCount(); ++column)
      if (model.headerData(column, Qt::Horizontal).toString().section(QLatin1Char(','), 0, 0) ==
          QLatin1String(head))
        return model.index(row, column).data().toString();
    return QStringLiteral("no column ") + QLatin1String(head);
  }
  /// The number there. Whether Qt reads the minus sign of print depends on its version.
  std::optional<double> number(int row, const char* head) {
    bool isNumber = false;
    const double value = cell(row, head).replace(QChar(0x2212), QLatin1Char('-')).toDouble(&isNumber);
    return isNumber ? std::optional(value) : std::nullopt;
  }
  /// The texts that have less room than they need.
  QStringList cutOff() {
    QStringList texts;
    for (const QLabel* label : panel->findChildren<QLabel*>()) {
      if (!label->isVisible() || label->text().isEmpty()) continue;
      const bool isWhole = label->wordWrap() ? label->height() >= label->heightForWidth(label->width())
                                             : label->width() >= label->minimumSizeHint().width() &&
                                                   label->height() >= label->fontMetrics().height();
      if (!isWhole) texts += label->text();
    }
    for (const QWidget* control : panel->findChildren<QWidget*>()) {
      const bool isControl = qobject_cast<const QToolButton*>(control) != nullptr ||
                             qobject_cast<const QComboBox*>(control) != nullptr;
      const bool isArrow = control->objectName().startsWith(QLatin1String("more"));  // of a wide equation
      if (!isControl || isArrow || !control->isVisible()) continue;
      const bool isInside = control->parentWidget()->rect().contains(control->geometry());
      if (control->width() < control->sizeHint().width() ||
          control->height() < control->fontMetrics().height() || !isInside)
        texts += control->objectName();
    }
    const LinkedTable& table = panel->table();
    for (int column = 0; table.isVisible() && column < panel->model().columnCount(); ++column) {
      if (table.isColumnHidden(column)) continue;
      const QString head = panel->model().headerData(column, Qt::Horizontal).toString();
      const QHeaderView& heads = *table.horizontalHeader();
      if (table.columnWidth(column) < heads.fontMetrics().horizontalAdvance(head) ||
          heads.height() < heads.fontMetrics().height())
        texts += head;
    }
    return texts;
  }
  int loads() { return static_cast<int>(document->mechanism()->loads.size()); }

 private slots:
  void init() { show(); }
  void cleanup() { close(); }

  void theTorquesOfAPlanetarySet() {
    open(loadedSet());
    QCOMPARE(panel->emptyText(), QString());
    QCOMPARE(panel->model().rowCount(), 3);
    QCOMPARE(cell(0, "part in it"), QStringLiteral("motor, given"));
    panel->showView(ForceView::joints);
    QCOMPARE(panel->emptyText(), QString());
    QCOMPARE(panel->model().rowCount(), 4);
    QCOMPARE(cell(0, "carried by"), QStringLiteral("load"));
    QCOMPARE(cell(1, "exact torque"), QStringLiteral("25"));
    QCOMPARE(cell(2, "torque"), QStringLiteral("−35"));
    QCOMPARE(panel->total(QStringLiteral("fed")), QStringLiteral("1000"));
    QCOMPARE(panel->total(QStringLiteral("forward")), QStringLiteral("–"));
    QCOMPARE(panel->remark(), QString());
    type("meshEfficiency", "0.98");
    QCOMPARE(cell(1, "exact torque"), QStringLiteral("2401/100"));
    QCOMPARE(panel->total(QStringLiteral("forward")), QStringLiteral("0.971714"));
    QCOMPARE(panel->total(QStringLiteral("efficiency")),
             QStringLiteral("0.971714"));  // in sight without the card
    const auto* forward = panel->findChild<QLabel*>(QStringLiteral("total.forward"));
    QVERIFY(forward->toolTip().endsWith(QLatin1String("Exactly 3401/3500")));
    QCOMPARE(panel->total(QStringLiteral("lost")), QStringLiteral("28.2857"));
    type("meshEfficiency", " ");
    QVERIFY(!forward->toolTip().contains(QLatin1String("Exactly")));
    type("meshEfficiency", "0.98");
    QCOMPARE(panel->total(QStringLiteral("circulating")), QStringLiteral("none"));
  }

  /// An equation of speeds and its dual of torques, with the entry of P that both use.
  void dualEquationsStandSideBySide() {
    auto* dual = panel->findChild<QLabel*>(QStringLiteral("twinLine"));
    QVERIFY(!dual->isVisible());
    open(loadedSet());
    panel->showView(ForceView::why);
    QTRY_VERIFY(dual->isVisible());
    const Mechanism& mechanism = *document->mechanism();
    selection.select({mechanism.turningJoints[1].id, mechanism.gearMeshes[1].id});
    for (const char* words :
         {"Row 10: speeds of mesh 10", "(17)", "Column 6: torque in joint 6", "(17*)", "here 25 N m", "P10"})
      QVERIFY2(dual->text().contains(QLatin1String(words)), qPrintable(dual->text()));
    QCOMPARE(dual->text().count(QStringLiteral("border:2px solid")), 3);  // in row, matrix and column
    QCOMPARE(
        dual->text().count(QRegularExpression(QStringLiteral("border:2px[^>]*><a [^>]*>\u2212?60</a></td>"))),
        3);
    const QSize both = dual->sizeHint();
    QCOMPARE(both, dual->QLabel::sizeHint());
    selection.select({mechanism.turningJoints[0].id});
    QVERIFY2(dual->text().contains(QLatin1String("Row 9: speeds of mesh 9")), qPrintable(dual->text()));
    QCOMPARE(dual->sizeHint(), dual->QLabel::sizeHint());
    QVERIFY(dual->sizeHint() != both);
    // It follows the train with losses.
    type("meshEfficiency", "0.98");
    selection.select({mechanism.turningJoints[1].id});
    QVERIFY2(dual->text().contains(QLatin1String("here 24.01 N m")), qPrintable(dual->text()));
  }

  /// The framed entry follows what is pointed at, tells others, and can be clicked.
  void theSharedEntryIsTold() {
    QSignalSpy changed(&panel->dualityLine(), &DualityLine::entryChanged);
    QSignalSpy wanted(&panel->dualityLine(), &DualityLine::entryWanted);
    open(loadedSet());
    panel->showView(ForceView::why);
    const Mechanism& mechanism = *document->mechanism();
    const auto entry = [&](int mesh, int joint) {
      return !changed.isEmpty() &&
             changed.last() ==
                 QVariantList{QVariant::fromValue(ElementId(mechanism.gearMeshes[std::size_t(mesh)].id)),
                              QVariant::fromValue(ElementId(mechanism.turningJoints[std::size_t(joint)].id))};
    };
    QTRY_VERIFY(panel->dualityLine().isVisible());
    QVERIFY(changed.isEmpty());  // nobody has chosen one
    emit panel->dualityLine().linkActivated(QStringLiteral("entry"));
    QVERIFY(entry(0, 0));
    wanted.clear();
    selection.select({mechanism.turningJoints[1].id, mechanism.gearMeshes[1].id});
    QVERIFY(entry(1, 1));
    selection.hover(ElementId(mechanism.turningJoints[2].id));
    QVERIFY(entry(1, 2));
    selection.unhover();
    QVERIFY(entry(1, 1));
    // The cell of a matrix comes before the cycle that lights up with it.
    panel->dualityLine().pointAt(mechanism.gearMeshes[0].id, mechanism.turningJoints[3].id);
    selection.hover(
        {mechanism.turningJoints[0].id, mechanism.turningJoints[3].id, mechanism.gearMeshes[0].id});
    QVERIFY(entry(0, 3));
    panel->dualityLine().pointAt({}, {});
    selection.unhover();
    QVERIFY(entry(1, 1));
    emit panel->dualityLine().linkActivated(QStringLiteral("entry"));
    QCOMPARE(wanted.size(), 1);
    // Without torques there is none.
    changed.clear();
    open(Mechanism());
    QCOMPARE(changed.size(), 1);
    QVERIFY(changed.last() ==
            (QVariantList{QVariant::fromValue(ElementId()), QVariant::fromValue(ElementId())}));
  }

  /// As large as in a window of 1366 x 768 px, the answer has most of the panel.
  void theAnswerHasItsRoom() {
    open(loadedSet());
    panel->resize(790, 290);
    for (const ForceViewEntry& entry : forceViewEntries()) {
      panel->showView(entry.view);
      QCoreApplication::processEvents();
      const auto* pages = panel->findChild<QStackedWidget*>();
      QVERIFY2(pages->height() >= panel->height() * 55 / 100,
               qPrintable(entry.name + QString::number(pages->height())));
      QVERIFY(pages->width() == panel->width());
    }
  }

  /// One question at a time: its views are offered, the first one is shown, and the last one is found again.
  void oneQuestionAtATime() {
    open(loadedSet());
    const auto offered = [&] {
      QStringList names;
      for (const auto* chip :
           panel->findChildren<QToolButton*>(QRegularExpression(QStringLiteral("^chip\\."))))
        if (chip->isVisible()) names += chip->objectName().mid(5);
      return names;
    };
    QCOMPARE(offered(), (QStringList{QStringLiteral("needed-torques"), QStringLiteral("joint-torques")}));
    press("question.flow");
    QVERIFY(panel->view() == ForceView::powers && panel->model().kind() == ForceTableKind::powers);
    QCOMPARE(offered(), (QStringList{QStringLiteral("powers"), QStringLiteral("losses"),
                                     QStringLiteral("circulations"), QStringLiteral("efficiency")}));
    QVERIFY(panel->findChild<QLabel*>(QStringLiteral("total.fed"))->isVisible());
    QVERIFY(!panel->findChild<QToolButton*>(QStringLiteral("addLoad"))->isVisible());
    press("chip.losses");
    press("question.parts");
    QVERIFY(panel->view() == ForceView::meshes);
    press("chip.bearings");
    QVERIFY(panel->model().kind() == ForceTableKind::bearings && panel->model().rowCount() == 4);
    press("question.why");
    QVERIFY(offered().isEmpty() && panel->dualityLine().isVisible());
    QVERIFY(!panel->findChild<QToolButton*>(QStringLiteral("exportForces"))->isEnabled());
    press("question.flow");
    QVERIFY(panel->view() == ForceView::losses);
    press("question.need");
    QVERIFY(panel->view() == ForceView::needs);
    QVERIFY(panel->findChild<QToolButton*>(QStringLiteral("addLoad"))->isVisible());
    // By keys, too.
    auto* button = panel->findChild<QToolButton*>(QStringLiteral("question.need"));
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Right);
    QVERIFY(panel->view() == ForceView::losses);
  }

  /// Of a low panel the table has most, until the loads are asked for.
  void loadsFoldAway() {
    open(loadedSet());
    const auto* loads = panel->findChild<LoadsList*>();
    panel->resize(800, 320);
    QTRY_VERIFY(loads->isVisible());
    panel->resize(800, 220);
    QTRY_VERIFY(!loads->isVisible());
    press("foldLoads");
    QVERIFY(loads->isVisible());
    panel->resize(800, 230);
    QVERIFY(loads->isVisible());
    press("foldLoads");
    panel->resize(800, 400);
    QCoreApplication::processEvents();
    QVERIFY(!loads->isVisible());
    QVERIFY(panel->findChild<QToolButton*>(QStringLiteral("foldLoads"))
                ->text()
                .endsWith(QLatin1String("Loads: 1")));
  }

  /// Where the row of questions has no room it is a list.
  void questionsFoldIntoAList() {
    open(loadedSet());
    auto* list = panel->findChild<QComboBox*>(QStringLiteral("forceQuestion"));
    panel->resize(900, 300);
    QTRY_VERIFY(!panel->questions().isFolded() && !list->isVisible());
    panel->resize(panel->minimumSizeHint().width(), 300);
    QTRY_VERIFY(panel->questions().isFolded() && list->isVisible());
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Down);
    QVERIFY(panel->view() == ForceView::powers);
    panel->showView(ForceView::bearings);
    QCOMPARE(list->currentText(), QStringLiteral("What do parts carry?"));
  }

  /// Forces and losses of meshes are of one table; no value of it is in neither.
  void meshesAnswerTwoQuestions() {
    open(loadedSet());
    std::set<int> shown;
    for (const ForceView view : {ForceView::meshes, ForceView::losses}) {
      panel->showView(view);
      for (int column = 0; column < panel->model().columnCount(); ++column)
        if (!panel->table().isColumnHidden(column)) shown.insert(column);
    }
    QCOMPARE(static_cast<int>(shown.size()), panel->model().columnCount());
    panel->showView(ForceView::bearings);
    for (int column = 0; column < panel->model().columnCount(); ++column)
      QVERIFY(!panel->table().isColumnHidden(column));
  }

  /// What names a row stays when its numbers scroll.
  void theFirstColumnStays() {
    open(loadedSet());
    panel->showView(ForceView::meshes);
    panel->resize(480, 300);
    QCoreApplication::processEvents();
    auto* first = panel->table().findChild<FrozenColumn*>();
    QVERIFY(!first->isVisible());
    panel->table().horizontalScrollBar()->setValue(panel->table().horizontalScrollBar()->maximum());
    QTRY_VERIFY(first->isVisible());
    QCOMPARE(first->columnWidth(0), panel->table().columnWidth(0));
    const QModelIndex second = panel->model().index(1, 0);
    QCOMPARE(first->visualRect(second).top(), panel->table().visualRect(second).top());
    QTest::mouseClick(first->viewport(), Qt::LeftButton, Qt::NoModifier, first->visualRect(second).center());
    QVERIFY(selection.isSelected(document->mechanism()->gearMeshes[1].id));
  }

  /// The list of the last question follows the selection, and selects.
  void whatIsExplainedIsChosenInAList() {
    open(loadedSet());
    panel->showView(ForceView::why);
    auto* list = panel->findChild<QComboBox*>(QStringLiteral("whyElement"));
    QVERIFY(list->isVisible());
    QCOMPARE(list->count(), 1 + 4 + 2);
    selection.select({document->mechanism()->turningJoints[1].id});
    QVERIFY2(list->currentText().startsWith(QLatin1String("joint 6")), qPrintable(list->currentText()));
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Down);
    QVERIFY(selection.isSelected(document->mechanism()->turningJoints[2].id));
    QVERIFY(panel->explanation().contains(QLatin1String("T7")));
    const auto* line = panel->findChild<QLabel*>(QStringLiteral("twinLine"));
    press("foldRow");
    QVERIFY(!line->isVisible());
    press("foldRow");
    QVERIFY(line->isVisible());
  }

  /// In the longest of the languages, with type up to twice as large, every word of the panel is whole.
  void nothingIsCutOff_data() {
    QTest::addColumn<double>("scale");
    QTest::addColumn<QSize>("size");
    QTest::newRow("100 %") << 1.0 << QSize(740, 290);
    QTest::newRow("150 %") << 1.5 << QSize(740, 320);
    QTest::newRow("150 %, narrow") << 1.5 << QSize(630, 520);
    QTest::newRow("150 %, loads") << 1.5 << QSize(740, 440);
    QTest::newRow("200 %") << 2.0 << QSize(1200, 480);
    QTest::newRow("200 %, loads") << 2.0 << QSize(1200, 600);
  }
  void nothingIsCutOff() {
    QFETCH(double, scale);
    QFETCH(QSize, size);
    close();
    useLanguage(QStringLiteral("de"));
    applyTheme(*qApp, Theme::light, scale);
    const auto restore = qScopeGuard([] {
      useLanguage(QStringLiteral("en"));
      applyTheme(*qApp, Theme::light);
    });
    show();
    panel->resize(size);
    for (const Mechanism& mechanism : {loadedSet(3), test::eightSpeed()}) {
      open(mechanism);
      if (!mechanism.states.empty()) panel->showState(0);
      QTRY_VERIFY(panel->isUpToDate());
      QVERIFY2(panel->minimumSizeHint().width() <= size.width(),
               qPrintable(QString::number(panel->minimumSizeHint().width())));
      for (const ForceViewEntry& entry : forceViewEntries()) {
        panel->showView(entry.view);
        QTRY_VERIFY(panel->isUpToDate());
        QCoreApplication::processEvents();
        QVERIFY2(cutOff().isEmpty(), qPrintable(entry.name + QStringLiteral(": ") + cutOff().join("; ")));
      }
    }
    close();
  }

  /// Type that grows while the panel is open finds wider columns.
  void columnsFollowTheType() {
    open(loadedSet());
    panel->showView(ForceView::joints);
    applyTheme(*qApp, Theme::light, 1.5);
    const auto restore = qScopeGuard([] { applyTheme(*qApp, Theme::light); });
    QTRY_VERIFY2(cutOff().isEmpty(), qPrintable(cutOff().join("; ")));
    QTRY_VERIFY(panel->table().rowHeight(0) >= panel->table().fontMetrics().height());
  }

  void itDoesNotKeepTheWindowWide() {
    open(loadedSet());
    QVERIFY2(panel->minimumSizeHint().width() < 480,
             qPrintable(QString::number(panel->minimumSizeHint().width())));
  }

  void whatIsBeyondTheEdgeIsReachedByArrows() {
    auto* bar = new QWidget;
    auto* layout = new QHBoxLayout(bar);
    for (int i = 0; i < 10; ++i) layout->addWidget(new QPushButton(QStringLiteral("a wide button")));
    SidewaysScroll strip(bar);
    auto* left = strip.findChild<QToolButton*>(QStringLiteral("moreLeft"));
    auto* right = strip.findChild<QToolButton*>(QStringLiteral("moreRight"));
    for (const Qt::LayoutDirection direction : {Qt::LeftToRight, Qt::RightToLeft}) {
      strip.setLayoutDirection(direction);
      strip.resize(2000, 40);
      strip.show();
      QTRY_VERIFY(!right->isVisible() && !left->isVisible());
      const QSize wanted = strip.minimumSizeHint();
      strip.resize(300, 40);
      QToolButton* on = direction == Qt::LeftToRight ? right : left;
      QToolButton* back = direction == Qt::LeftToRight ? left : right;
      QTRY_VERIFY(on->isVisible());
      QVERIFY(!back->isVisible());
      QCOMPARE(strip.minimumSizeHint(), wanted);  // no room for a scroll bar
      while (on->isVisible()) on->click();
      QVERIFY(back->isVisible());
      QVERIFY(strip.viewport()->rect().contains(
          layout->itemAt(9)->widget()->mapTo(strip.viewport(), QPoint(20, 5))));
      while (back->isVisible()) back->click();
      QVERIFY(on->isVisible());
    }
  }

  void aStripGrowsWithWhatIsInIt() {
    auto* bar = new QWidget;
    auto* words = new QLabel(QStringLiteral("one line"));
    (new QVBoxLayout(bar))->addWidget(words);
    QWidget page;
    auto* layout = new QVBoxLayout(&page);
    auto* strip = new SidewaysScroll(bar, &page);
    layout->addWidget(strip);
    layout->addStretch(1);
    page.resize(400, 300);
    page.show();
    const int before = strip->height();
    words->setText(QStringLiteral("one\ntwo\nthree"));
    QTRY_VERIFY(strip->height() > before + 20);
  }

  void everyTableIsShownAndExplained() {
    open(loadedSet());
    QAbstractItemModelTester tester(&panel->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    for (const ForceViewEntry& entry : forceViewEntries()) {
      if (!entry.kind) continue;
      panel->showView(entry.view);
      QVERIFY(panel->model().kind() == *entry.kind);
      QCOMPARE(panel->model().rowCount() == 0, !panel->emptyText().isEmpty());
      for (int column = 0; column < panel->model().columnCount(); ++column) {
        QVERIFY(panel->model().headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().size() > 10);
        if (panel->model().rowCount() > 0)
          QVERIFY(
              panel->model().index(0, column).data(Qt::ToolTipRole).toString().endsWith(QLatin1Char('.')));
      }
    }
    for (const QLabel* label : panel->findChildren<QLabel*>(QRegularExpression(QStringLiteral("total\\..*"))))
      QVERIFY(!label->toolTip().isEmpty());
    panel->showView(ForceView::meshes);
    QVERIFY(number(0, "tangential").value_or(0) != 0);
    panel->showView(ForceView::powers);
    QVERIFY(panel->model().rowCount() > 6);
  }

  void loadsAreAddedChangedAndRemoved() {
    open(loadedSet());
    panel->showView(ForceView::joints);
    selection.select({document->mechanism()->turningJoints[2].id});
    press("addLoad");
    QCOMPARE(loads(), 2);
    QCOMPARE(cell(2, "carried by"), QStringLiteral("load and balance"));
    selection.select({document->mechanism()->links[1].id});
    press("addLoad");
    QCOMPARE(loads(), 3);
    QVERIFY(std::holds_alternative<LinkTorque>(document->mechanism()->loads[2].action));
    // What is typed is one step.
    const int steps = document->undoStack().count();
    type("load.0.0", "-20");
    QCOMPARE(document->undoStack().count(), steps + 1);
    QCOMPARE(std::get<JointTorque>(document->mechanism()->loads[0].action).torque.exact(), Rational(-20));
    document->undoStack().undo();
    settle();
    QCOMPARE(field("load.0.0").text(), QStringLiteral("10"));
    // The unit of the list changes numbers on the screen, not in the document.
    const auto before = document->mechanism();
    panel->findChild<QComboBox*>(QStringLiteral("loadUnit"))->setCurrentIndex(1);
    QCOMPARE(document->mechanism(), before);
    QCOMPARE(field("load.0.0").text(), QStringLiteral("10000"));
    type("load.0.0", "2500");
    QCOMPARE(std::get<JointTorque>(document->mechanism()->loads[0].action).torque.exact(), Rational(5, 2));
    QTest::mouseClick(panel->findChildren<QToolButton*>(QStringLiteral("removeLoad")).front(),
                      Qt::LeftButton);
    settle();
    QCOMPARE(loads(), 2);
    while (document->undoStack().canUndo()) document->undoStack().undo();
    settle();
    QCOMPARE(loads(), 1);
    QCOMPARE(cell(1, "exact torque"), QStringLiteral("25"));
  }

  void aForceHasThreeComponents() {
    Mechanism mechanism = loadedSet();
    mechanism.loads.push_back(
        {{},
         LinkForce{
             mechanism.links[3].id, {Number(1), Number(2), Number(3)}, {Number(4), Number(5), Number(6)}}});
    open(mechanism);
    QCOMPARE(field("load.1.2").text(), QStringLiteral("3"));
    type("load.1.2", "-7");
    const auto& force = std::get<LinkForce>(document->mechanism()->loads[1].action);
    QCOMPARE(force.force[2].exact(), Rational(-7));
    QCOMPARE(force.point[2].exact(), Rational(6));
  }

  void rowsAndSelectionAreLinked() {
    open(loadedSet());
    panel->showView(ForceView::joints);
    const QModelIndex ring = panel->model().index(1, 0);
    QTest::mouseClick(panel->table().viewport(), Qt::LeftButton, Qt::NoModifier,
                      panel->table().visualRect(ring).center());
    QVERIFY(selection.isSelected(document->mechanism()->turningJoints[1].id));
    QCOMPARE(panel->table().selectionModel()->selectedRows().size(), 1);
    selection.select({document->mechanism()->turningJoints[2].id});
    QCOMPARE(panel->table().selectionModel()->selectedRows().front().row(), 2);
    selection.select({document->mechanism()->gearMeshes[1].id});
    QVERIFY(panel->table().selectionModel()->selectedRows().isEmpty());
    panel->showView(ForceView::meshes);
    QCOMPARE(panel->table().selectionModel()->selectedRows().front().row(), 1);
  }

  void whatNothingHoldsIsReported() {
    Mechanism mechanism = loadedSet();
    mechanism.balances->pop_back();
    open(mechanism);
    QVERIFY2(panel->remark().startsWith(QLatin1String("Nothing holds this motion")),
             qPrintable(panel->remark()));
    QVERIFY(!panel->emptyText().isEmpty());
    QCOMPARE(panel->total(QStringLiteral("fed")), QStringLiteral("–"));
    QVERIFY(!panel->findChild<QToolButton*>(QStringLiteral("exportForces"))->isEnabled());
    open(Mechanism());
    QVERIFY(!panel->emptyText().isEmpty());
  }

  void sharedLoadsAskForAnAssumption() {
    open(loadedSet(3));
    auto* share = panel->findChild<QToolButton*>(QStringLiteral("shareByStiffness"));
    QVERIFY(share->isVisible());
    QVERIFY(panel->remark().contains(QLatin1String("share the load")));
    panel->showView(ForceView::meshes);
    QCOMPARE(cell(0, "on tail"), QStringLiteral("shared"));
    share->click();
    settle();
    QVERIFY(cell(0, "on tail") != QLatin1String("shared"));
    QCOMPARE(cell(0, "on tail"), cell(2, "on tail"));
    // It is part of the document: it is saved, and undone.
    QCOMPARE(document->mechanism()->sharing, std::optional(LoadSharing::stiffness));
    document->undoStack().undo();
    settle();
    QVERIFY(!document->mechanism()->sharing && !share->isChecked());
    QCOMPARE(cell(0, "on tail"), QStringLiteral("shared"));
    share->click();
    QCOMPARE(document->mechanism()->sharing, std::optional(LoadSharing::stiffness));
    share->click();
    QVERIFY(!document->mechanism()->sharing);
    open(loadedSet());
    QVERIFY(!share->isVisible());
  }

  void anEfficiencyOutOfRangeChangesNothing() {
    open(loadedSet());
    panel->showView(ForceView::joints);
    type("meshEfficiency", "0.9");
    const QString torque = cell(1, "torque");
    for (const char* wrong : {"0", "-1", "2", "much"}) {
      type("meshEfficiency", wrong);
      QVERIFY2(field("meshEfficiency").property("wrong").toBool(), wrong);
    }
    settle();
    QCOMPARE(cell(1, "torque"), torque);
  }

  void theStatesOfAGearbox() {
    open(test::eightSpeed());
    auto* states = panel->findChild<QComboBox*>(QStringLiteral("forcesState"));
    QVERIFY(states->isVisible());
    QCOMPARE(states->count(), 10);
    QVERIFY(panel->view() == ForceView::states);  // with nothing engaged and no load
    panel->showState(0);
    QVERIFY(panel->view() == ForceView::needs);
    QTRY_VERIFY(panel->isUpToDate());
    QVERIFY(panel->remark().contains(QLatin1String("gets 1 N m")));
    panel->showView(ForceView::couplings);
    QCOMPARE(panel->model().rowCount(), 3);
    type("meshEfficiency", "0.98");
    panel->showView(ForceView::states);
    QCOMPARE(panel->model().rowCount(), 9);
    QCOMPARE(cell(5, "efficiency"), QStringLiteral("1"));
    QVERIFY(number(0, "efficiency").value_or(1) < 1);
    QVERIFY(!cell(0, "A").isEmpty());
    open(loadedSet());
    QVERIFY(!states->isVisible());
    QVERIFY(panel->model().kind() == ForceTableKind::needs);
  }

  /// What the document engages counts without a state, and not in one.
  void couplingsThatTheDocumentEngages() {
    Mechanism gearbox = test::eightSpeed();
    gearbox.engaged = gearbox.states[0].engaged;
    gearbox.inputs = std::vector<Input>{{gearbox.turningJoints[0].id, Number(1), {}}};
    gearbox.loads = {{{}, LinkTorque{gearbox.links[1].id, {}, Number(1)}}};
    gearbox.balances = std::vector<HoldingTorque>{{HoldingTorque::OnLink{gearbox.links[2].id, {}}}};
    open(gearbox);
    panel->showView(ForceView::couplings);
    QCOMPARE(panel->model().rowCount(), 3);
    const QString torque = cell(0, "torque");
    QVERIFY(number(0, "torque").value_or(0) != 0);
    panel->showState(0);
    QTRY_VERIFY(panel->isUpToDate());
    QCOMPARE(cell(0, "torque"), torque);
    panel->showState(1);
    QTRY_VERIFY(panel->isUpToDate());
    QCOMPARE(panel->model().rowCount(), 3);
    QVERIFY(cell(0, "torque") != torque);
    panel->showView(ForceView::states);
    QCOMPARE(panel->model().rowCount(), 9);
    QCOMPARE(number(5, "latent").value_or(1), 0.0);  // direct drive: no tooth rolls
  }

  /// A document without loads costs nothing while no view shows torques; loads are solved in any case.
  void outOfSightOnlyLoadsAreSolved() {
    panel->showView(ForceView::joints);
    panel->setAwake(false);
    Mechanism without = loadedSet();
    without.loads.clear();
    open(without);
    QVERIFY(panel->forces() == nullptr);
    panel->setAwake(true);
    QTRY_VERIFY(panel->forces() != nullptr && panel->model().rowCount() == 4);
    panel->setAwake(false);
    QVERIFY(panel->forces() == nullptr);
    open(loadedSet());
    QVERIFY(panel->forces() != nullptr && panel->forces()->report && panel->forces()->tables.empty());
    open(without);
    QVERIFY(panel->forces() == nullptr);
  }

  /// What is tried in the panel is no diagnostic of the document.
  void diagnosticsAreThoseOfTheDocument() {
    open(loadedSet());
    QVERIFY(panel->forces()->diagnostics.empty());
    Mechanism unheld = loadedSet();
    unheld.balances->pop_back();
    open(unheld);
    QCOMPARE(panel->forces()->diagnostics.size(), std::size_t{1});
    QVERIFY(panel->forces()->diagnostics.front().code == Code::unbalanced);
    open(loadedSet(3));
    const Diagnostics shared = panel->forces()->diagnostics;
    QVERIFY(shared.size() == 1 && shared.front().code == Code::staticallyIndeterminate);
    QVERIFY(shared.front().message.ends_with("Torques outside are determined."));
    unheld.loads.clear();
    open(unheld);
    QVERIFY(panel->forces()->diagnostics.empty());
  }

  /// Loads of a gearbox with nothing engaged are meant for its states.
  void diagnosticsOfStates() {
    Mechanism gearbox = test::eightSpeed();
    gearbox.loads = {{{}, LinkTorque{LinkId("1"), {}, Number(2)}}};
    open(gearbox);
    QVERIFY(panel->forces()->diagnostics.empty());
    gearbox.balances =
        std::vector<HoldingTorque>{{HoldingTorque::OnLink{LinkId("1"), {}}}};  // the driven link is free
    open(gearbox);
    const Diagnostics cancelled = panel->forces()->diagnostics;
    QVERIFY(cancelled.size() == 1 && cancelled.front().code == Code::loadOnBalance);
    gearbox.loads.push_back({{}, LinkTorque{LinkId("8"), {}, Number(2)}});
    gearbox.balances = std::vector<HoldingTorque>{};
    open(gearbox);
    const Diagnostics& found = panel->forces()->diagnostics;
    QVERIFY(!found.empty() && found.front().code == Code::unbalanced);
    QVERIFY2(found.front().message.starts_with("In state"), found.front().message.c_str());
  }

  void tablesAreExportedAndCopied() {
    open(loadedSet());
    panel->showView(ForceView::joints);
    QSignalSpy wanted(panel.get(), &ForcesPanel::exportWanted);
    press("exportForces");
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted[0][0].toString(), QStringLiteral("joint-torques.csv"));
    QVERIFY(wanted[0][1].toString().contains(QLatin1String("torque [N m]")));
    press("copyForces");
    QVERIFY(QGuiApplication::clipboard()->text().startsWith(QLatin1String("at\tturns\t")));
  }

  /// Two inputs: over the ratio of their speeds; the meshes' efficiency beside it. Off this thread, as CSV.
  void thePlots() {
    open(loadedSet());
    panel->showView(ForceView::efficiency);
    EfficiencyPage& plots = panel->plots();
    auto* axis = plots.findChild<QComboBox*>(QStringLiteral("efficiencyAxis"));
    QTRY_VERIFY(panel->isUpToDate() && plots.followed() != nullptr);
    QCOMPARE(axis->count(), 1);  // lossless: only what the meshes' efficiency does
    type("meshEfficiency", "0.98");
    QTRY_VERIFY(panel->isUpToDate());
    QCOMPARE(axis->count(), 2);
    QCOMPARE(axis->currentIndex(), 0);  // the ratio of speeds tells more, unless it was chosen
    QTRY_VERIFY(panel->isUpToDate() && plots.followed()->curve.axis == CurveAxis::speedRatio);
    const EfficiencyPlot::Sheet& sheet = plots.plot().sheet();
    QVERIFY(sheet.across.contains("joint"));
    QCOMPARE(sheet.lines.size(), std::size_t{2});
    QCOMPARE(*sheet.now, 0.0);
    const auto still = static_cast<std::size_t>(std::find(sheet.places.begin(), sheet.places.end(), 0.0) -
                                                sheet.places.begin());
    QCOMPARE(*sheet.lines[0].values[still], Rational(3401, 3500).toDouble());

    QSignalSpy wanted(panel.get(), &ForcesPanel::exportWanted);
    QTest::mouseClick(panel->findChild<QToolButton*>(QStringLiteral("exportForces")), Qt::LeftButton);
    QCOMPARE(wanted.size(), 1);
    QCOMPARE(wanted[0][0].toString(), QStringLiteral("efficiency.csv"));
    const QString csv = wanted[0][1].toString();
    QVERIFY(csv.contains("torque at joint 6 [N m]"));
    QCOMPARE(csv.count(QLatin1Char('\n')), 82);
    QVERIFY(csv.contains(QStringLiteral("0,0.971714285714285")));

    auto* quantity = plots.findChild<QComboBox*>(QStringLiteral("efficiencyQuantity"));
    quantity->setCurrentIndex(1);
    QCOMPARE(*plots.plot().sheet().lines[0].values[still], 24.01);

    // Keys read it.
    plots.plot().setFocus();
    QTest::keyClick(&plots.plot(), Qt::Key_Right);
    QVERIFY(plots.plot().reading().contains("joint 6"));
    QCOMPARE(plots.plot().accessibleDescription(), plots.plot().reading());

    document->apply(
        {QStringLiteral("Change"), [](const Mechanism& before) { return withoutLoad(before, 0); }, 0});
    settle();
    QVERIFY(plots.emptyText().contains("loads"));
    QVERIFY(!panel->findChild<QToolButton*>(QStringLiteral("exportForces"))->isEnabled());
  }

  /// A joint, in the table or in a drawing: its cutset, highlighted in all views; a mesh: which gear drives.
  void whatIsSelectedIsExplained() {
    open(loadedSet());
    panel->showView(ForceView::why);
    QCOMPARE(panel->explanation(), QString());
    const auto& mechanism = *document->mechanism();
    selection.select({mechanism.turningJoints[2].id});
    QVERIFY2(panel->explanation().contains("cuts off links 3 and 4"), qPrintable(panel->explanation()));
    QVERIFY(panel->explanation().contains("T7 + M9 + M10 = 0"));
    QVERIFY(selection.isHovered(mechanism.links[3].id));
    QVERIFY(selection.isHovered(mechanism.gearMeshes[0].id));
    QVERIFY(!selection.isHovered(mechanism.links[1].id));
    selection.hover(mechanism.links[1].id);  // the mouse goes first
    QVERIFY(!selection.isHovered(mechanism.links[3].id));
    selection.unhover();
    QVERIFY(selection.isHovered(mechanism.links[3].id));
    selection.select({mechanism.gearMeshes[0].id});
    QVERIFY(panel->explanation().contains("drives gear"));
    QVERIFY(selection.hovered().empty());
    selection.select({mechanism.turningJoints[2].id});
    panel->showView(ForceView::joints);  // nothing is lit that nothing tells of
    QVERIFY(selection.hovered().empty());
    panel->showView(ForceView::why);
    QVERIFY(!selection.hovered().empty());
    panel->setAwake(false);
    QCOMPARE(panel->explanation(), QString());
    QVERIFY(selection.hovered().empty());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::ForcesPanelTest)
#include "test_forces_panel.moc"
