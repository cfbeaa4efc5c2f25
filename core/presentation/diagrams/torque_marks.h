#pragma once

#include <string>
#include <vector>

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/schematic/schematic.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// An external torque or force shown in a drawing: a given load, or a balance that was found.
struct ShownTorque {
  ElementId element;  ///< the joint or the link
  bool isGiven = true;
  int sense = 0;       ///< sign of the torque; 0 for a force, or if the torque is not determined
  std::string torque;  ///< "T 10 N m", "F 20 N", "T shared"
  std::string rate;    ///< "100 rad/s", "100 rad/s · found"; empty for a load without a motion
  std::string tip;     ///< tooltip of a balance, in the current language: what it holds, and its power
};

/// Loads first, in the document's order, then balances; balances of 0 are left out. Cost: O(loads + balances)
/// @pre both of one mechanism
[[nodiscard]] std::vector<ShownTorque> shownTorques(const Mechanism& mechanism, const StaticsReport& report);

/// Chips near their elements, each with an arc in the direction of its torque and a line to its element:
/// amber for loads; dashed and with a disc, the symbol of a motor, for balances. They keep clear of the
/// drawing and of `under`, the marks below it.
[[nodiscard]] DisplayList digraphTorques(const std::vector<ShownTorque>& torques,
                                         const DigraphGeometry& geometry, const DisplayList& under);
[[nodiscard]] DisplayList schematicTorques(const std::vector<ShownTorque>& torques,
                                           const SchematicGeometry& geometry, const DisplayList& under);

}  // namespace geargraph
