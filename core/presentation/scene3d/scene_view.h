#pragma once

#include <optional>
#include <set>
#include <span>
#include <vector>

#include "core/presentation/scene/renderer.h"
#include "core/presentation/scene3d/input_trajectory.h"
#include "core/presentation/scene3d/scene_forces.h"
#include "core/presentation/scene3d/scene_lines.h"
#include "core/presentation/scene3d/stage.h"
#include "core/presentation/scene3d/traced_path.h"

namespace geargraph {

/// A section through the train: normal to x, y or z, at a place along it.
struct SectionChoice {
  int axis = 1;           ///< 0 x, 1 y, 2 z
  double place = 0.5;     ///< 0..1 along the scene
  bool isTurned = false;  ///< the other half is removed
  friend bool operator==(const SectionChoice&, const SectionChoice&) = default;
};

/// A point of a part whose path is shown.
struct ShownTrace {
  ElementId element;
  TracedPoint point;
  TracedPath path;
};

/// The state of a 3D view of a stage, except highlights. A value, so that a picture can be painted of what
/// the view showed at the time of the request.
struct SceneView {
  Camera camera = Camera::home();
  RenderStyle style = RenderStyle::light();
  double time = 0;  ///< s: the inputs run at their speeds
  /// Moves the inputs instead of their speeds; ignored if null or for another number of inputs.
  InputTrajectoryPtr trajectory;
  std::vector<double> turned;  ///< offsets of the inputs by dragging, rad; empty: none
  std::optional<SectionChoice> section;
  double explosion = 0;  ///< 0..1: degree of the exploded view
  MarkChoice marks;
  std::optional<ElementId> referenceLink;  ///< the link that is the reference frame; none: the ground
  std::set<ElementId> hidden;              ///< links
  std::vector<ShownTrace> traces;
  SceneForces forces;  ///< shown if marks.forces; null: there are none
};

/// Angles of the inputs at the view's time, rad; empty if the stage does not move.
[[nodiscard]] std::vector<double> inputAngles(const MechanismScene& stage, const SceneView& view);
/// Speeds of the inputs at the view's time, rad/s; empty if the stage does not move.
[[nodiscard]] std::vector<double> inputSpeeds(const MechanismScene& stage, const SceneView& view);
/// The trajectory that moves the inputs in this view; null: they run at their speeds.
[[nodiscard]] const InputTrajectory* trajectoryOf(const MechanismScene& stage, const SceneView& view);

/// The first instance of a link; std::nullopt if it has none.
[[nodiscard]] std::optional<std::size_t> instanceOf(const MechanismScene& stage,
                                                    const std::optional<ElementId>& link);

/// The displayed poses.
struct SeenPoses {
  std::vector<Pose> poses;         ///< by instance
  Pose ground = Pose::Identity();  ///< of the base frame
};

/// The poses at the view's time, relative to the reference link, displaced for the exploded view by a part of
/// `offsets` (explosionOffsets(stage); needed only if view.explosion > 0).
[[nodiscard]] SeenPoses seenPoses(const MechanismScene& stage, const SceneView& view,
                                  std::span<const Eigen::Vector3d> offsets);

/// The cutting plane of a section through the scene in these poses; std::nullopt without a section.
[[nodiscard]] std::optional<CutPlane> cutPlane(const Bounds& bounds, std::span<const Pose> poses,
                                               const std::optional<SectionChoice>& section);

/// The height of the floor: below the scene's own poses with this part of the offsets.
[[nodiscard]] std::optional<double> floorOf(const Scene& scene, std::span<const Eigen::Vector3d> offsets,
                                            double part);

/// The arrows of the view's forces; empty if it shows none.
[[nodiscard]] std::vector<ForceArrow> seenForces(const MechanismScene& stage, const SceneView& view,
                                                 const SeenPoses& seen);

/// The lines of the view: its marks, and the traces whose watcher is the reference link. Marks beyond the cut
/// are left out.
[[nodiscard]] std::vector<MarkLine> seenLines(const MechanismScene& stage, const SceneView& view,
                                              const SeenPoses& seen, const std::optional<CutPlane>& cut);

/// Prepares a view for a renderer; shares ownership of the stage.
class SeenStage {
 public:
  explicit SeenStage(MechanismScenePtr stage);

  [[nodiscard]] const MechanismScene& stage() const { return *m_stage; }
  [[nodiscard]] const std::vector<Pose>& poses() const { return m_seen.poses; }
  [[nodiscard]] std::span<const Visibility> visibility() const { return m_visibility; }
  [[nodiscard]] std::vector<ForceArrow> forceArrows() const { return seenForces(*m_stage, m_view, m_seen); }
  [[nodiscard]] const SceneView& view() const { return m_view; }
  [[nodiscard]] std::optional<CutPlane> cut() const {
    return cutPlane(m_bounds, m_seen.poses, m_view.section);
  }
  /// Outlines of what is shown, for Camera::fitted(). The result is meaningless if `stop` was requested.
  /// Cost: that of solidOutlines() once, then O(instances). @pre show() was called
  [[nodiscard]] std::vector<Eigen::Vector3d> corners(const std::stop_token& stop = {});
  /// Computes poses and lines of a view. The result is meaningless if `stop` was requested meanwhile.
  void show(const SceneView& view, const std::stop_token& stop = {});
  /// Valid until the next show(). @pre show() was called
  [[nodiscard]] Frame frame(const Viewport& viewport, double pixelRatio) const;

 private:
  MechanismScenePtr m_stage;
  std::vector<Eigen::Vector3d> m_explosionOffsets;  ///< empty until a view is exploded
  std::shared_ptr<const SolidOutlines> m_outlines;
  Bounds m_bounds;
  std::optional<double> m_floor;
  SceneView m_view;
  SeenPoses m_seen;
  std::vector<Visibility> m_visibility;
  std::vector<MarkLine> m_lines;
};

}  // namespace geargraph
