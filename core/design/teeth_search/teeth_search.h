#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/design/teeth_search/best_choices.h"

namespace geargraph {

/// How many choices pass each condition, in this order; a later one counts those that passed all before it.
struct TeethCounts {
  std::int64_t tried = 0;      ///< within the limits and with one centre distance between two axes
  std::int64_t turns = 0;      ///< drive and driven link of every ratio turn, and nothing locks
  std::int64_t clears = 0;     ///< planets clear each other
  std::int64_t assembles = 0;  ///< equal planets go in
  std::int64_t hunts = 0;      ///< every pair has a hunting tooth, where that is asked for
  std::int64_t stands = 0;     ///< no gear is undercut, where that is asked for
  std::int64_t within = 0;     ///< every ratio is within its bounds
  std::int64_t accepted = 0;   ///< efficient enough, where that is asked for

  TeethCounts& operator+=(const TeethCounts& more);
  friend bool operator==(const TeethCounts&, const TeethCounts&) = default;
};

/// All choices with this number of teeth of the first free wheel.
struct TeethBranch {
  int teeth = 0;
  TeethCounts counts;
};

struct TeethSearchOptions {
  std::size_t most = 20;  ///< choices that are kept
  /// Called after each branch with the share of branches that are done and the choices found so far.
  std::function<void(double share, std::int64_t found)> progress;
  /// Asked of every choice within the bounds; empty: all are accepted.
  std::function<bool(std::span<const int> teeth)> accepts;
};

/// What a search found. Everything but `best` and `nearest` is the same for every number of choices kept.
struct TeethFound {
  bool isComplete = false;  ///< all were tried
  TeethCounts counts;
  std::vector<int> order;  ///< wheels, as they were gone through; kept ones first
  int first = -1;          ///< the wheel whose teeth name the branches; -1: no wheel is free
  std::vector<TeethBranch> branches;
  std::vector<FoundTeeth> best;
  /// Where none was found: one that meets everything but the bounds, with the smallest error.
  std::optional<FoundTeeth> nearest;
};

/// Tries every choice. Wheels that a centre distance determines follow the others; where the ratios are
/// Moebius functions of the last free wheel and nothing else is asked of it, they are inverted, so that its
/// teeth are counted and not tried one by one. Comparisons are of whole numbers: of 64 or 128 bits where the
/// largest product fits, else of any size. Not complete if `stop` was requested.
///
/// Cost: with m free wheels of k counts O(k^(m-1)) where the last is inverted, else O(k^m); a few 100 ns for
/// each choice that is tried.
[[nodiscard]] TeethFound searchTeeth(const TeethProblem& problem, const TeethSearchOptions& options = {},
                                     const std::stop_token& stop = {});

}  // namespace geargraph
