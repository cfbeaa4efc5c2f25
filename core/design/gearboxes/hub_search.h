#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/design/gearboxes/hub_wish.h"

namespace geargraph {

/// One sun of a set with the step of the planets that it meshes with, and what holding it does.
struct HubSun {
  int teeth = 0;
  int planet = 0;
  int reduction = -1;  ///< gear with the ring driving and the carrier driven, others passed through; -1: none
  int increase = -1;   ///< the same with carrier and ring exchanged
  friend bool operator==(const HubSun&, const HubSun&) = default;
};

/// A set of a hub: the ring is on the step of the first sun.
struct HubSet {
  std::vector<HubSun> suns;
  int ring = 0;
  std::vector<int> planets;  ///< numbers of equal planets that can be assembled, 2 to 8
  /// Speed of the carrier over that of the ring with a sun held: 1 / (1 + S p_r / (p R)).
  [[nodiscard]] Rational reduction(std::size_t sun) const;
  friend bool operator==(const HubSet&, const HubSet&) = default;
};

/// Teeth of all sets with which every ratio is met.
struct HubCandidate {
  std::vector<HubSet> sets;
  std::vector<Rational> ratios;  ///< by gear, output over input
  [[nodiscard]] bool assembles() const;
};

/// A wheel that can be counted, "2.sun1", or a gear that can be measured, "gear 6"; by candidate the answer.
struct HubQuestion {
  std::string name;
  bool isCount = true;
  std::vector<std::string> answers;  ///< by candidate
  std::size_t leaves = 0;            ///< candidates with the most frequent answer
};

struct HubSearch {
  int structures = 0;               ///< ways to explain the ratios with the fewest suns
  std::vector<std::int64_t> tried;  ///< by set of the first structure: tooth sets within the limits
  std::vector<HubCandidate> assembled;
  std::vector<HubCandidate> others;    ///< ratios fit, but no equal planets can be assembled
  std::vector<HubQuestion> questions;  ///< those that part the candidates, the most decisive first
};

/// Turns of the input by which a measured gear is told from another, read to a degree.
constexpr int kMeasuredTurns = 50;

/// Every tooth set within the limits. Sets are in series; each passes its input through or holds one of its
/// suns. Each set's own ratios are gears of their own; gears that are not are products of one ratio of each
/// of several sets. Of all such structures those with the fewest suns are searched, all tooth counts of them
/// (complete within the wish); comparisons with the intervals are exact. Sorted: fewest sets, most numbers of
/// planets, fewest teeth.
/// std::nullopt if `stop` was requested.
/// Cost: by set the pairs of ring and planet times suns, then all pairs of the sets' teeth that fit.
[[nodiscard]] std::optional<HubSearch> findHubs(const HubWish& wish, const std::stop_token& stop = {});

/// Leaves the candidates of which a wheel has so many teeth, or a measured gear turns the output so far, and
/// what tells these apart. `question` names the wheel or the gear, `answer` is the number.
[[nodiscard]] HubSearch narrowed(HubSearch search, const HubQuestion& question, const std::string& answer);

/// The name of a wheel: "1.ring", "1.sun2", "1.planet2"; sets and steps count from 1.
[[nodiscard]] std::string hubWheelName(std::size_t set, std::string_view kind, std::size_t step);
/// All wheels of a candidate by name.
[[nodiscard]] std::vector<std::pair<std::string, int>> hubWheels(const HubCandidate& candidate);

}  // namespace geargraph
