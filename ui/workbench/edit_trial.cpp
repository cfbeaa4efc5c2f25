#include "ui/workbench/edit_trial.h"

#include <memory>

#include "core/machine/body_layout/derived_geometry.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
namespace {

/// No document's revision is as high: what keeps answers by revision does not take one for the other.
constexpr quint64 kTrials = quint64{1} << 63;

}  // namespace

Diagnostics showTrial(Workbench& workbench, const Edit& edit) {
  static quint64 number = kTrials;  // of the thread of the windows only
  const Expected<PlacedMechanism> tried = edit.reduce(workbench.document().placed());
  if (!tried) {
    workbench.request();
    return tried.error();
  }
  workbench.analysis().request({std::make_shared<const DerivedGeometry>(*tried), ++number});
  return {};
}

}  // namespace geargraph
