#pragma once

#include <QWidget>
#include <optional>

#include "ui/document/document.h"
#include "ui/lessons/lesson_progress.h"
#include "ui/lessons/lesson_service.h"
#include "ui/selection/selection.h"

class QLabel;
class QPushButton;
class QScrollArea;
class QToolButton;

namespace geargraph::inline ui_derivation {
class DerivationView;
}  // namespace geargraph::inline ui_derivation

namespace geargraph::inline ui_lessons {

class AnswerForm;
class StepBar;

/// A lesson, played step by step on the document of a window of its own: text, task, answer, hints, the
/// reason when the answer is wrong. Each step begins with its mechanism; what a task means lights up by the
/// shared selection. Progress is kept in the settings.
class LessonPanel : public QWidget {
  Q_OBJECT

 public:
  /// What the learner can do now; Return does the first of it.
  enum class State { loading, open, wrong, right, shown, faulty };

  LessonPanel(Document* document, Selection* selection, QWidget* parent = nullptr);

  /// Plays a lesson from where the learner left it. `place`: "Lesson 4 of 15", or where it comes from.
  void play(const LessonPtr& lesson, const QString& place);
  /// The same lesson as its file is now: at the same step, if there still is one.
  void reload(const LessonPtr& lesson);
  /// A lesson's file cannot be read now: says why, and keeps the lesson.
  void showFault(const QString& fault);
  void goTo(int step);

  [[nodiscard]] const LessonPtr& lesson() const { return m_lesson; }
  /// Questions of a sheet, not a lesson that an author wrote.
  [[nodiscard]] bool isPractice() const { return m_lesson->id.empty(); }
  [[nodiscard]] int step() const { return m_progress.step; }
  [[nodiscard]] State state() const { return m_state; }
  [[nodiscard]] const LessonProgress& progress() const { return m_progress; }
  [[nodiscard]] AnswerForm& form() { return *m_form; }
  [[nodiscard]] QString resultText() const;

 public slots:
  void check();
  void showHint();
  void showSolution();
  void back();
  void next();

 signals:
  void courseWanted();
  void nextLessonWanted();
  /// A step is on the screen: this drawing comes to the front.
  void stepBegan(geargraph::LessonView view);
  /// Whether views that hold the answer may be looked at.
  void answerOpened(bool isOpen);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QWidget* makeHead();
  QWidget* makeButtons();
  QPushButton* makeButton(const char* name, const QString& text, const QString& tip,
                          void (LessonPanel::*slot)());
  [[nodiscard]] const LessonStep& current() const;
  [[nodiscard]] bool isDrawing() const;
  void begin();
  void onAnswer(const LessonAnswerPtr& answer);
  void showStep(const PreparedStep& prepared);
  void takeMechanism(const MechanismPtr& mechanism);
  void grade(const Verdict& verdict);
  void finish(State state, int points, const QString& text);
  void setState(State state);
  void setResult(const QString& text, bool isRight);
  void renewHead();
  void renewButtons();
  void fitText();

  Document* m_document;
  Selection* m_selection;
  LessonService* m_service;
  LessonPtr m_lesson;
  LessonProgress m_progress;
  QString m_place;
  std::optional<PreparedStep> m_prepared;
  State m_state = State::loading;
  int m_hints = 0;      ///< that have been shown
  bool m_clean = true;  ///< no wrong answer and no hint in this step
  QToolButton* m_course = nullptr;
  QLabel* m_placeLabel = nullptr;
  QLabel* m_title = nullptr;
  StepBar* m_bar = nullptr;
  QLabel* m_stepLabel = nullptr;
  QLabel* m_score = nullptr;
  DerivationView* m_text = nullptr;
  AnswerForm* m_form = nullptr;
  QLabel* m_hintText = nullptr;
  QLabel* m_result = nullptr;
  QScrollArea* m_scroll = nullptr;
  QPushButton* m_hint = nullptr;
  QPushButton* m_check = nullptr;
  QPushButton* m_show = nullptr;
  QPushButton* m_back = nullptr;
  QPushButton* m_next = nullptr;
};

}  // namespace geargraph::inline ui_lessons
