#include "ui/motion_panel/vibration_service.h"

namespace geargraph {
namespace {

void answerVibration(const VibrationRequest& request, const VibrationService::Responder& respond) {
  auto answer = std::make_shared<VibrationAnswer>();
  answer->snapshot = request.snapshot;
  answer->options = request.options;
  auto cases = frequencyCases(*request.snapshot, request.options, respond.stop());
  if (!cases) return;
  answer->cases = *std::move(cases);
  const Mechanism& mechanism = *request.snapshot->mechanism;
  if (request.wantsLostMotion) {
    const bool hasStates = !mechanism.states.empty() && mechanism.engaged.empty();
    answer->lostMotion.emplace();
    if (hasStates) {
      auto all = lostMotionCases(mechanism, respond.stop());
      if (!all) return;
      answer->lostMotion = std::move(all);
    } else {
      auto one = lostMotionCase(*request.snapshot, respond.stop());
      if (!one) return;
      answer->lostMotion->push_back(*std::move(one));
    }
  }
  respond(std::move(answer));
}

}  // namespace

VibrationService::VibrationService(QObject* parent) : Service(answerVibration, parent) {}

}  // namespace geargraph
