#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "core/machine/solids/solid.h"
#include "core/presentation/print_kit/kit_outline.h"

namespace geargraph {

/// An outline at a height. Outlines of one wall have the same number of points.
struct Rim {
  double height = 0;
  KitOutline outline;
};

/// The surface of a printed part: walls between outlines and flat faces, all of whose points are on a grid of
/// kGrid, so that sides of triangles that belong together have the same points, bit by bit.
class KitShell {
 public:
  /// mm: fine beside what a printer resolves, and exact in a float up to 1 m.
  static constexpr double kGrid = 1.0 / 16384;

  [[nodiscard]] static Eigen::Vector2d onGrid(const Eigen::Vector2d& p);

  void addTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
  /// The wall from rim to rim, upwards, material on the left of each outline; two rims of one height are a
  /// step.
  void addWall(std::span<const Rim> rims);
  /// A flat face that the outlines bound, holes clockwise: up, or down. False if they cross each other.
  [[nodiscard]] bool addFace(std::span<const KitOutline> outlines, double height, bool isUp);

  [[nodiscard]] Solid solid() const;

 private:
  std::vector<std::array<Eigen::Vector3d, 3>> m_triangles;
};

/// The triangles of a region, as positions in the outlines one after the other; counter-clockwise. Exact on
/// the grid. Empty if outlines cross or touch each other. Cost: O(n^2) at worst, n points.
[[nodiscard]] std::vector<Triangle> triangulated(std::span<const KitOutline> outlines);

/// A closed solid has every edge once in either direction, after welding of equal positions.
[[nodiscard]] bool isClosed(const Solid& solid);

/// A part in one piece with straight or stepped walls: an outer wall, holes from its lower to its upper face,
/// and pockets sunk into either face.
struct PlateShape {
  std::vector<Rim> outer;
  std::vector<std::vector<Rim>> holes;    ///< clockwise, upwards from the lower face to the upper one
  std::vector<std::vector<Rim>> wells;    ///< the same, from a floor of their own
  std::vector<KitOutline> topPockets;     ///< counter-clockwise, as seen from above
  std::vector<KitOutline> bottomPockets;  ///< the same
  double pocketDepth = 0.6;
};

/// @pre outlines of a face do not cross; the heights of the first and last rims agree
[[nodiscard]] Solid plateSolid(const PlateShape& shape);

/// The rims of a straight wall from `low` to `high` whose lowest part is moved into the material against the
/// spread of the first layer; `chamfer` 0: none.
[[nodiscard]] std::vector<Rim> chamferedWall(const KitOutline& outline, double low, double high,
                                             double chamfer);

}  // namespace geargraph
