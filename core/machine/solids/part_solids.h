#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <span>
#include <vector>

#include "core/machine/solids/shell_builder.h"
#include "core/machine/solids/solid.h"

namespace geargraph {

/// The frame at `origin` with z along `axis` (unit vector) and x as near to `towards` as possible.
[[nodiscard]] Eigen::Isometry3d frameAlong(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis,
                                           const Eigen::Vector3d& towards = Eigen::Vector3d::UnitX());

/// A solid of revolution about z. The profile has the material on the left (from the top face inward, down
/// the bore, outward along the bottom, up the outside) and is closed implicitly.
[[nodiscard]] Solid revolved(std::span<const ProfileVertex> profile, double tolerance);

/// The profile of tube(), for revolved().
[[nodiscard]] std::vector<ProfileVertex> tubeProfile(double outer, double inner, double from, double to);

/// A shaft or tube along z from `from` to `to`, with chamfered ends. `outer`, `inner`: radii; inner 0: solid.
[[nodiscard]] Solid tube(double outer, double inner, double from, double to, double tolerance);

/// A bar of a cage along z: the part of a tube within `half` (rad, below pi) of the x axis.
[[nodiscard]] Solid tubeSector(double outer, double inner, double from, double to, double half,
                               double tolerance);

/// A boss or hub: a disc about an axis parallel to z, with or without a hole.
struct Boss {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 1;
  double hole = 0;  ///< radius, 0: none
  friend bool operator==(const Boss&, const Boss&) = default;
};

/// A circular arc in a plane, from one angle to another; clockwise where `to` is the smaller one.
struct PlanarArc {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 1;
  double from = 0;
  double to = 0;

  [[nodiscard]] Eigen::Vector2d at(double angle) const {
    return centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
};

/// A flat part from z = `from` to `to`, exactly: arcs in the order of its outline, counter-clockwise, each
/// joined to the next by a straight line where they do not meet; and its round holes.
struct FlatShape {
  std::vector<PlanarArc> outline;
  std::vector<Boss> holes;  ///< those with a hole
  double from = 0;
  double to = 0;
};

/// What tubeSector(), arm(), spider() and plate() are made of, as exact outlines. A spider without arms is a
/// tube, and has none.
[[nodiscard]] FlatShape sectorShape(double outer, double inner, double from, double to, double half);
[[nodiscard]] FlatShape armShape(const Boss& a, const Boss& b, double from, double to);
[[nodiscard]] std::vector<FlatShape> spiderShapes(const Boss& hub, std::span<const Boss> ends, double from,
                                                  double to);
[[nodiscard]] FlatShape plateShape(std::span<const Boss> corners, double from, double to);

/// A flat arm: the convex hull of two bosses with their holes, from z = `from` to `to`.
/// @pre neither boss is inside the other
[[nodiscard]] Solid arm(const Boss& a, const Boss& b, double from, double to, double tolerance);

/// Flat arms from a hub to bosses, in one piece: a single one as arm(), several as bars from a round hub, as
/// wide as there is room. Arms too close to each other for that become separate, overlapping shells. Bosses
/// that lie in the hub, or around it, have no arm and are left out.
[[nodiscard]] Solid spider(const Boss& hub, std::span<const Boss> ends, double from, double to,
                           double tolerance);

/// A flat plate with rounded corners: the convex hull of discs, from z = `from` to `to`. Holes are not cut.
/// @pre there is a corner
[[nodiscard]] Solid plate(std::span<const Boss> corners, double from, double to, double tolerance);

}  // namespace geargraph
