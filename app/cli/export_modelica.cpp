// `export FILE --to modelica -o OUT`: the mechanism as equations between the angles of its joints.

#include "app/cli/analyze_document.h"
#include "app/cli/export_forms.h"
#include "core/presentation/simulators/modelica.h"

namespace geargraph::cli {

int exportModelica(const Arguments& arguments) {
  const auto analyzed = analyzeEngaged(kExport, arguments);
  if (const int* status = std::get_if<int>(&analyzed)) return *status;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  if (hasErrors(snapshot->diagnostics) || snapshot->matroid() == nullptr) return kMechanismErrors;
  return writePicture(modelicaText(*snapshot), *arguments.value("-o"));
}

}  // namespace geargraph::cli
