#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/design/atlas/chain.h"
#include "core/design/atlas/chain_freedom.h"

namespace geargraph {

/// Two links that turn about one axis, the first before the second: a turning joint that may be drawn.
using TurningPair = std::pair<int, int>;

/// The choices that a chain leaves to whoever draws it. Lists hold at most the number that was asked for;
/// counts are complete.
struct ChainChoices {
  /// Trees of turning joints: for each axis of s links one of the s^(s-2) trees on them (Cayley). Above 2^63
  /// std::nullopt.
  std::optional<std::int64_t> treeCount;
  std::vector<std::vector<TurningPair>> trees;

  /// Sets of as many turning pairs as there are freedoms whose speeds determine the motion; of pairs that
  /// need not be drawn together.
  std::int64_t inputSetCount = 0;
  std::vector<std::vector<TurningPair>> inputSets;

  /// The links that are equal as the frame: each is one class of the symmetries.
  std::vector<std::vector<int>> frames;
};

/// At most this many sets of pairs are tried.
constexpr std::int64_t kMaxInputTrials = 200'000;

/// std::nullopt if `stop` was requested, or where more than kMaxInputTrials sets would have to be tried.
/// Inputs are decided with these teeth, one entry a mesh. Cost: an elimination per set of pairs.
[[nodiscard]] std::optional<ChainChoices> choicesOf(const Chain& chain, std::span<const SignedTeeth> teeth,
                                                    std::size_t most, const std::stop_token& stop = {});

}  // namespace geargraph
