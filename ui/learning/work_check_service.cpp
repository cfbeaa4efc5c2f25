#include "ui/learning/work_check_service.h"

#include "core/teaching/exercises/exercise_source.h"

namespace geargraph {
namespace {

/// Answers requests one after another, on the thread of the worker.
class Checker {
 public:
  void operator()(const WorkCheckRequest& request, const WorkCheckService::Responder& respond) {
    auto answer = std::make_shared<WorkCheckAnswer>();
    answer->mechanism = request.mechanism;
    if (m_mechanism != request.mechanism) {
      m_source = std::make_shared<const ExerciseSource>(*request.mechanism);
      m_mechanism = request.mechanism;
    }
    auto verdict = checkPaper(*m_source, request.text, request.kind, respond.stop());
    if (respond.stop().stop_requested()) return;
    if (verdict) {
      answer->verdict = std::move(verdict).value();
    } else {
      answer->faults = verdict.error();
    }
    respond(std::move(answer));
  }

 private:
  MechanismPtr m_mechanism;
  std::shared_ptr<const ExerciseSource> m_source;
};

}  // namespace

WorkCheckService::WorkCheckService(QObject* parent) : Service(Checker(), parent) {}

}  // namespace geargraph
