#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/design/teeth_search/teeth_answer.h"

namespace geargraph {

/// The teeth of a set that come nearest to a ratio, by the search for teeth of drawn trains: all within
/// `wish` whose ratio has the sign of the wanted one, the smallest error first, among equals the smallest
/// largest wheel. Its first ratio is `wanted`; bounds are widened until `isEnough` accepts what was found, or
/// everything was tried. Empty where the set cannot have a ratio of this sign.
/// @pre the wish is for `set`, with one ratio, of which only drive, driven and held links count
[[nodiscard]] std::vector<FoundTeeth> nearestTeeth(
    const Mechanism& set, TeethWish wish, const Rational& wanted,
    const std::function<bool(const std::vector<FoundTeeth>&)>& isEnough);

}  // namespace geargraph
