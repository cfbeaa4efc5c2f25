// `convert FILE --to FORM`: documents as tables (CSV) and back, and as graphs for other programs.

#include <array>
#include <iostream>
#include <optional>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/export_forms.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/wording.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_table.h"

namespace geargraph::cli {
namespace {

std::optional<char> separatorFrom(const Arguments& arguments) {
  const std::string name = arguments.value("--separator").value_or("comma");
  if (name == "comma") return ',';
  if (name == "semicolon") return ';';
  if (name == "tab") return '\t';
  return std::nullopt;
}

/// The document of a file, whichever of the two it is; or why there is none, which was reported, as the exit
/// status.
std::variant<Mechanism, int> readEither(const std::string& path) {
  const auto bytes = readFile(path, kLargestFile);
  if (const auto* error = std::get_if<FileError>(&bytes)) return fileFailure(error->message);
  auto document = readMechanismOrTable(std::get<std::string>(bytes));
  if (document) return std::move(document).value();
  std::cerr << diagnosticLines(path, document.error());
  return static_cast<int>(kMechanismErrors);
}

/// What is lost on the way, in one line to standard error.
void reportLosses(const std::vector<std::string>& lost, std::string_view form) {
  if (lost.empty()) return;
  std::cerr << "geargraph-cli: Not in the " << form << ": " << listed(lost, kAllNames) << ".\n";
}

/// What a graph leaves out of this mechanism beside what tables do.
std::vector<std::string> lostInGraphs(const Mechanism& mechanism) {
  std::vector<std::string> lost{"geometry", "kinds of meshes"};
  if (mechanism.inputs) lost.emplace_back("inputs");
  if (!mechanism.couplings.empty()) lost.emplace_back("couplings and states");
  if (!mechanism.loads.empty() || mechanism.balances) lost.emplace_back("loads and balances");
  return lost;
}

/// The text in the form that was asked for; none where there is no such form.
std::optional<std::string> converted(const Mechanism& mechanism, const std::string& form,
                                     const TableOptions& options) {
  if (form == "geargraph") return writeMechanism(mechanism);
  if (form == "csv") {
    TablePart part = tablePart(mechanism);
    reportLosses(part.lost, "table");
    return writeMechanismTable(part.mechanism, options);
  }
  const auto graph = graphFormFromName(form);
  if (!graph) return std::nullopt;
  reportLosses(lostInGraphs(mechanism), "graph");
  return digraphFile(mechanism, *graph);
}

int run(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kConvert, "One file is needed.");
  const std::string form = arguments.value("--to").value_or("");
  if (form != "csv" && form != "geargraph" && !graphFormFromName(form))
    return wrongUsage(kConvert, "--to is one of csv, geargraph, dot, graphml, node-link.");
  const auto separator = separatorFrom(arguments);
  if (!separator) return wrongUsage(kConvert, "--separator is one of comma, semicolon, tab.");
  for (const char* const option : {"--separator", "--bom"}) {
    if (form != "csv" && arguments.has(option))
      return wrongUsage(kConvert, std::string(option) + " has no meaning with --to " + form +
                                      "; it is an option of --to csv.");
  }
  const auto document = readEither(arguments.files.front());
  if (const int* status = std::get_if<int>(&document)) return *status;
  const auto text =
      converted(std::get<Mechanism>(document), form, TableOptions{*separator, arguments.has("--bom")});
  if (arguments.stop.stop_requested()) return outOfTime(arguments, "the conversion");
  return writePicture(*text, arguments.value("-o").value_or("-"));
}

constexpr std::array kOptions = {
    Option{"--to", "csv|geargraph|dot|graphml|node-link",
           "csv: a table with a row for each link, axis, turning joint, gear mesh, ..., which convert reads "
           "back; geargraph: a document; dot, graphml, node-link: the digraph, which is not read back"},
    Option{"-o", "OUT", "the file (standard output)"},
    Option{"--separator", "comma|semicolon|tab", "of a table that is written (comma); reading recognises it"},
    Option{"--bom", "", "begin a table with a byte order mark, for spreadsheet programs"},
};

}  // namespace

const Command kConvert = {"convert",
                          "FILE --to FORM [--separator NAME] [--bom] [-o OUT]",
                          "Converts documents to tables (CSV) and back, and to graphs; FILE is either.",
                          kOptions,
                          run,
                          false,
                          false};

}  // namespace geargraph::cli
