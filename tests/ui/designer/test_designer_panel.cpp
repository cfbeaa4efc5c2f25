#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>
#include <QTest>

#include "ui/designer/designer_panel.h"
#include "ui/designer/hit_card.h"
#include "ui/designer/hit_words.h"
#include "ui/designer/hits_table.h"
#include "ui/designer/lever_preview.h"
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
    QTRY_VERIFY(m_panel->card()->detail() != nullptr);
    QVERIFY(!part<LeverPreview>("hitLevers").drawing().marks.empty());
    QCOMPARE(m_panel->card()->detail()->document.states.size(), 4U);
  }

  void enterOpensTheChosenOne() {
    wishForSimpson();
    searchToTheEnd();
    const QSignalSpy opened(m_panel.get(), &DesignerPanel::openWanted);
    QTest::keyClick(m_panel->hits(), Qt::Key_Return);
    QTRY_COMPARE(opened.size(), 1);
    const auto document = opened.front().front().value<Mechanism>();
    QCOMPARE(document.states.size(), 4U);
    QVERIFY(document.couplings.size() >= 3);
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
