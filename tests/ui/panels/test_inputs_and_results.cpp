#include <QAbstractItemModelTester>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include "core/foundations/base/locale.h"
#include "core/mechanism/model/edits.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"
#include "ui/models/freedom_text.h"
#include "ui/panels/inputs_panel.h"
#include "ui/panels/ratio_text.h"
#include "ui/panels/results_delegate.h"
#include "ui/panels/results_panel.h"
#include "ui/panels/speed_slider.h"

namespace geargraph {

class InputsAndResultsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<Document> document;
  Selection selection;
  std::unique_ptr<InputsPanel> inputs;
  std::unique_ptr<ResultsPanel> results;
  SnapshotPtr snapshot;

  void settle() {
    snapshot = analyze(document->mechanism(), document->revision());
    inputs->setSnapshot(snapshot);
    results->setSnapshot(snapshot);
  }
  static QMenu& menuOf(QWidget& panel, const char* button) {
    QMenu* menu = panel.findChild<QToolButton*>(QLatin1String(button))->menu();
    emit menu->aboutToShow();
    return *menu;
  }
  static QAction* entry(const QMenu& menu, const QString& text) {
    for (QAction* action : menu.actions()) {
      if (action->text().contains(text)) return action;
    }
    return nullptr;
  }
  [[nodiscard]] QStringList inputLabels() const {
    QStringList labels;
    for (const Input& input : *document->mechanism()->inputs)
      labels << QString::fromStdString(input.joint.text());
    return labels;
  }
  QString cell(int row, int column) { return results->model().index(row, column).data().toString(); }

 private slots:
  void init() {
    selection.clear();
    document = std::make_unique<Document>();
    Mechanism robot = test::robot();
    robot.inputs = std::vector<Input>{
        {JointId("8"), Number(1), {}}, {JointId("9"), Number(1), {}}, {JointId("11"), Number(1), {}}};
    document->replace(std::move(robot), {});
    inputs = std::make_unique<InputsPanel>(document.get(), &selection);
    results = std::make_unique<ResultsPanel>(&selection);
    connect(results.get(), &ResultsPanel::inputsWanted, inputs.get(), &InputsPanel::drive);
    settle();
  }
  void cleanup() {
    inputs.reset();
    results.reset();
  }

  void oneClickExchangesAnInputAndTheMotionStays() {
    const std::vector<Rational> before = snapshot->solved->exact->rates;
    QAction* exchange = entry(menuOf(*inputs, "exchange.9"), QStringLiteral("Joint 13 instead of 9"));
    QVERIFY(exchange != nullptr && exchange->isEnabled());
    exchange->trigger();
    QCOMPARE(inputLabels(), (QStringList{"8", "13", "11"}));
    QCOMPARE(document->undoStack().count(), 1);
    settle();
    QCOMPARE(snapshot->solved->exact->rates, before);
  }

  void anExchangeThatIsNotValidSaysWhatItCouldReplace() {
    QAction* other = entry(menuOf(*inputs, "exchange.11"), QStringLiteral("Joint 12 does not depend on 11"));
    QVERIFY(other != nullptr && !other->isEnabled());
    QVERIFY(other->text().contains(QStringLiteral("it could replace 8 or 9")));
  }

  void theEndEffectorsJointsAreGivenAndTheMotorsRead() {
    const std::vector<Rational> before = snapshot->solved->exact->rates;
    QAction* chain = entry(menuOf(*results, "readMotors"), QStringLiteral("Joints of link 3: 10, 12, 14"));
    QVERIFY(chain != nullptr && chain->isEnabled());
    chain->trigger();
    QCOMPARE(inputLabels(), (QStringList{"10", "12", "14"}));
    settle();
    QCOMPARE(snapshot->solved->exact->rates, before);
  }

  void menusOfLargeTrainsAreShortAndHoldWhatIsSelected() {
    auto large = std::make_shared<const Mechanism>(test::randomTrain(7, 300, 120));
    snapshot = analyzeLive(large, 1);
    results->setSnapshot(snapshot);
    const SpanningTree& tree = *snapshot->tree;
    int last = 0;  // the last link at an end of the train that does not turn on the ground
    for (int link = 1; link <= snapshot->graph->n(); ++link) {
      bool carries = false;
      for (int other = 1; other <= snapshot->graph->n(); ++other) carries |= tree.parent(other) == link;
      if (!carries && tree.parent(link) != 0) last = link;
    }
    const QString wanted = QStringLiteral("Joints of link %1:").arg(last);
    QVERIFY(entry(menuOf(*results, "readMotors"), wanted) == nullptr);
    QVERIFY(menuOf(*results, "readMotors").actions().size() < 20);
    QVERIFY(menuOf(*results, "speedUnit").actions().size() < 50);
    selection.select({snapshot->graph->nodeId(last)});
    QVERIFY(entry(menuOf(*results, "readMotors"), wanted) != nullptr);
  }

