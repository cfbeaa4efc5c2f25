// `convert FILE --to FORM`: documents as tables (CSV) and graphs (DOT, GraphML, node-link JSON), and back.

#include <array>
#include <iostream>
#include <optional>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_graph.h"
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

/// The document of a file, whichever of the three it is; or why there is none, which was reported, as the
/// exit status.
std::variant<Mechanism, int> readAny(const std::string& path) {
  const auto bytes = readFile(path, kLargestFile);
  if (const auto* error = std::get_if<FileError>(&bytes)) return fileFailure(error->message);
  auto read = readAnyMechanism(std::get<std::string>(bytes));
  if (!read) {
    std::cerr << diagnosticLines(path, read.error());
    return static_cast<int>(kMechanismErrors);
  }
  for (const std::string& note : read->notes) std::cerr << path << ": note: " << note << '\n';
  return std::move(read).value().mechanism;
}

/// What is lost on the way, in one line to standard error.
void reportLosses(const std::vector<std::string>& lost, const char* form) {
  if (lost.empty()) return;
  std::cerr << "geargraph-cli: " << filled(translated(form), {listed(lost, kAllNames)}) << '\n';
}

/// The text in the form that was asked for; none where there is no such form.
std::optional<std::string> converted(const Mechanism& mechanism, const std::string& form,
                                     const TableOptions& options) {
  if (form == "geargraph") return writeMechanism(mechanism);
  if (form == "csv") {
    TablePart part = tablePart(mechanism);
    reportLosses(part.lost, toTranslate("Not in the table: %1."));
    return writeMechanismTable(part.mechanism, options);
  }
  const auto graph = graphFormFromName(form);
  if (!graph) return std::nullopt;
  reportLosses(tablePart(mechanism).lost, toTranslate("Not in the graph: %1."));
  return digraphFile(mechanism, *graph);
}

int runConvert(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kConvert, translated("One file is needed."));
  const std::string form = arguments.value("--to").value_or("");
  if (form != "csv" && form != "geargraph" && !graphFormFromName(form))
    return wrongUsage(kConvert, translated("--to is one of csv, geargraph, dot, graphml, node-link."));
  const auto separator = separatorFrom(arguments);
  if (!separator) return wrongUsage(kConvert, translated("--separator is one of comma, semicolon, tab."));
  for (const char* const option : {"--separator", "--bom"}) {
    if (form != "csv" && arguments.has(option))
      return wrongUsage(kConvert, translated("%1 has no meaning with %2; it is an option of %3.",
                                             {option, "--to " + form, "--to csv"}));
  }
  const auto document = readAny(arguments.files.front());
  if (const int* status = std::get_if<int>(&document)) return *status;
  const auto text =
      converted(std::get<Mechanism>(document), form, TableOptions{*separator, arguments.has("--bom")});
  if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the conversion"));
  return writeOutput(*text, arguments.value("-o").value_or("-"));
}

constexpr std::array kConvertOptions = {
    Option{"--to", "csv|geargraph|dot|graphml|node-link",
           toTranslate("csv: a table with a row for each link, axis, turning joint, gear mesh, ...; "
                       "geargraph: a document; "
                       "dot, graphml, node-link: the digraph; each is read back, graphs of other programs, "
                       "too, where edges "
                       "have kind, axis and tooth counts")},
    Option{"-o", "OUT", toTranslate("the file (standard output)")},
    Option{"--separator", "comma|semicolon|tab",
           toTranslate("of a table that is written (comma); reading recognises it")},
    Option{"--bom", "", toTranslate("begin a table with a byte order mark, for spreadsheet programs")},
};

}  // namespace

const Command kConvert = {
    "convert",
    "FILE --to FORM [--separator NAME] [--bom] [-o OUT]",
    toTranslate("Converts documents to tables (CSV) and graphs, and back; FILE is any of them."),
    kConvertOptions,
    runConvert,
    false,
    false};

}  // namespace geargraph::cli
