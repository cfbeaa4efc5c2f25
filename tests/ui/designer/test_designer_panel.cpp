#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "ui/canvas/drawing_preview.h"
#include "ui/designer/designer_panel.h"
#include "ui/designer/hit_card.h"
#include "ui/designer/hit_words.h"
#include "ui/designer/hits_table.h"
#include "ui/designer/wish_form.h"

namespace geargraph {
namespace {

constexpr int kSearch = 120'000;  // ms at most

}  // namespace

/// From a wish to a gearbox, in the panel alone.
class DesignerPanelTest : public QObject {
  Q_OBJECT

  std::unique_ptr<DesignerPanel> m_panel;

  template <class Widget>
  Widget& part(const char* name) const {
    auto* found = m_panel->findChild<Widget*>(QLatin1String(name));
    if (found == nullptr) qFatal("no %s", name);
    return *found;
  }
  /// The fault that is shown at a field and names this.
  [[nodiscard]] QString fault() const {
    QStringList shown;
    for (const auto* label : m_panel->findChildren<QLabel*>(QRegularExpression("^fault\\.")))
      if (!label->isHidden()) shown << label->text();
    return shown.join('|');
  }
  /// Two simple sets with the ratios of Simpson's gearbox: k of 2.25 and 1.94.
  void wishForSimpson() const {
    part<QPlainTextEdit>("wishRatios").setPlainText("2.52 1.52 1");
    part<QComboBox>("wishReverse").setCurrentIndex(1);
    part<QLineEdit>("wishReverseRatio").setText("-1.94");
    part<QSpinBox>("wishFewestTeeth").setValue(15);
    part<QSpinBox>("wishMostRing").setValue(90);
  }
  void searchToTheEnd() const {
    QTest::mouseClick(&part<QPushButton>("searchGearboxes"), Qt::LeftButton);
    QVERIFY2(fault().isEmpty(), qPrintable(fault()));
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->isDone(), kSearch);
  }

 private slots:
  void init() {
    m_panel = std::make_unique<DesignerPanel>();
    m_panel->resize(1200, 680);
    m_panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
  }
  void cleanup() { m_panel.reset(); }

  void ratiosAreReadAsTypedOrPasted() {
    QCOMPARE(ratiosIn("4.17 2.34\n1.52"), (QStringList{"4.17", "2.34", "1.52"}));
    QCOMPARE(ratiosIn("4,17 2,34; 1,52"), (QStringList{"4.17", "2.34", "1.52"}));
    QCOMPARE(ratiosIn("4.17, 2.34,1.52,"), (QStringList{"4.17", "2.34", "1.52"}));
    QCOMPARE(ratiosIn("38/13\t1"), (QStringList{"38/13", "1"}));
    QCOMPARE(ratiosIn("  "), QStringList());
  }

  void simpsonsRatiosGiveAGearboxWithItsShiftTable() {
    wishForSimpson();
    searchToTheEnd();
    const HitsModel& hits = m_panel->hits()->hits();
    QVERIFY(hits.rowCount() > 0);
    for (int row = 1; row < hits.rowCount(); ++row) QVERIFY(!ranksBefore(*hits.at(row), *hits.at(row - 1)));
    QVERIFY(part<QLabel>("designSampled").text().startsWith("sampled, not a proof"));

    const GearboxPtr first = m_panel->hits()->chosen();
    QVERIFY(first != nullptr);
    auto& states = part<QTableWidget>("hitStates");
    QCOMPARE(states.rowCount(), 4);
    const QStringList wanted{"2.52", "1.52", "1", "−1.94"};
    for (int row = 0; row < 4; ++row) {
      const Rational& ratio = first->gears[static_cast<std::size_t>(row)].ratio;
      QCOMPARE(states.item(row, 1)->text(), wanted[row]);
      QCOMPARE(states.item(row, 3)->text(), fractionOf(ratio));
      const double of = QString(wanted[row]).replace(QChar(0x2212), '-').toDouble();
      QVERIFY(std::abs(ratio.toDouble() / of - 1) <= 0.01 + 1e-12);
    }
    QTRY_VERIFY(m_panel->detailOf(first) != nullptr);
    QVERIFY(!part<DrawingPreview>("hitLevers").drawing().marks.empty());
    QVERIFY(!part<DrawingPreview>("otherHitDrawing").drawing().marks.empty());  // its schematic
    QCOMPARE(m_panel->detailOf(first)->document.states.size(), 4U);
  }

