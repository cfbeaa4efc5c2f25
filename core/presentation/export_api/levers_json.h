#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/presentation/diagrams/lever_picture.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/levers/speed_plan.h"

namespace geargraph {

/// The levers of an analysed train, with the speeds of its inputs and the torques without losses: under the
/// document's loads, or in an engaged state under the torque at its drive (driveTorqueOf()). It is all that
/// is drawn of them. Of a train that is not finished the plan says so. std::nullopt if `stop` was requested.
/// Cost: leverPlanOf(), an exact solution, and under loads analyzeStatics().
[[nodiscard]] std::optional<LeverPicture> leverPictureOf(const AnalysisSnapshot& snapshot,
                                                         const std::stop_token& stop = {});

/// The plan that is left when the coupling engaged last is let go; without engaged couplings that of the
/// train. std::nullopt if `stop` was requested.
[[nodiscard]] std::optional<LeverPlan> pointPlanOf(const AnalysisSnapshot& snapshot,
                                                   const std::stop_token& stop = {});

/// Kutzbach's speed plan with the speeds of the inputs. std::nullopt if `stop` was requested.
/// Cost: an exact solution where the snapshot has none yet.
[[nodiscard]] std::optional<SpeedPlan> speedPlanFor(const AnalysisSnapshot& snapshot,
                                                    const std::stop_token& stop = {});

/// The freedom of the train when this coupling is let go and the others stay engaged. std::nullopt if `stop`
/// was requested, or the train has no plan. Cost: leverPlanOf().
[[nodiscard]] std::optional<int> freedomWithout(const AnalysisSnapshot& snapshot,
                                                ShiftElementOrdinal coupling,
                                                const std::stop_token& stop = {});

/// What a nomogram is drawn of: the plan of the meshes, and all states, whatever the document engages.
struct StatesOnLevers {
  LeverPlan plan;
  std::vector<StateSolution> states;
  std::optional<int> current;  ///< shownState()
};
/// Of a train that is not finished the plan says so. std::nullopt if `stop` was requested.
/// Cost: leverPlanOf(), and solveStates() where the snapshot has no states yet.
[[nodiscard]] std::optional<StatesOnLevers> statesOnLevers(const AnalysisSnapshot& snapshot,
                                                           const std::stop_token& stop = {});

/// The position of the state that engages what the document engages; none where nothing is engaged.
[[nodiscard]] std::optional<int> shownState(const Mechanism& mechanism);

/// `levers --json`. `snapshot` and `picture`: null where the file could not be read.
[[nodiscard]] std::string leversJson(const AnalysisSnapshot* snapshot, const LeverPicture* picture);

}  // namespace geargraph
