#include "core/presentation/export_api/report_lists.h"

#include <algorithm>

#include "core/presentation/diagrams/lever_drawing.h"
#include "core/presentation/diagrams/nomogram.h"
#include "core/presentation/export_api/levers_json.h"
#include "core/presentation/export_api/named_drawings.h"

namespace geargraph {
namespace {

constexpr std::array kReportDrawingNames = {"schematic", "digraph", "ttgraph", "levers", "nomogram"};
static_assert(kReportDrawingNames.size() == kReportDrawingCount);

DisplayList leversOfReport(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const auto picture = leverPictureOf(snapshot, stop);
  if (!picture || picture->plan.levers.empty()) return {};
  return leverDrawing(*snapshot.mechanism, *picture, {});
}

DisplayList nomogramOfReport(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const auto found = statesOnLevers(snapshot, stop);
  if (!found || found->plan.levers.empty()) return {};
  NomogramSheet sheet = nomogramSheet(*snapshot.mechanism, found->plan, snapshot.kinematics->placement(),
                                      found->states, found->current, {});
  return sheet.missing.empty() ? std::move(sheet.drawing) : DisplayList();
}

}  // namespace

const char* reportDrawingName(ReportDrawing drawing) {
  return kReportDrawingNames[static_cast<std::size_t>(drawing)];
}

DisplayList reportDrawing(ReportDrawing drawing, const AnalysisSnapshot& snapshot,
                          const std::stop_token& stop) {
  if (drawing == ReportDrawing::levers) return leversOfReport(snapshot, stop);
  if (drawing == ReportDrawing::nomogram) return nomogramOfReport(snapshot, stop);
  return drawingNamed(reportDrawingName(drawing))->draw(snapshot, nullptr, stop);
}

ReportLists withLevers(ReportLists arranged, const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  for (const ReportDrawing each : {ReportDrawing::levers, ReportDrawing::nomogram})
    arranged[each] = reportDrawing(each, snapshot, stop);
  return arranged;
}

ReportLists arrangedLists(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  ReportLists lists;
  for (const ReportDrawing each : kArrangedDrawings) lists[each] = reportDrawing(each, snapshot, stop);
  return lists;
}

ReportLists reportLists(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  return withLevers(arrangedLists(snapshot, stop), snapshot, stop);
}

}  // namespace geargraph