  void enterOpensTheChosenOne() {
    wishForSimpson();
    searchToTheEnd();
    const QSignalSpy opened(m_panel.get(), &DesignerPanel::openWanted);
    QTest::keyClick(m_panel->hits(), Qt::Key_Return);
    QTRY_COMPARE(opened.size(), 1);
    const auto document = opened.front().front().value<MechanismPtr>();
    QCOMPARE(document->states.size(), 4U);
    QVERIFY(document->couplings.size() >= 3);
  }

  /// Two that are ticked stand beside each other, and a third takes the place of the first.
  void twoThatAreTickedAreCompared() {
    wishForSimpson();
    searchToTheEnd();
    HitsTable& table = *m_panel->hits();
    QVERIFY(table.hits().rowCount() >= 3);
    table.selectRow(0);
    QCOMPARE(m_panel->card()->hits().size(), 1U);
    QTest::keyClick(&table, Qt::Key_Space);
    QTest::keyClick(&table, Qt::Key_Down);  // beside the ticked one
    QCOMPARE(m_panel->card()->hits().size(), 2U);
    QTest::keyClick(&table, Qt::Key_Space);
    auto& states = part<QTableWidget>("hitStates");
    for (int row = 0; row < states.rowCount(); ++row) {
      for (const auto& [hit, column] : {std::pair(0, 3), std::pair(1, 5)}) {
        const GearState& gear = table.hits().at(hit)->gears[static_cast<std::size_t>(row)];
        QCOMPARE(states.item(row, column)->text(), decimalOf(gear.ratio));
      }
    }
    QVERIFY(part<QPushButton>("openOtherHit").isVisible());
    table.selectRow(2);
    QTest::keyClick(&table, Qt::Key_Space);
    QCOMPARE(table.hits().ticked().size(), 2U);
    QVERIFY(!table.hits().isTicked(table.hits().at(0)) && table.hits().isTicked(table.hits().at(2)));
    QTRY_VERIFY(m_panel->isSettled());
    const QSignalSpy opened(m_panel.get(), &DesignerPanel::openWanted);
    QTest::mouseClick(&part<QPushButton>("openOtherHit"), Qt::LeftButton);
    QTRY_COMPARE(opened.size(), 1);
    const auto document = opened.front().front().value<MechanismPtr>();
    QCOMPARE(document->couplings.size(), table.hits().at(2)->elements.size());
  }

  void filtersHideWithoutForgetting() {
    wishForSimpson();
    searchToTheEnd();
    HitsTable& table = *m_panel->hits();
    const std::vector<GearboxPtr> all = table.hits().all();
    HitFilter filter;
    filter.set(HitCondition::drawable, 0);
    table.shown().setFilter(filter);
    const auto drawable =
        std::count_if(all.begin(), all.end(), [](const auto& each) { return !each->brokenRule; });
    QCOMPARE(table.shown().rowCount(), static_cast<int>(drawable));
    QCOMPARE(filter.hiddenBy(HitCondition::drawable, all),
             static_cast<int>(all.size()) - table.shown().rowCount());
    QVERIFY(part<QLabel>("shownCount").text().startsWith(QString::number(drawable) + " of "));
    filter.set(HitCondition::error, Rational(1, 1000));
    table.shown().setFilter(filter);
    for (int row = 0; row < table.shown().rowCount(); ++row) {
      const Gearbox& each = *table.shown().at(table.shown().index(row, 0));
      QVERIFY(!each.brokenRule && each.error <= Rational(1, 1000));
    }
    QTest::mouseClick(&part<QToolButton>("filter.0"), Qt::LeftButton);  // lets go of the error
    QCOMPARE(table.shown().rowCount(), static_cast<int>(drawable));
    for (const HitCondition condition : kHitConditions) {
      for (const Rational& bound : boundsOf(condition, all)) {
        HitFilter one;
        one.set(condition, bound);
        const auto met =
            std::count_if(all.begin(), all.end(), [&](const auto& each) { return one.accepts(*each); });
        QVERIFY(met > 0 && met < static_cast<std::ptrdiff_t>(all.size()));
      }
    }
  }

