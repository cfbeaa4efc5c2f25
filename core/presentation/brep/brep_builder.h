#pragma once

#include <span>
#include <vector>

#include "core/machine/solids/part_solids.h"
#include "core/machine/solids/shell_builder.h"
#include "core/presentation/brep/brep.h"

namespace geargraph {

/// Adds points, edges and faces to a solid.
class BrepBuilder {
 public:
  int addPoint(const Eigen::Vector3d& point);
  [[nodiscard]] const Eigen::Vector3d& point(int index) const {
    return m_solid.points[static_cast<std::size_t>(index)];
  }

  /// The point that an edge begins at, in the direction of the loop.
  [[nodiscard]] int startOf(const LoopEdge& edge) const {
    const BrepEdge& of = m_solid.edges[static_cast<std::size_t>(edge.edge)];
    return edge.isForward ? of.from : of.to;
  }

  LoopEdge addLine(int from, int to);
  /// Counter-clockwise about z, in a plane across it.
  LoopEdge addArc(int from, int to, const Eigen::Vector3d& centre);
  /// A whole circle about z.
  LoopEdge addCircle(const Eigen::Vector2d& centre, double radius, double height);
  LoopEdge addSpline(int from, int to, SplineCurve curve);

  void addFace(std::variant<PlaneSurface, RoundSurface, SplineSurface> surface,
               std::vector<std::vector<LoopEdge>> loops, bool isReversed = false);
  /// Across z at a height, the material below it or above.
  void addPlane(double height, bool isTop, std::vector<std::vector<LoopEdge>> loops);

  /// A circle about z, counter-clockwise: whole, or as two arcs; empty: a point of the axis.
  using Circle = std::vector<LoopEdge>;
  /// A circle for every vertex of a profile; equal ones that follow each other are one.
  std::vector<Circle> addCircles(std::span<const ProfileVertex> profile);
  /// Two arcs between two angles.
  Circle addSplitCircle(const ProfileVertex& circle, double first, double second);
  /// The faces of revolution along a profile, between its circles. `inward`: the material is on the right of
  /// the profile. A stretch in one plane gets the holes that are named for it. @pre no cone ends in a point
  void addRevolved(std::span<const ProfileVertex> profile, std::span<const Circle> circles, bool inward,
                   std::span<const std::vector<std::vector<LoopEdge>>> holes = {});

  /// A wall along z round a closed outline, seen counter-clockwise with the material inside (or outside:
  /// `isHole`); the loops that it leaves on the plane above and the one below, each seen from outside there.
  struct WallLoops {
    std::vector<LoopEdge> top, bottom;
  };
  WallLoops addWall(std::span<const PlanarArc> outline, double from, double to, bool isHole);
  /// The same of a whole circle.
  WallLoops addRoundWall(const Eigen::Vector2d& centre, double radius, double from, double to, bool isHole);

  [[nodiscard]] Brep take() { return std::move(m_solid); }

 private:
  void addBand(const RoundSurface& surface, const Circle& low, const Circle& high, bool isOutward);

  Brep m_solid;
};

[[nodiscard]] inline LoopEdge against(LoopEdge edge) {
  return {edge.edge, !edge.isForward};
}
/// The loop seen from the other side.
[[nodiscard]] std::vector<LoopEdge> against(std::span<const LoopEdge> loop);

/// A solid of revolution, as revolved().
[[nodiscard]] Brep revolvedBrep(std::span<const ProfileVertex> profile);
/// A flat part.
[[nodiscard]] Brep flatBrep(const FlatShape& shape);

/// The solid in another place, its lengths times `scale`.
[[nodiscard]] Brep placed(Brep solid, const Eigen::Isometry3d& pose, double scale);

}  // namespace geargraph
