#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/graph/matrices.h"
#include "core/placement/placement.h"

namespace geargraph {

/// How all joints turn with the inputs: theta = K theta_E, exact for any number of turns because K is
/// constant.
struct JointMotion {
  std::vector<int> inputs;     ///< joints, in column order
  std::vector<double> speeds;  ///< rad/s, one an input
  std::vector<double> gains;   ///< K row by row: joints x inputs; the rows of inputs are unit rows
  double period = 0;  ///< s until every joint is where it was; 0 where nothing turns, or it is not known

  /// Fills the angle of every joint. @pre one angle an input, one place a joint
  void angles(std::span<const double> inputAngles, std::span<double> jointAngles) const;
};

/// By the matroid method: for the document's inputs, or the set that the program chooses where it names none.
/// Nothing where the inputs are not valid, nothing can move, or a mesh has no geometry.
/// Cost: that of the live solution and, for mechanisms of up to some hundred links, of the exact one.
/// @pre graph, tree and placement are the mechanism's
[[nodiscard]] std::optional<JointMotion> jointMotion(const Mechanism& mechanism, const DigraphPtr& graph,
                                                     const SpanningTreePtr& tree, const Placement& placement);

}  // namespace geargraph
