#include "ui/learning/lesson_panel.h"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QToolButton>
#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/mechanism/model/difference.h"
#include "core/teaching/lessons/mastery.h"
#include "ui/learning/answer_form.h"
#include "ui/learning/lesson_words.h"
#include "ui/reading/derivation_view.h"
#include "ui/theme/looks.h"
#include "ui/theme/theme_colors.h"
#include "ui/workbench/views.h"

namespace geargraph {

/// One segment a step: done, the current one, to come.
class StepBar : public QWidget {
 public:
  explicit StepBar(QWidget* parent) : QWidget(parent) { setFixedHeight(6); }

  void setSteps(const LessonProgress& progress) {
    m_progress = progress;
    setAccessibleName(
        LessonPanel::tr("%1 of %2 steps done").arg(progress.doneSteps()).arg(progress.points.size()));
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    constexpr double kGap = 4;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const Theme theme = themeOf(palette());
    const auto count = m_progress.points.size();
    const double step = count == 0 ? 0 : (width() + kGap) / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const bool isCurrent = static_cast<int>(i) == m_progress.step;
      const bool isDone = m_progress.points[i] != kNotDone;
      painter.setBrush(qColor(isCurrent ? ColorRole::accent
                              : isDone  ? ColorRole::fine
                                        : ColorRole::hairline,
                              theme));
      painter.drawRoundedRect(QRectF(step * static_cast<double>(i), 0, step - kGap, height()), 3, 3);
    }
  }

 private:
  LessonProgress m_progress;
};

namespace {

/// As high as what it holds wants to be now; QScrollArea keeps the first answer to that.
class FormScroll : public QScrollArea {
 public:
  explicit FormScroll(QWidget* parent) : QScrollArea(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  }
  [[nodiscard]] QSize sizeHint() const override { return widget()->sizeHint(); }

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::event(event);
  }
};

}  // namespace

LessonPanel::LessonPanel(Document* document, Selection* selection, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_service(new LessonService(this)) {
  setObjectName(QStringLiteral("lessonPanel"));
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  m_text = new DerivationView(selection, this);
  m_text->setObjectName(QStringLiteral("lessonText"));
  m_text->setFrameShape(QFrame::NoFrame);
  m_text->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  m_form = new AnswerForm(selection, this);
  m_hintText = new QLabel(this);
  m_hintText->setObjectName(QStringLiteral("lessonHints"));
  m_hintText->setProperty("look", "hint");
  m_hintText->setWordWrap(true);
  m_result = new QLabel(this);
  m_result->setObjectName(QStringLiteral("lessonResult"));
  m_result->setWordWrap(true);
  m_result->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* page = new QWidget(this);
  auto* answers = new QVBoxLayout(page);
  answers->setContentsMargins(20, 0, 16, 4);
  answers->addWidget(m_form);
  // As high as the form, where there is room: the verdict stays on the screen below it.
  m_scroll = new FormScroll(this);
  m_scroll->setObjectName(QStringLiteral("lessonForm"));
  m_scroll->setWidgetResizable(true);
  m_scroll->setFrameShape(QFrame::NoFrame);
  m_scroll->setWidget(page);
  auto* ends = new QHBoxLayout;
  ends->setContentsMargins(20, 6, 16, 10);
  m_back = makeButton("lessonBack", tr("‹ Back"), tr("The step before (Alt+Left)"), &LessonPanel::back);
  m_next = makeButton("lessonNext", tr("Skip ›"), tr("The next step (Alt+Right)"), &LessonPanel::next);
  m_back->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Left));
  m_next->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Right));
  ends->addWidget(m_back);
  ends->addStretch(1);
  ends->addWidget(m_next);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(makeHead());
  layout->addWidget(m_text);
  layout->addWidget(m_scroll);
  auto* told = new QVBoxLayout;
  told->setContentsMargins(20, 0, 16, 4);
  told->addWidget(makeButtons());
  told->addWidget(m_result);
  told->addWidget(m_hintText);
  layout->addLayout(told);
  layout->addStretch(1);
  layout->addLayout(ends);
  m_service->onAnswer(this, [this](const LessonAnswerPtr& answer) { onAnswer(answer); });
  connect(m_service, &LessonService::failed, this, &LessonPanel::showFault);
  connect(m_form, &AnswerForm::submitted, this, [this] {
    if (m_check->isEnabled()) m_check->click();
  });
  connect(m_form, &AnswerForm::edited, this, [this] {
    const bool isTold = m_state == State::wrong || (m_state == State::open && !m_result->text().isEmpty());
    if (!isTold) return;
    m_form->unmark();
    m_result->clear();
    setState(State::open);
  });
}

