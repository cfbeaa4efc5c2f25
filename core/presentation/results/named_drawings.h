#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string_view>

#include "core/presentation/drawing/display_list.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::inline results {

/// A drawing that `export --to svg/pdf/png` knows by its name.
struct NamedDrawing {
  std::string_view name;
  /// Of no use when `stop` was requested meanwhile.
  DisplayList (*draw)(const AnalysisSnapshot& snapshot, const std::stop_token& stop);
};

/// Every drawing, in the order of the help. A new one is a line in the table of named_drawings.cpp.
[[nodiscard]] std::span<const NamedDrawing> drawings();
[[nodiscard]] const NamedDrawing* drawingNamed(std::string_view name);
/// "digraph, ttgraph, schematic"
[[nodiscard]] std::string drawingNames();

}  // namespace geargraph::inline results
