#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include "tests/core/support/example_files.h"
#include "ui/document/selection.h"
#include "ui/learning/work_check_dialog.h"

namespace geargraph {

/// A learner compares what stands on paper with what is derived.
class PaperCheckDialogTest : public QObject {
  Q_OBJECT

  MechanismPtr m_robot = std::make_shared<const Mechanism>(test::example("robot"));
  std::unique_ptr<Selection> m_selection;
  std::unique_ptr<WorkCheckDialog> m_dialog;

  template <class Widget>
  Widget& part(const char* name) const {
    auto* found = m_dialog->findChild<Widget*>(QLatin1String(name));
    if (found == nullptr) qFatal("no %s", name);
    return *found;
  }
  [[nodiscard]] QString verdict() const { return part<QLabel>("paperVerdict").text(); }
  void write(const char* text) const {
    m_dialog->text().setPlainText(QString::fromUtf8(text));
    QTRY_VERIFY(m_dialog->isUpToDate());
  }

 private slots:
  void init() {
    m_selection = std::make_unique<Selection>();
    m_dialog = std::make_unique<WorkCheckDialog>(m_selection.get());
    m_dialog->setMechanism(m_robot);
    m_dialog->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_dialog.get()));
  }
  void cleanup() {
    m_dialog.reset();
    m_selection.reset();
  }

  void theExampleOfThePaperHasTwoRowsOfOtherJoints() {
    QTest::mouseClick(&part<QPushButton>("paperExample"), Qt::LeftButton);
    QTRY_COMPARE(part<QListWidget>("paperDifferences").count(), 2);
    QVERIFY2(verdict().startsWith(QStringLiteral("✗")), qPrintable(verdict()));
    const auto& yours = part<QTableWidget>("paperYours");
    const auto& derived = part<QTableWidget>("paperDerived");
    QCOMPARE(yours.rowCount(), 4);
    QCOMPARE(derived.columnCount(), 3);
    QVERIFY(yours.item(2, 0)->background().style() != Qt::NoBrush);
    QVERIFY(yours.item(0, 0)->background().style() == Qt::NoBrush);
    QVERIFY(yours.item(2, 0)->text() != derived.item(2, 0)->text());
    QVERIFY(!yours.item(2, 0)->font().bold());

    part<QListWidget>("paperDifferences").setCurrentRow(0);
    QVERIFY(yours.item(2, 0)->font().bold() && !yours.item(3, 0)->font().bold());
    QVERIFY(!m_selection->selected().empty());
  }

  void aWrongEntryIsMarkedUntilItIsCorrected() {
    write("T = [8 9; 1 2; 3 4; 5 6]");
    QVERIFY2(!verdict().startsWith(QStringLiteral("✓")), qPrintable(verdict()));
    write("theta10 = theta8");
    QVERIFY2(verdict().startsWith(QStringLiteral("✗")), qPrintable(verdict()));
    QCOMPARE(part<QTableWidget>("paperYours").item(0, 1)->text(), QStringLiteral("wrong"));
    QCOMPARE(part<QListWidget>("paperDifferences").count(), 1);
    part<QListWidget>("paperDifferences").setCurrentRow(0);
    QVERIFY(!m_selection->selected().empty());
    write("theta10 = -i15*theta8\ntheta12 = -i16*i15*theta8 - i16*theta9");
    QVERIFY2(verdict().startsWith(QStringLiteral("✓")), qPrintable(verdict()));
    QCOMPARE(part<QListWidget>("paperDifferences").count(), 0);
  }

  void whereATextCannotBeReadTheLastPictureStays() {
    write("theta10 = -i15*theta8");
    const QString right = verdict();
    write("1 0 0\n1 0\n");
    QVERIFY2(verdict().startsWith(QStringLiteral("Line 2")), qPrintable(verdict()));
    QCOMPARE(m_dialog->text().extraSelections().size(), qsizetype{1});
    QCOMPARE(part<QTableWidget>("paperYours").rowCount(), 1);
    write("theta10 = -i15*theta8");
    QCOMPARE(verdict(), right);
    QVERIFY(m_dialog->text().extraSelections().isEmpty());
    write("  \n");
    QCOMPARE(part<QTableWidget>("paperYours").rowCount(), 0);
  }

  void theVerdictFollowsTheDocument() {
    write("theta10 = -1/2*theta8");
    const QString before = verdict();
    Mechanism other = *m_robot;
    other.gearMeshes[0].pitchPoint.reset();
    other.gearMeshes[0].tailTeeth = 20;
    other.gearMeshes[0].headTeeth = 60;
    m_dialog->setMechanism(std::make_shared<const Mechanism>(std::move(other)));
    QTRY_VERIFY(m_dialog->isUpToDate());
    QVERIFY2(verdict() != before, qPrintable(verdict()));
  }

  void aFileIsReadAndAMissingOneIsTold() {
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("mine.txt")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("theta10 = -i15*theta8\n");
    file.close();
    m_dialog->openFile(file.fileName());
    QTRY_VERIFY(verdict().startsWith(QStringLiteral("✓")));
    m_dialog->openFile(folder.filePath(QStringLiteral("none.txt")));
    QVERIFY2(verdict().contains(QStringLiteral("none.txt")), qPrintable(verdict()));
  }

  void aMatrixThatIsNamedIsComparedWithThatOneOnly() {
    auto& kind = part<QComboBox>("paperKind");
    kind.setCurrentIndex(kind.findData(static_cast<int>(PaperMatrix::path)));
    write("theta10 = -i15*theta8");
    QVERIFY(!verdict().isEmpty());
    kind.setCurrentIndex(kind.findData(static_cast<int>(PaperMatrix::solution)));
    write(
        ",8,9,11\n10,-i15,0,0\n12,-i16 i15,-i16,0\n13,-i17 i16 i15,-i17 i16,-i17\n"
        "14,-i18 i17 i16 i15,-i18 i17 i16,-i18 i17\n");
    QVERIFY2(verdict().startsWith(QStringLiteral("✓")), qPrintable(verdict()));
    kind.setCurrentIndex(kind.findData(static_cast<int>(PaperMatrix::path)));
    QTRY_VERIFY(m_dialog->isUpToDate());
    QVERIFY2(!verdict().startsWith(QStringLiteral("✓")), qPrintable(verdict()));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::PaperCheckDialogTest)
#include "test_paper_check_dialog.moc"
