#pragma once

#include <functional>
#include <vector>

#include "core/machine/arrangement/meridian_router.h"
#include "core/machine/solids/shell_builder.h"

namespace geargraph::inline arrangement {

/// Where an edge of a set of cells really lies, given the cell inside and the direction that it faces.
struct OutlinePlaces {
  std::function<double(int cell, int side)> height;  ///< of the edge at the column's low (-1) or high (1) end
  std::function<double(int cell, int side)> radius;  ///< of the edge towards (-1) or away from (1) the axis
};

/// The outlines of a set of cells, material on the left, with corners where the places say. Cells that meet
/// at a corner alone are not joined.
[[nodiscard]] std::vector<std::vector<ProfileVertex>> outlinesOf(const MeridianGrid& grid,
                                                                 const std::vector<bool>& inside,
                                                                 const OutlinePlaces& places);

}  // namespace geargraph::inline arrangement
