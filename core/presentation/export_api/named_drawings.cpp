#include "core/presentation/export_api/named_drawings.h"

#include <array>

#include "core/foundations/base/translation.h"
#include "core/presentation/diagrams/lever_drawing.h"
#include "core/presentation/diagrams/motor_range_drawing.h"
#include "core/presentation/diagrams/nomogram.h"
#include "core/presentation/diagrams/point_plan.h"
#include "core/presentation/diagrams/power_drawing.h"
#include "core/presentation/diagrams/spectrum.h"
#include "core/presentation/diagrams/speed_plan_drawing.h"
#include "core/presentation/drawing/captions.h"
#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/layout.h"
#include "core/presentation/drawing/tt_graph_drawing.h"
#include "core/presentation/drawing/tt_graph_layout.h"
#include "core/presentation/export_api/levers_json.h"
#include "core/presentation/result_json/vibration_report.h"
#include "core/presentation/schematic/schematic.h"

namespace geargraph {
namespace {

DisplayList digraph(const AnalysisSnapshot& snapshot, const DrawnPower* power,
                    const std::stop_token& /*stop*/) {
  const Mechanism& mechanism = *snapshot.mechanism;
  const DigraphGeometry geometry = digraphGeometry(mechanism, completedPositions(mechanism));
  DisplayList drawing = digraphDrawing(geometry, {});
  if (power == nullptr) return drawing;
  DisplayList under = digraphPower(power->picture, mechanism, geometry);
  under.append(digraphTorques(power->torques, geometry, under));
  under.append(std::move(drawing));
  return under;
}

DisplayList ttGraph(const AnalysisSnapshot& snapshot, const DrawnPower* /*power*/,
                    const std::stop_token& /*stop*/) {
  const TtGraph* graph = snapshot.kinematics ? snapshot.kinematics->ttGraph.get() : nullptr;
  const NodePositions places =
      ttPositions(ttLayout(*snapshot.mechanism, graph), snapshot.mechanism->view.ttNodes);
  return ttGraphDrawing(ttGraphGeometry(*snapshot.mechanism, graph, places), {});
}

DisplayList schematic(const AnalysisSnapshot& snapshot, const DrawnPower* power,
                      const std::stop_token& stop) {
  const SchematicGeometry geometry = schematicGeometry(*snapshot.geometry, stop);
  DisplayList drawing = schematicDrawing(geometry, {});
  if (power == nullptr) return drawing;
  DisplayList under = schematicPower(power->picture, *snapshot.mechanism, geometry);
  under.append(schematicTorques(power->torques, geometry, under));
  under.append(std::move(drawing));
  return under;
}

DisplayList levers(const AnalysisSnapshot& snapshot, const DrawnPower* /*power*/,
                   const std::stop_token& stop) {
  const auto picture = leverPictureOf(snapshot, stop);
  return picture ? leverDrawing(*snapshot.mechanism, *picture, {}) : DisplayList();
}

DisplayList nomogram(const AnalysisSnapshot& snapshot, const DrawnPower* /*power*/,
                     const std::stop_token& stop) {
  const Mechanism& mechanism = *snapshot.mechanism;
  const auto found = statesOnLevers(snapshot, stop);
  if (!found) return {};
  if (found->plan.mainAxis < 0) return nomogramDrawing(mechanism, found->plan, {}, {}, {}, {});
  return nomogramDrawing(mechanism, found->plan, snapshot.kinematics->placement(), found->states,
                         found->current, {});
}

DisplayList plan(const AnalysisSnapshot& snapshot, const DrawnPower* /*power*/, const std::stop_token& stop) {
  const auto points = pointPlanOf(snapshot, stop);
  return points ? pointPlanDrawing(*snapshot.mechanism, *points, {}) : DisplayList();
}

DisplayList kutzbach(const AnalysisSnapshot& snapshot, const DrawnPower* /*power*/,
                     const std::stop_token& stop) {
  const auto plan = speedPlanFor(snapshot, stop);
  if (!plan) return {};
  static const Placement kNowhere{};
  const bool hasPlan = plan->absence == SpeedPlanAbsence::none;
  return speedPlanDrawing(*snapshot.mechanism, hasPlan ? snapshot.kinematics->placement() : kNowhere, *plan,
                          hasPlan ? schematicGeometry(*snapshot.geometry, stop) : SchematicGeometry(), {});
}

DisplayList spectrum(const AnalysisSnapshot& snapshot, const DrawnPower* /*power*/,
                     const std::stop_token& stop) {
  const auto found = frequenciesAsEngaged(snapshot, {}, stop);
  if (!found) return {};
  const Mechanism& mechanism = *snapshot.mechanism;
  const std::string title = found->reference ? translated("cycles for a turn of the shaft (%1)",
                                                          {referenceText(mechanism, *found->reference)})
                                             : std::string();
  return spectrumDrawing(mechanism, found->lines, title, absenceText(mechanism, *found));
}

/// The range of the first two motors.
DisplayList motors(const AnalysisSnapshot& snapshot, const DrawnPower* /*power*/,
                   const std::stop_token& stop) {
  const MatroidAnalysis* matroid = snapshot.matroid();
  if (matroid == nullptr || !matroid->solution)
    return motorRangeAbsence(translated("Nothing moves that limits could stop."));
  if (matroid->choice.joints.size() < 2) return motorRangeAbsence(translated("There are not two motors."));
  const auto exact = solveExact(*snapshot.kinematics->model, matroid->choice.joints, matroid->speeds, stop);
  if (!exact) return {};
  if (exact->matrix.empty() && !exact->outputs.empty())
    return motorRangeAbsence(translated("The mechanism is too large for exact limits."));
  const auto range =
      motorRange(*snapshot.mechanism, *exact, JointOrdinal(exact->inputs[0]), JointOrdinal(exact->inputs[1]));
  if (!range) return motorRangeAbsence(translated("The mechanism is too large for exact limits."));
  return motorRangeDrawing(*snapshot.mechanism, *range);
}

constexpr std::array kDrawings = {NamedDrawing{"digraph", digraph, true, kGraphNameSize},
                                  NamedDrawing{"ttgraph", ttGraph, false, kGraphNameSize},
                                  NamedDrawing{"schematic", schematic, true, 0.0},
                                  NamedDrawing{"levers", levers, false},
                                  NamedDrawing{"nomogram", nomogram, false},
                                  NamedDrawing{"plan", plan, false},
                                  NamedDrawing{"kutzbach", kutzbach, false},
                                  NamedDrawing{"spectrum", spectrum, false},
                                  NamedDrawing{"motors", motors, false}};

}  // namespace

std::span<const NamedDrawing> drawings() {
  return kDrawings;
}

const NamedDrawing* drawingNamed(std::string_view name) {
  for (const NamedDrawing& drawing : kDrawings) {
    if (drawing.name == name) return &drawing;
  }
  return nullptr;
}

std::string drawingNames() {
  std::string names;
  for (const NamedDrawing& drawing : kDrawings)
    names += (names.empty() ? "" : ", ") + std::string(drawing.name);
  return names;
}

}  // namespace geargraph
