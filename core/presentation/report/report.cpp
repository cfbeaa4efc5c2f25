#include "core/presentation/report/report.h"

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/report/report_parts.h"
#include "core/presentation/report/report_words.h"

namespace geargraph {
namespace {

void addDiagnostics(Report& report, const AnalysisSnapshot& snapshot) {
  if (snapshot.diagnostics.empty()) return;
  report.blocks.emplace_back(ReportHeading{1, translated("Warnings")});
  ReportList diagnostics;
  for (const Diagnostic& diagnostic : snapshot.diagnostics)
    diagnostics.items.push_back(plainWords(diagnostic.message));
  report.blocks.emplace_back(std::move(diagnostics));
}

}  // namespace

std::string reportTitle(const Mechanism& mechanism) {
  return mechanism.name.empty() ? translated("Untitled mechanism") : mechanism.name;
}

Report derivationReport(const SnapshotPtr& snapshot, const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(snapshot->isComplete);
  GEARGRAPH_REQUIRE(snapshot->mechanism->n() <= kMaxReportLinks);
  Report report;
  report.title = reportTitle(*snapshot->mechanism);
  addDiagnostics(report, *snapshot);
  addDigraphPart(report, snapshot);
  addMatroidPart(report, snapshot, stop);
  addTtGraphPart(report, *snapshot, stop);
  addComparisonPart(report, *snapshot, stop);
  addStaticsPart(report, *snapshot, stop);
  addLeversPart(report, *snapshot, stop);
  return report;
}

ReportDrawings svgDrawings(const ReportLists& lists) {
  ReportDrawings drawings;
  for (std::size_t i = 0; i < lists.all.size(); ++i) {
    if (!lists.all[i].marks.empty()) drawings.all[i] = svgOf(lists.all[i], SheetStyle());
  }
  return drawings;
}

std::string reportText(const Report& report, ReportForm form, const std::function<ReportLists()>& drawings) {
  if (form == ReportForm::markdown) return reportMarkdown(report);
  if (form == ReportForm::latex) return reportLatex(report, drawings());
  return reportHtml(report, svgDrawings(drawings()));
}

std::optional<ReportForm> reportFormFromName(std::string_view name) {
  if (name == "md") return ReportForm::markdown;
  if (name == "latex") return ReportForm::latex;
  if (name == "html") return ReportForm::html;
  return std::nullopt;
}

}  // namespace geargraph
