#pragma once

#include <QWidget>
#include <cstdint>
#include <optional>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/learning/lesson_progress.h"
#include "ui/learning/lesson_service.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QLabel;
class QPushButton;
class QScrollArea;
class QToolButton;

namespace geargraph {
class DerivationView;
}  // namespace geargraph

namespace geargraph {

class AnswerForm;
class StepBar;

/// Plays a lesson step by step on the document of a window of its own: text, task, answer, hints, and the
/// reason when the answer is wrong. Each step begins with its mechanism; the elements of a task are
/// highlighted by the shared selection. After the last step come fresh questions, further ones until enough
/// were right at the first check. Progress is stored in the settings.
class LessonPanel : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  /// The state of the current step, which determines the buttons; Return triggers the default one.
  enum class State { loading, open, wrong, right, shown, faulty };

  LessonPanel(Document* document, Selection* selection, QWidget* parent = nullptr);

  [[nodiscard]] QWidget& widget() override { return *this; }
  /// Plays a lesson from the stored progress. `place`: "Lesson 4 of 15", or its origin.
  void play(const LessonPtr& lesson, const QString& place);
  /// Replaces the lesson by a new version of its file, at the same step if it still exists.
  void reload(const LessonPtr& lesson);
  /// Shows why a lesson's file cannot be read, and keeps the lesson.
  void showFault(const QString& fault);
  void goTo(int step);

  /// With the fresh questions that were added to it.
  [[nodiscard]] const LessonPtr& lesson() const { return m_lesson; }
  /// As it was given to play().
  [[nodiscard]] const LessonPtr& playedLesson() const { return m_played; }
  /// Is it a practice with questions of a sheet, not an authored lesson?
  [[nodiscard]] bool isPractice() const { return m_lesson->id.empty(); }
  /// Does the step ask a fresh question, after those of the lesson itself?
  [[nodiscard]] bool isFresh() const;
  [[nodiscard]] bool isStartTest() const;
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
  /// A step is shown: bring this drawing to the front.
  void stepBegan(geargraph::StepView view);
  /// Emitted with whether views that reveal the answer may be shown.
  void answerOpened(bool isOpen);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeHead();
  QWidget* makeButtons();
  QPushButton* makeButton(const char* name, const QString& text, const QString& tip,
                          void (LessonPanel::*slot)());
  [[nodiscard]] const LessonStep& current() const;
  [[nodiscard]] bool isDrawing() const;
  void setLesson(const LessonPtr& lesson);
  void begin();
  void goOn();
  [[nodiscard]] int cleanFresh() const;
  [[nodiscard]] bool asksMore() const;
  void addFresh();
  void onAnswer(const LessonAnswerPtr& answer);
  void showStep(const PreparedStep& prepared);
  void takeMechanism(const MechanismPtr& mechanism);
  void grade(const Verdict& verdict);
  void finish(State state, int points, const QString& text);
  void setState(State state);
  void setResult(const QString& text, bool isRight);
  void updateHead();
  void updateButtons();
  void fitText();

  Document* m_document;
  Selection* m_selection;
  LessonService* m_service;
  LessonPtr m_played;
  LessonPtr m_lesson;  ///< with fresh questions
  std::uint64_t m_seed = 0;
  LessonProgress m_progress;
  QString m_place;
  std::optional<PreparedStep> m_prepared;
  State m_state = State::loading;
  int m_hints = 0;      ///< number of hints shown
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

[[nodiscard]] ViewEntry lessonView();

}  // namespace geargraph
