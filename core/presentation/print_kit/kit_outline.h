#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

namespace geargraph {

// Outlines in the plane of a printed layer, lengths in mm.

/// A closed polygon with the material on its left: counter-clockwise around a part, clockwise around a hole.
using KitOutline = std::vector<Eigen::Vector2d>;

/// A disc of a plate.
struct KitDisc {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 1;
};

/// Chords of circles are at most this far from them.
constexpr double kOutlineTolerance = 0.01;

/// `points`: of the outline, so that circles of several radii match; 0: as many as the tolerance takes.
[[nodiscard]] KitOutline circleOutline(const Eigen::Vector2d& centre, double radius, int points = 0);
/// The convex hull of points, counter-clockwise. @pre they span an area
[[nodiscard]] KitOutline hullOfPoints(std::vector<Eigen::Vector2d> points);
/// The convex hull of discs. @pre there is one
[[nodiscard]] KitOutline hullOutline(std::span<const KitDisc> discs);
/// A circle about the origin with a flat at the distance `flat`, normal to the direction `towards` (rad).
/// @pre 0 < flat < radius
[[nodiscard]] KitOutline flattedOutline(double radius, double flat, double towards);
/// @pre `across` is normal to `along`, both unit vectors
[[nodiscard]] KitOutline boxOutline(const Eigen::Vector2d& centre, const Eigen::Vector2d& along,
                                    double length, double width);

[[nodiscard]] KitOutline reversed(KitOutline outline);
[[nodiscard]] KitOutline shifted(KitOutline outline, const Eigen::Vector2d& by);
/// The outline moved into the material by `by`, corner by corner: a part becomes smaller, a hole wider; as
/// many points as before. @pre no edge is so short, and no corner so sharp, that edges would cross
[[nodiscard]] KitOutline inset(const KitOutline& outline, double by);

/// Twice the area, negative for a hole.
[[nodiscard]] double doubledArea(const KitOutline& outline);
/// Is the point within an odd number of the outlines?
[[nodiscard]] bool isInside(std::span<const KitOutline> outlines, const Eigen::Vector2d& point);
/// The distance of a point to the nearest edge.
[[nodiscard]] double distanceTo(std::span<const KitOutline> outlines, const Eigen::Vector2d& point);

/// Digits as strokes of seven segments that do not touch each other, so that each is one simple polygon, and
/// dots. Counter-clockwise, centred on the origin. Other characters leave a gap.
[[nodiscard]] std::vector<KitOutline> digitOutlines(std::string_view text, double height);
[[nodiscard]] double digitsWidth(std::string_view text, double height);

/// Where in the material a box of this size has the most room, at least `margin` to all edges; false if
/// nowhere. Cost: O(edges) for each of some hundred places.
[[nodiscard]] bool roomFor(std::span<const KitOutline> outlines, const Eigen::Vector2d& size, double margin,
                           Eigen::Vector2d& centre);

}  // namespace geargraph
