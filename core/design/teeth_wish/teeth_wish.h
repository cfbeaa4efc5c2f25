#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/design/teeth_wish/ratio_bounds.h"
#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// A ratio that is wanted: the absolute speed of `drive` over that of `driven`, in a state of the document or
/// with links held to the ground.
struct RatioWish {
  LinkOrdinal drive = 0;
  LinkOrdinal driven = 0;
  int state = -1;                 ///< position in the document; -1: `held`
  std::vector<LinkOrdinal> held;  ///< ascending; with neither, the train as it is engaged
  bool isEngaged = false;         ///< neither a state nor held links were given
  RatioBounds bounds;
  friend bool operator==(const RatioWish&, const RatioWish&) = default;
};

/// Whose teeth are wanted, and what they may be.
struct TeethWish {
  std::vector<RatioWish> ratios;  ///< at least one
  int fewest = 17;                ///< teeth of every wheel that may change
  int most = 120;                 ///< of external and bevel gears
  int mostRing = 150;             ///< of ring gears
  /// Equal planets at equal distances that have to go in and to clear each other; 0: those that are drawn.
  int planets = 0;
  int slack = 0;                  ///< teeth by which the centre sums between two axes may differ
  bool hasOneModule = true;       ///< false: gear pairs between two axes that share no wheel have their own
  bool keepsDistances = false;    ///< centre distances and modules stay
  bool onlyHunting = false;       ///< no two teeth meet before all others have been met
  bool allowsUndercut = true;     ///< without a profile shift
  std::vector<int> stock;         ///< the only teeth there are, with repetitions; empty: any
  bool usesStockOnce = false;     ///< each wheel of the stock once
  std::vector<std::string> kept;  ///< wheels that keep their teeth, "15:tail"
  Rational efficiency;            ///< of every mesh; 0: as the document states, if it does
  Rational leastEfficiency;       ///< of every ratio; 0: any
  friend bool operator==(const TeethWish&, const TeethWish&) = default;
};

constexpr int kMaxWishedRatios = 32;
constexpr int kMaxSearchedTeeth = 2'000;
constexpr int kMaxWishedPlanets = 100;
constexpr int kMaxSlack = 2;
constexpr int kMaxStock = 1'000;

/// Reads a wish about this mechanism (`teeth --help`, resources/schema/README.md). Rejects everything that is
/// wrong with it, in the order of the text: `syntax`, `schema` (with the JSON pointer), `unknown-id`.
/// Cost: O(bytes + links).
[[nodiscard]] Expected<TeethWish> readTeethWish(std::string_view json, const Mechanism& mechanism);

}  // namespace geargraph
