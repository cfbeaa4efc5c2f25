#pragma once

#include "core/machine/train/train_wheels.h"

namespace geargraph {

/// The fewest teeth with which a rack would cut this wheel without undercut and without a profile shift: by
/// the angle that the document states for its teeth, its helix and the rack's rounded corner
/// (fewestTeethWithoutUndercut()). Not rounded; its own number of teeth does not count.
/// @pre the wheel is of wheelsOf(), an external one with teeth
[[nodiscard]] double fewestTeethUncut(const Mechanism& mechanism, const TrainWheel& wheel);

}  // namespace geargraph
