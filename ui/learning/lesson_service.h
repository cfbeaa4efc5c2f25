#pragma once

#include <memory>
#include <optional>

#include "core/teaching/lessons/prepared_step.h"
#include "ui/service/service.h"

namespace geargraph {

using LessonPtr = std::shared_ptr<const Lesson>;

/// A request to prepare a step or, with a drawing, to judge the drawing.
struct LessonRequest {
  LessonPtr lesson;
  std::size_t step = 0;
  MechanismPtr drawing = {};
};

struct LessonAnswer {
  std::optional<PreparedStep> prepared;
  std::optional<Verdict> drawing;
  Diagnostics faults;  ///< why a step could not be prepared
};
using LessonAnswerPtr = std::shared_ptr<const LessonAnswer>;

/// Prepares steps and judges drawings off the GUI thread.
class LessonService final : public Service<LessonRequest, LessonAnswerPtr> {
 public:
  explicit LessonService(QObject* parent = nullptr);
};

}  // namespace geargraph
