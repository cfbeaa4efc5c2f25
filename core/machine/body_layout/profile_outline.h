#pragma once

#include <functional>
#include <vector>

#include "core/machine/body_layout/profile_router.h"
#include "core/machine/solids/shell_builder.h"

namespace geargraph {

/// The exact positions of the edges of a set of cells, by the cell inside and the side that the edge faces.
struct OutlinePlaces {
  /// Height of the edge at the column's low (-1) or high (1) end.
  std::function<double(CellOrdinal cell, int side)> height;
  /// Radius of the edge towards (-1) or away from (1) the axis.
  std::function<double(CellOrdinal cell, int side)> radius;
};

/// The outlines of a set of cells, material on the left, with corners at these positions. Cells that share
/// only a corner are not joined.
[[nodiscard]] std::vector<std::vector<ProfileVertex>> outlinesOf(const ProfileGrid& grid,
                                                                 const std::vector<bool>& inside,
                                                                 const OutlinePlaces& places);

}  // namespace geargraph
