#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/presentation/scene/mark_line.h"
#include "core/presentation/scene/renderer.h"
#include "core/presentation/scene3d/stage.h"

namespace geargraph {

/// The geometry and motion marks shown in addition to the solids.
struct MarkChoice {
  bool pitchCircles = false;  ///< for bevels also the pitch cones
  bool pitchPoints = false;
  bool axes = false;
  bool instantAxes = false;  ///< of links relative to the watcher, and of meshing wheels to each other
  bool velocities = false;   ///< arrows at pitch points and middles of wheels
  bool forces = false;       ///< tooth forces and bearing reactions under the loads (stage_forces.h)
  friend bool operator==(const MarkChoice&, const MarkChoice&) = default;
};

/// The stage at an instant, in the frame of the watcher.
struct Moment {
  std::span<const Pose> poses;     ///< by instance, as displayed
  std::span<const double> angles;  ///< of the inputs
  std::span<const double> speeds;
  Pose ground = Pose::Identity();  ///< displayed pose of the base frame
  std::optional<std::size_t>
      watcher;                       ///< an instance of the link that motion is relative to; none: the ground
  Rgb ink;                           ///< of geometry
  Rgb motion;                        ///< of arrows
  std::optional<CutPlane> cut = {};  ///< everything beyond it is removed, with its circles and arrows
};

/// The lines of the chosen marks. The longest arrow is a third of the scene's radius, the others in
/// proportion.
/// Cost: O(instances + marks).
[[nodiscard]] std::vector<MarkLine> stageLines(const MechanismScene& stage, const MarkChoice& choice,
                                               const Moment& moment);

}  // namespace geargraph
