#include "core/design/atlas/chain_choices.h"

#include <algorithm>
#include <limits>
#include <map>

#include "core/design/atlas/chain_form.h"

namespace geargraph {
namespace {

/// s^(s-2) trees on the links of an axis, all axes multiplied; std::nullopt beyond 63 bits.
std::optional<std::int64_t> countTrees(const Chain& chain) {
  std::int64_t count = 1;
  for (const std::vector<int>& axis : chain.axes) {
    for (std::size_t factor = 2; factor < axis.size(); ++factor) {
      const auto size = static_cast<std::int64_t>(axis.size());
      if (count > std::numeric_limits<std::int64_t>::max() / size) return std::nullopt;
      count *= size;
    }
  }
  return count;
}

/// The tree on these links with a number of base s, its code of Prüfer, whose digits are links by position.
std::vector<TurningPair> treeOfCode(const std::vector<int>& links, std::int64_t code) {
  const std::size_t size = links.size();
  std::vector<std::size_t> digits;
  for (std::size_t i = 0; i + 2 < size; ++i) {
    digits.push_back(static_cast<std::size_t>(code % static_cast<std::int64_t>(size)));
    code /= static_cast<std::int64_t>(size);
  }
  std::vector<int> degrees(size, 1);
  for (const std::size_t digit : digits) ++degrees[digit];
  std::vector<TurningPair> joints;
  const auto join = [&](std::size_t a, std::size_t b) {
    joints.emplace_back(std::minmax(links[a], links[b]));
    --degrees[a];
    --degrees[b];
  };
  const auto leaf = [&] {
    return static_cast<std::size_t>(std::find(degrees.begin(), degrees.end(), 1) - degrees.begin());
  };
  for (const std::size_t digit : digits) join(leaf(), digit);
  const std::size_t first = leaf();
  const auto second = std::find(degrees.begin() + static_cast<std::ptrdiff_t>(first) + 1, degrees.end(), 1);
  join(first, static_cast<std::size_t>(second - degrees.begin()));
  return joints;
}

/// The first trees, counted like the digits of a number, the first axis fastest.
std::vector<std::vector<TurningPair>> firstTrees(const Chain& chain, std::size_t most) {
  std::vector<std::int64_t> ends;
  for (const std::vector<int>& axis : chain.axes) {
    Chain alone{chain.links, {axis}, {}};
    ends.push_back(countTrees(alone).value_or(std::numeric_limits<std::int64_t>::max()));
  }
  std::vector<std::int64_t> codes(ends.size(), 0);
  std::vector<std::vector<TurningPair>> trees;
  while (trees.size() < most) {
    std::vector<TurningPair>& tree = trees.emplace_back();
    for (std::size_t a = 0; a < codes.size(); ++a) {
      const std::vector<TurningPair> joints = treeOfCode(chain.axes[a], codes[a]);
      tree.insert(tree.end(), joints.begin(), joints.end());
    }
    std::sort(tree.begin(), tree.end());
    std::size_t digit = 0;
    while (digit < codes.size() && ++codes[digit] == ends[digit]) codes[digit++] = 0;
    if (digit == codes.size()) break;
  }
  return trees;
}

/// Goes through sets of pairs that determine the motion.
class InputSetSearch {
 public:
  InputSetSearch(const Chain& chain, std::span<const SignedTeeth> teeth)
      : m_links(static_cast<std::size_t>(chain.links)) {
    for (std::size_t m = 0; m < teeth.size(); ++m)
      m_rows.push_back(speedRow(m_field, chain.meshes[m], teeth[m], m_links));
    m_dof = chain.links - 1 - static_cast<int>(reduceRows(m_field, m_rows).size());
    for (const std::vector<int>& axis : chain.axes) {
      for (std::size_t a = 0; a < axis.size(); ++a)
        for (std::size_t b = a + 1; b < axis.size(); ++b) m_pairs.emplace_back(axis[a], axis[b]);
    }
    std::sort(m_pairs.begin(), m_pairs.end());
  }

  /// How many sets there are to try; above kMaxInputTrials that limit and one.
  [[nodiscard]] std::int64_t trials() const {
    std::int64_t count = 1;
    const auto pairs = static_cast<std::int64_t>(m_pairs.size());
    for (std::int64_t i = 0; i < m_dof; ++i) {
      count = count * (pairs - i) / (i + 1);
      if (count > kMaxInputTrials) return kMaxInputTrials + 1;
    }
    return count;
  }

  /// False if `stop` was requested.
  bool run(std::size_t most, ChainChoices& choices, const std::stop_token& stop) {
    std::vector<TurningPair> set;
    return extend(0, set, m_rows, most, choices, stop);
  }

 private:
  /// Adds each further pair whose relative speed does not follow from the rows.
  bool extend(std::size_t first, std::vector<TurningPair>& set, const std::vector<ResidueRow>& rows,
              std::size_t most, ChainChoices& choices, const std::stop_token& stop) {
    if (stop.stop_requested()) return false;
    if (static_cast<int>(set.size()) == m_dof) {
      ++choices.inputSetCount;
      if (choices.inputSets.size() < most) choices.inputSets.push_back(set);
      return true;
    }
    for (std::size_t p = first; p < m_pairs.size(); ++p) {
      std::vector<ResidueRow> more = rows;
      ResidueRow& row = more.emplace_back(m_links, 0);
      row[static_cast<std::size_t>(m_pairs[p].first)] = m_field.one();
      row[static_cast<std::size_t>(m_pairs[p].second)] = m_field.negate(m_field.one());
      if (reduceRows(m_field, more).size() == rows.size()) continue;
      set.push_back(m_pairs[p]);
      if (!extend(p + 1, set, more, most, choices, stop)) return false;
      set.pop_back();
    }
    return true;
  }

  PrimeField m_field;
  std::size_t m_links;
  int m_dof = 0;
  std::vector<ResidueRow> m_rows;
  std::vector<TurningPair> m_pairs;
};

}  // namespace

std::optional<ChainChoices> choicesOf(const Chain& chain, std::span<const SignedTeeth> teeth,
                                      std::size_t most, const std::stop_token& stop) {
  InputSetSearch search(chain, teeth);
  if (search.trials() > kMaxInputTrials) return std::nullopt;
  ChainChoices choices;
  choices.treeCount = countTrees(chain);
  choices.trees = firstTrees(chain, most);
  if (!search.run(most, choices, stop)) return std::nullopt;
  std::map<int, std::vector<int>> frames;
  const std::vector<int> orbits = linkOrbits(chain);
  for (int link = 0; link < chain.links; ++link)
    frames[orbits[static_cast<std::size_t>(link)]].push_back(link);
  for (auto& [first, links] : frames) choices.frames.push_back(std::move(links));
  return choices;
}

}  // namespace geargraph