QWidget* LessonPanel::makeHead() {
  auto* head = new QWidget(this);
  auto* layout = new QVBoxLayout(head);
  layout->setContentsMargins(20, 8, 16, 0);
  layout->setSpacing(6);
  auto* top = new QHBoxLayout;
  m_course = new QToolButton(head);
  m_course->setObjectName(QStringLiteral("lessonCourse"));
  m_course->setProperty("look", "flat");
  connect(m_course, &QToolButton::clicked, this, &LessonPanel::courseWanted);
  m_placeLabel = new QLabel(head);
  m_placeLabel->setProperty("look", "hint");
  top->addWidget(m_course);
  top->addStretch(1);
  top->addWidget(m_placeLabel);
  m_title = new QLabel(head);
  m_title->setObjectName(QStringLiteral("lessonTitle"));
  m_title->setProperty("look", "heading");
  m_title->setWordWrap(true);
  m_bar = new StepBar(head);
  auto* counts = new QHBoxLayout;
  m_stepLabel = new QLabel(head);
  m_stepLabel->setProperty("look", "title");
  m_score = new QLabel(head);
  m_score->setProperty("look", "hint");
  m_score->setToolTip(
      tr("2 points for a step that is right at once, 1 after a hint or a correction; the score "
         "never falls"));
  counts->addWidget(m_stepLabel);
  counts->addStretch(1);
  counts->addWidget(m_score);
  layout->addLayout(top);
  layout->addWidget(m_title);
  layout->addWidget(m_bar);
  layout->addLayout(counts);
  return head;
}

QPushButton* LessonPanel::makeButton(const char* name, const QString& text, const QString& tip,
                                     void (LessonPanel::*slot)()) {
  auto* button = new QPushButton(text, this);
  button->setObjectName(QLatin1String(name));
  button->setToolTip(tip);
  button->setAutoDefault(true);
  connect(button, &QPushButton::clicked, this, slot);
  return button;
}

QWidget* LessonPanel::makeButtons() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 4, 0, 4);
  m_hint = makeButton("lessonHint", tr("H&int"), tr("Where to look, then the rule, then the first half"),
                      &LessonPanel::showHint);
  m_show = makeButton("lessonShow", tr("Show me"), tr("The answer; the step then gives no points"),
                      &LessonPanel::showSolution);
  m_check = makeButton("lessonCheck", tr("Check"), tr("Check the answer (Return)"), &LessonPanel::check);
  layout->addWidget(m_hint);
  layout->addWidget(m_show);
  layout->addStretch(1);
  layout->addWidget(m_check);
  return row;
}

const LessonStep& LessonPanel::current() const {
  return m_lesson->steps[static_cast<std::size_t>(m_progress.step)];
}

bool LessonPanel::isDrawing() const {
  return std::holds_alternative<DrawTask>(current().task);
}

QString LessonPanel::resultText() const {
  return m_result->text();
}

bool LessonPanel::isFresh() const {
  return m_progress.step >= static_cast<int>(m_played->steps.size());
}

bool LessonPanel::isStartTest() const {
  return m_played->id == kStartTestId;
}

/// Fresh questions that were right at the first check.
int LessonPanel::cleanFresh() const {
  const auto own = static_cast<std::ptrdiff_t>(m_played->steps.size());
  return static_cast<int>(std::count(m_progress.points.begin() + own, m_progress.points.end(), kStepPoints));
}

bool LessonPanel::asksMore() const {
  return !isPractice() && !isStartTest() && !practiceOf(*m_played).empty() && cleanFresh() < kFreshQuestions;
}

