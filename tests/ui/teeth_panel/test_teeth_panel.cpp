#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/design/teeth_check/teeth_check.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/pins.h"
#include "tests/core/support/example_files.h"
#include "ui/teeth_panel/choices_table.h"
#include "ui/teeth_panel/teeth_panel.h"
#include "ui/teeth_panel/wish_form.h"

namespace geargraph {
namespace {

Mechanism twoRingReducer() {
  QFile file(QString::fromStdString(test::sourcePath("tests/golden/files/two-ring.geargraph")));
  if (!file.open(QIODevice::ReadOnly)) qFatal("no two-ring.geargraph");
  const auto read = readMechanism(file.readAll().toStdString());
  if (!read) qFatal("two-ring.geargraph is wrong");
  return *read;
}

/// Without the signs that group thousands, which depend on the language of the machine.
QString withoutGroups(QString text) {
  return text.remove(QRegularExpression(QStringLiteral("(?<=\\d)[,.\\x{202f}\\x{a0}](?=\\d{3}\\b)")));
}

}  // namespace

/// Wishes are typed for the two-ring reducer of 50 : 1.
class TeethPanelTest : public QObject {
  Q_OBJECT

  std::unique_ptr<Document> m_document;
  std::unique_ptr<TeethPanel> m_panel;
  int m_previews = 0;
  int m_ends = 0;

  template <class Widget>
  Widget& part(const QString& name) const {
    auto* found = m_panel->findChild<Widget*>(name);
    if (found == nullptr) qFatal("no %s", qPrintable(name));
    return *found;
  }
  void settle() const { QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), 60'000); }
  void type(const QString& name, const QString& text) const {
    auto& field = part<QLineEdit>(name);
    field.selectAll();
    text.isEmpty() ? QTest::keyClick(&field, Qt::Key_Delete) : QTest::keyClicks(&field, text);
    settle();
  }
  void limit() const {
    part<QSpinBox>("mostTeeth").setValue(60);
    part<QSpinBox>("mostRingTeeth").setValue(120);
    part<QSpinBox>("wishedPlanets").setValue(3);
  }
  [[nodiscard]] ChoicesModel& choices() const { return m_panel->choices(); }
  [[nodiscard]] QString cell(int row, ChoicesModel::Kind kind) const {
    for (int column = 0; column < choices().columnCount(); ++column)
      if (choices().columnAt(column).kind == kind) return choices().index(row, column).data().toString();
    return {};
  }
  void sortBy(ChoicesModel::Kind kind, Qt::SortOrder order) const {
    for (int column = 0; column < choices().columnCount(); ++column)
      if (choices().columnAt(column).kind == kind) m_panel->table().sortByColumn(column, order);
  }
  [[nodiscard]] int ringTeeth() const { return m_document->mechanism()->gearMeshes[1].headTeeth; }

 private slots:
  void init() {
    m_document = std::make_unique<Document>();
    m_document->replace(twoRingReducer(), {});
    m_panel = std::make_unique<TeethPanel>(m_document.get());
    m_previews = m_ends = 0;
    connect(m_panel.get(), &TeethPanel::previewWanted, this, [this] { ++m_previews; });
    connect(m_panel.get(), &TeethPanel::previewEnded, this, [this] { ++m_ends; });
    m_panel->resize(1100, 320);
    m_panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
    m_panel->setAwake(true);
    settle();
  }
  void cleanup() {
    m_panel.reset();
    m_document.reset();
  }

  /// Before a ratio is typed the wheels are listed, with the ratio that the train has.
  void theTrainAsItIs() {
    QCOMPARE(choices().rowCount(), 0);
    QVERIFY(m_panel->badge().isEmpty());
    QCOMPARE(part<QLabel>("now.0").text(), QStringLiteral("now 50"));
    QCOMPARE(part<QComboBox>("drive.0").currentText(), QStringLiteral("1 sun"));
    QCOMPARE(part<QComboBox>("driven.0").currentText(), QStringLiteral("3 ring 2"));
    int wheels = 0;
    for (const QCheckBox* box : m_panel->findChildren<QCheckBox*>())
      wheels += box->objectName().startsWith(QLatin1String("wheel.")) && box->isChecked() ? 1 : 0;
    QCOMPARE(wheels, 5);  // equal planets are one
  }

