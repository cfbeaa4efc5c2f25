#include <algorithm>

#include "core/design/fixes/fix_makers.h"
#include "core/foundations/base/translation.h"
#include "core/theory/states/state_edits.h"

namespace geargraph {

std::vector<Fix> couplingFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  const Mechanism& mechanism = *snapshot.mechanism;
  std::vector<Fix> fixes;
  for (const ElementId& element : diagnostic.elements) {
    if (element.kind != ElementKind::coupling) continue;
    const ShiftElementId coupling(element.id);
    fixes.push_back(
        {translated("Release %1", {wordFor(mechanism, element)}),
         [coupling](const Mechanism& before) { return withCouplingEngaged(before, coupling, false); }});
    if (diagnostic.code == Code::redundantCoupling) break;  // the others hold something
  }
  if (diagnostic.code == Code::redundantCoupling) return fixes;
  return tried(std::move(fixes), mechanism, [](const Mechanism& released) {
    const SnapshotPtr after = analyzeLive(std::make_shared<const Mechanism>(released));
    return after->matroid() == nullptr || after->matroid()->dof == 0;
  });
}

}  // namespace geargraph
