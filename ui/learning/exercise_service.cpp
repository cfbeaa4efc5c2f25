#include "ui/learning/exercise_service.h"

#include "core/teaching/lessons/practice.h"

namespace geargraph {
namespace {

/// Answers requests one after another, on the thread of the worker; what is made of a mechanism is kept while
/// only the plan changes.
class Maker {
 public:
  void operator()(const ExerciseRequest& request, const ExerciseService::Responder& respond) {
    if (!m_source || m_mechanism != request.mechanism) {
      m_source = std::make_shared<const ExerciseSource>(*request.mechanism);
      m_mechanism = request.mechanism;
    }
    if (respond.stop().stop_requested()) return;
    auto answer = std::make_shared<ExerciseAnswer>();
    answer->mechanism = request.mechanism;
    for (const ExerciseKind kind : allExerciseKinds())
      answer->offers.push_back({kind, reasonAgainst(*m_source, kind).value_or("")});
    answer->difficulty = difficultyOf(*m_source).text;
    if (request.plan) {
      answer->practice =
          std::make_shared<const Lesson>(practiceLesson(*m_source, *request.plan, request.variant));
    }
    respond(std::move(answer));
  }

 private:
  MechanismPtr m_mechanism;
  std::shared_ptr<const ExerciseSource> m_source;
};

}  // namespace

ExerciseService::ExerciseService(QObject* parent) : Service(Maker(), parent) {}

}  // namespace geargraph
