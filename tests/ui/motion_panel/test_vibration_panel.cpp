#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "tests/core/support/example_files.h"
#include "tests/core/support/snapshot_of.h"
#include "ui/canvas/drawing_preview.h"
#include "ui/forces/linked_table.h"
#include "ui/motion_panel/vibration_panel.h"
#include "ui/panels/number_field.h"

namespace geargraph {

/// The panel of frequencies and lost motion.
class VibrationPanelTest : public QObject {
  Q_OBJECT

  Selection selection;
  std::unique_ptr<VibrationPanel> panel;

  template <class T>
  T& part(const char* name) {
    return *panel->findChild<T*>(QLatin1String(name));
  }
  void settle() { QTRY_VERIFY(panel->isSettled()); }
  void open(const char* example) {
    panel->setSnapshot(test::snapshotOf(test::example(example)));
    settle();
  }
  void press(const char* chip) {
    QTest::mouseClick(&part<QToolButton>(chip), Qt::LeftButton);
    settle();
  }
  void type(const char* field, const QString& text) {
    auto& number = part<NumberField>(field);
    number.setFocus();
    number.selectAll();
    QTest::keyClicks(&number, text);
    QTest::keyClick(&number, Qt::Key_Return);
    settle();
  }
  /// The texts of a column, by its heading and unit.
  QStringList column(const char* head, const char* unit = "") {
    const auto table = panel->table();
    QStringList texts;
    for (std::size_t c = 0; table && c < table->columns.size(); ++c) {
      if (table->columns[c].head != head || table->columns[c].unit != unit) continue;
      for (const ForceRow& row : table->rows) texts << QString::fromStdString(row.cells[c].text);
    }
    return texts;
  }

 private slots:
  void init() {
    selection.clear();
    panel = std::make_unique<VibrationPanel>(&selection);
    panel->resize(900, 400);
    panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel.get()));
    panel->setAwake(true);
  }
  void cleanup() { panel.reset(); }

  void saysWhatItNeedsWithoutATrain() { QVERIFY(!panel->emptyText().isEmpty()); }

  /// 20 teeth on the input shaft and 40 on the other: 20 cycles of the mesh a turn, half a turn of the other
  /// shaft.
  void listsTheFrequenciesOfAPair() {
    open("spur-pair");
    const auto pair = test::example("spur-pair");
    const int teeth = pair.gearMeshes[0].tailTeeth;
    const QStringList ratios = column("ratio");
    QVERIFY(ratios.contains(QString::number(teeth)));
    QVERIFY(ratios.contains("1"));
    QVERIFY(panel->emptyText().isEmpty());
    QVERIFY(column("frequency", "Hz").isEmpty());
    type("vibrationRpm", "600");
    QVERIFY(column("frequency", "Hz").contains(QString::number(10 * teeth)));
  }

  void harmonicsAndSidebandsAreAsWanted() {
    open("spur-pair");
    const auto before = column("ratio").size();
    type("vibrationSidebands", "0");
    const auto without = column("ratio").size();
    QVERIFY(without < before);
    type("vibrationHarmonics", "3");
    QCOMPARE(column("ratio").size(), without + 2);
  }

  void aStateIsChosen() {
    open("eight-speed-gearbox");
    auto& states = part<QComboBox>("vibrationState");
    QVERIFY(states.count() >= 8);
    QVERIFY(states.isVisible());
    const QStringList first = column("ratio");
    states.setCurrentIndex(3);
    emit states.activated(3);
    QVERIFY(column("ratio") != first);
  }

  void theSpectrumIsDrawn() {
    open("planetary-ring-held");
    press("chip.spectrum");
    QVERIFY(part<DrawingPreview>("spectrum").isVisible());
    QVERIFY(part<DrawingPreview>("spectrum").drawing().marks.size() > 3);
  }

  void lostMotionIsToldForEachOutput() {
    open("spur-pair");
    press("chip.lostMotion");
    QVERIFY(panel->table() && !panel->table()->rows.empty());
    QVERIFY(!part<NumberField>("vibrationRpm").isEnabled());
  }

  void aRowSelectsWhatItIsAbout() {
    open("spur-pair");
    auto& table = part<LinkedTable>("vibrationTable");
    const int row = static_cast<int>(column("of").indexOf(QRegularExpression("^mesh \\d+$")));
    QVERIFY(row >= 0);
    const QRect cell = table.visualRect(table.model()->index(row, 1));
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, cell.center());
    QCOMPARE(selection.selected().size(), std::size_t{1});
  }

  void theTableIsCopiedAndExported() {
    open("spur-pair");
    press("copyVibration");
    const QString copied = QApplication::clipboard()->text();
    QCOMPARE(copied.count('\n'), static_cast<qsizetype>(panel->table()->rows.size()) + 1);
    QSignalSpy exported(panel.get(), &VibrationPanel::exportWanted);
    press("exportVibration");
    QCOMPARE(exported.size(), 1);
    QCOMPARE(exported.first().at(1).toString().count('\n'), copied.count('\n'));
    QVERIFY(exported.first().at(1).toString().startsWith("frequency,of,"));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::VibrationPanelTest)
#include "test_vibration_panel.moc"
