#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

namespace geargraph {

/// The bounding sphere of a solid, in its own frame; radius 0 for an empty solid.
struct BoundingSphere {
  Eigen::Vector3d centre{0, 0, 0};
  double radius = 0;

  [[nodiscard]] static BoundingSphere about(const Eigen::AlignedBox3d& box) {
    return box.isEmpty() ? BoundingSphere{} : BoundingSphere{box.center(), 0.5 * box.diagonal().norm()};
  }
};

/// The six planes of the view frustum in the world, from the matrix from world to OpenGL's clip space.
class Frustum {
 public:
  explicit Frustum(const Eigen::Matrix4d& clip) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        Eigen::RowVector4d plane = clip.row(3) + side * clip.row(static_cast<Eigen::Index>(axis));
        plane /= plane.head<3>().norm();
        m_planes[2 * axis + (side > 0 ? 1 : 0)] = plane;
      }
    }
  }

  /// False only if the sphere is completely outside one of the planes.
  [[nodiscard]] bool mayShow(const Eigen::Vector3d& centre, double radius) const {
    for (const Eigen::RowVector4d& plane : m_planes) {
      if (plane.head<3>().dot(centre) + plane[3] < -radius) return false;
    }
    return true;
  }

 private:
  std::array<Eigen::RowVector4d, 6> m_planes;
};

}  // namespace geargraph
