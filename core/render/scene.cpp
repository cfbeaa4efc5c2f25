#include "core/render/scene.h"

namespace geargraph {

const std::shared_ptr<const Solid>& DetailLevels::chosen(const std::shared_ptr<const Solid>& own,
                                                         double pixels) const {
  constexpr double kInvisible = 1.0 / 3;  // of a pixel
  if (far && farError * pixels <= kInvisible) return far;
  if (close && error * pixels > kInvisible) return close;
  return own;
}

std::vector<Eigen::Vector3d> cornersOf(const Scene& scene) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const auto& solid : scene.solids) boxes.push_back(boundsOf(*solid));
  std::vector<Eigen::Vector3d> corners;
  for (const Instance& instance : scene.instances) {
    const Eigen::AlignedBox3d& box = boxes[instance.solid];
    if (box.isEmpty()) continue;
    for (int corner = 0; corner < 8; ++corner) {
      corners.push_back(instance.pose * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    }
  }
  return corners;
}

Bounds boundsOf(const Scene& scene) {
  Bounds bounds;
  for (const Eigen::Vector3d& corner : cornersOf(scene)) bounds.box.extend(corner);
  return bounds;
}

}  // namespace geargraph
