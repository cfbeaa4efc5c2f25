// `export FILE --to FORM ...`: the exporters of core (core/presentation/exporters) with what they say in the
// words and exit statuses of the program.

#include <filesystem>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/load.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/exporters/exporters.h"

namespace geargraph::cli {
namespace {

/// Reports why nothing was written; returns the exit status.
int exportFailure(const Arguments& arguments, const ExportError& error) {
  using Kind = ExportError::Kind;
  if (error.kind == Kind::usage) return wrongUsage(kExport, error.message);
  if (error.kind == Kind::stopped) return outOfTime(arguments, error.message);
  if (!error.message.empty()) std::cerr << "geargraph-cli: " << error.message << '\n';
  if (error.kind == Kind::file) return kUsageOrFile;
  return error.kind == Kind::mechanism ? kMechanismErrors : kResourceLimit;
}

void printNote(const std::string& file, const ExportNote& note) {
  if (note.about == ExportNote::About::program) std::cerr << "geargraph-cli: ";
  if (note.about == ExportNote::About::file) std::cerr << file << ": ";
  std::cerr << note.text << '\n';
}

ExportContext contextOf(const std::string& file) {
  ExportSource source;
  source.read = [file]() -> std::variant<Mechanism, ExportError> {
    auto loaded = loadOrSay(file);
    if (auto* mechanism = std::get_if<Mechanism>(&loaded)) return std::move(*mechanism);
    const bool isUnreadable = std::get<int>(loaded) == kUsageOrFile;
    return ExportError{isUnreadable ? ExportError::Kind::file : ExportError::Kind::mechanism, {}};
  };
  source.isFile = file != "-";
  if (source.isFile) {
    source.folder = std::filesystem::absolute(file).parent_path();
    source.stem = std::filesystem::path(file).stem().string();
  }
  source.diagnose = [file](const Diagnostics& found) { std::cerr << diagnosticLines(file, found); };
  source.note = [file](const ExportNote& note) { printNote(file, note); };
  return ExportContext(std::move(source));
}

std::string formNames() {
  std::string names;
  for (const std::string& form : exportForms()) names += (names.empty() ? "" : ", ") + form;
  return names;
}

int runExport(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kExport, translated("One file is needed."));
  if (arguments.value("--to") == "sdf") {
    return wrongUsage(
        kExport,
        translated(
            "SDF is not written: no current Gazebo runs its gear joints. --to urdf is read by Gazebo."));
  }
  const Exporter* const exporter = exporterOf(arguments.value("--to").value_or(""), arguments);
  if (exporter == nullptr) return wrongUsage(kExport, translated("--to is one of %1.", {formNames()}));
  if (const auto error = uselessOption(*exporter, arguments)) return wrongUsage(kExport, error->message);
  const auto path = arguments.value("-o");
  if (!path) return wrongUsage(kExport, translated("-o says where to write."));
  ExportContext context = contextOf(arguments.files.front());
  const ExportResult result =
      writeExport(*exporter, context, arguments, {*path, arguments.has("--force")}, arguments.stop);
  if (const auto* error = std::get_if<ExportError>(&result)) return exportFailure(arguments, *error);
  return std::get<ExportOutcome>(result).isFlawed ? kMechanismErrors : kFine;
}

}  // namespace

const Command kExport = {
    "export", "FILE --to FORM [...] -o OUT",
    toTranslate("Writes matrices as CSV, the worked derivation, pictures and animations, gears as "
                "3D files, models for simulators, and graphs."),
    exportOptionTexts(), runExport};

}  // namespace geargraph::cli