  void speedsAreToldInRpmAndAsRatios() {
    QCOMPARE(cell(0, 4), QStringLiteral("−1/2"));
    results->setUnit({SpeedUnit::Kind::rpm, {}});
    QCOMPARE(cell(0, 4), QStringLiteral("−4.77465"));
    QCOMPARE(results->model().headerData(4, Qt::Horizontal).toString(), QStringLiteral("rpm"));
    QAction* ratio = entry(menuOf(*results, "speedUnit"), QStringLiteral("Ratio to joint 12"));
    QVERIFY(ratio != nullptr);
    ratio->trigger();
    QCOMPARE(cell(1, 4), QStringLiteral("1"));
    QCOMPARE(cell(0, 4), QStringLiteral("1/2"));  // -1/2 over -1
  }

  void absoluteSpeedsAreSumsAboutAxesAndVectors() {
    const QAbstractItemModelTester tester(
        results->findChild<QTableView*>(QStringLiteral("linkSpeeds"))->model(),
        QAbstractItemModelTester::FailureReportingMode::QtTest);
    results->setAbsolute(true);
    const auto* model = results->findChild<QTableView*>(QStringLiteral("linkSpeeds"))->model();
    QCOMPARE(model->rowCount(), 7);
    QCOMPARE(model->index(0, 1).data().toString(), QStringLiteral("−1/2 about b"));
    QCOMPARE(model->index(3, 1).data().toString(), QStringLiteral("1 about a"));
    QCOMPARE(model->index(3, 4).data().toString(), QStringLiteral("1"));
    // Link 2 turns about b with link 1, and about c on it.
    QCOMPARE(model->index(1, 1).data().toString(), QStringLiteral("−1 about c, −1/2 about b"));
  }

  void speedsAreToldRelativeToAnyLink() {
    const auto* model = results->findChild<QTableView*>(QStringLiteral("linkSpeeds"))->model();
    QAction* observer = entry(menuOf(*results, "speedFrame"), QStringLiteral("Relative to link 1"));
    QVERIFY(observer != nullptr);
    observer->trigger();
    const auto* frame = results->findChild<QToolButton*>(QStringLiteral("speedFrame"));
    QCOMPARE(frame->text(), QStringLiteral("relative to link 1 ▾"));
    QCOMPARE(model->headerData(1, Qt::Horizontal).toString(), QStringLiteral("relative to 1"));
    QCOMPARE(model->index(0, 1).data().toString(), QStringLiteral("stands still"));
    // Link 2 turns about c on link 1; link 4 about a on the ground, where link 1 turns about b, parallel to
    // a.
    QCOMPARE(model->index(1, 1).data().toString(), QStringLiteral("−1 about c"));
    QCOMPARE(model->index(3, 1).data().toString(), QStringLiteral("3/2 about a"));
    QCOMPARE(model->index(3, 4).data().toString(), QStringLiteral("1.5"));
    QCOMPARE(model->index(0, 4).data().toString(), QStringLiteral("0"));
    entry(menuOf(*results, "speedFrame"), QStringLiteral("Relative to the ground"))->trigger();
    QCOMPARE(model->index(3, 1).data().toString(), QStringLiteral("1 about a"));
    entry(menuOf(*results, "speedFrame"), QStringLiteral("Joint by joint"))->trigger();
    QCOMPARE(frame->text(), QStringLiteral("joint by joint ▾"));
  }

  void linksAreCalledByTheirNames() {
    const auto rename = [this](const char* link, const std::string& name) {
      document->apply({"name",
                       [link, name](const Mechanism& before) { return withName(before, LinkId(link), name); },
                       0});
      results->setNames(document->mechanism());  // no new analysis
    };
    rename("2", "");
    rename("1", "");
    QCOMPARE(cell(1, 0), QStringLiteral("link 2 relative to 1"));
    rename("2", "forearm");
    rename("4", "first motor");
    QCOMPARE(cell(1, 0), QStringLiteral("link 2 (forearm) relative to 1"));
    QCOMPARE(results->model().index(1, 0).data(Qt::ToolTipRole).toString(),
             QStringLiteral("Speed of joint 12: link 2 (forearm) relative to link 1"));
    QTRY_COMPARE(inputs->findChild<QWidget*>(QStringLiteral("slider.8"))->accessibleName(),
                 QStringLiteral("Speed of joint 8, link 4 (first motor)"));
    results->setAbsolute(true);
    const auto* links = results->findChild<QTableView*>(QStringLiteral("linkSpeeds"))->model();
    QCOMPARE(links->index(3, 0).data().toString(), QStringLiteral("link 4 (first motor)"));
    results->setAbsolute(false);
    rename("2", "link 2");  // it repeats the label
    QCOMPARE(cell(1, 0), QStringLiteral("link 2 relative to 1"));
  }

