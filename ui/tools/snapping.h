#pragma once

#include <optional>
#include <span>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline tools {

/// How far a drag really goes, and along which lines it was pulled.
struct Snap {
  double dx = 0;
  double dy = 0;
  std::optional<double> column;  ///< x that a moved node now shares with a resting one
  std::optional<double> row;     ///< y
  friend bool operator==(const Snap&, const Snap&) = default;
};

/// Pulls moved nodes onto the nearest row and column of a resting one, if that is at most `reach` away.
/// `moving` are the places before the drag. Cost: O((moving + resting) log resting).
[[nodiscard]] Snap snapped(std::span<const SheetPoint> moving, std::span<const SheetPoint> resting, double dx,
                           double dy, double reach);

/// The nearest point of a square grid through the origin.
[[nodiscard]] SheetPoint onGrid(SheetPoint point, double step);

}  // namespace geargraph::inline tools
