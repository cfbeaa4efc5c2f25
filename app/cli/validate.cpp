// `validate FILE [--json]`: only the diagnostics.

#include <array>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/load.h"
#include "app/cli/time_limit.h"
#include "core/analysis/analysis.h"

namespace geargraph::cli {
namespace {

std::string asJson(const Diagnostics& diagnostics) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-validation");
    json.member("version", 1);
    json.key("diagnostics");
    writeDiagnostics(json, diagnostics);
    json.endObject();
  }
  return sink.take();
}

/// std::nullopt where `stop` was requested.
std::optional<Diagnostics> diagnosticsOf(const Mechanism& mechanism, const std::stop_token& stop) {
  SnapshotPtr live = analyzeLive(std::make_shared<const Mechanism>(mechanism), 0, stop);
  if (live) live = analyzeStates(live, {false}, stop);
  if (!live) return std::nullopt;
  Diagnostics diagnostics = live->diagnostics;
  const Diagnostics teeth = toothFindings(*live, stop);
  if (stop.stop_requested()) return std::nullopt;
  diagnostics.insert(diagnostics.end(), teeth.begin(), teeth.end());
  return diagnostics;
}

int run(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kValidate, "One file is needed.");
  const std::string& file = arguments.files.front();
  const auto loaded = load(file);
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  const auto& document = std::get<Expected<Mechanism>>(loaded);
  const auto found = document ? diagnosticsOf(*document, arguments.stop) : std::optional(document.error());
  if (!found) return outOfTime(arguments, "the validation");
  const Diagnostics& diagnostics = *found;
  const int status = hasErrors(diagnostics) ? kMechanismErrors : kFine;
  if (arguments.has("--json")) return print(asJson(diagnostics), status);
  return print(diagnostics.empty() ? file + ": no problems\n" : diagnosticLines(file, diagnostics), status);
}

constexpr std::array kOptions = {Option{"--json", "", "as JSON"}};

}  // namespace

const Command kValidate = {"validate", "FILE [--json]", "Says what is wrong with a file.", kOptions, run};

}  // namespace geargraph::cli