  void oneInputAndOneOutputHaveARatio() {
    const auto* ratio = results->findChild<QLabel*>(QStringLiteral("ratio"));
    QVERIFY(ratio->isHidden());  // three inputs
    test::TrainBuilder train("planetary set, ring held");
    const int axis = train.axis({0, 0, 0}, {0, 0, 1});
    const int sun = train.link(0, axis, "sun");
    const int carrier = train.link(0, axis, "carrier");
    const int planetAxis = train.axis({30, 0, 0}, {0, 0, 1});
    const int planet = train.link(carrier, planetAxis, "planet");
    train.external(sun, axis, 20, planet, planetAxis, 20);
    train.internal(0, axis, 60, planet, planetAxis, 20);
    train.input(0);
    document->replace(train.mechanism(), {});
    settle();
    QVERIFY(!ratio->isHidden());
    QCOMPARE(ratio->text(), QStringLiteral("Ratio i = link 1 (sun) : link 2 (carrier) = 4"));
    selection.select({ElementId(document->mechanism()->turningJoints[2].id)});
    QCOMPARE(ratio->text(),
             QStringLiteral("Ratio i = link 1 (sun) : link 3 (planet) relative to 2 = −4/3 (−1.33333)"));
    setDecimalSign(',');
    selection.clear();
    QVERIFY(ratio->text().contains(QStringLiteral("carrier")));
    selection.select({ElementId(document->mechanism()->turningJoints[2].id)});
    QVERIFY2(ratio->text().contains(QStringLiteral("−4/3 (−1,33333)")), qPrintable(ratio->text()));
    setDecimalSign('.');
    document->replace(test::robot(), {});
    settle();
    QVERIFY(ratio->isHidden());
  }

  void ofALongFormulaWhatIsSeenIsPainted() {
    const QFont font = QApplication::font();
    QString formula = QStringLiteral("-i15");
    for (int label = 16; label < 400; ++label) formula += QStringLiteral("*i%1").arg(label);
    QVERIFY(paintRatios(nullptr, font, {}, formula) > 4000);
    QVERIFY(paintRatios(nullptr, font, {}, QStringLiteral("i15*i16")) <
            paintRatios(nullptr, font, {}, QStringLiteral("-i15*i16")));
    const QRect cell(10, 0, 90, 30);
    const auto painted = [&](bool isClipped) {
      QImage image(300, 30, QImage::Format_RGB32);
      image.fill(Qt::white);
      QPainter painter(&image);
      if (isClipped) painter.setClipRect(cell);
      paintRatios(&painter, font, {12, 20}, formula);
      return image;
    };
    const QImage whole = painted(false), clipped = painted(true);
    QCOMPARE(clipped.copy(cell), whole.copy(cell));
    QImage blank(300, 30, QImage::Format_RGB32);
    blank.fill(Qt::white);
    QVERIFY(whole.copy(cell) != blank.copy(cell));
    const QRect beside(cell.right() + 1, 0, 100, 30);
    QCOMPARE(clipped.copy(beside), blank.copy(beside));
    QVERIFY(whole.copy(beside) != blank.copy(beside));
  }

  void theHeadOfAnInputLightsUpWhatItCommands() {
    auto* header = results->findChild<ResultsHeader*>();
    emit header->sectionHovered(3);  // joint 11
    QVERIFY(selection.isHovered(ElementId(JointId("13"))) && selection.isHovered(ElementId(JointId("14"))));
    QVERIFY(!selection.isHovered(ElementId(JointId("12"))));
    emit header->sectionHovered(-1);
    QVERIFY(selection.hovered().empty());
  }

  void freedomIsToldInWords() {
    const QString text = freedomText(*snapshot);
    QVERIFY(text.contains(QStringLiteral("Joint 11 commands 13, 14.")));
    QVERIFY(text.contains(QStringLiteral("Joints 8, 10 turn together")));
  }

