#include "core/design/collision/collision_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/design/collision/collision_shape.h"
#include "core/foundations/base/contract.h"
#include "core/machine/body_layout/body_recipe.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/part_solids.h"

namespace geargraph {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d asVector(const Float3& position) {
  return {position[0], position[1], position[2]};
}

TurningLine axisOf(const Eigen::Isometry3d& frame) {
  return {frame.translation(), frame.linear().col(2)};
}

/// The solid that the tips of a wheel sweep, in the wheel's frame.
Solid sweptWheel(const GearSpec& spec) {
  return revolved(wheelOutline(spec), kCollisionTolerance * toothSize(spec));
}

bool isRevolved(const BodyPart& part) {
  return std::holds_alternative<TubePart>(part.shape) || std::holds_alternative<RevolvedPart>(part.shape);
}

/// The distance of the origin from a triangle of the plane.
double distanceFromOrigin(const std::array<Vector2d, 3>& corners) {
  double nearest = 1e300;
  int left = 0;
  int right = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector2d& a = corners.at(i);
    const Vector2d side = corners.at((i + 1) % 3) - a;
    const double length = side.squaredNorm();
    const double place = length > 0 ? std::clamp(-a.dot(side) / length, 0.0, 1.0) : 0;
    nearest = std::min(nearest, (a + place * side).norm());
    const double turn = side.x() * -a.y() - side.y() * -a.x();
    (turn >= 0 ? left : right) += 1;
  }
  const bool isInside = left == 3 || right == 3;
  return isInside ? 0 : nearest;
}

}  // namespace

CollisionShape::CollisionShape(const Solid& solid) : m_model(std::make_unique<Model>()) {
  GEARGRAPH_REQUIRE(!solid.triangles.empty());
  std::vector<Vector3d> points;
  points.reserve(solid.positions.size());
  for (const Float3& position : solid.positions) points.push_back(asVector(position));
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(solid.triangles.size());
  for (const Triangle& t : solid.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  m_model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size()));
  m_model->addSubModel(points, triangles);
  m_model->endModel();
  m_model->computeLocalAABB();
}

CollisionPart collisionPart(LinkOrdinal link, const Solid& solid, double module,
                            const std::optional<TurningLine>& revolvedAbout) {
  CollisionPart part;
  part.link = link;
  part.module = module;
  part.revolvedAbout = revolvedAbout;
  auto shape = std::make_shared<const CollisionShape>(solid);
  part.centre = shape->model().aabb_center;
  part.shape = std::move(shape);
  part.radius = reachFrom(part, part.centre);
  return part;
}

std::vector<CollisionPart> collisionParts(const GearTrain& train, const std::stop_token& stop) {
  std::vector<CollisionPart> parts;
  for (const TrainGear& gear : train.gears) {
    if (stop.stop_requested()) return parts;
    parts.push_back(collisionPart(gear.link, moved(sweptWheel(gear.spec), gear.pose), toothSize(gear.spec),
                                  axisOf(gear.pose)));
  }
  for (const LinkBody& body : train.bodies) {
    for (const BodyPart& part : *body.recipe) {
      if (stop.stop_requested()) return parts;
      const auto axis = isRevolved(part) ? std::optional(axisOf(part.placed)) : std::nullopt;
      parts.push_back(collisionPart(body.link, madeBy({part}, kCollisionTolerance), part.module, axis));
    }
  }
  return parts;
}

AxialExtent axialExtent(const CollisionPart& part, const TurningLine& line) {
  const CollisionShape::Model& model = part.shape->model();
  AxialExtent extent{1e300, 0, 1e300, -1e300};
  const Eigen::Isometry3d inverse = frameAlong(line.point, line.direction).inverse();
  std::vector<Vector2d> across(static_cast<std::size_t>(model.num_vertices));
  for (std::size_t i = 0; i < across.size(); ++i) {
    const Vector3d p = inverse * model.vertices[i];
    across[i] = p.head<2>();
    extent.outer = std::max(extent.outer, across[i].norm());
    extent.low = std::min(extent.low, p.z());
    extent.high = std::max(extent.high, p.z());
  }
  for (int i = 0; i < model.num_tris; ++i) {
    const fcl::Triangle& t = model.tri_indices[i];
    extent.inner = std::min(extent.inner, distanceFromOrigin({across[t[0]], across[t[1]], across[t[2]]}));
  }
  return extent;
}

double reachFrom(const CollisionPart& part, const Vector3d& point) {
  const CollisionShape::Model& model = part.shape->model();
  double reach = 0;
  for (int i = 0; i < model.num_vertices; ++i) reach = std::max(reach, (model.vertices[i] - point).norm());
  return reach;
}

}  // namespace geargraph
