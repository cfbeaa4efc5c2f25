#pragma once

#include <string>
#include <vector>

#include "core/design/teeth_search/planet_conditions.h"
#include "core/design/teeth_search/teeth_polynomial.h"
#include "core/design/teeth_wish/teeth_wish.h"
#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placed_mechanism.h"

namespace geargraph {

/// A wheel whose teeth are looked for, with all that have as many: ends of meshes that share it, and the
/// corresponding wheels of equal planets.
struct SearchedWheel {
  std::string name;         ///< of its first end, "15:tail"
  std::vector<int> ends;    ///< 2 * mesh for the tail, 2 * mesh + 1 for the head, ascending
  std::vector<int> counts;  ///< that it may have, ascending; one for a wheel that is pinned or kept
  int drawn = 1;            ///< its teeth in the document
  int copies = 1;           ///< wheels that are one shape
  bool isKept = false;
  bool isRing = false;
  /// Teeth from which on no rack undercuts it without a profile shift; 0: that is not asked of rings, bevels,
  /// worms and pulleys.
  double fewestUncut = 0;

  [[nodiscard]] bool isUndercutWith(int teeth) const;
};

/// low <= sum of factor * teeth <= high.
struct SumCondition {
  struct Term {
    int wheel = 0;
    int factor = 1;
  };
  std::vector<Term> terms;  ///< by wheel, ascending
  std::int64_t low = 0;
  std::int64_t high = 0;
};

/// A wished ratio as a quotient of two polynomials in the teeth. Where one of them is 0, the drive or the
/// driven link stands still, or nothing is determined.
struct SearchedRatio {
  TeethPolynomial numerator;
  TeethPolynomial denominator;
  RatioBounds bounds;
};

/// A wish about a drawn train as equations of whole numbers.
struct TeethProblem {
  PlacedMechanism drawn;
  TeethWish wish;
  Mechanism train;  ///< the same with a state for each wished ratio (withWishedStates())
  std::vector<SearchedWheel> wheels;
  std::vector<int> wheelOfEnd;
  std::vector<SumCondition> sums;  ///< of centre distances
  std::vector<SearchedRatio> ratios;
  /// Have to be 0: rows that depend on others with the drawn teeth, and would lock the train with others.
  std::vector<TeethPolynomial> closures;
  std::vector<PlanetCondition> planets;

  /// Planets of a set that have to go in.
  [[nodiscard]] int planetsOf(const PlanetCondition& set) const {
    return wish.planets > 0 ? wish.planets : set.drawn();
  }
  /// Is anything asked of planets?
  [[nodiscard]] bool hasPlanets() const;
};

/// Rejects what the mechanism has errors with (tree, placement), a ratio that the drawn train does not
/// determine (state-locked, state-free, schema), and more than kMaxVariedMeshes independent meshes.
/// Cost: the placement, and 2^m determinants for each ratio. @pre the wish was read for this mechanism
[[nodiscard]] Expected<TeethProblem> teethProblemOf(const PlacedMechanism& drawn, const TeethWish& wish);

/// The exact ratio of a wish with these teeth, by the states' own elimination; none where there is none.
/// Cost: an elimination. @pre an entry for each wheel
[[nodiscard]] std::optional<Rational> solvedRatio(const TeethProblem& problem, std::size_t ratio,
                                                  std::span<const int> teeth);

}  // namespace geargraph
