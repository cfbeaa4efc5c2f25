// `exercises make`: sheets, solutions and files for answers.

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/exercise_forms.h"
#include "app/cli/load.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/folder.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/presentation/exercise_sheets/sheet_files.h"
#include "core/presentation/exporters/exercise_plan.h"

namespace geargraph::cli {
namespace {

namespace fs = std::filesystem;

/// Everything but the kinds, which depend on the mechanism.
std::variant<SheetRequest, UsageError, FileError> requestFrom(const Arguments& arguments) {
  SheetRequest request;
  if (arguments.has("--variants") && arguments.has("--names"))
    return UsageError{translated("Give --variants or --names: a name is a variant.")};
  auto plan = planFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&plan)) return *error;
  request.plan = std::get<SheetPlan>(std::move(plan));
  if (const auto path = arguments.value("--names")) {
    const auto bytes = readFile(*path, kLargestFile);
    if (const auto* error = std::get_if<FileError>(&bytes)) return *error;
    request.students = wordsOf(std::get<std::string>(bytes), '\n');
    if (request.students.empty() || request.students.size() > kMaxVariants)
      return UsageError{translated("--names is a text file of 1 to 1000 lines.")};
    request.plan.variants = static_cast<int>(request.students.size());
  }
  for (const std::string& name : wordsOf(arguments.value("--to").value_or("html,latex,pdf"), ',')) {
    const auto form = sheetFileForm(name);
    if (!form)
      return UsageError{translated(
          "--to lists forms out of html, latex, pdf, json, handout and scorm, not \"%1\".", {name})};
    request.forms.push_back(*form);
  }
  return request;
}

/// A file of the sheet that is there already: told before the long work of making them.
std::optional<fs::path> fileInTheWay(const fs::path& folder, const SheetRequest& request) {
  for (const std::string& name : sheetFileNames(request)) {
    if (fs::exists(folder / name)) return folder / name;
  }
  return std::nullopt;
}

int writeSheets(const Arguments& arguments, const ExerciseSource& source, const SheetRequest& request) {
  const fs::path folder = *arguments.value("-o");
  const bool overwrites = arguments.has("--force");
  if (const auto taken = overwrites ? std::nullopt : fileInTheWay(folder, request)) {
    return fileFailure(
        translated("\"%1\" is there already; nothing was written (--force overwrites).", {taken->string()}));
  }
  int made = 0;
  const auto files = sheetFiles(
      source, request, [&](int variants) { made = variants; }, arguments.stop);
  if (arguments.stop.stop_requested())
    return outOfTime(arguments,
                     translated("variant %1", {std::to_string(std::min(made + 1, request.plan.variants))}));
  if (!files) return fileFailure(files.error().front().message);
  const auto failure = writeFolder(folder, *files, {overwrites, {}, {}});
  return failure ? fileFailure(failure->message) : kFine;
}

}  // namespace

int makeExercises(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kExercises, translated("make needs one file."));
  if (!arguments.has("-o")) return wrongUsage(kExercises, translated("make needs a folder: -o FOLDER."));
  auto read = requestFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&read)) return wrongUsage(kExercises, error->message);
  if (const auto* error = std::get_if<FileError>(&read)) return fileFailure(error->message);
  auto& request = std::get<SheetRequest>(read);
  auto loaded = loadOrSay(arguments.files.front(), kExercises);
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  const auto& mechanism = std::get<Mechanism>(loaded);
  if (mechanism.n() > kMaxExerciseLinks) return tooLargeForExercises();
  const ExerciseSource source(mechanism);
  const Diagnostics& diagnostics = source.snapshot()->diagnostics;
  std::cerr << diagnosticLines(arguments.files.front(), diagnostics);
  auto kinds = kindsFrom(arguments, source);
  if (const auto* error = std::get_if<UsageError>(&kinds)) return wrongUsage(kExercises, error->message);
  request.plan.kinds = std::get<std::vector<ExerciseKind>>(std::move(kinds));
  request.folder = fs::path(arguments.files.front()).parent_path();
  const int status = hasErrors(diagnostics) ? kMechanismErrors : kFine;
  if (request.plan.kinds.empty()) {
    std::cerr << "geargraph-cli: "
              << translated("Nothing can be asked about this mechanism; no sheet was written.") << '\n';
    return status == kFine ? kUsageOrFile : status;
  }
  const int written = writeSheets(arguments, source, request);
  if (written == kFine && !arguments.has("--seed"))
    std::cerr << translated("--seed %1 makes these sheets again.", {std::to_string(request.plan.seed)})
              << '\n';
  return written == kFine ? status : written;
}

}  // namespace geargraph::cli