/// The first ones, or one more.
void LessonPanel::addFresh() {
  const auto own = m_played->steps.size();
  const int missing = m_lesson->steps.size() == own ? kFreshQuestions : 1;
  Lesson longer = *m_lesson;
  for (int i = 0; i < missing; ++i) {
    const auto number = static_cast<int>(longer.steps.size() - own);
    longer = withFreshStep(std::move(longer), m_seed, number);
    m_progress.points.push_back(kNotDone);
  }
  m_lesson = std::make_shared<const Lesson>(std::move(longer));
}

void LessonPanel::setLesson(const LessonPtr& lesson) {
  m_played = m_lesson = lesson;
  m_seed = randomSeed();
  m_progress = progressOf(*lesson);
  if (isStartTest()) {
    m_progress.step = 0;
    std::fill(m_progress.points.begin(), m_progress.points.end(), kNotDone);
    saveProgress(*lesson, m_progress);
  }
}

void LessonPanel::play(const LessonPtr& lesson, const QString& place) {
  m_place = place;
  setLesson(lesson);
  if (lesson->isReview && asksMore()) {
    m_progress.step = static_cast<int>(lesson->steps.size());
    addFresh();
  }
  begin();
}

void LessonPanel::reload(const LessonPtr& lesson) {
  const int step = m_progress.step;
  setLesson(lesson);
  m_progress.step = std::min(step, static_cast<int>(lesson->steps.size()) - 1);
  begin();
}

void LessonPanel::showFault(const QString& fault) {
  setResult(fault, false);
  if (m_state == State::loading) setState(State::faulty);
}

void LessonPanel::goTo(int step) {
  m_progress.step = std::clamp(step, 0, static_cast<int>(m_lesson->steps.size()) - 1);
  saveProgress(*m_lesson, m_progress);
  begin();
}

void LessonPanel::begin() {
  m_prepared.reset();
  m_hints = 0;
  m_clean = true;
  m_hintText->clear();
  m_result->clear();
  m_form->clear();
  m_selection->clear();
  m_selection->unhover();
  updateHead();
  setState(State::loading);
  m_service->request({m_lesson, static_cast<std::size_t>(m_progress.step)});
}

void LessonPanel::onAnswer(const LessonAnswerPtr& answer) {
  if (!answer) return;
  if (answer->drawing) return grade(*answer->drawing);
  if (answer->prepared) return showStep(*answer->prepared);
  setState(State::faulty);
  showFault(QString::fromStdString(answer->faults.front().pointer + ": " + answer->faults.front().message));
}

void LessonPanel::showStep(const PreparedStep& prepared) {
  m_prepared = prepared;
  const LessonStep& step = current();
  const Question* question = prepared.question ? &*prepared.question : nullptr;
  takeMechanism(prepared.mechanism);
  if (question != nullptr) m_form->setQuestion(*question, prepared.mechanism);
  m_text->setReport(stepText(step.title, step.text, step.formula, step.equation, translated(taskTitle(step)),
                             question != nullptr ? question->prompt : step.prompt,
                             question != nullptr ? question->formula : std::string()));
  m_text->verticalScrollBar()->setValue(0);
  const std::set<ElementId> meant(step.elements.begin(), step.elements.end());
  // Where elements are picked the selection is the answer: what is meant is shown by its halo alone.
  m_form->picks() ? m_selection->hover(meant) : m_selection->select(meant);
  setState(State::open);
  fitText();
  emit stepBegan(step.view);
  if (question != nullptr) m_form->focusFirst();
}

/// Steps often share a mechanism: then the views keep what they show, and what was edited is put right.
void LessonPanel::takeMechanism(const MechanismPtr& mechanism) {
  if (!isSameButForView(*m_document->mechanism(), *mechanism))
    return m_document->replace(*mechanism, QString());
  m_document->apply(
      {tr("Begin the step"), [mechanism](const Mechanism&) -> Expected<Mechanism> { return *mechanism; }, 0});
}

void LessonPanel::check() {
  if (m_state == State::right || m_state == State::shown) return goOn();
  if (m_state == State::wrong && !isDrawing()) {
    m_form->focusFirst();
    return setState(State::open);
  }
  if (!m_prepared) return;
  if (m_prepared->question) return grade(geargraph::grade(*m_prepared->question, m_form->answer()));
  m_service->request({m_lesson, static_cast<std::size_t>(m_progress.step), m_document->mechanism()});
}

