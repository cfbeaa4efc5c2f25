#pragma once

#include <optional>
#include <vector>

#include "core/machine/solids/part_solids.h"
#include "core/machine/solids/shell_builder.h"
#include "core/machine/teeth/gear_spec.h"

namespace geargraph {

/// Openings between the spokes of a wheel's web: polar rectangles with rounded corners and parallel spokes.
struct WebWindows {
  int count = 5;
  double hub = 0;  ///< radii of the web's circles
  double rim = 0;
  double inner = 0;  ///< radii of the windows
  double outer = 0;
  double spoke = 0;   ///< width between two windows
  double corner = 0;  ///< radius
  double half = 0;    ///< of the web's thickness: its faces are at z = +-half
};

/// Windows for the web of a dressed wheel between these radii; std::nullopt if there is no room for
/// reasonable ones.
[[nodiscard]] std::optional<WebWindows> windowsFor(double hub, double rim, double half, double module);

/// The outline of the window whose middle is at the angle `turn`, counter-clockwise: arcs about its corners
/// and on its two circles, joined by straight lines beside the spokes.
[[nodiscard]] std::vector<PlanarArc> windowOutline(const WebWindows& windows, double turn);

/// Adds both faces of the web between its circles of `count` vertices from angle `start`, and the windows'
/// walls.
/// @pre count is a multiple of the number of windows
void addWindowedWeb(ShellBuilder& builder, const WebWindows& windows, int count, double start,
                    double tolerance);

}  // namespace geargraph
