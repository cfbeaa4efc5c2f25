#pragma once

#include <utility>
#include <vector>

#include "core/design/atlas/chain.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Longer chains are laid out on a circle as they are, without a search.
constexpr int kMaxSearchedLinks = 7;

/// The turning joints by which a chain is drawn: on each axis one link carries the others, that of the
/// smallest number. The links of a pair ascend; joints are in the order of the axes. The second is the axis.
struct DrawnTurning {
  std::pair<int, int> links;
  int axis = 0;
  friend bool operator==(const DrawnTurning&, const DrawnTurning&) = default;
};
[[nodiscard]] std::vector<DrawnTurning> drawnTurnings(const Chain& chain);

struct ChainLayout {
  std::vector<CanvasPoint> places;  ///< by link, about the origin
  int crossings = 0;                ///< pairs of lines that cross
};

/// Places for the links of a chain, so that its joints and gear pairs are straight lines that pass through
/// no other link: those with the fewest crossings, of these the shortest lines, among all ways to put the
/// links on some fixed patterns (a circle, one with links inside it, a triangle about the others, two rows,
/// a row between two poles).
/// Deterministic. Cost: links! times a few patterns, about 3 ms for 7 links.
[[nodiscard]] ChainLayout chainLayout(const Chain& chain);

}  // namespace geargraph
