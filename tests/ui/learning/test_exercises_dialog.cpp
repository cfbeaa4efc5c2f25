#include <QCheckBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "core/teaching/lessons/practice.h"
#include "tests/core/support/deep_train.h"
#include "tests/core/support/example_files.h"
#include "ui/learning/exercises_dialog.h"

namespace geargraph {

/// A learner chooses what to practise, a teacher what a class is asked.
class ExercisesDialogTest : public QObject {
  Q_OBJECT

  std::unique_ptr<ExercisesDialog> m_dialog;

  template <class Widget>
  Widget& part(const char* name) const {
    auto* found = m_dialog->findChild<Widget*>(QLatin1String(name));
    if (found == nullptr) qFatal("no %s", name);
    return *found;
  }
  [[nodiscard]] QListWidgetItem& row(ExerciseKind kind) const {
    return *m_dialog->kinds().item(static_cast<int>(kind));
  }
  void setExample(const char* name) const {
    m_dialog->setMechanism(std::make_shared<const Mechanism>(test::example(name)));
    QTRY_VERIFY(m_dialog->isUpToDate());
  }

 private slots:
  void initTestCase() { qRegisterMetaType<LessonPtr>(); }
  void init() {
    m_dialog = std::make_unique<ExercisesDialog>();
    m_dialog->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_dialog.get()));
    setExample("robot");
  }
  void cleanup() { m_dialog.reset(); }

  void whatCannotBeAskedSaysWhy() {
    const ExerciseSource source(test::example("robot"));
    QCOMPARE(m_dialog->kinds().count(), static_cast<int>(allExerciseKinds().size()));
    for (const ExerciseKind kind : allExerciseKinds()) {
      const auto reason = reasonAgainst(source, kind);
      const QListWidgetItem& item = row(kind);
      QCOMPARE(item.checkState() == Qt::Checked, !reason);
      QCOMPARE((item.flags() & Qt::ItemIsEnabled) != 0, !reason);
      if (reason) QVERIFY2(item.text().contains(QString::fromStdString(*reason)), qPrintable(item.text()));
    }
    QVERIFY(reasonAgainst(source, ExerciseKind::engagement));
    QVERIFY(part<QLabel>("exerciseDifficulty").text().contains("4 cycles"));
  }

  void theQuestionsAreThoseOfTheSheetWithThisSeed() {
    for (const ExerciseKind kind : allExerciseKinds()) {
      if (kind != ExerciseKind::cycle && (row(kind).flags() & Qt::ItemIsUserCheckable) != 0)
        row(kind).setCheckState(Qt::Unchecked);
    }
    part<QSpinBox>("exerciseEach").setValue(3);
    part<QSpinBox>("exerciseSeed").setValue(7);
    const SheetPlan plan = m_dialog->plan();
    QCOMPARE(plan.kinds, std::vector<ExerciseKind>(3, ExerciseKind::cycle));
    QSignalSpy wanted(m_dialog.get(), &ExercisesDialog::practiceWanted);
    QTest::mouseClick(&part<QPushButton>("exercisePractise"), Qt::LeftButton);
    QTRY_COMPARE(wanted.count(), qsizetype{1});
    const auto lesson = wanted[0][0].value<LessonPtr>();
    const SheetVariant sheet = makeVariant(ExerciseSource(test::example("robot")), plan, 1);
    QCOMPARE(lesson->steps.size(), std::size_t{3});
    for (std::size_t i = 0; i < 3; ++i) {
      QCOMPARE(std::get<QuestionTask>(lesson->steps[i].task).question, sheet.questions[i]);
      QCOMPARE(lesson->steps[i].hints.size(), std::size_t{1});
    }
    QTest::qWait(50);
    QCOMPARE(wanted.count(), qsizetype{1});
  }

  /// A requested kind stays while the mechanism does not give the kind.
  void theChoiceOutlivesAnotherMechanism() {
    row(ExerciseKind::freedom).setCheckState(Qt::Unchecked);
    setExample("eight-speed-gearbox");
    QVERIFY(row(ExerciseKind::engagement).checkState() == Qt::Checked);
    QVERIFY(row(ExerciseKind::freedom).checkState() == Qt::Unchecked);
    setExample("robot");
    QVERIFY(row(ExerciseKind::engagement).checkState() == Qt::Unchecked);
    setExample("eight-speed-gearbox");
    QVERIFY(row(ExerciseKind::engagement).checkState() == Qt::Checked);
  }

  void whatCannotBeDoneSaysWhy() {
    auto& practise = part<QPushButton>("exercisePractise");
    auto& sheets = part<QPushButton>("exerciseSheets");
    auto& handout = part<QPushButton>("exerciseHandout");
    QVERIFY(practise.isEnabled() && sheets.isEnabled() && handout.isEnabled());
    part<QSpinBox>("exerciseEach").setValue(5);
    QVERIFY(!practise.isEnabled() && practise.toolTip().contains("40"));
    part<QSpinBox>("exerciseEach").setValue(1);
    for (auto* form : m_dialog->findChildren<QCheckBox*>()) form->setChecked(false);
    QVERIFY(!sheets.isEnabled() && sheets.toolTip().contains("form") && handout.isEnabled());
    m_dialog->setMechanism(std::make_shared<const Mechanism>(test::deepTrain(1, 70)));
    QVERIFY(!practise.isEnabled() && !handout.isEnabled());
    QVERIFY(part<QLabel>("exerciseDifficulty").text().contains("60"));
    setExample("robot");
    QVERIFY(practise.isEnabled());
    m_dialog->setMechanism(std::make_shared<const Mechanism>(emptyMechanism()));
    QTRY_VERIFY(m_dialog->isUpToDate());
    QVERIFY(!practise.isEnabled() && practise.toolTip().contains("kind"));
  }

  /// Until its own kinds are known nothing is asked of another mechanism.
  void kindsOfTheFormerMechanismAreNotAsked() {
    m_dialog->setMechanism(std::make_shared<const Mechanism>(test::example("spur-pair")));
    auto& practise = part<QPushButton>("exercisePractise");
    QVERIFY(!practise.isEnabled() && !practise.toolTip().isEmpty());
    QVERIFY(!part<QPushButton>("exerciseSheets").isEnabled());
    QVERIFY(!part<QPushButton>("exerciseHandout").isEnabled());
    QTRY_VERIFY(practise.isEnabled());
  }

  void sheetsAreWantedInTheFormsThatAreChosen() {
    QSignalSpy wanted(m_dialog.get(), &ExercisesDialog::sheetsWanted);
    part<QSpinBox>("exerciseVariants").setValue(30);
    QTest::mouseClick(&part<QPushButton>("exerciseSheets"), Qt::LeftButton);
    QCOMPARE(wanted.count(), qsizetype{1});
    const auto request = wanted[0][0].value<SheetRequest>();
    QCOMPARE(request.plan.variants, 30);
    QCOMPARE(request.plan.kinds, m_dialog->plan().kinds);
    QCOMPARE(request.forms, std::vector{SheetFileForm::pdf});
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::ExercisesDialogTest)
#include "test_exercises_dialog.moc"