void LessonPanel::grade(const Verdict& verdict) {
  m_form->mark(verdict);
  if (verdict.isRight) {
    finish(State::right, m_clean ? kStepPoints : kStepPoints - 1,
           tr("Right. %1").arg(plainSentence(verdict.reason)));
    return;
  }
  // What is not answered or cannot be read is not wrong: it stays open, and costs nothing.
  if (verdict.isBlank || verdict.isUnreadable) return setResult(plainSentence(verdict.reason), false);
  m_clean = false;
  std::set<ElementId> meant;
  if (verdict.mistake) meant.insert(verdict.mistake->elements.begin(), verdict.mistake->elements.end());
  if (!meant.empty()) m_form->picks() ? m_selection->hover(meant) : m_selection->select(meant);
  // Without a known mistake the rule would give the answer away.
  const auto wrong = static_cast<int>(verdict.wrongFields.size());
  setResult(verdict.mistake ? plainSentence(verdict.reason)
            : wrong > 0     ? tr("%n field(s) are wrong: look at those that are framed.", nullptr, wrong)
                            : tr("This is not right. A hint tells where to look."),
            false);
  setState(State::wrong);
}

void LessonPanel::finish(State state, int points, const QString& text) {
  int& kept = m_progress.points[static_cast<std::size_t>(m_progress.step)];
  const bool wasMastered = cleanFresh() >= kFreshQuestions;
  kept = std::max(kept, points);
  saveProgress(*m_lesson, m_progress);
  QString told = text;
  if (!wasMastered && cleanFresh() >= kFreshQuestions) {
    saveMastered(*m_played, QDate::currentDate());
    told += QLatin1Char('\n') + tr("You have mastered this lesson. Review it from %1 on.")
                                    .arg(locale().toString(masteryOf(*m_played).due(), QLocale::LongFormat));
  }
  setState(state);
  setResult(told, state == State::right);
  updateHead();
  m_check->setFocus();
}

void LessonPanel::showHint() {
  const auto& hints = current().hints;
  if (m_hints >= static_cast<int>(hints.size())) return;
  ++m_hints;
  m_clean = false;
  QStringList shown;
  for (int i = 0; i < m_hints; ++i)
    shown << tr("%1. %2").arg(i + 1).arg(plainSentence(hints[static_cast<std::size_t>(i)]));
  m_hintText->setText(shown.join(QLatin1Char('\n')));
  const auto& elements = current().elements;
  m_selection->hover({elements.begin(), elements.end()});
  updateButtons();
}

void LessonPanel::showSolution() {
  if (!m_prepared || !m_prepared->question) return;
  m_form->unmark();
  m_form->setAnswer(m_prepared->question->solution);
  finish(State::shown, 0, tr("Shown: %1").arg(plainSentence(m_prepared->question->rule)));
}

void LessonPanel::back() {
  if (m_progress.step > 0) goTo(m_progress.step - 1);
}

/// From a step that is solved: also to fresh questions. The start test ends with the second miss: then it is
/// known where to begin.
void LessonPanel::goOn() {
  const bool isLast = m_progress.step + 1 == static_cast<int>(m_lesson->steps.size());
  constexpr int kMostMisses = 2;
  const auto misses = std::count_if(m_progress.points.begin(), m_progress.points.end(),
                                    [](int each) { return each != kNotDone && each != kStepPoints; });
  if (isStartTest() && misses >= kMostMisses) return emit nextLessonWanted();
  if (isLast && asksMore()) {
    addFresh();
    return goTo(m_progress.step + 1);
  }
  next();
}

void LessonPanel::next() {
  if (m_progress.step + 1 < static_cast<int>(m_lesson->steps.size())) return goTo(m_progress.step + 1);
  emit nextLessonWanted();
}

void LessonPanel::setState(State state) {
  m_state = state;
  const bool isSolved = state == State::right || state == State::shown;
  m_form->setReadOnly(isSolved);
  updateButtons();
  if (m_lesson) emit answerOpened(isSolved || isDrawing());
}

void LessonPanel::setResult(const QString& text, bool isRight) {
  const bool isShown = m_state == State::shown;
  setInk(*m_result, isShown ? ColorRole::ink : isRight ? ColorRole::fine : ColorRole::error);
  m_result->setText((isRight ? QStringLiteral("✓ ") : QStringLiteral("✗ ")) + text);
}

