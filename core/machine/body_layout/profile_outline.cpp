#include "core/machine/body_layout/profile_outline.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace geargraph {
namespace {

/// A side of a cell on the outline, in the sense of travel with the cell on the left.
struct Edge {
  CellOrdinal cell = 0;
  int direction = 0;  ///< 0: away from the axis, 1: up the axis, 2: towards it, 3: down
  int toColumn = 0;   ///< corner where it ends
  int toRow = 0;
  bool used = false;
};

}  // namespace

std::vector<std::vector<ProfileVertex>> outlinesOf(const ProfileGrid& grid, const std::vector<bool>& inside,
                                                   const OutlinePlaces& places) {
  const auto isIn = [&](int column, int row) {
    return column >= 0 && column < grid.columns && row >= 0 && row < grid.rows &&
           inside[static_cast<std::size_t>(grid.cell(column, row))];
  };
  std::map<std::pair<int, int>, std::vector<Edge>> from;  // by corner (column, row)
  for (int c = 0; c < grid.columns; ++c) {
    for (int r = 0; r < grid.rows; ++r) {
      if (!isIn(c, r)) continue;
      const CellOrdinal cell = grid.cell(c, r);
      if (!isIn(c - 1, r)) from[{c, r}].push_back({cell, 0, c, r + 1});
      if (!isIn(c, r + 1)) from[{c, r + 1}].push_back({cell, 1, c + 1, r + 1});
      if (!isIn(c + 1, r)) from[{c + 1, r + 1}].push_back({cell, 2, c + 1, r});
      if (!isIn(c, r - 1)) from[{c + 1, r}].push_back({cell, 3, c, r});
    }
  }
  const auto placeOf = [&](const Edge& e) {
    return e.direction % 2 == 0 ? places.height(e.cell, e.direction == 0 ? -1 : 1)
                                : places.radius(e.cell, e.direction == 1 ? 1 : -1);
  };
  std::vector<std::vector<ProfileVertex>> outlines;
  for (auto& [corner, starts] : from) {
    for (Edge& start : starts) {
      if (start.used) continue;
      std::vector<const Edge*> loop;
      Edge* edge = &start;
      while (!edge->used) {
        edge->used = true;
        loop.push_back(edge);
        std::vector<Edge>& next = from[{edge->toColumn, edge->toRow}];
        // Of two ways at a corner the one that stays with the cell: a turn to the left.
        const int left = (edge->direction + 1) % 4;
        const auto found = std::find_if(next.begin(), next.end(), [&](const Edge& e) {
          return !e.used && (next.size() == 1 || e.direction == left);
        });
        if (found == next.end()) break;
        edge = &*found;
      }
      std::vector<ProfileVertex> outline;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Edge& a = *loop[i];
        const Edge& b = *loop[(i + 1) % loop.size()];
        const double here = placeOf(a), then = placeOf(b);
        if (a.direction % 2 == b.direction % 2) {  // straight on: a step where the place changes
          if (here == then) continue;
          const bool level = a.direction % 2 == 0;
          // The part that reaches farther out is the shorter one.
          const int ahead = a.direction < 2 ? 1 : -1;
          const bool farther = a.direction == 0 || a.direction == 3 ? here < then : here > then;
          const CellOrdinal cell = farther ? a.cell : b.cell;
          const int side = farther ? ahead : -ahead;
          const double along = level ? places.radius(cell, side) : places.height(cell, side);
          outline.push_back(level ? ProfileVertex{along, here} : ProfileVertex{here, along});
          outline.push_back(level ? ProfileVertex{along, then} : ProfileVertex{then, along});
        } else if (a.direction % 2 == 0) {
          outline.push_back({then, here});
        } else {
          outline.push_back({here, then});
        }
      }
      if (outline.size() >= 4) outlines.push_back(std::move(outline));
    }
  }
  return outlines;
}

}  // namespace geargraph
