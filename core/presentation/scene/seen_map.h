#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/foundations/base/contract.h"

#include "core/presentation/scene/camera.h"

namespace geargraph {

/// A coarse visibility map: a grid of cells over the picture, row after row from the top.
struct VisibilityBuffer {
  int columns = 0;
  int rows = 0;
  std::vector<std::uint32_t> numbers;  ///< by cell: 1 + position of the nearest instance; 0: background
  std::vector<float> depths;           ///< by cell: value of the depth buffer, 0..1
  Eigen::Matrix4d toWorld = Eigen::Matrix4d::Identity();  ///< from the clip cube -1..1 of the picture

  [[nodiscard]] bool has(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns && row < rows;
  }
  /// The position of a cell in both lists. @pre has(column, row)
  [[nodiscard]] std::size_t at(int column, int row) const {
    GEARGRAPH_REQUIRE(has(column, row));
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  /// The surface point in the middle of the cell, mm in the world; with the precision of the depth buffer.
  [[nodiscard]] Eigen::Vector3d point(int column, int row) const {
    const Eigen::Vector4d inCube((2 * column + 1.0) / columns - 1, 1 - (2 * row + 1.0) / rows,
                                 2.0 * depths[at(column, row)] - 1, 1);
    return (toWorld * inCube).hnormalized();
  }
};

}  // namespace geargraph
