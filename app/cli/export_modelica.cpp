// `export FILE --to modelica -o OUT`: the mechanism as equations between the angles of its joints.

#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/export_forms.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/words.h"
#include "core/presentation/simulators/modelica.h"

namespace geargraph::cli {

int exportModelica(const Arguments& arguments) {
  auto document = loadEngaged(kExport, arguments);
  if (const int* status = std::get_if<int>(&document)) return *status;
  const SnapshotPtr snapshot = analyzeLive(
      std::make_shared<const Mechanism>(std::get<Mechanism>(std::move(document))), 0, arguments.stop);
  if (!snapshot) return outOfTime(arguments, translated("the analysis"));
  std::cerr << diagnosticLines(arguments.files.front(), snapshot->diagnostics);
  if (hasErrors(snapshot->diagnostics) || snapshot->matroid() == nullptr) return kMechanismErrors;
  return writePicture(modelicaText(*snapshot), *arguments.value("-o"));
}

}  // namespace geargraph::cli
