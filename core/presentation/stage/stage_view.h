#pragma once

#include <optional>
#include <set>
#include <span>
#include <vector>

#include "core/presentation/painting/renderer.h"
#include "core/presentation/stage/input_trajectory.h"
#include "core/presentation/stage/stage.h"
#include "core/presentation/stage/stage_forces.h"
#include "core/presentation/stage/stage_lines.h"
#include "core/presentation/stage/traced_path.h"

namespace geargraph::inline stage {

/// A cut across the train: square to x, y or z, so far along it.
struct SectionChoice {
  int axis = 1;           ///< 0 x, 1 y, 2 z
  double place = 0.5;     ///< 0..1 through the scene
  bool isTurned = false;  ///< the other half is taken away
  friend bool operator==(const SectionChoice&, const SectionChoice&) = default;
};

/// A point of a part whose path is shown.
struct ShownTrace {
  ElementId element;
  TracedPoint point;
  TracedPath path;
};

/// What is seen of a stage, and how: all that the 3D view can show but what the pointer lights up. A value,
/// so that a picture can be painted of what the view showed when it was asked for.
struct StageView {
  Camera camera = Camera::home();
  Look look = Look::light();
  double time = 0;  ///< s: the inputs run at their speeds
  /// Moves the inputs instead of their speeds; null, or of another number of inputs: nothing does.
  InputTrajectoryPtr trajectory;
  std::vector<double> turned;  ///< rad that hands have added to the inputs; empty: none
  std::optional<SectionChoice> section;
  double pulledApart = 0;  ///< 0..1: the exploded view
  MarkChoice marks;
  std::optional<ElementId> ridden;  ///< the link that stands still; none: the ground
  std::set<ElementId> hidden;       ///< links
  std::vector<ShownTrace> traces;
  StageForces forces;  ///< shown where the marks want them; null: there are none
};

/// Angles of the inputs at the view's time; empty where the stage does not move.
[[nodiscard]] std::vector<double> inputAngles(const Stage& stage, const StageView& view);
/// Their speeds then, rad/s; empty where the stage does not move.
[[nodiscard]] std::vector<double> inputSpeeds(const Stage& stage, const StageView& view);
/// What moves the inputs of the stage in this view; null: their speeds.
[[nodiscard]] const InputTrajectory* trajectoryOf(const Stage& stage, const StageView& view);

/// The first instance of a link; none where it has no part.
[[nodiscard]] std::optional<std::size_t> instanceOf(const Stage& stage, const std::optional<ElementId>& link);

/// Where everything is seen.
struct SeenPoses {
  std::vector<Pose> poses;         ///< by instance
  Pose ground = Pose::Identity();  ///< of the base frame
};

/// The poses of the view's moment, seen from the ridden link, pulled apart by a part of `separations`
/// (separations(stage); needed only where the view pulls apart).
[[nodiscard]] SeenPoses seenPoses(const Stage& stage, const StageView& view,
                                  std::span<const Eigen::Vector3d> separations);

/// The plane of the view's section through the scene in these poses; none where there is nothing to cut.
[[nodiscard]] std::optional<CutPlane> cutPlane(const Bounds& bounds, std::span<const Pose> poses,
                                               const std::optional<SectionChoice>& section);

/// Where the floor is: below the scene's own poses, pulled apart as the view wants it.
[[nodiscard]] std::optional<double> floorOf(const Scene& scene, std::span<const Eigen::Vector3d> separations,
                                            double part);

/// The arrows of the view's forces; empty where it shows none.
[[nodiscard]] std::vector<ForceArrow> seenForces(const Stage& stage, const StageView& view,
                                                 const SeenPoses& seen);

/// The lines of the view: its marks, and the traces that were drawn from where it is seen. Marks beyond the
/// cut are left out.
[[nodiscard]] std::vector<MarkLine> seenLines(const Stage& stage, const StageView& view,
                                              const SeenPoses& seen, const std::optional<CutPlane>& cut);

/// A view made ready for a renderer. It refers to the stage.
class SeenStage {
 public:
  explicit SeenStage(StagePtr stage);

  [[nodiscard]] const Stage& stage() const { return *m_stage; }
  [[nodiscard]] const std::vector<Pose>& poses() const { return m_seen.poses; }
  [[nodiscard]] std::span<const Showing> showing() const { return m_showing; }
  [[nodiscard]] std::vector<ForceArrow> forceArrows() const { return seenForces(*m_stage, m_view, m_seen); }
  [[nodiscard]] const StageView& view() const { return m_view; }
  [[nodiscard]] std::optional<CutPlane> cut() const {
    return cutPlane(m_bounds, m_seen.poses, m_view.section);
  }
  /// Outlines of what is seen, for Camera::fitted. Of no use when `stop` was requested. Cost: that of
  /// solidOutlines() once, then O(instances). @pre show() was called
  [[nodiscard]] std::vector<Eigen::Vector3d> corners(const std::stop_token& stop = {});
  /// Of no use when `stop` was requested meanwhile.
  void show(const StageView& view, const std::stop_token& stop = {});
  /// Valid until the next show(). @pre show() was called
  [[nodiscard]] Frame frame(const Viewport& viewport, double pixelRatio) const;

 private:
  StagePtr m_stage;
  std::vector<Eigen::Vector3d> m_separations;  ///< empty until a view pulls apart
  std::shared_ptr<const SolidOutlines> m_outlines;
  Bounds m_bounds;
  std::optional<double> m_floor;
  StageView m_view;
  SeenPoses m_seen;
  std::vector<Showing> m_showing;
  std::vector<MarkLine> m_lines;
};

}  // namespace geargraph::inline stage
