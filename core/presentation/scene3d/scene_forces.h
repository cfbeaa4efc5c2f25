#pragma once

#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/presentation/scene/mark_line.h"
#include "core/presentation/scene/render_style.h"
#include "core/presentation/scene3d/label_anchors.h"
#include "core/presentation/scene3d/stage.h"

namespace geargraph {

enum class ForceKind : std::uint8_t { tooth, bearing };

/// A force on a part, shown as an arrow. It belongs to the reference pose, and moves with its link.
struct SceneForce {
  ForceKind kind = ForceKind::tooth;
  ElementId element;               ///< the mesh or joint
  std::string text;                ///< "mesh 9: 443 N"
  Eigen::Vector3d point{0, 0, 0};  ///< where it acts at the scene's own poses, mm, base frame
  Eigen::Vector3d force{0, 0, 0};  ///< N, base frame
  std::optional<ElementId> link;   ///< with which it moves; none: the ground
};
using SceneForces = std::shared_ptr<const std::vector<SceneForce>>;

/// The arrow of a force in the world as shown; it begins at the point of action.
struct ForceArrow {
  std::size_t force = 0;  ///< position in the list
  Eigen::Vector3d from{0, 0, 0};
  Eigen::Vector3d to{0, 0, 0};
};

/// The arrow of the greatest force is a third of the scene's radius long, the others in proportion; forces
/// below a thousandth of it are left out. `ground`: the displayed pose of the base frame. Cost: O(forces +
/// instances).
[[nodiscard]] std::vector<ForceArrow> forceArrows(const MechanismScene& stage,
                                                  std::span<const SceneForce> forces,
                                                  std::span<const Pose> poses, const Pose& ground);

/// Adds the arrows as lines: tooth forces in the ink colour, bearing reactions in the accent colour.
void addForceLines(std::span<const SceneForce> forces, std::span<const ForceArrow> arrows,
                   const RenderStyle& style, std::vector<MarkLine>& lines);
[[nodiscard]] Rgb forceColour(ForceKind kind, const RenderStyle& style);

/// The legend of the arrows of this kind.
[[nodiscard]] std::string_view forceLegend(ForceKind kind);

/// The box of a label in the picture, in logical pixels; a line leads from the tip of its arrow to it.
struct ForceLabel {
  std::size_t force = 0;
  Eigen::Vector2d middle{0, 0};
  Eigen::Vector2d half{0, 0};
  Eigen::Vector2d tip{0, 0};
};

constexpr std::size_t kMaxForceLabels = 6;

/// Labels of the greatest forces, and of those whose elements are in `highlighted`: beside the tips of their
/// arrows, clear of all arrows and of each other; labels without room are left out. `widthOf`: width of a
/// text, px. Cost: O(labels * arrows).
[[nodiscard]] std::vector<ForceLabel> placeForceLabels(
    std::span<const SceneForce> forces, std::span<const ForceArrow> arrows,
    const std::set<ElementId>& highlighted, const LabelGround& ground,
    const std::function<double(const std::string&)>& widthOf);

}  // namespace geargraph
