#pragma once

#include <stop_token>
#include <string>

#include "core/foundations/files/json_writer.h"
#include "core/presentation/diagrams/lever_drawing.h"
#include "core/presentation/diagrams/nomogram.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The levers of a page, whose script draws the speeds as the inputs move, and the nomogram of the states,
/// whose script shows the state that is engaged. Empty drawings for a train that has none.
struct HandoutLevers {
  LeverPlan plan;
  LeverSheet levers;  ///< without speeds and torques, nothing engaged
  NomogramSheet nomogram;
  std::string leversSvg;
  std::string nomogramSvg;
};

/// The result is meaningless if `stop` was requested meanwhile. Cost: leverPlanOf(), and solveStates() where
/// there are states.
[[nodiscard]] HandoutLevers handoutLevers(const AnalysisSnapshot& snapshot, const std::stop_token& stop);

/// "levers": by bar its points from the top, each with the "element" of its first link, its colour, its place
/// on the sheet, and "terms", [joint, sign], whose rates add up to the link's speed. "nomogram": "lines",
/// [state, x, y, x, y], and "tags", each with its "states" and its "box", [left, top, width, height]. Nothing
/// of what is not drawn.
void writeHandoutLevers(JsonWriter& json, const AnalysisSnapshot& snapshot, const HandoutLevers& levers);

}  // namespace geargraph
