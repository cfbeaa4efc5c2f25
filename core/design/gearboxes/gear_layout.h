#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace geargraph {

constexpr int kMaxSets = 4;    ///< a Ravigneaux set counts twice
constexpr int kMaxShafts = 9;  ///< rotating links, the input shaft too

/// How the planets of a set join its sun and its ring.
enum class SetKind : std::uint8_t {
  simple,        ///< each planet meshes with both
  doublePlanet,  ///< in pairs: one meshes with the sun, one with the ring
  ravigneaux     ///< a large sun on long planets; a small one on short planets, which mesh with the long ones
};

/// A set with three members as the search sees it: N_S w_S + N_R w_R = (N_S + N_R) w_C of a simple one,
/// N_S w_S - N_R w_R = (N_S - N_R) w_C of one with double planets. A Ravigneaux set is one of each, in this
/// order, with carrier and ring in common.
struct BasicSet {
  bool isDouble = false;
  bool sharesRing = false;  ///< carrier and ring are those of the set before
  friend bool operator==(const BasicSet&, const BasicSet&) = default;
};
using BasicSets = std::vector<BasicSet>;

[[nodiscard]] BasicSets basicSets(const std::vector<SetKind>& kinds);

enum class SetMember : std::uint8_t { sun, carrier, ring };

/// Which members of the sets are one link, and which links are input and output.
struct GearLayout {
  /// By set and SetMember: 0 the housing, else the number of a link, 1 .. shafts.
  std::array<std::uint8_t, 3 * kMaxSets> linkOf{};
  std::uint8_t input = 0;  ///< may have no member
  std::uint8_t output = 0;

  [[nodiscard]] int link(int set, SetMember member) const {
    return linkOf[3 * static_cast<std::size_t>(set) + static_cast<std::size_t>(member)];
  }
  friend auto operator<=>(const GearLayout&, const GearLayout&) = default;
};

/// "S1", "C2", ...: the name of a member in files; set counts from 0.
[[nodiscard]] std::string memberName(int set, SetMember member);

struct LayoutLimits {
  std::vector<SetKind> kinds;
  int shafts = 5;         ///< rotating links, the input shaft too
  int held = 0;           ///< members that are part of the housing
  bool freeInput = true;  ///< the input shaft may have no member: clutches drive others from it
};

/// Every layout within the limits, once, sorted: layouts that differ in the order of equal sets are one, the
/// least. Left out, by arithmetic modulo a prime at random tooth counts: sets whose equations depend on each
/// other, links that always turn as one, stand still, or input and output in a fixed ratio. std::nullopt if
/// `stop` was requested.
/// Cost: set partitions of the members times the choices of input and output; a second for four simple sets.
/// @pre at most kMaxSets sets and kMaxShafts shafts
[[nodiscard]] std::optional<std::vector<GearLayout>> gearLayouts(const LayoutLimits& limits,
                                                                 const std::stop_token& stop = {});

}  // namespace geargraph
