// Graphs for other programs.

#include <array>

#include "core/presentation/export_api/graph_files.h"
#include "core/presentation/exporters/export_context.h"
#include "core/presentation/exporters/export_families.h"

namespace geargraph {
namespace {

constexpr ExportRefusal kNoTtGraph{
    "no-tt-graph", toTranslate("The turning joints are no spanning tree, or a mesh has no carrier.")};

template <GraphForm form>
ExportResult writeGraph(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                        const std::stop_token& stop) {
  const std::string view = given.value("--view").value_or("digraph");
  if (view != "digraph" && view != "ttgraph") {
    return ExportError{ExportError::Kind::usage,
                       translated("A graph is the digraph or the ttgraph, not \"%1\".", {view})};
  }
  const auto analyzed = context.live(given, stop);
  if (const auto* error = std::get_if<ExportError>(&analyzed)) return *error;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  const auto text = view == "digraph" ? std::optional(digraphFile(*snapshot->mechanism, form))
                                      : ttGraphFile(*snapshot, form);
  if (!text) {
    return ExportError{
        ExportError::Kind::mechanism,
        translated(
            "There is no T-T graph: the turning joints are no spanning tree, or a mesh has no carrier; "
            "nothing was written."),
        kNoTtGraph.code};
  }
  if (auto error = writeExport(*text, target.path)) return *std::move(error);
  return ExportOutcome{hasErrors(snapshot->diagnostics)};
}

constexpr std::array kGraphOptions = {choiceOption(
    "--view",
    [] {
      return std::vector<std::string>{"digraph", "ttgraph"};
    },
    "digraph")};
constexpr std::array kGraphRefusals = {&kNoTtGraph};

constexpr std::string_view kGraph = toTranslate("a graph");
constexpr std::array kGraphExporters = {
    Exporter{"dot",
             "dot",
             "Graphviz (DOT)",
             kGraph,
             ExportFiles::file,
             "dot",
             kGraphOptions,
             {},
             ExportNeed::nothing,
             kGraphRefusals,
             writeGraph<GraphForm::dot>,
             nullptr,
             true},
    Exporter{"graphml",
             "graphml",
             "GraphML",
             kGraph,
             ExportFiles::file,
             "graphml",
             kGraphOptions,
             {},
             ExportNeed::nothing,
             kGraphRefusals,
             writeGraph<GraphForm::graphMl>,
             nullptr,
             true},
    Exporter{"node-link",
             "node-link",
             "NetworkX (JSON)",
             kGraph,
             ExportFiles::file,
             "json",
             kGraphOptions,
             {},
             ExportNeed::nothing,
             kGraphRefusals,
             writeGraph<GraphForm::nodeLink>,
             nullptr,
             true},
};

}  // namespace

ExportFamily graphFamily() {
  return {toTranslate("Graphs"), toTranslate("graphs"), {}, false, kGraphExporters, ExportPurpose::data};
}

}  // namespace geargraph
