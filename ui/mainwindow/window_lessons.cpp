// Lessons in a window of their own: the course, the lesson beside the drawing, and the preview for authors.
// Exercises about the document, and the check of matrices that the learner has worked out on paper.

#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <array>

#include "core/foundations/files/file.h"
#include "core/teaching/lessons/course.h"
#include "core/teaching/lessons/lesson_reader.h"
#include "core/teaching/lessons/mastery.h"
#include "ui/canvas/drawing_view.h"
#include "ui/help/search_field.h"
#include "ui/learning/course_dialog.h"
#include "ui/learning/exercises_dialog.h"
#include "ui/learning/lesson_panel.h"
#include "ui/learning/work_check_dialog.h"
#include "ui/lever_views/levers_view.h"
#include "ui/mainwindow/file_watch.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/view_docks.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/mainwindow/window_files.h"
#include "ui/panels/problems_panel.h"
#include "ui/panels/properties_panel.h"
#include "ui/view3d/view3d.h"

namespace geargraph {
namespace {

constexpr std::size_t kLargestLesson = std::size_t{4} * 1024 * 1024;
constexpr int kLessonWidth = 352;  ///< px
constexpr int kPictureWidth = 430;
constexpr int kProblemsPart = 6;  ///< of the height of the window, while something is drawn

/// The lesson of a file, or why there is none, with its place.
std::variant<std::shared_ptr<const Lesson>, QString> lessonOf(const QString& path) {
  const auto bytes = readFile(QFile::encodeName(path).toStdString(), kLargestLesson);
  if (const auto* error = std::get_if<FileError>(&bytes)) return QString::fromStdString(error->message);
  auto lesson = readLesson(std::get<std::string>(bytes));
  if (lesson) return std::make_shared<const Lesson>(std::move(lesson).value());
  const Diagnostic& fault = lesson.error().front();
  return MainWindow::tr("%1, line %2: %3")
      .arg(QFileInfo(path).fileName())
      .arg(fault.line)
      .arg(QString::fromStdString(fault.message));
}

QString placeInCourse(std::size_t lesson) {
  return MainWindow::tr("Lesson %1 of %2").arg(lesson + 1).arg(course().size());
}

std::shared_ptr<const Lesson> lessonOfCourse(std::size_t lesson) {
  return std::make_shared<const Lesson>(course()[lesson]);
}

}  // namespace

void MainWindow::showCourse() {
  if (m_course == nullptr) {
    m_course = new CourseDialog(this);
    connect(m_course, &CourseDialog::lessonChosen, this, [this](int lesson) {
      const auto position = static_cast<std::size_t>(lesson);
      Lesson wanted = course()[position];
      wanted.isReview = reviewStateOf(wanted, QDate::currentDate()) != ReviewState::none;
      wantLesson(std::make_shared<const Lesson>(std::move(wanted)), placeInCourse(position), QString());
    });
    connect(m_course, &CourseDialog::testWanted, this, [this] {
      wantLesson(std::make_shared<const Lesson>(startTest(course(), randomSeed()).lesson), tr("Start test"),
                 QString());
    });
    connect(m_course, &CourseDialog::fileWanted, this, &MainWindow::chooseLessonFile);
  } else {
    m_course->renew();
  }
  m_course->show();
  m_course->raise();
  m_course->activateWindow();
}

void MainWindow::showExercises() {
  if (m_exercises == nullptr) {
    m_exercises = new ExercisesDialog(this);
    connect(m_document, &Document::changed, m_exercises, [this] {
      if (m_exercises->isVisible()) m_exercises->setMechanism(m_document->mechanism());
    });
    connect(m_exercises, &ExercisesDialog::practiceWanted, this, [this](const LessonPtr& lesson) {
      m_exercises->hide();
      wantLesson(lesson, QString(), QString());
    });
    connect(m_exercises, &ExercisesDialog::sheetsWanted, m_exports, &WindowExports::chooseAndExportSheets);
    connect(m_exercises, &ExercisesDialog::handoutWanted, m_exports,
            &WindowExports::chooseAndExportHandoutAsking);
  }
  m_exercises->show();
  m_exercises->setMechanism(m_document->mechanism());
  m_exercises->raise();
  m_exercises->activateWindow();
}

void MainWindow::showPaperCheck() {
  if (m_paperCheck == nullptr) {
    m_paperCheck = new WorkCheckDialog(m_selection, this);
    const auto renew = [this] {
      if (m_paperCheck->isVisible()) m_paperCheck->setMechanism(m_document->mechanism());
    };
    connect(m_document, &Document::changed, m_paperCheck, renew);
  }
  m_paperCheck->show();
  m_paperCheck->setMechanism(m_document->mechanism());
  m_paperCheck->raise();
  m_paperCheck->activateWindow();
}

void MainWindow::chooseLessonFile() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open a lesson file"), {}, tr("Lessons (*.json)"));
  if (!path.isEmpty()) openLessonFile(path);
}

void MainWindow::openLessonFile(const QString& path) {
  const auto lesson = lessonOf(path);
  if (const QString* fault = std::get_if<QString>(&lesson)) return m_status->showRejection(*fault);
  wantLesson(std::get<0>(lesson), tr("Preview"), path);
}

