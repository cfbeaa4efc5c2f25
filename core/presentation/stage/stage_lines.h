#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/presentation/painting/mark_line.h"
#include "core/presentation/painting/renderer.h"
#include "core/presentation/stage/stage.h"

namespace geargraph::inline stage {

/// What is shown of the geometry and of the motion beside the solids.
struct MarkChoice {
  bool pitchCircles = false;  ///< of bevels the pitch cones too
  bool pitchPoints = false;
  bool axes = false;
  bool instantAxes = false;  ///< of every link against the watcher, and of meshing wheels against each other
  bool velocities = false;   ///< arrows at pitch points and middles of wheels
  bool forces = false;       ///< tooth forces and bearing reactions under the loads (stage_forces.h)
  friend bool operator==(const MarkChoice&, const MarkChoice&) = default;
};

/// The stage at a moment, as it is watched.
struct Moment {
  std::span<const Pose> poses;     ///< by instance, as they are seen
  std::span<const double> angles;  ///< of the inputs
  std::span<const double> speeds;
  Pose ground = Pose::Identity();  ///< where the base frame is seen
  std::optional<std::size_t>
      watcher;                       ///< an instance of the link that motion is relative to; none: the ground
  Rgb ink;                           ///< of geometry
  Rgb motion;                        ///< of arrows
  std::optional<CutPlane> cut = {};  ///< what lies beyond it is taken away, and so are its circles and arrows
};

/// The lines of the choice. The longest arrow is a third of the scene's radius, the others in proportion.
/// Cost: O(instances + marks).
[[nodiscard]] std::vector<MarkLine> stageLines(const Stage& stage, const MarkChoice& choice,
                                               const Moment& moment);

}  // namespace geargraph::inline stage
