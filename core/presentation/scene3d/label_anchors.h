#pragma once

#include <map>
#include <span>
#include <vector>

#include "core/presentation/scene/camera.h"
#include "core/presentation/scene/renderer.h"
#include "core/presentation/scene/seen_map.h"
#include "core/presentation/scene3d/stage.h"

namespace geargraph {

/// Half the size of a label's plate, in logical pixels.
constexpr double kLabelRadius = 11.5;

/// The picture for which labels are placed.
struct LabelGround {
  const MechanismScene& stage;
  std::span<const Pose> poses;
  std::span<const Visibility> visibility;  ///< empty: everything
  const Camera& camera;
  const Viewport& viewport;
  double pixelRatio = 1;
  const VisibilityBuffer* seen = nullptr;  ///< what is visible in the picture; null: no new map
  double above = 0, below = 0;  ///< logical pixels at the top and bottom that labels of forces keep free

  /// The same with logical pixels that are `scale` times as large.
  [[nodiscard]] LabelGround enlarged(double scale) const {
    return {stage, poses,         visibility,   camera, viewport, pixelRatio * scale,
            seen,  above / scale, below / scale};
  }
  [[nodiscard]] bool isShown(const SceneLabel& label) const {
    return visibility.empty() || visibility[label.instance] == Visibility::solid;
  }
  /// Logical pixels.
  [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& point) const {
    const ScreenPoint at = camera.project(point, viewport);
    return {at.x / pixelRatio, at.y / pixelRatio};
  }
  [[nodiscard]] Eigen::Vector3d middleOf(const SceneLabel& label) const {
    return poses[label.instance] * label.place;
  }
};

/// The size of the grid of a VisibilityBuffer for label placement.
[[nodiscard]] Viewport labelCells(const Viewport& viewport, double pixelRatio);

/// The place of a link's label: on the visible part of the link, or beside it with a leader line.
struct LabelAnchor {
  Eigen::Vector3d off{0, 0, 0};  ///< mm in the world, from the middle of the part; does not turn with it
  Eigen::Vector2d away{0, 0};    ///< logical pixels from there to the plate
};

/// The anchors of links' labels: in the middle of the visible part of a link, so that a number is never on
/// another part. An anchor stays while its link is well visible there, so that labels of turning parts do not
/// wander.
class LabelAnchors {
 public:
  /// @pre the ground has a map Cost: the map's cells; for parts that are narrower than a plate, as many
  /// places as there are round them.
  void renew(const LabelGround& ground);
  void reset() { *this = {}; }
  [[nodiscard]] bool areNew() const { return m_areNew; }
  /// Null if nothing of the link is visible.
  [[nodiscard]] const LabelAnchor* of(const ElementId& link) const {
    const auto anchor = m_anchors.find(link);
    return anchor == m_anchors.end() ? nullptr : &anchor->second;
  }

 private:
  std::map<ElementId, LabelAnchor> m_anchors;
  bool m_areNew = true;
};

}  // namespace geargraph
