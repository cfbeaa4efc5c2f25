#pragma once

#include <stop_token>

#include "core/machine/train/train.h"
#include "core/machine/train/train_wheels.h"

namespace geargraph::inline train {

/// Which wheels there are, in their shape but not stacked (stackWheels()). Of no use when `stop` was
/// requested meanwhile.
[[nodiscard]] TrainWheels shapedWheels(const Mechanism& mechanism, const Placement& placement,
                                       const std::stop_token& stop = {});

/// Wheels and their meshes, each turned into the others' spaces; no bodies.
[[nodiscard]] GearTrain toothedTrain(const Mechanism& mechanism, const TrainWheels& wheels);

/// What the teeth of the train, wheels side by side and the assembly of its loops give to find. Those found
/// before `stop` was requested.
[[nodiscard]] Diagnostics wheelDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                           const GearTrain& train, const std::stop_token& stop = {});

/// `interference` of wheels that share a place and do not mesh (wheelsInOnePlace()).
[[nodiscard]] Diagnostics placeDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                           const TrainWheels& wheels, const GearTrain& train,
                                           const std::stop_token& stop = {});

}  // namespace geargraph::inline train
