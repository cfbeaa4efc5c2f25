#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/design/atlas/chain.h"

namespace geargraph {

/// Equal for two chains if and only if they are isomorphic. Not the same in all versions of nauty: compare,
/// never store.
using ChainForm = std::vector<std::uint64_t>;

/// The form of the displacement graph: links, axes and gear pairs. Cost: some microseconds for a dozen links.
[[nodiscard]] ChainForm displacementForm(const Chain& chain);

/// The form of the rotation graph: the triples (gear, gear; carrier) alone, which are the equations of the
/// speeds. Chains with other shafts may have the same. A link in no triple counts as a link, too.
[[nodiscard]] ChainForm rotationForm(const Chain& chain);

/// By link: the first link that a symmetry of the displacement graph takes it to.
[[nodiscard]] std::vector<int> linkOrbits(const Chain& chain);

/// What two chains are compared by.
enum class ChainLikeness { displacement, rotation };

/// Which link of `b` each link of `a` is; std::nullopt where the chains are not isomorphic. One of the maps
/// where symmetries give several.
[[nodiscard]] std::optional<std::vector<int>> isomorphism(const Chain& a, const Chain& b,
                                                          ChainLikeness likeness);

}  // namespace geargraph
