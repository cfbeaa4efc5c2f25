#include "ui/motion_panel/dynamics_service.h"

#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/theory/statics/applied_loads.h"

namespace geargraph {
namespace {

/// The sentence for a document that has no dynamics whatever its masses; empty for one that may have.
std::string unavailableReason(const AnalysisSnapshot& snapshot) {
  for (const Diagnostic& each : snapshot.diagnostics)
    if (each.severity() == Severity::error) return each.message;
  const MatroidAnalysis* const matroid = snapshot.matroid();
  if (matroid == nullptr)
    return translated("Draw turning joints and gear meshes: their masses and their motion appear here.");
  if (!matroid->solution || matroid->solution->inputs.empty())
    return translated("Nothing can turn here: without an input there is no equation of motion.");
  const std::size_t entries = matroid->solution->inputs.size() * matroid->solution->outputs.size();
  if (entries > LiveSolution::kMaxLiveEntries)
    return translated(
        "This train has too many inputs and joints: dynamics is computed for up to %1 entries of the "
        "solution.",
        {std::to_string(LiveSolution::kMaxLiveEntries)});
  return {};
}

Eigen::VectorXd vectorOf(const std::vector<double>& values, Eigen::Index size) {
  if (static_cast<Eigen::Index>(values.size()) != size) return Eigen::VectorXd::Zero(size);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), size);
}

/// Answers one request after the other, with the masses of the last mechanism.
class Worker {
 public:
  void answer(const DynamicsRequest& request, const DynamicsService::Responder& respond) {
    if (request.snapshot != m_snapshot && !renew(request.snapshot, respond.stop())) return;
    auto dynamics = std::make_shared<Dynamics>();
    dynamics->snapshot = m_snapshot;
    dynamics->train = m_train;
    dynamics->unavailableReason = m_whyNone;
    if (m_train && !evaluate(request.moment, *dynamics, respond.stop())) return;
    respond(std::move(dynamics));
  }

 private:
  /// False where `stop` was requested.
  bool renew(const SnapshotPtr& snapshot, const std::stop_token& stop) {
    m_snapshot.reset();
    m_train.reset();
    m_evaluator.reset();
    m_whyNone = unavailableReason(*snapshot);
    if (m_whyNone.empty()) {
      const auto train = snapshot->geometry->train(stop);
      if (!train) return false;
      auto dynamics = dynamicsOf(*snapshot->mechanism, *snapshot->kinematics->model,
                                 snapshot->kinematics->placement(), *snapshot->matroid(), *train, stop);
      if (!dynamics) return false;
      if (*dynamics) {
        m_train = std::make_shared<const MechanismDynamics>(**std::move(dynamics));
        m_evaluator.emplace(m_train->train);
      } else {
        m_whyNone = dynamics->error().front().message;
      }
    }
    m_snapshot = snapshot;
    return true;
  }

  /// False where `stop` was requested.
  bool evaluate(const InputMoment& moment, Dynamics& dynamics, const std::stop_token& stop) {
    const Eigen::Index inputs = m_train->train.inputs();
    const Eigen::VectorXd angles = vectorOf(moment.angles, inputs);
    dynamics.state.equation = m_evaluator->at(angles, vectorOf(moment.speeds, inputs), stop);
    if (stop.stop_requested()) return false;
    dynamics.state.reflected = m_evaluator->reflectedInertias(angles);
    dynamics.isMassless = !accelerationsFor(dynamics.state.equation, Eigen::VectorXd::Zero(inputs));
    dynamics.metres = metresPerUnit(*m_snapshot->mechanism)->toDouble();
    return true;
  }

  SnapshotPtr m_snapshot;  ///< whose masses these are; null: none are
  MechanismDynamicsPtr m_train;
  std::string m_whyNone;
  std::optional<TrainDynamics> m_evaluator;
};

DynamicsService::Work work() {
  return [worker = std::make_shared<Worker>()](const DynamicsRequest& request,
                                               const DynamicsService::Responder& respond) {
    worker->answer(request, respond);
  };
}

bool isSame(const DynamicsRequest& before, const DynamicsRequest& now) {
  return before.snapshot == now.snapshot && before.moment == now.moment;
}

}  // namespace

DynamicsService::DynamicsService(QObject* parent) : Service(work(), parent, {.same = &isSame}) {}

}  // namespace geargraph