void LessonPanel::updateHead() {
  m_course->setText(isPractice() ? tr("‹ Exercises") : tr("‹ Course"));
  m_course->setToolTip(isPractice() ? tr("Other questions, or another seed")
                                    : tr("All lessons, with your progress"));
  m_placeLabel->setText(m_lesson->minutes > 0 ? tr("%1, %2 min").arg(m_place).arg(m_lesson->minutes)
                                              : m_place);
  m_title->setText(QString::fromStdString(m_lesson->title));
  m_bar->setSteps(m_progress);
  const auto steps = static_cast<int>(m_lesson->steps.size());
  if (isFresh()) {
    m_stepLabel->setText(
        tr("Fresh question %1").arg(m_progress.step + 1 - static_cast<int>(m_played->steps.size())));
    m_score->setText(tr("%1 of %2 right at once").arg(cleanFresh()).arg(kFreshQuestions));
    m_score->setToolTip(
        tr("Right at the first check, without a hint; one more is asked as long as some are missing"));
    return;
  }
  m_stepLabel->setText(tr("Step %1 of %2").arg(m_progress.step + 1).arg(m_played->steps.size()));
  m_score->setText(tr("Score %1 of %2").arg(m_progress.score()).arg(steps * kStepPoints));
}

void LessonPanel::updateButtons() {
  const bool isSolved = m_state == State::right || m_state == State::shown;
  const bool isOpen = m_state == State::open || m_state == State::wrong;
  const bool isLast = m_lesson && m_progress.step + 1 == static_cast<int>(m_lesson->steps.size());
  const bool goesOn = !isLast || (m_lesson && asksMore());
  m_check->setText(isSolved
                       ? (goesOn ? (isLast && !isFresh() ? tr("Fresh questions") : tr("Next")) : tr("Finish"))
                   : m_state == State::wrong && !isDrawing() ? tr("Try again")
                                                             : tr("Check"));
  m_check->setEnabled(isOpen || isSolved);
  m_check->setDefault(true);
  const auto hints = m_lesson ? static_cast<int>(current().hints.size()) : 0;
  m_hint->setEnabled(isOpen && m_hints < hints);
  m_hint->setToolTip(m_hints < hints
                         ? tr("Where to look, then the rule: hint %1 of %2").arg(m_hints + 1).arg(hints)
                         : tr("There are no more hints in this step."));
  m_show->setEnabled(isOpen && m_prepared && m_prepared->question);
  m_show->setToolTip(m_lesson && isDrawing() ? tr("A drawing can be right in many ways: take a hint.")
                                             : tr("The answer; the step then gives no points"));
  m_back->setEnabled(m_progress.step > 0);
  m_back->setToolTip(m_progress.step > 0 ? tr("The step before (Alt+Left)") : tr("This is the first step."));
  m_next->setText(
      isSolved ? (isLast ? (isPractice() ? tr("Other exercises ›") : tr("Next lesson ›")) : tr("Next ›"))
               : (isLast ? tr("Leave ›") : tr("Skip ›")));
}

/// The text as high as it is, up to half of the panel.
void LessonPanel::fitText() {
  constexpr int kBelow = 16;  ///< px, so that no scroll bar is needed
  m_text->setFixedHeight(m_text->minimumSizeHint().height());
  const int needed = m_text->viewport()->height() + m_text->verticalScrollBar()->maximum() + kBelow;
  m_text->setFixedHeight(std::clamp(needed, 80, std::max(120, height() * 55 / 100)));
}

void LessonPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitText();
}

ViewEntry lessonView() {
  constexpr int kMinWidth = 320;  // px
  return {.id = QStringLiteral("lesson"),
          .title = LessonPanel::tr("Lesson"),
          .purpose = LessonPanel::tr(
              "A lesson: what is asked, your answer, hints, and the reason where it is wrong."),
          .helpPage = QStringLiteral("lessons-and-exercises"),
          .place = ViewPlace::left,
          .minimumSize = {kMinWidth, 0},
          .holdsAnswers = false,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            return new LessonPanel(views.document(), views.selection(), parent);
          }};
}

}  // namespace geargraph

#include "moc_lesson_panel.cpp"
