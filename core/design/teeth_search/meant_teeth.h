#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/design/teeth_search/teeth_answer.h"

namespace geargraph {

/// Teeth that differ from the drawn ones in a few wheels and have all stated ratios.
struct MeantChoice {
  std::vector<int> changed;  ///< wheels by position, ascending
  FoundTeeth found;
};

/// Which teeth a document means whose ratios are not the stated ones.
struct MeantTeeth {
  std::shared_ptr<const TeethProblem> problem;
  std::vector<std::optional<Rational>> drawn;  ///< by wish: the ratio with the drawn teeth; none if it locks
  std::vector<char> fits;                      ///< by wish: is the drawn ratio the stated one?
  int changed = -1;        ///< wheels that differ in every choice, the fewest; -1: there is no choice
  std::int64_t tried = 0;  ///< tooth counts
  std::vector<MeantChoice> choices;  ///< fewest teeth more or less, then the smallest error
};

struct MeantTeethOptions {
  int by = 5;      ///< teeth by which a wheel may differ
  int wheels = 3;  ///< that may differ

  friend bool operator==(const MeantTeethOptions&, const MeantTeethOptions&) = default;
};
constexpr int kMaxMeantTeeth = 20;
constexpr int kMaxMeantWheels = 4;

/// Looks for teeth near the drawn ones with which every ratio of the wish is within its bounds, by the fewest
/// wheels that have to differ: all sets of so many wheels are tried. Limits of the wish on numbers of teeth
/// do not count, wheels that are pinned or kept stay. Centre distances fit as the wish asks, or at least as
/// they do with the drawn teeth. Rejects what teethProblemOf() rejects. Of no use if `stop` was requested.
/// Cost: with m wheels of w that differ searchTeeth() for each of the C(w, m) sets, of 2 by counts a wheel.
[[nodiscard]] Expected<MeantTeeth> meantTeeth(const PlacedMechanism& drawn, const TeethWish& wish,
                                              const MeantTeethOptions& options = {},
                                              const std::stop_token& stop = {});

/// The first `most` choices with all that is told of choices for a wish; complete unless `stop` was
/// requested.
[[nodiscard]] TeethAnswer meantAnswer(const MeantTeeth& meant, std::size_t most,
                                      const std::stop_token& stop = {});

/// `geargraph-meant-teeth` (resources/schema/README.md): the first `limit` choices.
[[nodiscard]] std::string meantTeethJson(const MeantTeeth& meant, std::size_t limit);

}  // namespace geargraph
