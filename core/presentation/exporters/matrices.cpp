// Matrices and tables of statics as CSV: one file, or all of them in a folder.

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include "core/foundations/files/file.h"
#include "core/foundations/files/stoppable_sink.h"
#include "core/presentation/exporters/export_context.h"
#include "core/presentation/exporters/export_families.h"
#include "core/teaching/derivation/named_results.h"
#include "core/teaching/derivation/result_text.h"
#include "core/teaching/derivation/solved_statics.h"

namespace geargraph {
namespace {

namespace fs = std::filesystem;

constexpr ExportRefusal kNoTable{"undefined-table", toTranslate("The mechanism has no such table.")};

/// Reads an option that has one of a few names.
std::variant<char, UsageError> characterOption(const OptionValues& given, std::string_view option,
                                               char otherwise,
                                               std::span<const std::pair<std::string_view, char>> values) {
  const auto word = given.value(option);
  if (!word) return otherwise;
  std::string names;
  for (const auto& [name, value] : values) {
    if (*word == name) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return UsageError{translated("%1 is one of %2.", {option, names})};
}

constexpr std::array kSeparators = {std::pair<std::string_view, char>{"comma", ','},
                                    std::pair<std::string_view, char>{"semicolon", ';'},
                                    std::pair<std::string_view, char>{"tab", '\t'}};
constexpr std::array kDecimals = {std::pair<std::string_view, char>{"point", '.'},
                                  std::pair<std::string_view, char>{"comma", ','}};

template <const auto& pairs>
std::vector<std::string> namesOfPairs() {
  std::vector<std::string> names;
  for (const auto& pair : pairs) names.emplace_back(pair.first);
  return names;
}

std::variant<CsvOptions, UsageError> csvOptions(const OptionValues& given) {
  const auto separator = characterOption(given, "--separator", ',', kSeparators);
  const auto decimal = characterOption(given, "--decimal", '.', kDecimals);
  for (const auto* read : {&separator, &decimal}) {
    if (const auto* error = std::get_if<UsageError>(read)) return *error;
  }
  return CsvOptions{std::get<char>(separator), std::get<char>(decimal), !given.has("--no-labels"),
                    given.has("--bom")};
}

/// Writes one table to a file, or to standard output for "-".
std::optional<ExportError> writeTable(const fs::path& path, const ResultTable& table,
                                      const CsvOptions& options, const std::stop_token& stop) {
  if (path == "-") {  // what has begun is written to its end
    StandardOutput out;
    writeResultCsv(out, table, options);
    return out.failed() ? std::optional(streamFailure()) : std::nullopt;
  }
  AtomicFile file(path);
  StoppableSink sink(file, stop);
  writeResultCsv(sink, table, options);
  if (stop.stop_requested()) return outOfTime("\"" + path.string() + '"');
  const auto error = file.commit();
  return error ? std::optional(ExportError{ExportError::Kind::file, error->message}) : std::nullopt;
}

std::optional<ExportError> writeOneTable(const NamedResult& result, const ResultSource& source,
                                         const ExportTarget& target, const CsvOptions& options, bool isFlawed,
                                         const std::stop_token& stop) {
  const ResultTablePtr table = exactTable(result, source);
  if (table) return writeTable(target.path, *table, options, stop);
  return ExportError{
      isFlawed ? ExportError::Kind::mechanism : ExportError::Kind::limit,
      translated("The matrix \"%1\" needs %2; nothing was written.", {result.name, translated(result.needs)}),
      kNoTable.code};
}

std::optional<ExportError> writeAllTables(const ResultSource& source, const ExportContext& context,
                                          const ExportTarget& target, const CsvOptions& options,
                                          const std::stop_token& stop) {
  const fs::path& folder = target.path;
  const auto fileError = [](std::string message) {
    return ExportError{ExportError::Kind::file, std::move(message)};
  };
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder))
    return fileError(translated("The folder \"%1\" could not be made.", {folder.string()}));
  std::vector<std::pair<fs::path, const NamedResult*>> files;
  for (const NamedResult* result : namedResults()) {
    const bool isOfLoads = result->of == ResultOf::loads || result->of == ResultOf::states;
    if (result->forms(source).empty()) {
      if (!isOfLoads)
        context.tell(translated("Left out: %1, which needs %2.", {result->name, translated(result->needs)}));
      continue;
    }
    files.emplace_back(folder / (std::string(result->name) + ".csv"), result);
    if (fs::exists(files.back().first) && !target.mayOverwrite) {
      return fileError(translated("\"%1\" is there already; nothing was written (--force overwrites).",
                                  {files.back().first.string()}));
    }
  }
  std::vector<std::unique_ptr<AtomicFile>> written;  // they take their names together
  for (const auto& [path, result] : files) {
    StoppableSink sink(*written.emplace_back(std::make_unique<AtomicFile>(path)), stop);
    writeResultCsv(sink, *exactTable(*result, source), options);
    if (stop.stop_requested()) return outOfTime("\"" + path.string() + '"');
  }
  for (const auto& file : written) {
    if (const auto failure = file->commit()) return fileError(failure->message);
  }
  return std::nullopt;
}

ExportResult writeMatrices(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                           const std::stop_token& stop) {
  const bool isAll = given.has("--all");
  if (given.has("--matrix") == isAll)
    return ExportError{ExportError::Kind::usage, translated("Give --matrix NAME or --all.")};
  auto options = csvOptions(given);
  if (auto* error = std::get_if<UsageError>(&options))
    return ExportError{ExportError::Kind::usage, std::move(error->message)};

  auto analyzed = context.live(given, stop);
  if (auto* error = std::get_if<ExportError>(&analyzed)) return std::move(*error);
  auto snapshot = std::get<SnapshotPtr>(std::move(analyzed));
  const bool isFlawed = hasErrors(snapshot->diagnostics);
  const std::string name = given.value("--matrix").value_or("");
  const NamedResult* const result = resultNamed(name);
  if (!isAll && result == nullptr) {
    std::string names;
    for (const std::string& each : resultNames()) names += (names.empty() ? "" : ", ") + each;
    return ExportError{ExportError::Kind::usage,
                       translated("There is no matrix \"%1\"; there are %2.", {name, names})};
  }
  const auto isAsked = [&](ResultOf of) { return isAll || result->of == of; };
  if (isAsked(ResultOf::solution)) {
    snapshot = analyzeFully(snapshot, SolveOptions{false}, stop);
    if (!snapshot) return outOfTime(translated("the solution"));
  }
  ResultSource source{snapshot};
  if (isAsked(ResultOf::loads) || isAsked(ResultOf::states)) {
    source.statics = solvedStatics(snapshot, given.value("--state"), isAsked(ResultOf::states), stop);
    if (!source.statics) return outOfTime(translated("the torques"));
  }
  const auto& csv = std::get<CsvOptions>(options);
  auto error = isAll ? writeAllTables(source, context, target, csv, stop)
                     : writeOneTable(*result, source, target, csv, isFlawed, stop);
  if (error) return *std::move(error);
  return ExportOutcome{isFlawed};
}

constexpr std::array kAllTablesOptions = {
    flagOption("--no-labels"), choiceOption("--separator", namesOfPairs<kSeparators>, "comma"),
    choiceOption("--decimal", namesOfPairs<kDecimals>, "point"), flagOption("--bom")};
constexpr std::array kOneTableOptions = {choiceOption("--matrix", resultNames, {}, true),
                                         kAllTablesOptions[0], kAllTablesOptions[1], kAllTablesOptions[2],
                                         kAllTablesOptions[3]};
constexpr std::array kAllTablesImplied = {std::pair<std::string_view, std::string_view>{"--all", ""}};
constexpr std::array kOneTableRefusals = {&kNoTable};
constexpr std::string_view kMatrices = toTranslate("matrices");

constexpr std::array kMatrixExporters = {
    Exporter{"csv",
             "csv",
             toTranslate("CSV, one matrix or table"),
             kMatrices,
             ExportFiles::file,
             "csv",
             kOneTableOptions,
             {},
             ExportNeed::nothing,
             kOneTableRefusals,
             writeMatrices,
             nullptr,
             true},
    Exporter{"csv-all",
             "csv",
             toTranslate("CSV, all matrices and tables"),
             kMatrices,
             ExportFiles::folder,
             {},
             kAllTablesOptions,
             kAllTablesImplied,
             ExportNeed::nothing,
             {},
             writeMatrices,
             nullptr,
             true},
};

}  // namespace

ExportFamily matrixFamily() {
  return {toTranslate("Matrices"), {}, {}, false, kMatrixExporters, ExportPurpose::data};
}

}  // namespace geargraph
