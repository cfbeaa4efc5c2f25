// `validate FILE [--motion] [--json]`: only the diagnostics.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/load.h"
#include "app/cli/time_limit.h"
#include "core/design/collision/motion_diagnostics.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/document_format/shape_files.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {
namespace {

/// `motion`: what `--motion` has looked at; null where it was not asked for.
std::string asJson(const Diagnostics& diagnostics, const std::optional<MotionReport>* motion) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-validation");
    json.member("version", 1);
    json.key("diagnostics");
    writeDiagnostics(json, diagnostics);
    if (motion != nullptr) writeMotionCheck(json, *motion);
    json.endObject();
  }
  return sink.take();
}

/// std::nullopt where `stop` was requested.
std::optional<Diagnostics> diagnosticsOf(const Mechanism& mechanism, std::optional<MotionReport>* motion,
                                         const std::stop_token& stop) {
  SnapshotPtr live = analyzeLive(std::make_shared<const Mechanism>(mechanism), 0, stop);
  if (live) live = analyzeStates(live, {false}, stop);
  if (!live) return std::nullopt;
  Diagnostics diagnostics = live->diagnostics;
  const Diagnostics teeth = geometryDiagnostics(*live, stop);
  if (stop.stop_requested()) return std::nullopt;
  append(diagnostics, teeth);
  if (motion != nullptr) {
    *motion = checkMotion(*live, stop);
    if (stop.stop_requested()) return std::nullopt;
    if (*motion) append(diagnostics, (*motion)->diagnostics);
  }
  sortBySeverity(diagnostics);
  return diagnostics;
}

int runValidate(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kValidate, translated("One file is needed."));
  const std::string& file = arguments.files.front();
  const auto loaded = load(file);
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  const auto& document = std::get<Expected<Mechanism>>(loaded);
  std::optional<MotionReport> report;
  auto* const motion = arguments.has("--motion") ? &report : nullptr;
  auto found = std::optional(document ? Diagnostics() : document.error());
  if (document) {
    const auto engaged = withEngagementOptions(*document, arguments);
    if (const auto* error = std::get_if<UsageError>(&engaged)) return wrongUsage(kValidate, error->message);
    found = diagnosticsOf(std::get<Mechanism>(engaged), motion, arguments.stop);
    if (found && file != "-") {
      const std::filesystem::path path = std::filesystem::absolute(file);
      append(*found, missingFileDiagnostics(*document, path.parent_path()));
    }
  }
  if (!found) return outOfTime(arguments, translated("the validation"));
  const Diagnostics& diagnostics = *found;
  const int status = hasErrors(diagnostics) ? kMechanismErrors : kFine;
  if (arguments.has("--json")) return print(asJson(diagnostics, motion), status);
  std::string text =
      diagnostics.empty() ? translated("%1: no problems", {file}) + '\n' : diagnosticLines(file, diagnostics);
  if (motion != nullptr) text += motionCheckLine(file, report);
  return print(text, status);
}

constexpr std::array kValidateOptions = {
    Option{"--motion", "",
           toTranslate("also look for links that collide while the inputs run at their speeds")},
    kStateOption,
    kEngageOption,
    Option{"--json", "", toTranslate("as JSON")},
};

}  // namespace

const Command kValidate = {"validate", "FILE [--motion] [--state NAME | --engage A,B] [--json]",
                           toTranslate("Says what is wrong with a file."), kValidateOptions, runValidate};

}  // namespace geargraph::cli
