#include "core/design/gearboxes/gear_layout.h"

#include <algorithm>
#include <numeric>

#include "core/design/gearboxes/speed_space.h"
#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

/// The orders of the sets in which equal ones are exchanged; a Ravigneaux set moves with both its parts.
std::vector<std::vector<int>> exchanges(const std::vector<SetKind>& kinds) {
  std::vector<int> order(kinds.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<int> firsts;
  for (int first = 0; const SetKind kind : kinds) {
    firsts.push_back(first);
    first += kind == SetKind::ravigneaux ? 2 : 1;
  }
  std::vector<std::vector<int>> result;
  do {
    std::vector<int> sets;
    bool fits = true;
    for (std::size_t place = 0; place < order.size() && fits; ++place) {
      const auto from = static_cast<std::size_t>(order[place]);
      fits = kinds[from] == kinds[place];
      sets.push_back(firsts[from]);
      if (kinds[from] == SetKind::ravigneaux) sets.push_back(firsts[from] + 1);
    }
    if (fits) result.push_back(std::move(sets));
  } while (std::next_permutation(order.begin(), order.end()));
  return result;
}

/// The same layout with its sets in another order and its links numbered by their first member; a link
/// without a member comes last.
GearLayout renumbered(const GearLayout& layout, const std::vector<int>& order, int shafts) {
  GearLayout result;
  std::array<std::uint8_t, kMaxShafts + 1> numbers{};
  std::uint8_t next = 1;
  for (std::size_t set = 0; set < order.size(); ++set) {
    for (std::size_t member = 0; member < 3; ++member) {
      const std::uint8_t link = layout.linkOf[3 * static_cast<std::size_t>(order[set]) + member];
      if (link != 0 && numbers[link] == 0) numbers[link] = next++;
      result.linkOf[3 * set + member] = numbers[link];
    }
  }
  for (int link = 1; link <= shafts; ++link) {
    if (numbers[static_cast<std::size_t>(link)] == 0) numbers[static_cast<std::size_t>(link)] = next++;
  }
  result.input = numbers[layout.input];
  result.output = numbers[layout.output];
  return result;
}

using ResidueSpace = SpeedSpace<PrimeField::Residue>;
using LayoutResidues = std::array<PrimeField::Residue, kMaxFreedom>;

bool areParallel(const LayoutResidues& a, const LayoutResidues& b, int freedom,
                 const ResidueNumbers& numbers) {
  for (int i = 0; i < freedom; ++i) {
    for (int j = i + 1; j < freedom; ++j) {
      const auto x = static_cast<std::size_t>(i);
      const auto y = static_cast<std::size_t>(j);
      if (numbers.multiply(a[x], b[y]) != numbers.multiply(a[y], b[x])) return false;
    }
  }
  return true;
}

/// Does every link turn, and no two always as one?
bool linksDiffer(const ResidueSpace& space, int shafts) {
  for (int a = 0; a <= shafts; ++a) {
    for (int b = a + 1; b <= shafts; ++b) {
      if (space.rows[static_cast<std::size_t>(a)] == space.rows[static_cast<std::size_t>(b)]) return false;
    }
  }
  return true;
}

/// Puts members into links, one after another, in every way.
class Partitions {
 public:
  Partitions(const LayoutLimits& limits, const std::stop_token& stop)
      : m_limits(limits),
        m_sets(basicSets(limits.kinds)),
        m_orders(exchanges(limits.kinds)),
        m_stop(stop),
        m_numbers{PrimeField()} {
    ResidueStream stream(m_numbers.field, PrimeField::kSecondSeed);
    for (std::size_t set = 0; set < m_sets.size(); ++set) m_k.push_back(stream.next());
  }

  std::vector<GearLayout> all() {
    place(0, 0, 0);
    std::sort(m_found.begin(), m_found.end());
    return std::move(m_found);
  }

 private:
  void place(std::size_t at, int links, int held) {
    if (m_stop.stop_requested()) return;
    const std::size_t members = 3 * m_sets.size();
    if (at == members) {
      const bool isFree = links + 1 == m_limits.shafts && m_limits.freeInput;
      if (held == m_limits.held && (links == m_limits.shafts || isFree)) complete(links);
      return;
    }
    const std::size_t set = at / 3;
    if (m_sets[set].sharesRing && at % 3 != 0) {
      m_layout.linkOf[at] = m_layout.linkOf[at - 3];
      place(at + 1, links, held);
      return;
    }
    for (int link = 0; link <= std::min(links + 1, m_limits.shafts); ++link) {
      if (link == 0 && held == m_limits.held) continue;
      if (isInSet(at, link)) continue;
      m_layout.linkOf[at] = static_cast<std::uint8_t>(link);
      place(at + 1, std::max(links, link), held + (link == 0 ? 1 : 0));
    }
  }

  /// Is a member of the same set on this link already? Of a Ravigneaux set: of one of its two parts.
  [[nodiscard]] bool isInSet(std::size_t at, int link) const {
    const std::size_t set = at / 3;
    const std::size_t begin = 3 * (m_sets[set].sharesRing ? set - 1 : set);
    const auto first = m_layout.linkOf.begin();
    return std::find(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(at),
                     static_cast<std::uint8_t>(link)) != first + static_cast<std::ptrdiff_t>(at);
  }

  void complete(int links) {
    m_layout.input = m_layout.output = 0;
    const auto orders = leastOrders();
    if (orders.empty()) return;
    const auto space = speedSpace<ResidueNumbers>(m_sets, m_layout, m_limits.shafts, m_k, m_numbers);
    if (!space || !linksDiffer(*space, m_limits.shafts)) return;
    const bool isFree = links < m_limits.shafts;
    for (int input = isFree ? m_limits.shafts : 1; input <= m_limits.shafts; ++input) {
      for (int output = 1; output <= links; ++output) {
        if (output == input) continue;
        if (areParallel(space->rows[static_cast<std::size_t>(input)],
                        space->rows[static_cast<std::size_t>(output)], space->freedom, m_numbers))
          continue;
        GearLayout layout = m_layout;
        layout.input = static_cast<std::uint8_t>(input);
        layout.output = static_cast<std::uint8_t>(output);
        const bool isLeast = std::none_of(orders.begin(), orders.end(), [&](const std::vector<int>* order) {
          return renumbered(layout, *order, m_limits.shafts) < layout;
        });
        if (isLeast) m_found.push_back(layout);
      }
    }
  }

  /// The exchanges that leave the links as they are; empty if one gives a lesser layout.
  [[nodiscard]] std::vector<const std::vector<int>*> leastOrders() const {
    std::vector<const std::vector<int>*> result;
    for (const std::vector<int>& order : m_orders) {
      const GearLayout other = renumbered(m_layout, order, m_limits.shafts);
      if (other.linkOf < m_layout.linkOf) return {};
      if (other.linkOf == m_layout.linkOf) result.push_back(&order);
    }
    return result;
  }

  const LayoutLimits& m_limits;
  BasicSets m_sets;
  std::vector<std::vector<int>> m_orders;
  std::stop_token m_stop;
  ResidueNumbers m_numbers;
  std::vector<PrimeField::Residue> m_k;
  GearLayout m_layout;
  std::vector<GearLayout> m_found;
};

}  // namespace

BasicSets basicSets(const std::vector<SetKind>& kinds) {
  BasicSets sets;
  for (const SetKind kind : kinds) {
    sets.push_back({kind == SetKind::doublePlanet, false});
    if (kind == SetKind::ravigneaux) sets.push_back({true, true});
  }
  return sets;
}

std::string memberName(int set, SetMember member) {
  constexpr std::array kLetters = {'S', 'C', 'R'};
  return kLetters[static_cast<std::size_t>(member)] + std::to_string(set + 1);
}

std::optional<std::vector<GearLayout>> gearLayouts(const LayoutLimits& limits, const std::stop_token& stop) {
  const auto sets = static_cast<int>(basicSets(limits.kinds).size());
  GEARGRAPH_REQUIRE(sets <= kMaxSets && limits.shafts <= kMaxShafts);
  const int freedom = limits.shafts - sets;
  if (freedom < 1 || freedom > kMaxFreedom) return std::vector<GearLayout>();
  std::vector<GearLayout> found = Partitions(limits, stop).all();
  if (stop.stop_requested()) return std::nullopt;
  return found;
}

}  // namespace geargraph
