// `export FILE --to dot/graphml/node-link --view digraph/ttgraph -o OUT`: graphs for other programs.

#include <iostream>

#include "app/cli/analyze_document.h"
#include "app/cli/export_forms.h"
#include "core/foundations/base/words.h"

namespace geargraph::cli {

int exportGraph(const Arguments& arguments, GraphForm form) {
  const std::string view = arguments.value("--view").value_or("digraph");
  if (view != "digraph" && view != "ttgraph")
    return wrongUsage(kExport, translated("A graph is the digraph or the ttgraph, not \"%1\".", {view}));
  const auto analyzed = analyzeEngaged(kExport, arguments);
  if (const int* status = std::get_if<int>(&analyzed)) return *status;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  const auto text = view == "digraph" ? std::optional(digraphFile(*snapshot->mechanism, form))
                                      : ttGraphFile(*snapshot, form);
  if (!text) {
    std::cerr
        << "geargraph-cli: "
        << translated(
               "There is no T-T graph: the turning joints are no spanning tree, or a mesh has no carrier; "
               "nothing was written.")
        << '\n';
    return kMechanismErrors;
  }
  const int written = writePicture(*text, *arguments.value("-o"));
  if (written != kFine) return written;
  return hasErrors(snapshot->diagnostics) ? kMechanismErrors : kFine;
}

}  // namespace geargraph::cli
