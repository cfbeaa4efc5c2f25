#pragma once

#include <array>
#include <stop_token>

#include "core/presentation/report/report.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The drawings that a document arranges; the window exports them as it shows them.
inline constexpr std::array kArrangedDrawings = {ReportDrawing::schematic, ReportDrawing::digraph,
                                                 ReportDrawing::ttGraph};

/// The name of a report's drawing among the named drawings: "ttgraph".
[[nodiscard]] const char* reportDrawingName(ReportDrawing drawing);

/// A drawing of a report; levers and nomogram are empty for a train that has none. The result is meaningless
/// if `stop` was requested meanwhile.
[[nodiscard]] DisplayList reportDrawing(ReportDrawing drawing, const AnalysisSnapshot& snapshot,
                                        const std::stop_token& stop = {});
/// Those that a document arranges.
[[nodiscard]] ReportLists arrangedLists(const AnalysisSnapshot& snapshot, const std::stop_token& stop = {});
/// All drawings of a report.
[[nodiscard]] ReportLists reportLists(const AnalysisSnapshot& snapshot, const std::stop_token& stop = {});
/// The arranged drawings, completed by the others.
[[nodiscard]] ReportLists withLevers(ReportLists arranged, const AnalysisSnapshot& snapshot,
                                     const std::stop_token& stop = {});

}  // namespace geargraph
