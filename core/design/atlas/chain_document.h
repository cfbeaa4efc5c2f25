#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/design/atlas/chain.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// What a chain leaves open that a document states.
struct ChainDrawing {
  std::optional<int> frame = {};  ///< the link that is the ground; std::nullopt: usualFrame(), or another
                                  ///< with which the bodies have room
  std::vector<int> rings = {};    ///< meshes, by position, of which one gear is a ring
};

/// The link that is held where nothing else is asked for: of those on the axis with the most links one that
/// carries no gear pair, with the fewest gear pairs of its own.
[[nodiscard]] int usualFrame(const Chain& chain);

/// A document of the chain that opens, has the chain's freedom and can be seen in three dimensions. The frame
/// is the ground; ids are the paper's labels, names give the links' numbers in the chain, from 1. The axes
/// are parallel; those on one link are the corners of a regular polygon (to a hundredth of a millimetre),
/// with the fewest and shortest diagonals for gear pairs; each gear pair has two wheels of its own, hence a
/// plane and a module. All links of a coaxial bundle turn on the one nearest the frame. Teeth are different
/// primes, so that no ratio is a special one. Of a ring gear pair the ring is the gear on the axis nearer the
/// frame. A degenerate chain gets a document, too, which cannot turn.
///
/// The size of outer polygons, and where it is open the frame, are the first of a fixed list with which no
/// bodies overlap (DerivedGeometry::diagnostics()), else those with the fewest diagnostics. Of the chains of
/// one freedom up to 6 links none is left with any, of those of 7 links four. Once `stop` is requested the
/// best so far is taken. Cost: about a millisecond per attempt, at most 8 a frame.
[[nodiscard]] Mechanism chainDocument(const Chain& chain, std::string name, const ChainDrawing& drawing = {},
                                      const std::stop_token& stop = {});

}  // namespace geargraph
