#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/teaching/grading/grade.h"
#include "core/teaching/lessons/lesson.h"

namespace geargraph {

/// Returns the example with this name, or an error.
using ExampleSource = std::function<Expected<MechanismPtr>(const std::string& name)>;

/// A prepared step: its mechanism and, unless the learner draws, its question with the key from the analysis.
/// An immutable value.
struct PreparedStep {
  MechanismPtr mechanism;
  std::optional<Question> question;
};

/// Fails with pointers into the step: `schema` if the task does not fit the document, `unknown-id` if the
/// document lacks a named element. The result is meaningless if `stop` was requested meanwhile.
/// Cost: at most an analysis of the document. @pre the step is one of the lesson's
[[nodiscard]] Expected<PreparedStep> prepareStep(const Lesson& lesson, std::size_t step,
                                                 const ExampleSource& examples,
                                                 const std::stop_token& stop = {});

/// The mechanism of a lesson's document; errors have this pointer.
[[nodiscard]] Expected<MechanismPtr> mechanismOf(const LessonDocument& document,
                                                 const ExampleSource& examples, const std::string& pointer);

/// The result of checkDrawing().
struct DrawingVerdict {
  Verdict verdict;
  int failing = -1;  ///< position of the first condition that does not hold; -1: none
};
/// Judges a drawing: right if all conditions hold; else the reason is that of the first one that does not,
/// and if that one is about errors, the elements of the drawing's diagnostics are highlighted. No points.
/// Cost: at most an analysis of the drawing.
[[nodiscard]] DrawingVerdict checkDrawing(const DrawTask& task, const MechanismPtr& drawing,
                                          const std::stop_token& stop = {});

/// The short title of a task: "Type", "Find the mistake".
[[nodiscard]] std::string_view taskTitle(const LessonStep& step);

/// The element of a label ("8") or of a coupling's id; std::nullopt if the mechanism has no such element.
[[nodiscard]] std::optional<ElementId> elementLabelled(const Mechanism& mechanism, const std::string& label);

}  // namespace geargraph
