#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>

#include "core/foundations/files/file.h"
#include "core/presentation/typeset/tex_reader.h"
#include "core/teaching/grading/wrong_answers.h"
#include "core/teaching/lessons/course.h"
#include "core/teaching/lessons/lesson_checker.h"
#include "core/teaching/lessons/mastery.h"
#include "tests/ui/mainwindow/file_windows.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/tt_graph_view.h"
#include "ui/learning/answer_form.h"
#include "ui/learning/course_dialog.h"
#include "ui/learning/exercises_dialog.h"
#include "ui/learning/lesson_panel.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/window_actions.h"
#include "ui/settings/settings.h"

namespace geargraph {

using State = LessonPanel::State;

/// A learner works on lessons in the real window; an author previews one.
class WindowLessonsTest : public QObject, private test::FileWindows {
  Q_OBJECT

  [[nodiscard]] LessonPanel& panel() const { return *last().lesson(); }
  template <class Widget>
  Widget* part(const char* name) const {
    return panel().findChild<Widget*>(QLatin1String(name));
  }
  static std::size_t positionOf(const std::string& id) {
    for (std::size_t i = 0; i < course().size(); ++i) {
      if (course()[i].id == id) return i;
    }
    qFatal("no such lesson");
  }
  /// A window with a document of the learner's, and the lesson beside it at this step.
  void play(const std::string& id, int step = 0) {
    if (set->windows().empty()) set->openNew();
    emit first().lessonWanted(std::make_shared<const Lesson>(course()[positionOf(id)]), "Lesson", QString());
    QCOMPARE(set->windows().size(), std::size_t{2});
    panel().goTo(step);
    QTRY_COMPARE(panel().state(), State::open);
  }
  void press(const char* button) const { QTest::mouseClick(part<QPushButton>(button), Qt::LeftButton); }
  void answerWith(const std::vector<std::string>& answer) const {
    panel().form().setAnswer(answer);
    press("lessonCheck");
  }
  [[nodiscard]] const LessonStep& step() const {
    return panel().lesson()->steps[static_cast<std::size_t>(panel().step())];
  }
  /// An answer in which a mistake is made that the task knows.
  static std::vector<std::string> mistakenAnswer(const LessonStep& step, const Question& question) {
    if (const auto* task = std::get_if<AnswerTask>(&step.task))
      return exampleOf(task->mistakes.front(), question);
    for (const Mistake& mistake : question.mistakes) {
      if (auto answer = wrongAnswer(question, mistake)) return *std::move(answer);
    }
    qFatal("no mistake of \"%s\" can be made", step.title.c_str());
  }
  void draw(const LessonDocument& drawing) const {
    const auto mechanism = mechanismOf(drawing, bundledExample, {});
    QVERIFY(mechanism.has_value());
    last().document().apply({QStringLiteral("Draw"),
                             [mechanism](const Mechanism&) -> Expected<Mechanism> { return **mechanism; },
                             0});
    press("lessonCheck");
  }
  static std::string saved(const QString& path, std::string text, const std::string& from,
                           const std::string& to) {
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    if (writeFile(QFile::encodeName(path).toStdString(), text)) qFatal("not written");
    return text;
  }

 private slots:
  void initTestCase() { setUpWindows(); }
  void init() { makeFolder(); }
  void cleanup() { set.reset(); }

  void theCourseIsChosenFromAndKeepsProgress() {
    set->openNew();
    addLink(first());
    const MechanismPtr own = first().document().mechanism();
    first().actions()[CommandId::lessons]->trigger();
    auto* dialog = first().findChild<CourseDialog*>();
    QVERIFY(dialog != nullptr && dialog->isVisible());
    QCOMPARE(dialog->list().model()->rowCount(), static_cast<int>(course().size()));
    QTest::keyClick(&dialog->list(), Qt::Key_Return);
    QTRY_COMPARE(set->windows().size(), std::size_t{2});
    QTRY_COMPARE(panel().state(), State::open);
    QVERIFY(!dialog->isVisible());
    QCOMPARE(part<QLabel>("lessonTitle")->text(), QString("One gear pair"));
    answerWith({"2/3"});
    QCOMPARE(panel().state(), State::right);
    QCOMPARE(first().document().mechanism(), own);
    QVERIFY(first().document().isModified());
    last().document().apply({QStringLiteral("Add"),
                             [](const Mechanism& m) {
                               return withLink(m, CanvasPoint{10, 10});
                             },
                             0});
    last().close();  // asks nothing, and leaves no side file
    QTRY_COMPARE(set->windows().size(), std::size_t{1});
    QCOMPARE(progressOf(course().front()).score(), 2);
    dialog->renew();
    QVERIFY(dialog->list().model()->index(0, 0).data(Qt::DisplayRole).toString().contains("gear pair"));
    QCOMPARE(dialog->findChild<QPushButton*>("courseStart")->text(), QString("Continue"));
  }

