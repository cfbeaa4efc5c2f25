#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/teaching/exercises/exercise_sheet.h"
#include "ui/learning/lesson_service.h"
#include "ui/service/service.h"

namespace geargraph {

/// A request for the available exercises of a mechanism; with a plan also for its questions as a lesson.
struct ExerciseRequest {
  MechanismPtr mechanism;
  std::optional<SheetPlan> plan = {};
  int variant = 1;
};

/// A kind of question, with the reason if it is not available for the mechanism.
struct KindOffer {
  ExerciseKind kind = ExerciseKind::incidence;
  std::string reason;  ///< empty if it is available
};

struct ExerciseAnswer {
  MechanismPtr mechanism;
  std::vector<KindOffer> offers;  ///< of all kinds, in their order
  std::string difficulty;         ///< "medium: 4 cycles, 3 inputs"
  LessonPtr practice;             ///< null without a plan
};
using ExerciseAnswerPtr = std::shared_ptr<const ExerciseAnswer>;

/// Generates exercises off the GUI thread.
///
/// @pre requested mechanisms have at most kMaxExerciseLinks moving links and support every kind of the plan
class ExerciseService final : public Service<ExerciseRequest, ExerciseAnswerPtr> {
 public:
  explicit ExerciseService(QObject* parent = nullptr);
};

}  // namespace geargraph
