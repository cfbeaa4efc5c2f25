#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

#include "ui/designer/hub_form.h"
#include "ui/designer/hub_lists.h"
#include "ui/designer/hub_panel.h"

namespace geargraph {
namespace {

constexpr int kHubSearch = 120'000;  // ms at most

}  // namespace

/// From the ratios of a maker's sheet to the one tooth set, in the panel alone.
class HubPanelTest : public QObject {
  Q_OBJECT

  std::unique_ptr<HubPanel> m_panel;

  template <class Widget>
  Widget& part(const QString& name) const {
    auto* found = m_panel->findChild<Widget*>(name);
    if (found == nullptr) qFatal("no %s", qPrintable(name));
    return *found;
  }
  void searchToTheEnd() const {
    QTest::mouseClick(&part<QPushButton>("searchHubs"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->left() != nullptr && m_panel->isSettled(), kHubSearch);
  }

 private slots:
  void init() {
    m_panel = std::make_unique<HubPanel>();
    m_panel->resize(1200, 680);
    m_panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
  }
  void cleanup() { m_panel.reset(); }

  void aCountLeavesOneOfTheCandidates() {
    emit part<QLabel>("hubEmpty").linkActivated("example");
    searchToTheEnd();
    QCOMPARE(m_panel->left()->assembled.size(), 3U);
    QCOMPARE(m_panel->table()->rowCount(), 17);
    QVERIFY(part<QLabel>("hubCount").text().contains("3") && part<QLabel>("hubProof").text().contains("378"));
    QVERIFY(part<QLabel>("hubShared").text().contains("the ring of set 1: 72"));
    QVERIFY(part<QLabel>("hubAsk").text().contains("sun 2 of set 2"));
    QTest::mouseClick(&part<QPushButton>("answer.29"), Qt::LeftButton);
    QCOMPARE(m_panel->left()->assembled.size(), 1U);
    QVERIFY(part<QLabel>("hubShared").text().contains("This is it"));
    QVERIFY(!part<QWidget>("hubQuestion").isVisible());
    QTest::mouseClick(&part<QToolButton>("answered.0"), Qt::LeftButton);  // takes it back
    QCOMPARE(m_panel->left()->assembled.size(), 3U);
    part<QLineEdit>("hubOtherAnswer").setText("31");
    QTest::keyClick(&part<QLineEdit>("hubOtherAnswer"), Qt::Key_Return);
    QVERIFY(m_panel->left()->assembled.empty());
  }

  void productsSayWhy() {
    emit part<QLabel>("hubEmpty").linkActivated("example");
    searchToTheEnd();
    const auto& products = part<QTableWidget>("hubProducts");
    QVERIFY(products.isVisible());
    QCOMPARE(products.rowCount(), 3);
    QCOMPARE(products.columnCount(), 3);
    QStringList cells;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) cells << products.item(row, column)->text();
    cells.sort();
    QCOMPARE(cells, (QStringList{"0.976, not used", "1, not used", "1:  0.632", "2:  0.741", "3:  0.843",
                                 "4:  0.989", "5:  1.145", "6:  1.335", "7:  1.545"}));
  }

  void aCandidateIsOpenedAsADocument() {
    part<QPlainTextEdit>("hubRatios").setPlainText("0.75 1 1.333");
    part<QLineEdit>("hubCounted").setText("1.sun1 20");
    searchToTheEnd();
    QVERIFY(!m_panel->left()->assembled.empty());
    const QSignalSpy opened(m_panel.get(), &HubPanel::openWanted);
    QTest::keyClick(m_panel->table(), Qt::Key_Return);
    QTRY_COMPARE(opened.size(), 1);
    QCOMPARE(opened.front().front().value<MechanismPtr>()->states.size(), 3U);
  }

  void faultsAreShownAtTheirFields() {
    const auto fault = [this] {
      QStringList shown;
      for (const auto* label : m_panel->findChildren<QLabel*>(QRegularExpression("^fault\\.")))
        if (!label->isHidden()) shown << label->text();
      return shown.join('|');
    };
    QTest::mouseClick(&part<QPushButton>("searchHubs"), Qt::LeftButton);
    QVERIFY2(fault().contains("ratios"), qPrintable(fault()));
    part<QPlainTextEdit>("hubRatios").setPlainText("0.75 1");
    part<QLineEdit>("hubCounted").setText("3.ring 60");
    QTest::mouseClick(&part<QPushButton>("searchHubs"), Qt::LeftButton);
    QVERIFY2(fault().contains("3.ring"), qPrintable(fault()));
    QVERIFY(m_panel->left() == nullptr);
  }

  void ratiosThatNothingGivesSayWhy() {
    part<QPlainTextEdit>("hubRatios").setPlainText("0.75 1.4");
    part<QCheckBox>("hubStepped").setChecked(false);
    part<QSpinBox>("hubSets").setValue(1);
    searchToTheEnd();
    QVERIFY(m_panel->left()->assembled.empty());
    QVERIFY(part<QLabel>("hubEmpty").isVisible());
    QVERIFY(part<QLabel>("hubEmpty").text().contains("no product of the others"));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::HubPanelTest)

#include "test_hub_panel.moc"