  void wrongAnswersAreExplainedAndCorrected() {
    play("gear-pair");
    auto* field = part<QLineEdit>("answer.turns of gear 2");
    QCOMPARE(QApplication::focusWidget(), field);
    QTest::keyClicks(field, "3/2");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(panel().state(), State::wrong);
    QVERIFY2(panel().resultText().contains("upside down"), qPrintable(panel().resultText()));
    QCOMPARE(part<QPushButton>("lessonCheck")->text(), QString("Try again"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(panel().state(), State::open);
    QTest::keyClicks(field, "0.667");  // selected, so it is replaced; a decimal of three digits will do
    QVERIFY(panel().resultText().isEmpty());  // it was said of another answer
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(panel().state(), State::right);
    QCOMPARE(panel().progress().score(), 1);
    QTest::keyClick(part<QPushButton>("lessonCheck"), Qt::Key_Return);
    QTRY_COMPARE(panel().step(), 1);
  }

  void whatIsBlankOrUnreadableStaysOpenAndCostsNothing() {
    play("gear-pair");
    press("lessonCheck");
    QCOMPARE(panel().state(), State::open);
    QVERIFY2(panel().resultText().contains("not answered"), qPrintable(panel().resultText()));
    answerWith({"2/3 rpm"});
    QCOMPARE(panel().state(), State::open);
    QVERIFY2(panel().resultText().contains("rpm"), qPrintable(panel().resultText()));
    answerWith({"66.7%"});
    QCOMPARE(panel().state(), State::right);
    QCOMPARE(panel().progress().score(), 2);
  }

  void aChoiceIsMadeAndCheckedByKeys() {
    play("links-and-joints");
    auto* choice = part<QRadioButton>("choice.0");
    QTest::keyClick(choice, Qt::Key_Space);
    QVERIFY(choice->isChecked());
    QTest::keyClick(choice, Qt::Key_Return);
    QCOMPARE(panel().state(), State::right);
  }

  /// What is said of an answer stands below the form: that is as high as its fields, if there is room.
  void theFormIsAsHighAsItsFields() {
    play("gear-pair");
    for (const char* lesson : {"links-and-joints", "digraph-and-incidence", "gear-pair"}) {
      panel().play(std::make_shared<const Lesson>(course()[positionOf(lesson)]), QString());
      panel().goTo(lesson == std::string("digraph-and-incidence") ? 1 : 0);
      QTRY_COMPARE(panel().state(), State::open);
      auto* form = part<QScrollArea>("lessonForm");
      const auto* check = part<QPushButton>("lessonCheck");
      if (lesson != std::string("digraph-and-incidence"))
        QTRY_COMPARE(form->verticalScrollBar()->maximum(), 0);
      QCOMPARE(check->visibleRegion().boundingRect(), check->rect());
    }
  }

  void hintsAndShowingCostPoints() {
    play("gear-pair");
    press("lessonHint");
    QVERIFY(part<QLabel>("lessonHints")->text().startsWith("1. "));
    press("lessonHint");
    QVERIFY(!part<QPushButton>("lessonHint")->isEnabled());
    answerWith({"2/3"});
    QCOMPARE(panel().progress().score(), 1);
    panel().next();
    QTRY_COMPARE(panel().state(), State::open);
    press("lessonShow");
    QCOMPARE(panel().state(), State::shown);
    QCOMPARE(panel().form().answer(), std::vector<std::string>{"-2/3"});
    QCOMPARE(panel().progress().points[1], 0);
  }

  void viewsThatHoldTheAnswerAreClosedUntilItIsRight() {
    play("cycle-basis", 2);
    auto* matrices = last().findChild<QDockWidget*>("dock.matrices");
    auto* action = last().findChild<QAction*>("dock.matrices");
    QVERIFY(matrices->isHidden() && !action->isEnabled());
    QVERIFY(action->toolTip().contains("holds the answer"));
    QVERIFY(last().findChild<QToolButton*>("chip.rank")->isHidden());
    QVERIFY(last().selection().isSelected(MeshId("17")));
    const auto* digraph = last().findChild<DigraphView*>();
    QVERIFY2(digraph->caption().isEmpty(), qPrintable(digraph->caption().join('\n')));
    std::vector<std::string> answer = panel().form().answer();
    for (const int along : {3, 4, 9}) answer[static_cast<std::size_t>(along)] = "1";
    answer[5] = "-1";
    answerWith(answer);
    QCOMPARE(panel().state(), State::wrong);
    QVERIFY(last().selection().isSelected(JointId("12")));
    QVERIFY2(panel().resultText().contains("against the arrow of joint 12"),
             qPrintable(panel().resultText()));
    answer[4] = "-1";
    press("lessonCheck");
    answerWith(answer);
    QCOMPARE(panel().state(), State::right);
    QVERIFY(action->isEnabled());
    QVERIFY(!last().findChild<QToolButton*>("chip.rank")->isHidden());
    action->trigger();
    QVERIFY(!matrices->isHidden());
    panel().next();
    QVERIFY(matrices->isHidden());
  }

  /// Steps that share a mechanism: the drawing stays, and what was edited is put right.
  void theNextStepBeginsWithItsMechanism() {
    play("tt-graph", 3);
    QTRY_VERIFY(last().isSettled());
    last().document().apply({QStringLiteral("Add"),
                             [](const Mechanism& m) {
                               return withLink(m, CanvasPoint{10, 10});
                             },
                             0});
    panel().next();
    QTRY_COMPARE(panel().state(), State::open);
    QCOMPARE(last().document().mechanism()->n(), 7);
    QTRY_VERIFY(last().isSettled());
    QCOMPARE(last().drawing().objectName(), QString("schematic"));
    last().showDrawing(QStringLiteral("ttgraph"));
    QVERIFY(last().ttGraph().displayList().marks.size() > 20);
    panel().back();
    QTRY_COMPARE(panel().state(), State::open);
    QTRY_VERIFY(last().isSettled());
    QVERIFY(last().ttGraph().displayList().marks.size() > 20);
  }

  void elementsArePickedInTheDrawing() {
    play("paths-trees-cycles", 1);
    last().selection().select({JointId("14"), JointId("10"), LinkId("3")});
    QCOMPARE(panel().form().answer(), std::vector<std::string>{"10, 14"});
    press("lessonCheck");
    QCOMPARE(panel().state(), State::wrong);
    last().selection().toggle(JointId("12"));
    press("lessonCheck");
    QCOMPARE(panel().state(), State::right);
  }

  /// Every task of every lesson with its mistakes and a right answer.
  void everyLessonIsFinished_data() {
    QTest::addColumn<int>("lesson");
    for (std::size_t i = 0; i < course().size(); ++i)
      QTest::newRow(course()[i].id.c_str()) << static_cast<int>(i);
  }
  void everyLessonIsFinished() {
    QFETCH(int, lesson);
    const Lesson& played = course()[static_cast<std::size_t>(lesson)];
    play(played.id);
    for (std::size_t i = 0; i < played.steps.size(); ++i) {
      QTRY_COMPARE(panel().state(), State::open);
      QCOMPARE(panel().step(), static_cast<int>(i));
      if (const auto* drawing = std::get_if<DrawTask>(&step().task)) {
        draw(drawing->mistakes.front().drawing);
        QTRY_COMPARE_WITH_TIMEOUT(panel().state(), State::wrong, 20'000);
        draw(drawing->solution);
        QTRY_COMPARE_WITH_TIMEOUT(panel().state(), State::right, 20'000);
      } else {
        const auto prepared = prepareStep(played, i, bundledExample);
        const Question& question = *prepared->question;
        answerWith(mistakenAnswer(step(), question));
        QCOMPARE(panel().state(), State::wrong);
        QVERIFY(panel().resultText().size() > 10);
        press("lessonCheck");
        answerWith(question.solution);
        QVERIFY2(panel().state() == State::right, qPrintable(panel().resultText()));
      }
      if (i + 1 < played.steps.size()) press("lessonCheck");
    }
    QVERIFY(panel().progress().isComplete());
  }

  /// Three that are right at the first check master a lesson; one that is not brings another one.
  void aLessonEndsWithFreshQuestions() {
    play("gear-pair", 3);
    QTRY_COMPARE(panel().state(), State::open);
    draw(std::get<DrawTask>(step().task).solution);
    QTRY_COMPARE_WITH_TIMEOUT(panel().state(), State::right, 20'000);
    QCOMPARE(part<QPushButton>("lessonCheck")->text(), QString("Fresh questions"));
    QVERIFY(!panel().isFresh());
    const std::size_t own = panel().playedLesson()->steps.size();
    press("lessonCheck");
    for (int i = 0; i < kFreshQuestions + 1; ++i) {
      QTRY_COMPARE(panel().state(), State::open);
      QVERIFY(panel().isFresh());
      QCOMPARE(panel().step(), static_cast<int>(own) + i);
      const auto prepared = prepareStep(*panel().lesson(), own + static_cast<std::size_t>(i), bundledExample);
      if (i == 1) {
        answerWith(mistakenAnswer(step(), *prepared->question));
        QCOMPARE(panel().state(), State::wrong);
        press("lessonCheck");
      }
      QVERIFY(!masteryOf(*panel().playedLesson()).isMastered());
      answerWith(prepared->question->solution);
      QVERIFY2(panel().state() == State::right, qPrintable(panel().resultText()));
      if (i < kFreshQuestions) press("lessonCheck");
    }
    QVERIFY2(panel().resultText().contains("You have mastered this lesson."),
             qPrintable(panel().resultText()));
    QCOMPARE(part<QPushButton>("lessonCheck")->text(), QString("Finish"));
    const Lesson& lesson = course().front();
    QCOMPARE(masteryOf(lesson).on, QDate::currentDate());
    QCOMPARE(progressOf(lesson).points.size(), lesson.steps.size());
    press("lessonCheck");
    QTRY_COMPARE(panel().lesson()->id, course()[1].id);
  }

  /// Reviews come after 1, 3, 7 days and so on; one before its day moves nothing.
  void lessonsComeBackForReview() {
    const Lesson& lesson = course()[2];
    QCOMPARE(reviewStateOf(lesson, QDate(2030, 5, 1)), ReviewState::none);  // its own steps are not done
    LessonProgress progress = progressOf(lesson);
    progress.points.assign(lesson.steps.size(), kStepPoints);
    saveProgress(lesson, progress);
    QCOMPARE(reviewStateOf(lesson, QDate(2030, 5, 1)), ReviewState::freshLeft);
    saveMastered(lesson, QDate(2030, 5, 1));
    QCOMPARE(masteryOf(lesson).due(), QDate(2030, 5, 2));
    QCOMPARE(reviewStateOf(lesson, QDate(2030, 5, 1)), ReviewState::none);
    QCOMPARE(reviewStateOf(lesson, QDate(2030, 5, 2)), ReviewState::due);
    saveMastered(lesson, QDate(2030, 5, 1));
    QCOMPARE(masteryOf(lesson).due(), QDate(2030, 5, 2));
    saveMastered(lesson, QDate(2030, 5, 4));
    QCOMPARE(masteryOf(lesson).due(), QDate(2030, 5, 7));
    saveMastered(lesson, QDate(2030, 6, 1));
    QCOMPARE(masteryOf(lesson).due(), QDate(2030, 6, 8));
    // The course offers a review of what is due: it begins with the fresh questions.
    saveSetting(QStringLiteral("lessons/%1/mastered").arg(QString::fromStdString(lesson.id)),
                QStringLiteral("2020-01-01"));
    set->openNew();
    first().actions()[CommandId::lessons]->trigger();
    auto* dialog = first().findChild<CourseDialog*>();
    dialog->list().setCurrentIndex(dialog->list().model()->index(2, 0));
    QCOMPARE(dialog->findChild<QPushButton*>("courseStart")->text(), QString("Review"));
    dialog->findChild<QPushButton*>("courseStart")->click();
    QTRY_COMPARE(set->windows().size(), std::size_t{2});
    QTRY_COMPARE(panel().state(), State::open);
    QVERIFY(panel().isFresh());
  }

  /// It ends with the second question that is not right at once, and the course begins with the first.
  void theStartTestTellsWhereToBegin() {
    set->openNew();
    first().actions()[CommandId::lessons]->trigger();
    first().findChild<QPushButton*>("courseTest")->click();
    QTRY_COMPARE(set->windows().size(), std::size_t{2});
    for (int i = 0; i < 4; ++i) {
      QTRY_COMPARE(panel().state(), State::open);
      QCOMPARE(panel().step(), i);
      const auto prepared = prepareStep(*panel().lesson(), static_cast<std::size_t>(i), bundledExample);
      if (i == 0 || i == 2) {
        answerWith(prepared->question->solution);
        QCOMPARE(panel().state(), State::right);
      } else {
        press("lessonShow");
        QCOMPARE(panel().state(), State::shown);
      }
      press("lessonCheck");
    }
    auto* dialog = last().findChild<CourseDialog*>();
    QVERIFY(dialog != nullptr && dialog->isVisible());
    QCOMPARE(dialog->list().currentIndex().row(), 1);
    QCOMPARE(lessonToBeginWith(course()), std::optional<std::size_t>(1));
  }

  /// Questions about the learner's own document, in a window of their own.
  void theOwnMechanismIsPractised() {
    set->openNew();
    first().document().replace(**bundledExample("robot"), {});
    first().actions()[CommandId::exercises]->trigger();
    auto* dialog = first().findChild<ExercisesDialog*>();
    QVERIFY(dialog != nullptr && dialog->isVisible());
    QTRY_VERIFY(dialog->isUpToDate() && dialog->findChild<QPushButton*>("exercisePractise")->isEnabled());
    QTest::mouseClick(dialog->findChild<QPushButton*>("exercisePractise"), Qt::LeftButton);
    QTRY_COMPARE(set->windows().size(), std::size_t{2});
    QVERIFY(!dialog->isVisible());
    QTRY_COMPARE(panel().state(), State::open);
    QVERIFY(panel().isPractice());
    const auto steps = panel().lesson()->steps.size();
    QVERIFY(steps > 14);
    press("lessonHint");
    for (std::size_t i = 0; i < steps; ++i) {
      QTRY_COMPARE(panel().state(), State::open);
      const Question& question = std::get<QuestionTask>(step().task).question;
      answerWith(mistakenAnswer(step(), question));
      QCOMPARE(panel().state(), State::wrong);
      press("lessonCheck");
      answerWith(question.solution);
      QVERIFY2(panel().state() == State::right, qPrintable(panel().resultText()));
      if (i + 1 < steps) press("lessonCheck");
    }
    QVERIFY(panel().progress().isComplete());
    press("lessonCheck");  // Finish
    auto* again = last().findChild<ExercisesDialog*>();
    QVERIFY(again != nullptr && again->isVisible());
    QTRY_VERIFY(again->isUpToDate());
  }

  void everyFormulaCanBeSet() {
    const auto check = [](const std::string& tex) { QVERIFY2(readTex(tex).fault.empty(), tex.c_str()); };
    for (const Lesson& lesson : course()) {
      for (const LessonStep& each : lesson.steps) {
        if (!each.formula.empty()) check(each.formula);
      }
    }
  }

  void aPreviewFollowsItsFile() {
    set->openNew();
    const QString path = pathOf("mine.json");
    QFile bundled(QStringLiteral(GEARGRAPH_LESSONS "/01-gear-pair.json"));
    QVERIFY(bundled.open(QIODevice::ReadOnly));
    std::string text = saved(path, bundled.readAll().toStdString(), {}, {});
    first().openLessonFile(path);
    QTRY_COMPARE(set->windows().size(), std::size_t{2});
    QTRY_COMPARE(panel().state(), State::open);
    panel().goTo(1);
    QTRY_COMPARE(panel().state(), State::open);
    text = saved(path, text, "One gear pair", "My own pair");
    QTRY_COMPARE(part<QLabel>("lessonTitle")->text(), QString("My own pair"));
    QTRY_COMPARE(panel().state(), State::open);
    QCOMPARE(panel().step(), 1);
    saved(path, text, "\"goal\"", "\"gaol\"");
    QTRY_VERIFY2(panel().resultText().contains("mine.json, line 7:"), qPrintable(panel().resultText()));
    QVERIFY(panel().resultText().contains("\"gaol\" is not known here"));
    first().openLessonFile(path);
    QVERIFY(first().statusLine().text().contains("mine.json, line 7:"));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowLessonsTest)
#include "test_window_lessons.moc"