  void aValidSetIsOneClickAwayWhereThereIsNone() {
    Mechanism open = *document->mechanism();
    open.inputs.reset();
    document->replace(std::move(open), {});
    settle();
    auto* choose = inputs->findChild<QToolButton*>(QStringLiteral("chooseInputs"));
    QCOMPARE(choose->text(), QStringLiteral("Drive joints 8, 9, 11"));
    choose->click();
    QCOMPARE(inputLabels(), (QStringList{"8", "9", "11"}));
    settle();
    QVERIFY(choose->isHidden());
  }

  void theSpeedsOfNowAreInSightBesideLongFormulas() {
    auto* table = results->findChild<QTableView*>(QStringLiteral("resultsTable"));
    results->show();
    for (const int width : {1200, 300}) {
      results->resize(width, 300);
      QCoreApplication::sendPostedEvents();
      const int now = results->model().columnCount() - 1;
      const QHeaderView* header = table->horizontalHeader();
      QVERIFY(header->sectionViewportPosition(now) >= 0);
      QVERIFY(header->sectionViewportPosition(now) + header->sectionSize(now) <= table->viewport()->width());
      QCOMPARE(header->visualIndex(now), width > 1000 ? now : 1);
    }
  }

  /// The first step of the analysis of a drag's next speed.
  SnapshotPtr dragASpeed() {
    document->apply({"speed",
                     [](const Mechanism& before) {
                       std::vector<Input> driven = *before.inputs;
                       driven.front().speed = Number(5);
                       return withInputs(before, driven);
                     },
                     0});
    return analyzeLive(document->mechanism(), document->revision());
  }

  /// A step of a drag brings other numbers under the same heads, first live and then exact.
  void namesAreShortenedBeforeCoefficientsAreHidden() {
    document->apply({"Rename",
                     [](const Mechanism& before) {
                       return withName(before, LinkId("7"), "planets that have a long name");
                     },
                     0});
    settle();
    results->setNames(document->mechanism());
    auto* table = results->findChild<QTableView*>(QStringLiteral("resultsTable"));
    auto* header = table->horizontalHeader();
    results->resize(1400, 300);
    results->show();
    const int whole = header->sectionSize(0);
    int others = ResultsDelegate(&selection, nullptr).widthOf(results->model().index(0, 4), table->font());
    for (int column = 1; column < 4; ++column) others += header->sectionSize(column);
    results->resize(whole - 20 + others, 300);
    QCoreApplication::sendPostedEvents();
    QVERIFY(header->sectionSize(0) < whole);
    QCOMPARE(table->horizontalScrollBar()->maximum(), 0);
    // The name of the link goes, its number and those of the joint stay.
    const int least = ResultsDelegate::leastWidthOf(results->model().index(0, 0), table->font());
    results->resize(300, 300);
    QVERIFY(header->sectionSize(0) >= least);
    QCOMPARE(results->model().rowText(0, {}), QString("link 1"));
    QCOMPARE(results->model().rowName(2), QString("planets that have a long name"));
  }

  void aDragLaysNothingOutAnew() {
    QSignalSpy resets(&results->model(), &QAbstractItemModel::modelReset);
    QSignalSpy changes(&results->model(), &QAbstractItemModel::dataChanged);
    const QString before = cell(0, 4);
    auto* formulas = results->findChild<QToolButton*>(QStringLiteral("formulas"));
    QVERIFY(!formulas->isHidden());
    results->setSnapshot(dragASpeed());
    QVERIFY(!formulas->isHidden());
    settle();
    QVERIFY(!formulas->isHidden());
    QCOMPARE(resets.count(), 0);
    QCOMPARE(changes.count(), 2);
    QVERIFY(cell(0, 4) != before);
  }

  void asleepItKnowsTheResultsAndShowsThemWhenItIsSeen() {
    auto* pages = results->findChild<QStackedWidget*>();
    auto* verdict = results->findChild<QLabel*>(QStringLiteral("verdict"));
    QVERIFY(!verdict->text().isEmpty());
    const int page = pages->currentIndex();
    results->setAwake(false);
    document->replace(emptyMechanism(), {});
    settle();
    QCOMPARE(results->verdict(), QString());
    QCOMPARE(pages->currentIndex(), page);
    QVERIFY(!verdict->text().isEmpty());
    results->setAwake(true);
    QVERIFY(pages->currentIndex() != page);
    QVERIFY(verdict->text().isEmpty());
  }

