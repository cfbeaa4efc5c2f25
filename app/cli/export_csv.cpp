// `export FILE --to csv --matrix NAME -o OUT` and `export FILE --to csv --all -o FOLDER`.

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/cli/analyze_document.h"
#include "app/cli/command.h"
#include "app/cli/export_forms.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/words.h"
#include "core/foundations/files/file.h"
#include "core/foundations/files/stoppable_sink.h"
#include "core/presentation/results/csv_tables.h"

namespace geargraph::cli {
namespace {

namespace fs = std::filesystem;

/// Reads an option that has one of a few names.
std::variant<char, UsageError> choice(const Arguments& arguments, std::string_view option, char otherwise,
                                      std::span<const std::pair<std::string_view, char>> values) {
  const auto given = arguments.value(option);
  if (!given) return otherwise;
  std::string names;
  for (const auto& [name, value] : values) {
    if (*given == name) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return UsageError{translated("%1 is one of %2.", {option, names})};
}

std::variant<CsvOptions, UsageError> csvOptions(const Arguments& arguments) {
  using Pair = std::pair<std::string_view, char>;
  constexpr std::array kSeparators = {Pair{"comma", ','}, Pair{"semicolon", ';'}, Pair{"tab", '\t'}};
  constexpr std::array kDecimals = {Pair{"point", '.'}, Pair{"comma", ','}};
  const auto separator = choice(arguments, "--separator", ',', kSeparators);
  const auto decimal = choice(arguments, "--decimal", '.', kDecimals);
  for (const auto* read : {&separator, &decimal}) {
    if (const auto* error = std::get_if<UsageError>(read)) return *error;
  }
  return CsvOptions{std::get<char>(separator), std::get<char>(decimal), !arguments.has("--no-labels"),
                    arguments.has("--bom")};
}

/// Writes one table to a file, or to standard output for "-"; the exit status, `fine` where all went well.
int writeTable(const fs::path& path, const CsvTable& table, const CsvOptions& options,
               const Arguments& arguments, int fine) {
  if (path == "-") {  // what has begun is written to its end
    StandardOutput out;
    table.write(out, options);
    return out.failed() ? fileFailure(translated("Standard output could not be written.")) : fine;
  }
  AtomicFile file(path);
  StoppableSink sink(file, arguments.stop);
  table.write(sink, options);
  if (arguments.stop.stop_requested()) return outOfTime(arguments, "\"" + path.string() + '"');
  const auto error = file.commit();
  return error ? fileFailure(error->message) : fine;
}

std::string tableNames(const std::vector<CsvTable>& tables) {
  std::string text;
  for (const CsvTable& table : tables) text += (text.empty() ? "" : ", ") + std::string(table.name);
  return text;
}

int exportOne(const std::vector<CsvTable>& tables, const Arguments& arguments, const CsvOptions& options,
              int status) {
  const std::string name = *arguments.value("--matrix");
  const auto table =
      std::find_if(tables.begin(), tables.end(), [&](const CsvTable& t) { return t.name == name; });
  if (table == tables.end()) {
    return wrongUsage(kExport,
                      translated("There is no matrix \"%1\"; there are %2.", {name, tableNames(tables)}));
  }
  if (!table->write) {
    std::cerr << "geargraph-cli: "
              << translated("The matrix \"%1\" needs %2; nothing was written.",
                            {name, translated(table->needs)})
              << '\n';
    return status == kFine ? kResourceLimit : status;
  }
  return writeTable(*arguments.value("-o"), *table, options, arguments, status);
}

int exportAll(const std::vector<CsvTable>& tables, const Arguments& arguments, const CsvOptions& options,
              int status) {
  const fs::path folder = *arguments.value("-o");
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder))
    return fileFailure(translated("The folder \"%1\" could not be made.", {folder.string()}));
  std::vector<std::pair<fs::path, const CsvTable*>> files;
  for (const CsvTable& table : tables) {
    if (!table.write && table.ofLoads) continue;
    if (!table.write) {
      std::cerr << "geargraph-cli: "
                << translated("Left out: %1, which needs %2.", {table.name, translated(table.needs)}) << '\n';
      continue;
    }
    files.emplace_back(folder / (std::string(table.name) + ".csv"), &table);
    if (fs::exists(files.back().first) && !arguments.has("--force")) {
      return fileFailure(translated("\"%1\" is there already; nothing was written (--force overwrites).",
                                    {files.back().first.string()}));
    }
  }
  std::vector<std::unique_ptr<AtomicFile>> written;  // they take their names together
  for (const auto& [path, table] : files) {
    StoppableSink sink(*written.emplace_back(std::make_unique<AtomicFile>(path)), arguments.stop);
    table->write(sink, options);
    if (arguments.stop.stop_requested()) return outOfTime(arguments, "\"" + path.string() + '"');
  }
  for (const auto& file : written) {
    if (const auto failure = file->commit()) return fileFailure(failure->message);
  }
  return status;
}

}  // namespace

int exportCsv(const Arguments& arguments) {
  if (arguments.has("--matrix") == arguments.has("--all"))
    return wrongUsage(kExport, translated("Give --matrix NAME or --all."));
  const auto options = csvOptions(arguments);
  if (const auto* error = std::get_if<UsageError>(&options)) return wrongUsage(kExport, error->message);

  auto analyzed = analyzeEngaged(kExport, arguments);
  if (const int* status = std::get_if<int>(&analyzed)) return *status;
  auto snapshot = std::get<SnapshotPtr>(std::move(analyzed));
  const int status = hasErrors(snapshot->diagnostics) ? kMechanismErrors : kFine;
  if (arguments.has("--all") || arguments.value("--matrix") == "solution") {
    snapshot = analyzeFully(snapshot, SolveOptions{false}, arguments.stop);
    if (!snapshot) return outOfTime(arguments, translated("the solution"));
  }
  SolvedStaticsPtr statics;
  if (arguments.has("--all") || isOfStatics(*arguments.value("--matrix"))) {
    const bool allStates = arguments.has("--all") || isOfAllStates(*arguments.value("--matrix"));
    statics = solvedStatics(snapshot, arguments.value("--state"), allStates, arguments.stop);
    if (!statics) return outOfTime(arguments, translated("the torques"));
  }
  const auto write = arguments.has("--all") ? exportAll : exportOne;
  return write(csvTables(snapshot, statics), arguments, std::get<CsvOptions>(options), status);
}

}  // namespace geargraph::cli
