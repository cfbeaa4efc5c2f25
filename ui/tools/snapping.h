#pragma once

#include <optional>
#include <span>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The snapped displacement of a drag, and the lines that it snapped to.
struct Snap {
  double dx = 0;
  double dy = 0;
  std::optional<double> column;  ///< x shared by a moved node and a fixed one
  std::optional<double> row;     ///< y, likewise
  friend bool operator==(const Snap&, const Snap&) = default;
};

/// Snaps the displacement (dx, dy) so that a moved node aligns with the nearest row and column of a fixed
/// node, if at most `reach` away. `moving`: places before the drag. Cost: O((moving + resting) log resting).
[[nodiscard]] Snap snapped(std::span<const CanvasPoint> moving, std::span<const CanvasPoint> resting,
                           double dx, double dy, double reach);

/// The nearest point of a square grid of this step through the origin.
[[nodiscard]] CanvasPoint onGrid(CanvasPoint point, double step);

}  // namespace geargraph
