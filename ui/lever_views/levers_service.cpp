#include "ui/lever_views/levers_service.h"

#include "core/theory/levers/lever_motion.h"
#include "core/theory/matroid/exact_solution.h"

namespace geargraph {
namespace {

/// What pages are drawn of is in the live part already.
bool isSamePage(const LeversRequest& before, const LeversRequest& now) {
  return before.page == now.page && before.snapshot->mechanism == now.snapshot->mechanism &&
         before.snapshot->kinematics == now.snapshot->kinematics;
}

/// False if `stop` was requested.
bool findSpeedsPerInput(DrawnLevers& drawn, const std::stop_token& stop) {
  const MatroidAnalysis* const matroid = drawn.snapshot->matroid();
  if (matroid == nullptr || !matroid->solution || drawn.picture.plan.levers.empty()) return true;
  drawn.inputs = matroid->choice.joints;
  drawn.speeds = matroid->speeds;
  if (drawn.inputs.size() > kMaxDraggedInputs) return true;
  const LiveKinematics& kinematics = *drawn.snapshot->kinematics;
  for (std::size_t input = 0; input < drawn.inputs.size(); ++input) {
    std::vector<Rational> alone(drawn.inputs.size());
    alone[input] = 1;
    const auto solution = solveExact(*kinematics.model, drawn.inputs, alone, stop);
    if (!solution) return false;
    drawn.perInput.push_back(leverSpeeds(drawn.picture.plan, kinematics.placement(), solution->rates));
  }
  return true;
}

void findFreedoms(DrawnLevers& drawn, const std::stop_token& stop) {
  constexpr std::size_t kMost = 8;  // an elimination each
  if (drawn.picture.engaged.size() > kMost) return;
  for (const ShiftElementOrdinal coupling : drawn.picture.engaged) {
    if (const auto freedom = freedomWithout(*drawn.snapshot, coupling, stop))
      drawn.freedomWithout.emplace_back(coupling, *freedom);
  }
}

bool drawPage(DrawnLevers& drawn, const std::stop_token& stop) {
  const AnalysisSnapshot& snapshot = *drawn.snapshot;
  switch (drawn.page) {
    case LeversPage::levers: {
      auto picture = leverPictureOf(snapshot, stop);
      if (!picture) return false;
      drawn.picture = *std::move(picture);
      drawn.layout = leverLayout(*snapshot.mechanism, drawn.picture.plan);
      if (!findSpeedsPerInput(drawn, stop)) return false;
      findFreedoms(drawn, stop);
      return !stop.stop_requested();
    }
    case LeversPage::nomogram: {
      auto states = statesOnLevers(snapshot, stop);
      if (states) drawn.states = *std::move(states);
      return states.has_value();
    }
    case LeversPage::plan: {
      auto points = pointPlanOf(snapshot, stop);
      if (points) drawn.points = *std::move(points);
      return points.has_value();
    }
    case LeversPage::speedPlan: {
      auto plan = speedPlanFor(snapshot, stop);
      if (!plan) return false;
      drawn.speedPlan = *std::move(plan);
      if (drawn.speedPlan.absence == SpeedPlanAbsence::none)
        drawn.section = schematicGeometry(*snapshot.geometry, stop);
      return !stop.stop_requested();
    }
  }
  return false;
}

void makePage(const LeversRequest& request, const LeversService::Responder& respond) {
  DrawnLevers drawn;
  drawn.snapshot = request.snapshot;
  drawn.page = request.page;
  if (drawPage(drawn, respond.stop())) respond(std::make_shared<const DrawnLevers>(std::move(drawn)));
}

}  // namespace

LeversService::LeversService(QObject* parent) : Service(&makePage, parent, {.same = &isSamePage}) {}

}  // namespace geargraph
