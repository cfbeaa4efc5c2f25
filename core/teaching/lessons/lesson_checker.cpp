#include "core/teaching/lessons/lesson_checker.h"

#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/teaching/derivation/glossary.h"
#include "core/teaching/lessons/mastery.h"

namespace geargraph {
namespace {

class LessonChecker {
 public:
  LessonChecker(const Lesson& lesson, const ExampleSource& examples, const std::stop_token& stop)
      : m_lesson(lesson), m_examples(examples), m_stop(stop) {}

  Diagnostics check() {
    checkTerms();
    for (std::size_t i = 0; i < m_lesson.steps.size() && !m_stop.stop_requested(); ++i) checkStep(i);
    if (!m_stop.stop_requested()) checkPractice();
    return m_stop.stop_requested() ? Diagnostics() : std::move(m_diagnostics);
  }

 private:
  void find(const std::string& pointer, const std::string& message) {
    m_diagnostics.push_back({Code::schema, message, {}, pointer});
  }

  void checkTerms() {
    for (std::size_t i = 0; i < m_lesson.terms.size(); ++i) {
      const auto& glossaryTerms = glossary();
      const bool isKnown = std::any_of(glossaryTerms.begin(), glossaryTerms.end(),
                                       [&](const Definition& d) { return d.name == m_lesson.terms[i]; });
      if (!isKnown)
        find("/terms/" + std::to_string(i),
             translated("The glossary has no term \"%1\".", {m_lesson.terms[i]}));
    }
  }

  void checkStep(std::size_t position) {
    const LessonStep& step = m_lesson.steps[position];
    const std::string pointer = "/steps/" + std::to_string(position) + "/task";
    const auto prepared = prepareStep(m_lesson, position, m_examples, m_stop);
    if (!prepared) return append(m_diagnostics, prepared.error());
    if (const auto* draw = std::get_if<DrawTask>(&step.task)) return checkDrawTask(*draw, *prepared, pointer);
    const Question& question = *prepared->question;
    if (!grade(question, question.solution).isRight)
      find(pointer, translated("The solution is not accepted."));
    if (const auto* answer = std::get_if<AnswerTask>(&step.task)) checkMistakes(*answer, question, pointer);
  }

  /// Those that the file lists; the others are exercises of steps.
  void checkPractice() {
    for (std::size_t i = 0; i < m_lesson.practice.size(); ++i) {
      Lesson one = m_lesson;
      one.steps = {freshStep(m_lesson, 1, static_cast<int>(i))};
      const auto prepared = prepareStep(one, 0, m_examples, m_stop);
      if (prepared) continue;
      for (Diagnostic diagnostic : prepared.error()) {
        diagnostic.pointer = "/practice/" + std::to_string(i);
        m_diagnostics.push_back(std::move(diagnostic));
      }
    }
  }

  void checkMistakes(const AnswerTask& task, const Question& question, const std::string& pointer) {
    for (std::size_t i = 0; i < task.mistakes.size(); ++i) {
      const std::string place = pointer + "/mistakes/" + std::to_string(i);
      const std::vector<std::string> example = exampleOf(task.mistakes[i], question);
      if (example.size() != question.fields.size()) {
        find(place + "/example", translated("An answer has a text for each field."));
        continue;
      }
      const Verdict verdict = grade(question, example);
      if (verdict.isRight) {
        find(place, translated("This answer is accepted as right."));
      } else if (verdict.reason != task.mistakes[i].mistake.reason) {
        find(place, translated("This answer gets another reason: \"%1\"", {verdict.reason}));
      }
    }
  }

  void checkDrawTask(const DrawTask& task, const PreparedStep& prepared, const std::string& pointer) {
    if (checkDrawing(task, prepared.mechanism, m_stop).verdict.isRight)
      find(pointer + "/conditions",
           translated("The document of the step fulfils them already: nothing is left to draw."));
    const auto solution = mechanismOf(task.solution, m_examples, pointer + "/solution");
    if (!solution) {
      append(m_diagnostics, solution.error());
    } else {
      const DrawingVerdict result = checkDrawing(task, *solution, m_stop);
      if (!result.verdict.isRight)
        find(pointer + "/solution", translated("The solution is not accepted: %1", {result.verdict.reason}));
    }
    for (std::size_t i = 0; i < task.mistakes.size(); ++i) {
      const std::string place = pointer + "/mistakes/" + std::to_string(i);
      const auto drawing = mechanismOf(task.mistakes[i].drawing, m_examples, place + "/drawing");
      if (!drawing) {
        append(m_diagnostics, drawing.error());
        continue;
      }
      const int failing = checkDrawing(task, *drawing, m_stop).failing;
      if (failing != task.mistakes[i].failing)
        find(place + "/failing",
             failing < 0 ? translated("This drawing is accepted as right.")
                         : translated("The first condition that fails is %1.", {std::to_string(failing)}));
    }
  }

  const Lesson& m_lesson;
  const ExampleSource& m_examples;
  const std::stop_token& m_stop;
  Diagnostics m_diagnostics;
};

}  // namespace

std::vector<std::string> exampleOf(const TaskMistake& mistake, const Question& question) {
  if (!mistake.example.empty()) return mistake.example;
  std::vector<std::string> answer = question.solution;
  const Condition& condition = mistake.mistake.when.front();
  if (condition.values.empty()) return answer;
  const std::vector<std::string>& values = condition.values.front();
  if (condition.fields.empty()) return values;
  for (std::size_t i = 0; i < condition.fields.size() && i < values.size(); ++i)
    answer[static_cast<std::size_t>(condition.fields[i])] = values[i];
  return answer;
}

Diagnostics checkLesson(const Lesson& lesson, const ExampleSource& examples, const std::stop_token& stop) {
  return LessonChecker(lesson, examples, stop).check();
}

}  // namespace geargraph