/// A window that plays a lesson goes on with the next one; any other keeps its document.
void MainWindow::wantLesson(const std::shared_ptr<const Lesson>& lesson, const QString& place,
                            const QString& file) {
  if (m_lesson != nullptr) return playLesson(lesson, place, file);
  emit lessonWanted(lesson, place, file);
}

void MainWindow::playLesson(const std::shared_ptr<const Lesson>& lesson, const QString& place,
                            const QString& file) {
  if (m_lesson == nullptr) makeLesson();
  m_files->makeTransient(QString::fromStdString(lesson->title));
  m_lessonWatch->watch(file);
  m_lessonFile = file;
  m_lesson->play(lesson, place);
  updateTitle();
}

void MainWindow::makeLesson() {
  const ViewEntry entry = lessonView();
  QDockWidget* const lesson = m_docks->add(entry, m_views->make(entry, this));
  m_lesson = &m_views->get<LessonPanel>();
  lesson->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  m_docks->showOnly({m_lesson, &view3d()});
  (*m_actions)[CommandId::captions]->setChecked(true);  // names help who learns
  updateOffer();
  resizeDocks({lesson, m_docks->of(view3d())}, {kLessonWidth, kPictureWidth}, Qt::Horizontal);
  m_lessonWatch = new FileWatch(this);
  connect(m_lessonWatch, &FileWatch::changed, this, [this] {
    m_lessonWatch->accept();
    const auto now = lessonOf(m_lessonFile);
    if (const QString* fault = std::get_if<QString>(&now)) return m_lesson->showFault(*fault);
    m_lesson->reload(std::get<0>(now));
  });
  connect(m_lesson, &LessonPanel::courseWanted, this,
          [this] { m_lesson->isPractice() ? showExercises() : showCourse(); });
  connect(m_lesson, &LessonPanel::nextLessonWanted, this, &MainWindow::playNextLesson);
  connect(m_lesson, &LessonPanel::answerOpened, this, &MainWindow::setAnswersOpen);
  connect(m_lesson, &LessonPanel::stepBegan, this, [this](StepView view) {
    constexpr std::array<const char*, 5> kNames = {"digraph", "ttgraph", "schematic", "levers", "levers"};
    const bool readsLevers = view == StepView::levers || view == StepView::nomogram;
    auto& levers = m_views->get<LeversView>();
    levers.setRead(readsLevers);
    if (readsLevers) levers.setPage(view == StepView::levers ? LeversPage::levers : LeversPage::nomogram);
    showDrawing(QLatin1String(kNames[static_cast<std::size_t>(view)]));
    const auto& steps = m_lesson->lesson()->steps;
    const bool draws =
        std::holds_alternative<DrawTask>(steps[static_cast<std::size_t>(m_lesson->step())].task);
    m_docks->showForDrawing(draws);
    if (!draws) return;
    m_docks->of(m_views->get<PropertiesPanel>())->raise();
    resizeDocks({m_docks->of(problems())}, {height() / kProblemsPart}, Qt::Vertical);
  });
}

/// Of the course.
void MainWindow::playLessonNamed(const QString& id) {
  for (std::size_t i = 0; i < course().size(); ++i) {
    if (QString::fromStdString(course()[i].id) == id)
      return wantLesson(lessonOfCourse(i), placeInCourse(i), QString());
  }
}

void MainWindow::playNextLesson() {
  if (m_lesson->isPractice()) return showExercises();
  const auto& lessons = course();
  for (std::size_t next = 1; next < lessons.size(); ++next) {
    if (lessons[next - 1].id == m_lesson->lesson()->id && m_lessonFile.isEmpty())
      return playLesson(lessonOfCourse(next), placeInCourse(next), QString());
  }
  showCourse();
}

/// From its step on: the lesson begins the step anew.
void MainWindow::resumeLesson(const MainWindow& former) {
  const auto& lesson = former.m_lesson->playedLesson();
  const auto& lessons = course();
  const auto found =
      std::find_if(lessons.begin(), lessons.end(), [&](const Lesson& each) { return each.id == lesson->id; });
  const bool isOfCourse = found != lessons.end() && former.m_lessonFile.isEmpty();
  playLesson(lesson,
             former.m_lesson->isStartTest() ? tr("Start test")
             : isOfCourse                   ? placeInCourse(static_cast<std::size_t>(found - lessons.begin()))
             : former.m_lesson->isPractice() ? QString()
                                             : tr("Preview"),
             former.m_lessonFile);
}

/// Views that hold the answer of a step are closed until it is right or shown, and say so.
void MainWindow::setAnswersOpen(bool isOpen) {
  m_docks->setAnswersOpen(isOpen,
                          tr("This panel holds the answer: it opens when the step is right or shown."));
  m_views->setAnswersOpen(isOpen);
  m_status->showCounts(isOpen);
  m_search->setAnswersOpen(isOpen);
  m_areAnswersOpen = isOpen;
  updateCommands();
}

}  // namespace geargraph
