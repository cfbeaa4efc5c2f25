#pragma once

#include <vector>

#include "core/foundations/base/triple.h"

namespace geargraph {

/// A disc in space. `axis` is a unit vector.
struct Disc {
  Vector3 centre{};
  Vector3 axis{};
  double radius = 0;
};

/// The convex hull of discs: two coaxial ones are a cylinder or a truncated cone, four on two parallel axes
/// an arm.
using DiscHull = std::vector<Disc>;

/// Are two hulls nearer to each other than `margin`, overlapping or touching? By the nearest point of their
/// Minkowski difference (E. G. Gilbert, D. W. Johnson, S. S. Keerthi, IEEE Journal on Robotics and Automation
/// 4(2), 1988, 193-203). Cost: about ten passes over all discs. @pre neither is empty, margin >= 0
[[nodiscard]] bool areNear(const DiscHull& a, const DiscHull& b, double margin = 0);

/// The hull turned about a line by an angle (rad). `direction` is a unit vector.
[[nodiscard]] DiscHull turned(const DiscHull& hull, const Vector3& point, const Vector3& direction,
                              double angle);

}  // namespace geargraph