  void twelveChoicesAreFoundAndOneIsTakenAndUndone() {
    limit();
    type("ratio.0", "64");
    QCOMPARE(choices().rowCount(), 12);
    QCOMPARE(withoutGroups(m_panel->badge()), QStringLiteral("All 38997 choices tried: complete"));
    const QString funnel = withoutGroups(m_panel->funnel());
    for (const char* step : {"37919 turn", "30372 with planets", "10112 with equal planets", "12 meet"})
      QVERIFY2(funnel.contains(QLatin1String(step)), qPrintable(funnel));
    QCOMPARE(cell(0, ChoicesModel::Kind::ratio), QStringLiteral("64"));
    QCOMPARE(cell(0, ChoicesModel::Kind::error), QStringLiteral("exact"));
    QCOMPARE(cell(0, ChoicesModel::Kind::efficiency), QStringLiteral("0.699"));
    QCOMPARE(cell(3, ChoicesModel::Kind::ratio), QStringLiteral("1090/17"));
    QCOMPARE(cell(3, ChoicesModel::Kind::decimal), QStringLiteral("64.118"));
    QCOMPARE(cell(3, ChoicesModel::Kind::error), QStringLiteral("+0.184 %"));
    QCOMPARE(m_previews, 0);

    const MechanismPtr before = m_document->mechanism();
    ChoicesTable& table = m_panel->table();
    table.setFocus();
    QTest::keyClick(&table, Qt::Key_Down);
    QCOMPARE(table.chosenRow(), 0);
    QCOMPARE(m_previews, 1);
    QCOMPARE(part<QLabel>("chosen.15:tail").text(), QStringLiteral("→ 17"));
    QTest::keyClick(&table, Qt::Key_Down);
    QCOMPARE(table.chosenRow(), 1);
    QCOMPARE(m_previews, 2);
    QTest::keyClick(&table, Qt::Key_Escape);
    QCOMPARE(table.chosenRow(), -1);
    QCOMPARE(m_ends, 1);
    QVERIFY(part<QLabel>("chosen.15:tail").text().isEmpty());
    QCOMPARE(m_document->mechanism(), before);  // a preview is no edit
    QVERIFY(!part<QToolButton>("useTeeth").isEnabled());

    QTest::keyClick(&table, Qt::Key_Down);
    QTest::keyClick(&table, Qt::Key_Return);
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(ringTeeth(), 85);
    settle();
    QCOMPARE(part<QLabel>("now.0").text(), QStringLiteral("now 64"));
    QCOMPARE(choices().rowCount(), 12);
    m_document->undoStack().undo();
    QCOMPARE(*m_document->mechanism(), *before);
    settle();
    QCOMPARE(part<QLabel>("now.0").text(), QStringLiteral("now 50"));
  }

  void aHeadSortsExactly() {
    limit();
    type("ratio.0", "64");
    sortBy(ChoicesModel::Kind::ratio, Qt::DescendingOrder);
    for (int row = 1; row < choices().rowCount(); ++row)
      QVERIFY(choices().choiceAt(row).found.ratios[0] <= choices().choiceAt(row - 1).found.ratios[0]);
    QVERIFY(choices().rankAt(0) > 1);
    sortBy(ChoicesModel::Kind::rank, Qt::AscendingOrder);
    QCOMPARE(choices().rankAt(0), 1);
    const QStringList lines = choices().csv().split('\n');
    QCOMPARE(lines.size(), 14);
    QVERIFY2(lines[0].startsWith("choice,15:tail,15:head"), qPrintable(lines[0]));
  }

  /// 0.5 % of 64 is 0.32, and commas are read.
  void tolerancesAreSharesOrNumbers() {
    limit();
    type("ratio.0", "64");
    type("tolerance.0", "0,32");
    QCOMPARE(choices().rowCount(), 12);
    type("tolerance.0", "0");
    QCOMPARE(choices().rowCount(), 3);  // exactly
    type("tolerance.0", "");
    QCOMPARE(choices().rowCount(), 3);
    type("ratio.0", "64.2");  // rounded: 64.15 up to 64.25
    for (int row = 0; row < choices().rowCount(); ++row) {
      const Rational& ratio = choices().choiceAt(row).found.ratios[0];
      QVERIFY(ratio >= Rational(6415, 100) && ratio < Rational(6425, 100));
    }
    QCOMPARE(choices().rowCount(), 3);
  }

