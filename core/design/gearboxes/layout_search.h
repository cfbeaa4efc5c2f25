#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/design/gearboxes/element_classes.h"

namespace geargraph {

/// A ratio as the search in doubles sees it.
struct RatioTarget {
  double log = 0;        ///< of the size of the ratio
  double tolerance = 0;  ///< of the logarithm
};

enum class ReverseWish : std::uint8_t { none, any, ratio };

/// What a search looks for, in doubles; what it finds is judged in fractions elsewhere.
struct SearchProblem {
  LayoutLimits limits;
  std::vector<RatioTarget> forward;
  ReverseWish reverse = ReverseWish::any;
  RatioTarget reverseTarget;
  int mostElements = 4;
  bool isSingleShift = true;  ///< neighbouring gears differ in one element for one
  double leastK = 1.5;        ///< ring over sun of a set
  double mostK = 4;
  int steps = 8;  ///< a set: of the grid of k, or of the sample for four freedoms (kSamples in all)
  /// Whether branches that cannot succeed are cut off by bounds of the ratios in a cell; false tries all, for
  /// measurements.
  bool prunes = true;
};

constexpr int kSamples = 24;  ///< points of k at which element sets of four freedoms are looked at

/// A gearbox with its ring ratios refined, not yet in whole teeth.
struct GearboxCandidate {
  GearLayout layout;
  std::vector<ElementClass> elements;            ///< those that are engaged in some gear
  std::vector<std::vector<std::uint8_t>> gears;  ///< by gear, reverse last: positions in `elements`
  std::vector<double> k;
  double error = 0;  ///< largest of the logarithms
};

/// What was looked at.
struct SearchCounts {
  std::int64_t states = 0;      ///< gears at general tooth counts, of all layouts
  std::int64_t points = 0;      ///< layouts times points of k
  std::int64_t candidates = 0;  ///< shift tables that were refined
  SearchCounts& operator+=(const SearchCounts& other);
};

/// Every candidate of one layout whose ratios come within three tolerances of the wish, in a fixed order.
/// Ends early once `stop` is requested; the result is then of no use.
///
/// Up to three freedoms: at each point of a geometric grid of k the gears are chosen one after another among
/// the states that can come near inside the cell. With four: sets of elements nearly all of whose states are
/// gears, and one of them direct if 1 is wanted, at general tooth counts; then their ratios in order at
/// sampled k. Both are refined by Gauss and Newton's method in the logarithms of ratios and k.
[[nodiscard]] std::vector<GearboxCandidate> searchLayout(const SearchProblem& problem,
                                                         const GearLayout& layout, SearchCounts& counts,
                                                         const std::stop_token& stop = {});

/// The grid of one set's k: the middles of cells of equal ratio.
[[nodiscard]] std::vector<double> gridOf(const SearchProblem& problem);

}  // namespace geargraph
