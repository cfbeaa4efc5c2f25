#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/design/gearboxes/wanted_ratio.h"
#include "core/foundations/base/expected.h"

namespace geargraph {

constexpr std::size_t kMaxHubRatios = 16;
constexpr int kMaxHubSets = 3;
constexpr int kMaxHubSuns = 3;  ///< of a set with stepped planets

/// A ratio that was measured more exactly than the maker's sheet gives it.
struct MeasuredRatio {
  int gear = 0;  ///< position in HubWish::ratios
  WantedRatio ratio;
};

/// What is known of a hub gear: output over input speed of each gear, and what may be inside.
struct HubWish {
  std::vector<WantedRatio> ratios;
  int direct = -1;        ///< the gear that passes the motion through, to which `ratios` relate; -1: not told
  int sets = 1;           ///< at most so many, in series
  bool isStepped = true;  ///< planets may have steps, each with a sun of its own
  std::array<int, 2> planets{12, 30};
  std::array<int, 2> suns{15, 60};
  std::array<int, 2> rings{40, 90};
  int slack = 0;                       ///< by which the centre sums of a set may differ
  std::map<std::string, int> counted;  ///< teeth by the name of the wheel, "2.sun1"
  std::vector<MeasuredRatio> measured;
};

/// Reads a wish (resources/schema/README.md, hardware). Everything that is wrong is a diagnostic with its
/// place in the JSON.
[[nodiscard]] Expected<HubWish> readHubWish(std::string_view json);

}  // namespace geargraph
