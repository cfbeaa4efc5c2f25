#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/foundations/base/contract.h"

#include "core/presentation/painting/camera.h"

namespace geargraph::inline painting {

/// What is seen of what, coarsely: a grid of cells over the picture, row after row from the top.
struct SeenMap {
  int columns = 0;
  int rows = 0;
  std::vector<std::uint32_t> numbers;  ///< by cell: position of the nearest instance plus 1; 0: the ground
  std::vector<float> depths;           ///< by cell: of the depth buffer, 0..1
  Eigen::Matrix4d toWorld = Eigen::Matrix4d::Identity();  ///< from the cube of -1..1 that the picture shows

  [[nodiscard]] bool has(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns && row < rows;
  }
  /// The position of a cell in both lists. @pre has(column, row)
  [[nodiscard]] std::size_t at(int column, int row) const {
    GEARGRAPH_REQUIRE(has(column, row));
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  /// Where the surface is in the middle of the cell, mm in the world; to the depth buffer's precision.
  [[nodiscard]] Eigen::Vector3d point(int column, int row) const {
    const Eigen::Vector4d inCube((2 * column + 1.0) / columns - 1, 1 - (2 * row + 1.0) / rows,
                                 2.0 * depths[at(column, row)] - 1, 1);
    return (toWorld * inCube).hnormalized();
  }
};

}  // namespace geargraph::inline painting
