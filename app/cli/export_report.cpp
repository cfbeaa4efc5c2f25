// `export FILE --to html/latex/md -o OUT`: the worked derivation, both methods.

#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/drawings.h"
#include "app/cli/export_forms.h"
#include "app/cli/input_options.h"
#include "app/cli/load.h"
#include "core/drawing/svg_writer.h"

namespace geargraph::cli {
namespace {

std::string svgNamed(const char* name, const AnalysisSnapshot& snapshot) {
  return svgOf(drawingNamed(name)->draw(snapshot), SheetLook{});
}

}  // namespace

int exportReport(const Arguments& arguments, ReportForm form) {
  const std::string& file = arguments.files.front();
  auto document = loadOrSay(file);
  if (const int* status = std::get_if<int>(&document)) return *status;
  auto mechanism = withInputOptions(std::get<Mechanism>(std::move(document)), arguments);
  if (const auto* error = std::get_if<UsageError>(&mechanism)) return wrongUsage(kExport, error->message);
  if (std::get<Mechanism>(mechanism).n() > kMostReportLinks) {
    std::cerr << "geargraph-cli: A derivation of more than " << kMostReportLinks
              << " links is not written: nobody could read it. The matrices are exported as CSV.\n";
    return kResourceLimit;
  }
  const SnapshotPtr snapshot =
      analyze(std::make_shared<const Mechanism>(std::get<Mechanism>(std::move(mechanism))));
  std::cerr << diagnosticLines(file, snapshot->diagnostics);
  const std::string text = reportText(derivationReport(snapshot), form, [&] {
    return ReportDrawings{svgNamed("schematic", *snapshot), svgNamed("digraph", *snapshot),
                          svgNamed("ttgraph", *snapshot)};
  });
  const int status = writePicture(text, *arguments.value("-o"));
  if (status != kFine) return status;
  return hasErrors(snapshot->diagnostics) ? kMechanismErrors : kFine;
}

}  // namespace geargraph::cli
