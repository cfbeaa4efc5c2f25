// `export FILE --to csv --matrix NAME -o OUT` and `export FILE --to csv --all -o FOLDER`; other forms have
// files of their own (export_forms.h).

#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/export_forms.h"
#include "app/cli/load.h"
#include "core/analysis/analysis.h"
#include "core/io/matrix_csv.h"

namespace geargraph::cli {
namespace {

namespace fs = std::filesystem;

std::string matrixNames() {
  std::string text;
  for (const MatrixKind kind : allMatrixKinds()) {
    text += (text.empty() ? "" : ", ") + std::string(matrixCommandName(kind));
  }
  return text;
}

/// Reads an option that has one of a few names.
template <class Value>
std::variant<Value, UsageError> choice(const Arguments& arguments, std::string_view option, Value otherwise,
                                       std::span<const std::pair<std::string_view, Value>> values) {
  const auto given = arguments.value(option);
  if (!given) return otherwise;
  std::string names;
  for (const auto& [name, value] : values) {
    if (*given == name) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return UsageError{std::string(option) + " is one of " + names + "."};
}

std::variant<CsvOptions, UsageError> csvOptions(const Arguments& arguments) {
  using Pair = std::pair<std::string_view, char>;
  constexpr std::array kSeparators = {Pair{"comma", ','}, Pair{"semicolon", ';'}, Pair{"tab", '\t'}};
  constexpr std::array kDecimals = {Pair{"point", '.'}, Pair{"comma", ','}};
  const auto separator = choice<char>(arguments, "--separator", ',', kSeparators);
  const auto decimal = choice<char>(arguments, "--decimal", '.', kDecimals);
  for (const auto* read : {&separator, &decimal}) {
    if (const auto* error = std::get_if<UsageError>(read)) return *error;
  }
  return CsvOptions{std::get<char>(separator), std::get<char>(decimal), !arguments.has("--no-labels"),
                    arguments.has("--bom")};
}

/// Writes one matrix to a file, or to standard output for "-".
std::optional<FileError> writeMatrix(const fs::path& path, const IntegerMatrix& matrix,
                                     const CsvOptions& options) {
  if (path == "-") {
    DescriptorSink out(STDOUT_FILENO);
    writeMatrixCsv<MatrixEntry, UniformRow>(out, matrix, options);
    if (out.failed()) return FileError{"Standard output could not be written."};
    return std::nullopt;
  }
  AtomicFile file(path);
  writeMatrixCsv<MatrixEntry, UniformRow>(file, matrix, options);
  return file.commit();
}

int exportOne(const AnalysisSnapshot& snapshot, const Arguments& arguments, const CsvOptions& options,
              int status) {
  const std::string name = *arguments.value("--matrix");
  const auto& kinds = allMatrixKinds();
  const auto kind =
      std::find_if(kinds.begin(), kinds.end(), [&](MatrixKind k) { return matrixCommandName(k) == name; });
  if (kind == kinds.end()) {
    return wrongUsage(kExport, "There is no matrix \"" + name + "\"; there are " + matrixNames() + ".");
  }
  const IntegerMatrixPtr& matrix = snapshot.matrix(*kind);
  if (!matrix) {
    std::cerr << "geargraph-cli: The matrix \"" << name << "\" needs a spanning tree; nothing was written.\n";
    return status;
  }
  const auto error = writeMatrix(*arguments.value("-o"), *matrix, options);
  return error ? fileFailure(error->message) : status;
}

int exportAll(const AnalysisSnapshot& snapshot, const Arguments& arguments, const CsvOptions& options,
              int status) {
  const fs::path folder = *arguments.value("-o");
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder))
    return fileFailure("The folder \"" + folder.string() + "\" could not be made.");
  std::vector<std::pair<fs::path, IntegerMatrixPtr>> files;
  for (const IntegerMatrixPtr& matrix : snapshot.matrices) {
    if (!matrix) continue;
    files.emplace_back(folder / (std::string(matrixCommandName(matrix->kind())) + ".csv"), matrix);
    if (fs::exists(files.back().first) && !arguments.has("--force")) {
      return fileFailure("\"" + files.back().first.string() +
                         "\" is there already; nothing was written (--force overwrites).");
    }
  }
  for (const auto& [path, matrix] : files) {
    if (const auto failure = writeMatrix(path, *matrix, options)) return fileFailure(failure->message);
  }
  if (files.size() < snapshot.matrices.size()) {
    std::cerr << "geargraph-cli: Matrices that need a spanning tree were left out.\n";
  }
  return status;
}

int run(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kExport, "One file is needed.");
  const std::string form = arguments.value("--to").value_or("");
  if (const auto format = meshFormatFromName(form)) {
    if (!arguments.has("-o")) return wrongUsage(kExport, "-o says where to write.");
    return exportSolids(arguments, *format);
  }
  if (form == "assembly") {
    if (!arguments.has("-o")) return wrongUsage(kExport, "-o says where to write.");
    return exportAssembly(arguments);
  }
  if (form != "csv") return wrongUsage(kExport, "--to is one of csv, stl, obj, ply, glb, 3mf, assembly.");
  if (arguments.has("--matrix") == arguments.has("--all"))
    return wrongUsage(kExport, "Give --matrix NAME or --all.");
  if (!arguments.has("-o")) return wrongUsage(kExport, "-o says where to write.");
  const auto options = csvOptions(arguments);
  if (const auto* error = std::get_if<UsageError>(&options)) return wrongUsage(kExport, error->message);

  const std::string& file = arguments.files.front();
  auto loaded = load(file);
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  auto& document = std::get<Expected<Mechanism>>(loaded);
  if (!document) {
    std::cerr << diagnosticLines(file, document.error());
    return kMechanismErrors;
  }
  const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(std::move(document).value()));
  std::cerr << diagnosticLines(file, snapshot->diagnostics);
  const int status = hasErrors(snapshot->diagnostics) ? kMechanismErrors : kFine;
  const auto write = arguments.has("--all") ? exportAll : exportOne;
  return write(*snapshot, arguments, std::get<CsvOptions>(options), status);
}

constexpr std::array kOptions = {
    Option{"--to", "FORM", "csv: matrices; stl, obj, ply, glb, 3mf: gears; assembly: gears for a check"},
    Option{"--matrix", "NAME",
           "one of incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset"},
    Option{"--all", "", "every matrix, into the folder that -o names"},
    Option{"-o", "OUT", "the file (\"-\" is standard output), or with --all the folder"},
    Option{"--force", "", "with a folder: overwrite files that are there"},
    Option{"--no-labels", "", "without the header row and the first column"},
    Option{"--separator", "NAME", "comma (the default), semicolon or tab"},
    Option{"--decimal", "NAME", "point (the default) or comma"},
    Option{"--bom", "", "begin with a byte order mark, for spreadsheet programs"},
    Option{"--gear", "MESH:SIDE", "one gear in its own frame: 15:tail or 15:head"},
    Option{"--link", "LABEL", "the solids of one link"},
    Option{"--animate", "SECONDS", "with glb: how long one period plays (without: as long as it takes)"},
    Option{"--tolerance", "MODULES", "of solids: farthest chord from the exact form (0.002)"},
    Option{"--frames", "N", "with assembly: poses of every gear, 12 or more (24)"},
};

}  // namespace

const Command kExport = {"export", "FILE --to FORM [...] -o OUT",
                         "Writes matrices as CSV, and gears as 3D files.", kOptions, run};

}  // namespace geargraph::cli
