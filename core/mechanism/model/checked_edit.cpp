#include "core/mechanism/model/checked_edit.h"

#include <algorithm>

#include "core/mechanism/model/limits.h"

namespace geargraph {

Expected<Mechanism> checkedEdit(Mechanism mechanism, std::string_view pointer,
                                Diagnostics (*checks)(const Mechanism&)) {
  for (const Diagnostics& diagnostics : {checks(mechanism), limitDiagnostics(mechanism)}) {
    const auto found = std::find_if(
        diagnostics.begin(), diagnostics.end(),
        [pointer](const Diagnostic& diagnostic) { return diagnostic.pointer.starts_with(pointer); });
    if (found == diagnostics.end()) continue;
    Diagnostic rejection = *found;
    rejection.pointer.clear();
    return rejection;
  }
  return mechanism;
}

}  // namespace geargraph