  void thousandsOfInputsCostWidgetsOnlyWhenAskedFor() {
    document->replace(test::randomTrain(7, 400, 0), {});
    settle();
    QCOMPARE(snapshot->matroid()->choice.joints.size(), std::size_t{400});
    const auto* note = results->findChild<QLabel*>(QStringLiteral("inputsNote"));
    QVERIFY(note->text().contains(QStringLiteral("(400 in all)")));
    QVERIFY2(note->text().size() < 200, qPrintable(note->text()));

    inputs->drive(snapshot->matroid()->choice.joints);
    QCOMPARE(document->mechanism()->inputs->size(), std::size_t{400});
    const auto rows = [&] {
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
      return inputs->findChildren<SpeedSlider*>().size();
    };
    QCOMPARE(rows(), 30);
    auto* more = inputs->findChild<QToolButton*>(QStringLiteral("moreInputs"));
    QVERIFY(more->isVisibleTo(inputs.get()));
    more->click();
    QCOMPARE(rows(), 60);
    QCOMPARE(more->text(), QStringLiteral("Show more: 60 of 400 inputs are listed"));
    more->click();
    QCOMPARE(rows(), 90);
    QVERIFY(!more->isEnabled() && !more->toolTip().isEmpty());

    document->undoStack().undo();
    QCOMPARE(rows(), 0);
    QVERIFY(!more->isVisibleTo(inputs.get()));
  }

  void rowsStayWhereLabelsChange() {
    const auto row = [this](const char* joint) {
      return inputs->findChild<SpeedSlider*>(QLatin1String("slider.") + QLatin1String(joint));
    };
    SpeedSlider* const first = row("8");
    SpeedSlider* const third = row("11");
    document->apply({"add",
                     [](const Mechanism& before) {
                       return withLink(before, CanvasPoint{90, 300});
                     },
                     0});
    QCOMPARE(row("9"), first);  // eight links move, so that the joints follow 8
    QCOMPARE(row("12"), third);
    QCOMPARE(first->accessibleName(), QStringLiteral("Speed of joint 9, link 4"));

    auto driven = document->mechanism()->inputs;
    driven->erase(driven->begin() + 1);
    document->apply({"drive", [driven](const Mechanism& before) { return withInputs(before, driven); }, 0});
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCOMPARE(row("9"), first);
    QVERIFY(row("12") != third);  // it is another row
    QCOMPARE(row("12")->accessibleName(), QStringLiteral("Speed of joint 12, link 6 relative to 1"));
  }

  void slidersHaveTheRangeOfTheDocumentsSpeeds() {
    const auto slider = [this] {
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
      return inputs->findChild<SpeedSlider*>(QStringLiteral("slider.8"));
    };
    SpeedSlider* const before = slider();
    Mechanism other = *document->mechanism();
    other.inputs->front().speed = Number(Rational(1, 2));
    document->replace(other, {});
    QCOMPARE(slider(), before);
    other.inputs->front().speed = Number(50);
    document->replace(other, {});
    slider()->setValue(slider()->value() / 2);
    QCOMPARE(document->mechanism()->inputs->front().speed.value(), 25.0);
  }

  void rowsAreShownTogether() {
    inputs->show();
    document->replace(test::randomTrain(7, 40, 0), {});
    settle();
    inputs->drive(snapshot->matroid()->choice.joints);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    const QList<SpeedSlider*> sliders = inputs->findChildren<SpeedSlider*>();
    QCOMPARE(sliders.size(), 30);
    for (const SpeedSlider* slider : sliders)
      QVERIFY(slider->isVisible());  // before another event is handled
    QVERIFY(!inputs->findChild<QToolButton*>(QStringLiteral("releaseAll"))->isVisible());
    QVERIFY(sliders.back()->y() > sliders.front()->y());
  }

  void aJumpToTheEndMeasuresNoColumnOnTheWay() {
    results->setSnapshot(analyzeLive(std::make_shared<const Mechanism>(test::randomTrain(7, 1000, 400)), 1));
    results->resize(500, 300);
    results->show();
    const int columns = results->model().columnCount();
    QVERIFY(columns > 100);
    const QList<QTableView*> tables = results->findChildren<QTableView*>();
    const auto rates = std::find_if(tables.begin(), tables.end(),
                                    [&](auto* table) { return table->model() == &results->model(); });
    QVERIFY(rates != tables.end());
    QScrollBar* bar = (*rates)->horizontalScrollBar();
    QTRY_VERIFY(bar->maximum() > 0);
    const int first = results->columnsFitted();
    bar->setValue(bar->maximum());
    QVERIFY(results->columnsFitted() > first);
    QVERIFY2(results->columnsFitted() < columns / 4, qPrintable(QString::number(results->columnsFitted())));
  }

  void nothingSolvedIsNotCalledEqual() {
    Mechanism pair = emptyMechanism();
    document->replace(pair, {});
    settle();
    QCOMPARE(results->verdict(), QString());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::InputsAndResultsTest)
#include "test_inputs_and_results.moc"