  void aHiddenRowComesBackByUndo() {
    wishForSimpson();
    searchToTheEnd();
    HitsTable& table = *m_panel->hits();
    const int all = table.shown().rowCount();
    table.selectRow(1);
    const GearboxPtr hidden = table.chosen();
    QTest::keyClick(&table, Qt::Key_H);
    QCOMPARE(table.shown().rowCount(), all - 1);
    QVERIFY(table.chosen() != nullptr && table.chosen() != hidden);
    QTest::keyClick(&table, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(table.shown().rowCount(), all);
    QCOMPARE(table.hits().rowCount(), all);
  }

  void columnsSort() {
    wishForSimpson();
    searchToTheEnd();
    HitsTable& table = *m_panel->hits();
    for (const int column : {HitsModel::error, HitsModel::speed, HitsModel::torque, HitsModel::circulating}) {
      table.sortByColumn(column, Qt::AscendingOrder);
      const HitMeasure measure = *HitsModel::measureOf(column);
      for (int row = 1; row < table.shown().rowCount(); ++row) {
        QVERIFY(sortKeyOf(measure, *table.shown().at(table.shown().index(row - 1, 0))) <=
                sortKeyOf(measure, *table.shown().at(table.shown().index(row, 0))));
      }
    }
  }

  void aVariantIsComparedWithWhatItIsAVariantOf() {
    wishForSimpson();
    searchToTheEnd();
    HitsTable& table = *m_panel->hits();
    const int before = table.hits().rowCount();
    int row = 0;
    auto& button = part<QToolButton>("hitVariants");
    for (; row < before && !button.isEnabled(); ++row) table.selectRow(row);
    QVERIFY(button.isEnabled());
    const GearboxPtr original = table.chosen();
    emit button.menu()->aboutToShow();
    QVERIFY(!button.menu()->actions().isEmpty() && button.menu()->actions().front()->isEnabled());
    button.menu()->actions().front()->trigger();
    QCOMPARE(table.hits().ticked().size(), 2U);
    QVERIFY(table.hits().isTicked(original));
    const GearboxPtr variant = table.chosen();
    QVERIFY(variant != original && variant->layout == original->layout);
    QVERIFY(variant->elements != original->elements);
    for (std::size_t gear = 0; gear < original->gears.size(); ++gear)
      QCOMPARE(variant->gears[gear].ratio, original->gears[gear].ratio);
  }

  void rowsHavePictures() {
    wishForSimpson();
    searchToTheEnd();
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), kSearch);
    HitPictures pictures;
    pictures.startAnew(m_panel->hits()->hits().wish());
    const QSignalSpy drawn(&pictures, &HitPictures::drawn);
    const GearboxPtr first = m_panel->hits()->hits().at(0);
    QVERIFY(pictures.of(first, Theme::light, 1).levers.isNull());
    QTRY_COMPARE(drawn.size(), 1);
    const auto made = pictures.of(first, Theme::light, 1);
    for (const QImage& each : {made.levers, made.schematic}) {
      QImage empty(each.size(), each.format());
      empty.fill(Qt::transparent);
      QVERIFY(!each.isNull() && each != empty);
    }
  }

  void aSavedWishIsThatOfTheCommandLine() {
    wishForSimpson();
    const QTemporaryDir folder;
    const QString path = folder.filePath("wish.json");
    m_panel->saveWish(path);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto read = readGearboxWish(file.readAll().toStdString());
    QVERIFY(read.has_value());
    QCOMPARE(read->canonical, m_panel->form()->wish()->canonical);
    const QSignalSpy rejected(m_panel.get(), &DesignerPanel::rejected);
    m_panel->saveWish(folder.filePath("none/wish.json"));
    QCOMPARE(rejected.size(), 1);
  }

  // The wish of the eight-speed gearbox takes minutes.
  void escapePausesAndKeepsWhatWasSearched() {
    part<QPlainTextEdit>("wishRatios").setPlainText("4.696 3.130 2.104 1.667 1.285 1 0.839 0.667");
    part<QSpinBox>("wishSimple").setValue(4);
    part<QSpinBox>("wishLinks").setValue(8);
    part<QSpinBox>("wishElements").setValue(5);
    QTest::mouseClick(&part<QPushButton>("searchGearboxes"), Qt::LeftButton);
    QVERIFY2(fault().isEmpty(), qPrintable(fault()));
    auto& count = part<QLabel>("designCount");
    QTRY_VERIFY_WITH_TIMEOUT(count.text().contains(" of "), kSearch);
    QTest::keyClick(m_panel->hits(), Qt::Key_Escape);
    QVERIFY(!m_panel->isSearching() && !m_panel->isDone());
    const QString paused = count.text();
    QVERIFY2(paused.startsWith("Paused at "), qPrintable(paused));
    QTest::mouseClick(&part<QPushButton>("pauseSearch"), Qt::LeftButton);
    QVERIFY(m_panel->isSearching());
    const QString at = paused.section(' ', 2, 2);
    QVERIFY2(count.text().startsWith(at), qPrintable(count.text()));  // it goes on from there
    QTest::mouseClick(&part<QPushButton>("pauseSearch"), Qt::LeftButton);
    QVERIFY(!m_panel->isSearching());
  }

  void faultsAreShownAtTheirFields() {
    QTest::mouseClick(&part<QPushButton>("searchGearboxes"), Qt::LeftButton);
    QVERIFY2(fault().contains("ratios"), qPrintable(fault()));
    QVERIFY(!m_panel->isSearching());
    wishForSimpson();
    QVERIFY(fault().isEmpty());
    part<QPlainTextEdit>("wishRatios").setPlainText("2.52 fast 1");
    QTest::mouseClick(&part<QPushButton>("searchGearboxes"), Qt::LeftButton);
    QVERIFY2(fault().contains("fast"), qPrintable(fault()));
    wishForSimpson();
    part<QLineEdit>("wishLeastK").setText("9");
    QTest::mouseClick(&part<QPushButton>("searchGearboxes"), Qt::LeftButton);
    QVERIFY2(fault().contains("the smaller one first"), qPrintable(fault()));
    part<QLineEdit>("wishLeastK").setText("1.5");
    part<QSpinBox>("wishElements").setValue(2);
    QTest::mouseClick(&part<QPushButton>("searchGearboxes"), Qt::LeftButton);
    QVERIFY2(fault().startsWith("Impossible: 4 gears"), qPrintable(fault()));
  }

  void theExampleIsALinkThatFillsTheWish() {
    auto& empty = part<QLabel>("designEmpty");
    QVERIFY(empty.isVisible() && empty.text().contains("<a href"));
    emit empty.linkActivated("example");
    QCOMPARE(part<QPlainTextEdit>("wishRatios").toPlainText(), QString(WishForm::kExampleRatios));
    const auto wish = m_panel->form()->wish();
    QVERIFY(wish.has_value());
    QCOMPARE(wish->forward.size(), 6U);
    QCOMPARE(wish->limits.kinds, (std::vector{SetKind::simple, SetKind::ravigneaux}));
  }

  void whoSearchesByKeysGoesOnInTheList() {
    auto& ratios = part<QPlainTextEdit>("wishRatios");
    wishForSimpson();
    ratios.setFocus();
    QTest::keyClick(&ratios, Qt::Key_Return, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->isDone(), kSearch);
    QCOMPARE(m_panel->window()->focusWidget(), static_cast<QWidget*>(m_panel->hits()));
    // Who goes on typing stays where the typing is.
    ratios.setFocus();
    QTest::keyClick(&ratios, Qt::Key_Return, Qt::ControlModifier);
    QTest::keyClicks(&ratios, " 1");
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->isDone(), kSearch);
    QCOMPARE(m_panel->window()->focusWidget(), static_cast<QWidget*>(&ratios));
  }

  /// It is not scrolled sideways: what does not fit could not be seen.
  void theFormIsAsWideAsItsFields() {
    auto& scroll = part<QScrollArea>("wishScroll");
    QVERIFY(scroll.viewport()->width() >= m_panel->form()->minimumSizeHint().width());
  }

  void anotherWishMarksTheListAsThatOfTheEarlierOne() {
    wishForSimpson();
    searchToTheEnd();
    const int found = m_panel->hits()->hits().rowCount();
    part<QLineEdit>("wishTolerance").setText("2");
    QCOMPARE(m_panel->hits()->hits().rowCount(), found);
    const auto labels = m_panel->findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* each) {
      return each->isVisible() && each->text().contains("earlier wish");
    }));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::DesignerPanelTest)

#include "test_designer_panel.moc"
