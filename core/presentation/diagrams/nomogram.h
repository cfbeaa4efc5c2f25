#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/mechanism/placement/placement.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/theory/levers/lever_plan.h"
#include "core/theory/states/state_solution.h"

namespace geargraph {

/// A nomogram and where its states are.
struct NomogramSheet {
  /// The line of a state on one lever.
  struct Line {
    int state = 0;  ///< position in the document
    CanvasPoint from;
    CanvasPoint to;
  };
  /// The tag of the states that share a place.
  struct Tag {
    std::vector<int> states;
    Extent box;
  };
  DisplayList drawing;
  std::vector<Line> lines;
  std::vector<Tag> tags;
  std::string missing;  ///< why there is no line, as a sentence, which is then all of the drawing
};

/// nomogramDrawing() with the places of its states.
[[nodiscard]] NomogramSheet nomogramSheet(const Mechanism& mechanism, const LeverPlan& plan,
                                          const Placement& placement, std::span<const StateSolution> states,
                                          std::optional<int> current, const Emphases& emphases);

/// The shift table as one picture: for each lever an axis a link, at exact distances, and a line a state
/// through the links' speeds, those of the drive being 1. A coupling is a letter at the speed of its other
/// side, where that is the same in all states that engage it: all their lines pass through it. States are
/// tagged on the axis of the driven link. `current`: the position of the state that stands out.
///
/// States without speeds (locked, free) and lines of links that idle are left out; where nothing is left a
/// sentence says what is missing. Cost: states times points.
/// @pre all of one mechanism; the plan is leverPlanOf() without held rows
[[nodiscard]] DisplayList nomogramDrawing(const Mechanism& mechanism, const LeverPlan& plan,
                                          const Placement& placement, std::span<const StateSolution> states,
                                          std::optional<int> current, const Emphases& emphases);

}  // namespace geargraph
