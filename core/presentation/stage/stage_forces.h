#pragma once

#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/presentation/painting/look.h"
#include "core/presentation/painting/mark_line.h"
#include "core/presentation/stage/label_anchors.h"
#include "core/presentation/stage/stage.h"

namespace geargraph::inline stage {

enum class ForceKind : std::uint8_t { tooth, bearing };

/// A force on a part, shown as an arrow. It belongs to the reference pose, and moves with its link.
struct StageForce {
  ForceKind kind = ForceKind::tooth;
  ElementId element;               ///< the mesh or joint
  std::string text;                ///< "mesh 9: 443 N"
  Eigen::Vector3d point{0, 0, 0};  ///< where it acts at the scene's own poses, mm, base frame
  Eigen::Vector3d force{0, 0, 0};  ///< N, base frame
  std::optional<ElementId> link;   ///< that it moves with; none: the ground
};
using StageForces = std::shared_ptr<const std::vector<StageForce>>;

/// An arrow as it is seen: it begins where its force acts.
struct ForceArrow {
  std::size_t force = 0;  ///< position in the list
  Eigen::Vector3d from{0, 0, 0};
  Eigen::Vector3d to{0, 0, 0};
};

/// The greatest force is as long as a third of the scene's radius, the others in proportion; what is below a
/// thousandth of it is left out. `ground`: where the base frame is seen. Cost: O(forces + instances).
[[nodiscard]] std::vector<ForceArrow> forceArrows(const Stage& stage, std::span<const StageForce> forces,
                                                  std::span<const Pose> poses, const Pose& ground);

/// Tooth forces in the look's ink, bearing reactions in accent, cased in the colour of the sheet.
void addForceLines(std::span<const StageForce> forces, std::span<const ForceArrow> arrows, const Look& look,
                   std::vector<MarkLine>& lines);
[[nodiscard]] Rgb forceColour(ForceKind kind, const Look& look);

/// What the arrows of this colour are, for a legend.
[[nodiscard]] std::string_view forceLegend(ForceKind kind);

/// The box of a label in the picture, in logical pixels; a line leads from the tip of its arrow to it.
struct ForceLabel {
  std::size_t force = 0;
  Eigen::Vector2d middle{0, 0};
  Eigen::Vector2d half{0, 0};
  Eigen::Vector2d tip{0, 0};
};

constexpr std::size_t kMostForceLabels = 6;

/// Labels of the greatest forces, and of those whose elements are in `lit`: beside the tips of their arrows,
/// clear of all arrows and of each other; one without room is left out. `widthOf`: px of a text.
/// Cost: O(labels * arrows).
[[nodiscard]] std::vector<ForceLabel> placeForceLabels(
    std::span<const StageForce> forces, std::span<const ForceArrow> arrows, const std::set<ElementId>& lit,
    const LabelGround& ground, const std::function<double(const std::string&)>& widthOf);

}  // namespace geargraph::inline stage