  void whatIsWrongIsSaidAtItsField() {
    type("ratio.0", "0");
    auto& problem = part<QLabel>("problem.0");
    QVERIFY2(problem.isVisibleTo(m_panel.get()) && problem.text().contains("stand still"),
             qPrintable(problem.text()));
    QVERIFY(part<QLineEdit>("ratio.0").palette().color(QPalette::Text) !=
            part<QLineEdit>("tolerance.0").palette().color(QPalette::Text));
    QCOMPARE(choices().rowCount(), 0);
    type("ratio.0", "64");
    QVERIFY(!problem.isVisibleTo(m_panel.get()));
    part<QSpinBox>("fewestTeeth").setValue(200);
    settle();
    QVERIFY(part<QLabel>("limitsProblem").text().contains("from 200 to 120"));
    QTest::mouseClick(&part<QToolButton>("defaultLimits"), Qt::LeftButton);
    settle();
    QVERIFY(part<QLabel>("limitsProblem").text().isEmpty());
    type("stock", "8 x");
    QVERIFY(!part<QLabel>("limitsProblem").text().isEmpty());
  }

  void theNearestMissIsTold() {
    limit();
    type("tolerance.0", "0.1 %");
    type("ratio.0", "100");
    QVERIFY2(m_panel->funnel().contains("None. Nearest: 5512/55, off by +0.218 %"),
             qPrintable(m_panel->funnel()));
    QCOMPARE(choices().rowCount(), 1);
    QCOMPARE(cell(0, ChoicesModel::Kind::rank), QStringLiteral("nearest"));
  }

  void wheelsKeepTheirTeeth() {
    limit();
    type("tolerance.0", "5 %");
    type("ratio.0", "64");
    part<QCheckBox>("wheel.15:tail").setChecked(false);
    settle();
    QVERIFY(choices().rowCount() > 1);
    for (int row = 0; row < choices().rowCount(); ++row) QCOMPARE(choices().choiceAt(row).found.teeth[0], 24);
    QVERIFY(!part<QCheckBox>("wheel.15:tail").isChecked());
    part<QCheckBox>("wheel.15:tail").setChecked(true);
    settle();
    QVERIFY(choices().choiceAt(0).found.teeth[0] != 24);

    m_document->apply(
        {"Pin", [](const Mechanism& before) { return withPinMark(before, before.links[1].id, true); }, 0});
    settle();
    QVERIFY(!part<QCheckBox>("wheel.15:tail").isEnabled());
    for (int row = 0; row < choices().rowCount(); ++row) QCOMPARE(choices().choiceAt(row).found.teeth[0], 24);
  }

  void twoRatiosHaveToBeMetTogether() {
    limit();
    type("ratio.0", "64");
    QTest::mouseClick(&part<QToolButton>("addRatio"), Qt::LeftButton);
    auto& condition = part<QComboBox>("condition.1");
    condition.setCurrentIndex(condition.findText("with links held:"));
    emit condition.activated(condition.currentIndex());
    auto& driven = part<QComboBox>("driven.1");
    driven.setCurrentIndex(driven.findText("4 carrier"));
    emit driven.activated(driven.currentIndex());
    type("held.1", "2");
    QCOMPARE(choices().rowCount(), 0);  // it has no number yet
    QCOMPARE(part<QLabel>("now.1").text(), QStringLiteral("now 9/2"));
    type("tolerance.1", "0");
    type("ratio.1", "6");
    QVERIFY(choices().rowCount() > 0);
    for (int row = 0; row < choices().rowCount(); ++row)
      QCOMPARE(choices().choiceAt(row).found.ratios[1], Rational(6));
    QTest::mouseClick(&part<QToolButton>("removeRatio.1"), Qt::LeftButton);
    settle();
    QCOMPARE(choices().rowCount(), 12);
  }

