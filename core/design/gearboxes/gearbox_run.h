#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/design/gearboxes/gearbox.h"
#include "core/foundations/base/expected.h"

namespace geargraph {

/// The layouts with index = part modulo count of the ordered list: what one of several machines searches.
struct Shard {
  int part = 0;
  int count = 1;
  friend auto operator<=>(const Shard&, const Shard&) = default;
};

/// What a search has looked at and found.
struct GearboxSearch {
  std::int64_t layouts = 0;   ///< in the whole list
  std::int64_t searched = 0;  ///< of these
  SearchCounts counts;
  JudgeCounts judged;
  std::vector<Gearbox> found;  ///< in the order of ranksBefore(); of a part of a search in that of the list
  /// Nothing was left out: false wherever ring ratios were sampled.
  bool isComplete = false;

  /// Adds what another part of the same list found.
  void add(GearboxSearch other);
};

struct GearboxRunOptions {
  Shard shard;
  std::int64_t from = 0;  ///< of the shard's layouts, those before are done
  int threads = 1;
  /// Called by one thread at a time after each block, in the order of the list, with what it added and how
  /// many of the shard's layouts are done now, `from` included. Returns false to end the search.
  std::function<bool(const GearboxSearch& block, std::int64_t done, std::int64_t total)> onBlock;
};

/// Searches the layouts of a shard in blocks. The result, also what onBlock() sees, does not depend on the
/// number of threads. std::nullopt if `stop` was requested or onBlock() ended it.
/// Every gearbox is checked by the states of its document (checkByDocument()).
[[nodiscard]] std::optional<GearboxSearch> findGearboxes(const GearboxWish& wish,
                                                         const GearboxRunOptions& options = {},
                                                         const std::stop_token& stop = {});

/// Can no gearbox meet the wish, because the elements have fewer states than gears are wanted?
[[nodiscard]] bool hasTooFewStates(const GearboxWish& wish);

/// Layouts in one block of findGearboxes().
constexpr std::int64_t kBlockLayouts = 64;

}  // namespace geargraph
