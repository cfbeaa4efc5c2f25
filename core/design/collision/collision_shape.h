#pragma once

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>

#include <memory>

#include "core/design/collision/collision_parts.h"

namespace geargraph {

class CollisionShape {
 public:
  using Model = fcl::BVHModel<fcl::OBBRSS<double>>;

  /// @pre the solid has triangles
  explicit CollisionShape(const Solid& solid);

  [[nodiscard]] const Model& model() const { return *m_model; }

 private:
  std::unique_ptr<Model> m_model;
};

}  // namespace geargraph
