#pragma once

#include "core/gears/phase.h"
#include "core/gears/train.h"

namespace geargraph {

/// `undercut` and `interference` of the train's gears, with the numbers that say how to mend them.
[[nodiscard]] Diagnostics toothDiagnostics(const Mechanism& mechanism, const GearTrain& train);

/// `assembly` for every mesh whose residual does not fit, with the nearest positions or tooth counts that do.
[[nodiscard]] Diagnostics assemblyDiagnostics(const Mechanism& mechanism, const GearTrain& train);

}  // namespace geargraph
