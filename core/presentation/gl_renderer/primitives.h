#pragma once

#include "core/machine/solids/solid.h"

namespace geargraph {

/// A shaft: a cylinder about z from `from` to `to`, with a small chamfer at both ends. Closed.
/// @pre from < to, radius > 0
[[nodiscard]] Solid cylinderSolid(double radius, double from, double to, int sides = 32);

/// A box from `low` to `high`. @pre low < high in every coordinate
[[nodiscard]] Solid boxSolid(const Eigen::Vector3d& low, const Eigen::Vector3d& high);

/// The solid of revolution of a closed polyline of (radius, z) points about z: counter-clockwise in the
/// (radius, z) half plane, radii > 0 except where it touches the axis. Creases between the bands, smooth
/// around the axis.
[[nodiscard]] Solid revolvedSolid(const std::vector<Eigen::Vector2d>& outline, int sides = 32);

}  // namespace geargraph
