#pragma once

#include "core/design/teeth_wish/teeth_wish.h"

namespace geargraph {

/// The mechanism with one state for each wished ratio in place of its own, with nothing engaged: held links
/// get brakes of their own. Links, joints and meshes keep their positions.
/// @pre the wish was read for this mechanism
[[nodiscard]] Mechanism withWishedStates(const Mechanism& mechanism, const TeethWish& wish);

}  // namespace geargraph