  void theCertificateHolds() {
    QVERIFY(!m_panel->mayCertify());
    limit();
    type("ratio.0", "64");
    QVERIFY(m_panel->mayCertify());
    QTemporaryDir folder;
    const QString path = folder.filePath("teeth.json");
    m_panel->saveCertificate(path);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto verdict = checkTeeth(file.readAll().toStdString());
    QVERIFY(verdict && verdict->holds());
    QCOMPARE(verdict->tried, std::int64_t{38'997});
    QCOMPARE(verdict->within, std::int64_t{12});
    QString why;
    connect(m_panel.get(), &TeethPanel::rejected, this, [&why](const QString& text) { why = text; });
    m_panel->saveCertificate(folder.filePath("missing/teeth.json"));
    QVERIFY(!why.isEmpty());
    type("leastEfficiency", "0.6");
    m_panel->saveCertificate(path);
    QVERIFY2(why.contains("least efficiency"), qPrintable(why));
  }

  /// Choices of an earlier train are not taken.
  /// 67.5 is the ratio with 27 and 81 teeth instead of the drawn 26 and 80, which give 50.
  void teethThatWereMeant() {
    QVERIFY(!part<QSpinBox>("meantBy").isVisible());
    part<QCheckBox>("meantTeeth").click();
    QVERIFY(part<QSpinBox>("meantBy").isVisible());
    QVERIFY(!part<QSpinBox>("mostTeeth").isEnabled());
    part<QSpinBox>("meantWheels").setValue(2);
    type("ratio.0", "67.5");
    QVERIFY2(m_panel->badge().endsWith("choices near the drawn teeth tried: complete"),
             qPrintable(m_panel->badge()));
    QCOMPARE(m_panel->funnel().section('\n', 0, 0),
             QStringLiteral("Ratio 1 of the drawn teeth: 50, not the stated one"));
    QVERIFY(m_panel->funnel().contains("Wheels that differ: 2"));
    QStringList wheels;
    for (int column = 0; column < choices().columnCount(); ++column)
      if (choices().columnAt(column).kind == ChoicesModel::Kind::wheel)
        wheels << choices().index(0, column).data().toString();
    QCOMPARE(wheels, (QStringList{"24", "30", "84", "26 → 27", "80 → 81"}));
    QCOMPARE(cell(0, ChoicesModel::Kind::ratio), QStringLiteral("135/2"));
    QVERIFY(!m_panel->mayCertify());  // others may be farther from the drawn ones
    m_panel->take(0);
    settle();
    QCOMPARE(m_document->mechanism()->gearMeshes[2].headTeeth, 81);
    QVERIFY2(m_panel->funnel().endsWith("135/2, as stated"), qPrintable(m_panel->funnel()));

    type("ratio.0", "1000");
    QCOMPARE(choices().rowCount(), 0);
    QVERIFY(m_panel->funnel().endsWith("135/2, not the stated one"));
    part<QCheckBox>("meantTeeth").click();
    settle();
    QVERIFY(part<QSpinBox>("mostTeeth").isEnabled());
    QVERIFY(m_panel->badge().contains("choices tried"));
  }

  void choicesOfAnotherTrainAreNotTaken() {
    limit();
    type("ratio.0", "64");
    m_document->apply(
        {"Pin", [](const Mechanism& before) { return withPinMark(before, before.links[1].id, true); }, 0});
    m_panel->take(0);
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(ringTeeth(), 84);
    settle();
  }

  /// The wish begins anew, with the state of the other document.
  void anotherDocumentForgetsTheWish() {
    m_document->replace(test::example("robot"), {});
    settle();
    QCOMPARE(part<QComboBox>("condition.0").count(), 2);
    m_document->replace(twoRingReducer(), {});
    QTRY_COMPARE(m_panel->findChildren<QComboBox*>("condition.0").size(), 1);
    settle();
    QCOMPARE(part<QComboBox>("condition.0").currentText(), QStringLiteral("in state 1"));
    QCOMPARE(part<QLabel>("now.0").text(), QStringLiteral("now 50"));
  }

  void nothingIsSearchedOutOfSight() {
    m_panel->setAwake(false);
    m_document->replace(test::example("robot"), {});
    QVERIFY(m_panel->isSettled());
    QVERIFY(part<QLineEdit>("ratio.0").text().isEmpty());
    m_document->replace(emptyMechanism(), {});
    QVERIFY(!m_panel->emptyText().isEmpty());
    m_panel->setAwake(true);
    QVERIFY(m_panel->isSettled());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::TeethPanelTest)

#include "test_teeth_panel.moc"
