#pragma once

#include <vector>

#include "core/design/atlas/chain.h"
#include "core/presentation/drawing/display_list.h"

namespace geargraph {

/// How the links of a chain are named and coloured in its drawing.
struct ChainDrawingStyle {
  /// By link: the label, and the number of the colour. Empty: 1, 2, ... of the chain.
  std::vector<int> labels = {};
  std::vector<int> colors = {};
  bool namesAxes = false;  ///< the axes as letters at the turning joints, as in [AU, Fig. 2]
};

/// The digraph of a chain without directions: links as discs, turning joints as solid lines, gear pairs as
/// dashed ones, where chainLayout() puts them. The ids of its marks are those of the chain: links "1", "2",
/// ..., joints "j1", ..., gear pairs "m1", ...
/// Cost: that of chainLayout().
[[nodiscard]] DisplayList chainDrawing(const Chain& chain, const ChainDrawingStyle& style = {});

}  // namespace geargraph
