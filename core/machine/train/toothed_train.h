#pragma once

#include <stop_token>

#include "core/machine/train/train.h"
#include "core/machine/train/train_wheels.h"

namespace geargraph {

/// The wheels of a mechanism, shaped but not stacked (stackWheels()). The result is meaningless if `stop` was
/// requested meanwhile.
[[nodiscard]] TrainWheels shapedWheels(const Mechanism& mechanism, const Placement& placement,
                                       const std::stop_token& stop = {});

/// The gears and meshes of these wheels, turned so that their teeth mesh; without bodies.
[[nodiscard]] GearTrain toothedTrain(const Mechanism& mechanism, const TrainWheels& wheels);

/// The diagnostics of the teeth of the train, of adjacent wheels and of the assembly of its loops. Incomplete
/// if `stop` was requested meanwhile.
[[nodiscard]] Diagnostics wheelDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                           const GearTrain& train, const std::stop_token& stop = {});

/// `interference` for wheels that overlap and do not mesh (overlappingWheels()). Incomplete if `stop` was
/// requested meanwhile.
[[nodiscard]] Diagnostics placeDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                           const TrainWheels& wheels, const GearTrain& train,
                                           const std::stop_token& stop = {});

}  // namespace geargraph
