#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string_view>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/power_drawing/power_picture.h"
#include "core/presentation/power_drawing/torque_marks.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::inline results {

/// Where power goes in a mechanism, and the torques that act on it.
struct DrawnPower {
  PowerPicture picture;
  std::vector<ShownTorque> torques;
};

/// A drawing that `export --to svg/pdf/png` knows by its name.
struct NamedDrawing {
  std::string_view name;
  /// Of no use when `stop` was requested meanwhile. `power`: laid under the drawing; null: none.
  DisplayList (*draw)(const AnalysisSnapshot& snapshot, const DrawnPower* power, const std::stop_token& stop);
  bool showsPower = true;
};

/// Every drawing, in the order of the help. A new one is a line in the table of named_drawings.cpp.
[[nodiscard]] std::span<const NamedDrawing> drawings();
[[nodiscard]] const NamedDrawing* drawingNamed(std::string_view name);
/// "digraph, ttgraph, schematic"
[[nodiscard]] std::string drawingNames();

}  // namespace geargraph::inline results
