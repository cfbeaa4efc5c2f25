#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/teaching/grading/grade.h"
#include "core/teaching/lessons/lesson.h"

namespace geargraph::inline lessons {

/// The example of a name, or why there is none.
using ExampleSource = std::function<Expected<MechanismPtr>(const std::string& name)>;

/// A step ready to be worked on: its mechanism and, unless the learner draws, its question with the key that
/// the analysis gives. An immutable value.
struct PreparedStep {
  MechanismPtr mechanism;
  std::optional<Question> question;
};

/// Fails with findings whose pointers lead to the step: `schema` where the task does not fit the document,
/// `unknown-id` where the document has not what is named. Of no use when `stop` was requested meanwhile.
/// Cost: at most an analysis of the document. @pre the step is one of the lesson's
[[nodiscard]] Expected<PreparedStep> prepareStep(const Lesson& lesson, std::size_t step,
                                                 const ExampleSource& examples,
                                                 const std::stop_token& stop = {});

/// A lesson's mechanism; the finding has this pointer.
[[nodiscard]] Expected<MechanismPtr> mechanismOf(const LessonDocument& document,
                                                 const ExampleSource& examples, const std::string& pointer);

/// Judges a drawing: right if all conditions hold; else the first that does not is the reason, and what the
/// findings of the drawing blame is lit up where errors are what fails. No points.
/// Cost: at most an analysis of the drawing.
struct DrawingVerdict {
  Verdict verdict;
  int failing = -1;  ///< position of that condition
};
[[nodiscard]] DrawingVerdict checkDrawing(const DrawTask& task, const MechanismPtr& drawing,
                                          const std::stop_token& stop = {});

/// What a task is about in two words: "Type", "Find the mistake".
[[nodiscard]] std::string_view taskTitle(const LessonStep& step);

/// The element of a label ("8") or of a coupling's id; none where the mechanism has no such element.
[[nodiscard]] std::optional<ElementId> elementLabelled(const Mechanism& mechanism, const std::string& label);

}  // namespace geargraph::inline lessons
