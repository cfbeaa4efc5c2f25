#pragma once

#include <Eigen/Geometry>
#include <span>

#include "core/machine/solids/shell_builder.h"
#include "core/machine/solids/solid.h"

namespace geargraph::inline solids {

/// The frame at `origin` with z along `axis` (unit) and x as near `towards` as it can be, for parts that have
/// an axis.
[[nodiscard]] Eigen::Isometry3d frameAlong(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis,
                                           const Eigen::Vector3d& towards = Eigen::Vector3d::UnitX());

/// A body of revolution about z. The meridian runs with the material on the left (from the top face inward,
/// down the bore, outward along the bottom, up the outside) and closes by itself.
[[nodiscard]] Solid lathed(std::span<const ProfileVertex> meridian, double tolerance);

/// A shaft or tube along z from `from` to `to`, its ends chamfered. `inner` 0: solid. Lengths.
[[nodiscard]] Solid tube(double outer, double inner, double from, double to, double tolerance);

/// A bar of a cage along z: the part of a tube within `half` (rad, below pi) of the x axis.
[[nodiscard]] Solid tubeSector(double outer, double inner, double from, double to, double half,
                               double tolerance);

/// One end of an arm: an eye about an axis parallel to z.
struct Eye {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 1;
  double hole = 0;  ///< radius, 0: none
  friend bool operator==(const Eye&, const Eye&) = default;
};

/// A flat arm: the hull of two round eyes, of thickness from z = `from` to `to`, with their holes.
/// @pre neither eye lies inside the other
[[nodiscard]] Solid arm(const Eye& a, const Eye& b, double from, double to, double tolerance);

/// Flat arms from one eye, the hub, to others, in one piece: a single one as arm() makes it, several as bars
/// from a round hub, as wide as there is room for them. Arms too close for that overlap each other as pieces
/// of their own.
[[nodiscard]] Solid spider(const Eye& hub, std::span<const Eye> ends, double from, double to,
                           double tolerance);

/// A flat plate with rounded corners: the convex hull of discs, from z = `from` to `to`. Holes are not cut.
/// @pre there is a corner
[[nodiscard]] Solid plate(std::span<const Eye> corners, double from, double to, double tolerance);

}  // namespace geargraph::inline solids
