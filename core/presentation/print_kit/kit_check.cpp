#include "core/presentation/print_kit/kit_check.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>

#include <algorithm>
#include <set>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Model = fcl::BVHModel<fcl::OBBRSS<double>>;

constexpr double kWay = 1.0;  // mm between two looks at a part on its way

}  // namespace

struct KitAssembly::Shape {
  Model model;
  Eigen::AlignedBox3d box;
  double radius = 0;  ///< of the ball about the middle of the box
};

KitAssembly::KitAssembly() = default;
KitAssembly::~KitAssembly() = default;

void KitAssembly::add(const KitPart& part) {
  auto shape = std::make_unique<Shape>();
  std::vector<Vector3d> points;
  for (const Float3& p : part.solid->positions) points.push_back(part.pose * Vector3d(p[0], p[1], p[2]));
  for (const Vector3d& p : points) shape->box.extend(p);
  for (const Vector3d& p : points) shape->radius = std::max(shape->radius, (p - shape->box.center()).norm());
  std::vector<fcl::Triangle> triangles;
  for (const Triangle& t : part.solid->triangles) triangles.emplace_back(t[0], t[1], t[2]);
  shape->model.beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size()));
  shape->model.addSubModel(points, triangles);
  shape->model.endModel();
  m_shapes.push_back(std::move(shape));
}

void KitAssembly::drop() {
  m_shapes.pop_back();
}

std::size_t KitAssembly::size() const {
  return m_shapes.size();
}

bool KitAssembly::overlaps(std::size_t a, std::size_t b, const Isometry3d& moved,
                           const Isometry3d& movedB) const {
  const Shape &one = *m_shapes[a], &other = *m_shapes[b];
  if ((moved * one.box.center() - movedB * other.box.center()).norm() > one.radius + other.radius)
    return false;
  const fcl::CollisionRequestd request(1, false);
  fcl::CollisionResultd result;
  fcl::detail::MeshCollisionTraversalNodeOBBRSSd node;
  const bool isReady =
      fcl::detail::initialize(node, m_shapes[a]->model, moved, m_shapes[b]->model, movedB, request, result);
  GEARGRAPH_REQUIRE(isReady);
  fcl::detail::collide(&node);
  return result.isCollision();
}

std::optional<std::pair<std::size_t, std::size_t>> KitAssembly::overlap(const std::stop_token& stop) const {
  for (std::size_t a = 0; a < m_shapes.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (stop.stop_requested()) return std::nullopt;
      if (m_shapes[a]->box.intersects(m_shapes[b]->box) && overlaps(a, b)) return std::pair(b, a);
    }
  }
  return std::nullopt;
}

std::vector<KitStep> KitAssembly::order(std::span<const KitPart> parts, std::span<const Vector3d> directions,
                                        const std::stop_token& stop) const {
  std::vector<bool> isIn(m_shapes.size(), true);
  Eigen::AlignedBox3d whole;
  for (const auto& shape : m_shapes) whole.extend(shape->box);
  const double far = whole.diagonal().norm();
  // Can the parts leave along the direction, past those that are still in?
  const auto leaves = [&](const std::vector<std::size_t>& group, const Vector3d& way) {
    for (const std::size_t part : group) {
      if (stop.stop_requested()) return false;
      Eigen::AlignedBox3d swept = m_shapes[part]->box;
      swept.extend(swept.translated(far * way));
      for (std::size_t other = 0; other < m_shapes.size(); ++other) {
        if (!isIn[other] || std::find(group.begin(), group.end(), other) != group.end()) continue;
        if (!swept.intersects(m_shapes[other]->box)) continue;
        for (double at = kWay / 4; at < far; at += at < 3 * kWay ? kWay / 4 : kWay) {
          const Eigen::AlignedBox3d box = m_shapes[part]->box.translated(at * way);
          if (!box.intersects(m_shapes[other]->box)) {
            if (way.dot(box.center() - m_shapes[other]->box.center()) > 0) break;  // it is past
            continue;
          }
          Isometry3d moved = Isometry3d::Identity();
          moved.translation() = at * way;
          if (overlaps(part, other, moved)) return false;
        }
      }
    }
    return true;
  };
  std::vector<KitStep> taken;
  std::size_t left = m_shapes.size();
  const auto take = [&](std::vector<std::size_t> group, const Vector3d& way, bool isFree) {
    for (const std::size_t part : group) isIn[part] = false;
    left -= group.size();
    taken.push_back({std::move(group), Vector3d::Zero() - way, isFree});
  };
  // What begins highest above the base leaves first.
  std::vector<std::size_t> byHeight(m_shapes.size());
  std::vector<double> heights;
  for (std::size_t p = 0; p < m_shapes.size(); ++p) {
    byHeight[p] = p;
    const Eigen::AlignedBox3d& box = m_shapes[p]->box;
    const Vector3d& up = directions.front();
    heights.push_back(up.dot(box.center()) - up.cwiseAbs().dot(box.sizes()) / 2);
  }
  std::stable_sort(byHeight.begin(), byHeight.end(),
                   [&](std::size_t a, std::size_t b) { return heights[a] > heights[b]; });
  while (left > 1 && !stop.stop_requested()) {
    bool isTaken = false;
    for (const std::size_t p : byHeight) {
      if (isTaken) break;
      if (!isIn[p]) continue;
      for (const Vector3d& way : directions) {
        if (!leaves({p}, way)) continue;
        take({p}, way, true);
        isTaken = true;
        break;
      }
    }
    std::set<int> links;
    for (std::size_t p = 0; p < m_shapes.size(); ++p) {
      if (isIn[p]) links.insert(parts[p].link);
    }
    for (auto link = links.rbegin(); link != links.rend() && !isTaken; ++link) {
      std::vector<std::size_t> group;
      for (std::size_t p = 0; p < m_shapes.size(); ++p) {
        if (isIn[p] && int{parts[p].link} == *link) group.push_back(p);
      }
      if (group.size() == left) continue;
      for (const Vector3d& way : directions) {
        if (!leaves(group, way)) continue;
        take(std::move(group), way, true);
        isTaken = true;
        break;
      }
    }
    if (isTaken) continue;
    for (const std::size_t p : byHeight) {
      if (isTaken) break;
      if (!isIn[p]) continue;
      take({p}, directions.front(), false);
      isTaken = true;
    }
  }
  for (std::size_t p = 0; p < m_shapes.size(); ++p) {
    if (isIn[p]) taken.push_back({{p}, Vector3d::Zero(), true});
  }
  std::reverse(taken.begin(), taken.end());
  return taken;
}

}  // namespace geargraph
