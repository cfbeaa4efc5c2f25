#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string_view>

#include "core/presentation/diagrams/power_picture.h"
#include "core/presentation/diagrams/torque_marks.h"
#include "core/presentation/drawing/display_list.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The power flow of a mechanism, and the torques that act on it.
struct DrawnPower {
  PowerPicture picture;
  std::vector<ShownTorque> torques;
};

/// A drawing with its name in `export --to svg/pdf/png`.
struct NamedDrawing {
  std::string_view name;
  /// The result is meaningless if `stop` was requested meanwhile. `power`: drawn under it; null: none.
  DisplayList (*draw)(const AnalysisSnapshot& snapshot, const DrawnPower* power, const std::stop_token& stop);
  bool showsPower = true;
  /// px of the names in its captions, as captionsOf() takes them; empty: it has no room for any.
  std::optional<double> captionSize = {};
};

/// Every drawing, in the order of the help. To add one, add a line to the table in named_drawings.cpp.
[[nodiscard]] std::span<const NamedDrawing> drawings();
/// Null if there is none.
[[nodiscard]] const NamedDrawing* drawingNamed(std::string_view name);
/// "digraph, ttgraph, schematic, levers, nomogram, plan, kutzbach, spectrum, motors"
[[nodiscard]] std::string drawingNames();

}  // namespace geargraph
