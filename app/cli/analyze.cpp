// `analyze FILE [--json] [--dense]`: everything that is computed, for people or as JSON.

#include <unistd.h>

#include <array>
#include <memory>

#include "app/cli/analyze_json.h"
#include "app/cli/analyze_text.h"
#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/load.h"

namespace geargraph::cli {
namespace {

int run(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kAnalyze, "One file is needed.");
  const std::string& file = arguments.files.front();
  auto loaded = load(file);
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  auto& document = std::get<Expected<Mechanism>>(loaded);
  const SnapshotPtr snapshot =
      document ? analyze(std::make_shared<const Mechanism>(std::move(document).value())) : nullptr;
  const Diagnostics& diagnostics = snapshot ? snapshot->diagnostics : document.error();
  const int status = hasErrors(diagnostics) ? kMechanismErrors : kFine;
  if (!arguments.has("--json")) {
    return print((snapshot ? analysisText(*snapshot) + (diagnostics.empty() ? "" : "\n") : "") +
                     diagnosticLines(file, diagnostics),
                 status);
  }
  DescriptorSink out(STDOUT_FILENO);
  writeAnalysisJson(out, snapshot.get(), diagnostics, arguments.has("--dense"));
  return out.failed() ? fileFailure("Standard output could not be written.") : status;
}

constexpr std::array kOptions = {
    Option{"--json", "", "as JSON"},
    Option{"--dense", "", "with --json: all entries of matrices, also above 250,000 (else triplets)"},
};

}  // namespace

const Command kAnalyze = {"analyze", "FILE [--json] [--dense]",
                          "Analyses a mechanism, for people or as JSON.", kOptions, run};

}  // namespace geargraph::cli
