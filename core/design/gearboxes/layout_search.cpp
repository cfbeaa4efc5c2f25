#include "core/design/gearboxes/layout_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

#include "core/design/gearboxes/candidate_refinement.h"
#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

using Direction = std::array<double, kMaxFreedom>;

/// At a sample a state may miss its wanted ratio by this much, as a logarithm.
constexpr double kFarthest = 0.35;

/// The ratios of all states of a layout at one k: the logarithm of the size, or NaN where it has none there.
struct StateValues {
  std::vector<double> logs;
  std::vector<char> isNegative;
};

/// One layout and its states, with what is asked of them.
class LayoutSearch {
 public:
  LayoutSearch(const SearchProblem& problem, const GearLayout& layout, SearchCounts& counts,
               const std::stop_token& stop)
      : m_problem(problem),
        m_layout(layout),
        m_counts(counts),
        m_stop(stop),
        m_shafts(problem.limits.shafts),
        m_sets(basicSets(problem.limits.kinds)),
        m_freedom(m_shafts - static_cast<int>(m_sets.size())),
        m_classes(elementClasses(m_sets, layout, m_shafts)),
        m_states(gearStates(m_sets, layout, m_shafts, m_classes).states),
        m_ratios(m_sets, layout, m_shafts) {
    GEARGRAPH_REQUIRE(m_classes.size() <= 64);
    m_wanted = problem.forward.size() + (problem.reverse == ReverseWish::none ? 0 : 1);
    for (const RatioTarget& target : problem.forward) {
      m_logs.push_back(target.log);
      m_isDirectWanted = m_isDirectWanted || target.log == 0;
    }
    if (problem.reverse == ReverseWish::ratio) m_logs.push_back(problem.reverseTarget.log);
    touchMasks();
    m_counts.states += static_cast<std::int64_t>(m_states.size());
  }

  std::vector<GearboxCandidate> run() {
    if (m_freedom < 2 || m_states.size() < m_wanted) return {};
    for (const std::uint64_t mask : m_touching) {
      if (mask == 0) return {};
    }
    if (m_freedom == kMaxFreedom) {
      searchElementSets();
    } else {
      searchGrid();
    }
    return refined();
  }

 private:
  /// A shift table that may fit: positions of states by gear, reverse last, and where it was seen.
  struct Start {
    double error = 0;
    std::array<double, kMaxSets> k{};
  };
  using Table = std::vector<std::uint16_t>;

  /// For each link that only one member is on, or none, and that is not the output: the classes that touch
  /// it. One of them has to be used.
  void touchMasks() {
    for (int link = 1; link <= m_shafts; ++link) {
      const int members = memberCount(link);
      const bool isOpen = link == m_layout.input ? members == 0 : members == 1 && link != m_layout.output;
      if (!isOpen) continue;
      std::uint64_t mask = 0;
      for (std::size_t i = 0; i < m_classes.size(); ++i) {
        for (const ElementLinks& each : m_classes[i].variants) {
          if (each.a == link || each.b == link) mask |= std::uint64_t{1} << i;
        }
      }
      m_touching.push_back(mask);
    }
  }

  [[nodiscard]] int memberCount(int link) const {
    int count = 0;
    for (std::size_t set = 0; set < m_sets.size(); ++set) {
      for (std::size_t member = 0; member < 3; ++member) {
        if (m_sets[set].sharesRing && member != 0) continue;
        count += m_layout.linkOf[3 * set + member] == link ? 1 : 0;
      }
    }
    return count;
  }

  [[nodiscard]] bool touchesAll(std::uint64_t elements) const {
    return std::all_of(m_touching.begin(), m_touching.end(),
                       [elements](std::uint64_t mask) { return (mask & elements) != 0; });
  }

  /// The states' ratios at these k; empty if the sets depend on each other there.
  [[nodiscard]] StateValues valuesAt(std::span<const double> k) const {
    const DoubleNumbers numbers;
    StateValues values;
    const auto space = speedSpace<DoubleNumbers>(m_sets, m_layout, m_shafts, k, numbers);
    if (!space) return values;
    std::vector<Direction> directions;
    for (const ElementClass& each : m_classes)
      directions.push_back(directionOf(*space, each.variants.front(), numbers));
    values.logs.assign(m_states.size(), std::numeric_limits<double>::quiet_NaN());
    values.isNegative.assign(m_states.size(), 0);
    Direction input{};
    Direction output{};
    std::array<std::uint8_t, 2> before{255, 255};
    const std::size_t last = static_cast<std::size_t>(m_freedom) - 2;
    for (std::size_t state = 0; state < m_states.size(); ++state) {
      const auto& members = m_states[state].members;
      const std::array<std::uint8_t, 2> now{last > 0 ? members[0] : std::uint8_t{0},
                                            last > 1 ? members[1] : std::uint8_t{0}};
      if (now != before) {
        before = now;
        const Direction* first = &directions[now[0]];
        const Direction* second = &directions[now[1]];
        input = lastFactors<DoubleNumbers>(first, second, space->rows[m_layout.input], m_freedom, numbers);
        output = lastFactors<DoubleNumbers>(first, second, space->rows[m_layout.output], m_freedom, numbers);
      }
      const Direction& engaged = directions[members[last]];
      const double in = rowProduct(input, engaged, m_freedom, numbers);
      const double out = rowProduct(output, engaged, m_freedom, numbers);
      if (std::abs(in) < 1e-9 || std::abs(out) < 1e-9) continue;
      const double ratio = in / out;
      values.isNegative[state] = ratio < 0 ? 1 : 0;
      values.logs[state] = m_states[state].isDirect ? 0 : std::log(std::abs(ratio));
    }
    return values;
  }

  void searchGrid();
  void searchCell(std::span<const double> k, double half);
  void walk(std::size_t gear, std::uint64_t elements, std::uint64_t always);
  void completeTable(std::uint64_t elements, std::uint64_t always);
  void addReverse(std::uint64_t elements, std::uint64_t always);
  void record(std::uint64_t elements, std::uint64_t always);
  [[nodiscard]] std::vector<std::uint32_t> reachOf(const StateValues& values) const;
  void takeSamples();
  void searchElementSets();
  void tryElementSet(std::uint64_t elements);
  void matchAt(std::size_t sample, std::span<const std::uint16_t> states);
  [[nodiscard]] double misfit() const;
  [[nodiscard]] std::vector<GearboxCandidate> refined();
  [[nodiscard]] GearboxCandidate candidateOf(const Table& table) const;

  const SearchProblem& m_problem;
  const GearLayout& m_layout;
  SearchCounts& m_counts;
  std::stop_token m_stop;
  int m_shafts;
  BasicSets m_sets;
  int m_freedom;
  std::vector<ElementClass> m_classes;
  std::vector<StateList::State> m_states;
  StateRatios m_ratios;
  std::size_t m_wanted = 0;
  std::vector<double> m_logs;  ///< of all gears with a wanted ratio, reverse last
  bool m_isDirectWanted = false;
  std::vector<std::uint64_t> m_touching;
  std::map<Table, Start> m_tables;

  // of a cell
  StateValues m_now;
  std::vector<std::array<double, kMaxSets>> m_gradients;
  std::vector<std::vector<std::uint16_t>> m_near;  ///< by wanted ratio: the states that come near it
  std::vector<std::uint16_t> m_negative;           ///< for any reverse
  Table m_table;
  std::array<double, kMaxSets> m_k{};
  double m_half = 0;

  // of element sets
  std::vector<StateValues> m_samples;
  std::vector<std::array<double, kMaxSets>> m_sampleK;
  std::vector<std::vector<std::uint32_t>> m_sampleReach;
  std::vector<std::int16_t> m_stateOf;  ///< by three classes: the state, or -1
};

/// Bits of two states' classes.
int changed(const StateList::State& a, const StateList::State& b) {
  return std::popcount(a.mask ^ b.mask);
}

void LayoutSearch::searchGrid() {
  const std::vector<double> grid = gridOf(m_problem);
  const double half = std::log(m_problem.mostK / m_problem.leastK) / (2 * static_cast<double>(grid.size()));
  std::vector<std::size_t> at(m_sets.size(), 0);
  for (bool more = true; more && !m_stop.stop_requested();) {
    for (std::size_t set = 0; set < at.size(); ++set) m_k[set] = grid[at[set]];
    // The small sun of a Ravigneaux set is the smaller one: its ring ratio is above that of the large one.
    bool isSensible = true;
    for (std::size_t set = 1; set < at.size(); ++set)
      isSensible = isSensible && (!m_sets[set].sharesRing || m_k[set] > m_k[set - 1] * 0.999);
    if (isSensible) {
      ++m_counts.points;
      searchCell(std::span(m_k).first(at.size()), half);
    }
    more = false;
    for (std::size_t set = 0; set < at.size() && !more; ++set) {
      more = ++at[set] < grid.size();
      if (!more) at[set] = 0;
    }
  }
}

void LayoutSearch::searchCell(std::span<const double> k, double half) {
  constexpr double kDifference = 1e-4;
  constexpr double kWidest = 0.7;  // beyond it a cell says nothing
  m_now = valuesAt(k);
  if (m_now.logs.empty()) return;
  m_half = half;
  m_gradients.assign(m_states.size(), {});
  std::array<double, kMaxSets> moved{};
  std::copy(k.begin(), k.end(), moved.begin());
  for (std::size_t set = 0; set < k.size(); ++set) {
    moved[set] = k[set] * (1 + kDifference);
    const StateValues other = valuesAt(std::span(moved).first(k.size()));
    moved[set] = k[set];
    if (other.logs.empty()) return;
    for (std::size_t state = 0; state < m_states.size(); ++state)
      m_gradients[state][set] = (other.logs[state] - m_now.logs[state]) / kDifference;
  }
  m_near.assign(m_logs.size(), {});
  m_negative.clear();
  const std::size_t forward = m_problem.forward.size();
  for (std::size_t state = 0; state < m_states.size(); ++state) {
    if (std::isnan(m_now.logs[state])) continue;
    double reach = 0;
    for (const double each : m_gradients[state]) reach += std::abs(each) * half;
    reach = std::isfinite(reach) ? std::min(1.3 * reach, kWidest) : kWidest;
    if (!m_problem.prunes) reach = kWidest;
    const bool isNegative = m_now.isNegative[state] != 0;
    for (std::size_t gear = 0; gear < m_logs.size(); ++gear) {
      if (isNegative != (gear >= forward)) continue;
      const double tolerance =
          gear < forward ? m_problem.forward[gear].tolerance : m_problem.reverseTarget.tolerance;
      if (std::abs(m_now.logs[state] - m_logs[gear]) <= reach + tolerance)
        m_near[gear].push_back(static_cast<std::uint16_t>(state));
    }
    if (isNegative) m_negative.push_back(static_cast<std::uint16_t>(state));
  }
  for (const auto& near : m_near) {
    if (near.empty()) return;
  }
  if (m_problem.reverse == ReverseWish::any && m_negative.empty()) return;
  m_table.clear();
  walk(0, 0, ~std::uint64_t{0});
}

void LayoutSearch::walk(std::size_t gear, std::uint64_t elements, std::uint64_t always) {
  if (gear == m_problem.forward.size()) return addReverse(elements, always);
  for (const std::uint16_t state : m_near[gear]) {
    const StateList::State& each = m_states[state];
    if (gear > 0 && m_problem.isSingleShift && changed(each, m_states[m_table.back()]) != 2) continue;
    if (gear > 0 && !m_problem.isSingleShift &&
        std::find(m_table.begin(), m_table.end(), state) != m_table.end())
      continue;
    const std::uint64_t all = elements | each.mask;
    if (std::popcount(all) > m_problem.mostElements) continue;
    m_table.push_back(state);
    // Where ratios are ordered no state is used twice, since each has one ratio.
    if (!m_problem.prunes || gear + 1 < 3 || misfit() <= 1) walk(gear + 1, all, always & each.mask);
    m_table.pop_back();
  }
}

void LayoutSearch::addReverse(std::uint64_t elements, std::uint64_t always) {
  if (m_problem.reverse == ReverseWish::none) return record(elements, always);
  const auto& from = m_problem.reverse == ReverseWish::any ? m_negative : m_near.back();
  std::uint16_t best = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint16_t state : from) {
    const std::uint64_t all = elements | m_states[state].mask;
    if (std::popcount(all) > m_problem.mostElements) continue;
    if (m_problem.reverse == ReverseWish::ratio) {
      m_table.push_back(state);
      if (!m_problem.prunes || misfit() <= 1) record(all, always & m_states[state].mask);
      m_table.pop_back();
      continue;
    }
    if (!touchesAll(all)) continue;
    const double distance = std::abs(m_now.logs[state] - m_logs.front());
    if (distance < nearest) {
      nearest = distance;
      best = state;
    }
  }
  if (std::isfinite(nearest)) {
    m_table.push_back(best);
    record(elements | m_states[best].mask, always & m_states[best].mask);
    m_table.pop_back();
  }
}

/// How far the chosen states stay from their ratios at the best k of the cell, with the gradients at its
/// middle, over what curvature and tolerance allow: above 1 is out of reach.
double LayoutSearch::misfit() const {
  std::array<std::array<double, kMaxSets + 1>, kMaxSets> rows{};
  const std::size_t sets = m_sets.size();
  const std::size_t count = std::min(m_table.size(), m_logs.size());
  double largest = 0;
  double tolerance = 0;
  std::array<double, 24> residuals{};
  for (std::size_t gear = 0; gear < count; ++gear) {
    const std::size_t state = m_table[gear];
    const double residual = m_logs[gear] - m_now.logs[state];
    residuals[gear] = residual;
    largest = std::max(largest, std::abs(residual));
    const double own = gear < m_problem.forward.size() ? m_problem.forward[gear].tolerance
                                                       : m_problem.reverseTarget.tolerance;
    tolerance = std::max(tolerance, own);
    for (std::size_t i = 0; i < sets; ++i) {
      for (std::size_t j = 0; j < sets; ++j) rows[i][j] += m_gradients[state][i] * m_gradients[state][j];
      rows[i][kMaxSets] += m_gradients[state][i] * residual;
    }
  }
  for (std::size_t i = 0; i < sets; ++i) rows[i][i] += 1e-6;
  for (std::size_t i = 0; i < sets; ++i) {
    for (std::size_t below = i + 1; below < sets; ++below) {
      const double factor = rows[below][i] / rows[i][i];
      for (std::size_t j = i; j < sets; ++j) rows[below][j] -= factor * rows[i][j];
      rows[below][kMaxSets] -= factor * rows[i][kMaxSets];
    }
  }
  std::array<double, kMaxSets> x{};
  for (std::size_t i = sets; i-- > 0;) {
    double sum = rows[i][kMaxSets];
    for (std::size_t j = i + 1; j < sets; ++j) sum -= rows[i][j] * x[j];
    x[i] = sum / rows[i][i];
  }
  double left = 0;
  for (std::size_t gear = 0; gear < count; ++gear) {
    double predicted = residuals[gear];
    for (std::size_t i = 0; i < sets; ++i) predicted -= m_gradients[m_table[gear]][i] * x[i];
    left = std::max(left, std::abs(predicted));
  }
  for (std::size_t i = 0; i < sets; ++i) {
    if (std::abs(x[i]) > 3 * m_half + 0.05) return 2;  // another cell's
  }
  return left / (3 * tolerance + 0.01 + 0.25 * largest);
}

void LayoutSearch::record(std::uint64_t elements, std::uint64_t always) {
  if (always != 0 || !touchesAll(elements)) return;
  double error = 0;
  for (std::size_t gear = 0; gear < m_logs.size(); ++gear)
    error = std::max(error, std::abs(m_logs[gear] - m_now.logs[m_table[gear]]));
  const auto [place, isNew] = m_tables.try_emplace(m_table, Start{error, m_k});
  if (!isNew && error < place->second.error) place->second = {error, m_k};
}

/// Points that fill the cube evenly: Halton's sequence.
double haltonOf(int index, int base) {
  double result = 0;
  double part = 1;
  for (; index > 0; index /= base) {
    part /= base;
    result += part * (index % base);
  }
  return result;
}

/// By state: the gears that it comes near to, a bit each, the reverse gear's after those of the forward ones.
std::vector<std::uint32_t> LayoutSearch::reachOf(const StateValues& values) const {
  const std::size_t gears = m_problem.forward.size();
  std::vector<std::uint32_t> reach(m_states.size(), 0);
  for (std::size_t state = 0; state < m_states.size(); ++state) {
    const double log = values.logs[state];
    if (std::isnan(log)) continue;
    if (values.isNegative[state] != 0) {
      const bool isNear =
          m_problem.reverse == ReverseWish::any ||
          (m_problem.reverse == ReverseWish::ratio && std::abs(log - m_logs.back()) <= kFarthest);
      if (isNear) reach[state] = std::uint32_t{1} << gears;
      continue;
    }
    for (std::size_t gear = 0; gear < gears; ++gear) {
      if (std::abs(log - m_logs[gear]) > kFarthest) continue;
      if (m_logs[gear] == 0 && !m_states[state].isDirect) continue;
      reach[state] |= std::uint32_t{1} << gear;
    }
  }
  return reach;
}

void LayoutSearch::takeSamples() {
  constexpr std::array kBases = {2, 3, 5, 7};
  const double span = std::log(m_problem.mostK / m_problem.leastK);
  for (int sample = 1; sample <= kSamples; ++sample) {
    std::array<double, kMaxSets> k{};
    for (std::size_t set = 0; set < m_sets.size(); ++set)
      k[set] = m_problem.leastK * std::exp(span * haltonOf(sample, kBases[set]));
    for (std::size_t set = 1; set < m_sets.size(); ++set) {
      if (m_sets[set].sharesRing && k[set] < k[set - 1]) std::swap(k[set], k[set - 1]);
    }
    StateValues values = valuesAt(std::span(k).first(m_sets.size()));
    if (values.logs.empty()) continue;
    m_sampleReach.push_back(reachOf(values));
    m_samples.push_back(std::move(values));
    m_sampleK.push_back(k);
    ++m_counts.points;
  }
}

void LayoutSearch::searchElementSets() {
  const auto count = m_classes.size();
  m_stateOf.assign(count * count * count, -1);
  const auto at = [count](std::size_t a, std::size_t b, std::size_t c) {
    return (a * count + b) * count + c;
  };
  for (std::size_t state = 0; state < m_states.size(); ++state) {
    const auto& members = m_states[state].members;
    m_stateOf[at(members[0], members[1], members[2])] = static_cast<std::int16_t>(state);
  }
  // Elements are added one by one; what counts are the states among them that are no gears.
  const auto most = static_cast<std::size_t>(m_problem.mostElements);
  for (std::size_t size = 3; size <= most; ++size) {
    const auto all = static_cast<int>(size * (size - 1) * (size - 2) / 6);
    const int spare = all - static_cast<int>(m_wanted);
    if (spare < 0) continue;
    std::vector<std::size_t> chosen;
    const auto add = [&](const auto& self, std::size_t from, int lost, int direct) -> void {
      if (chosen.size() == size) {
        if (m_isDirectWanted && direct == 0) return;
        if (lost + std::max(0, direct - 1) > spare) return;
        std::uint64_t elements = 0;
        for (const std::size_t each : chosen) elements |= std::uint64_t{1} << each;
        if (touchesAll(elements)) tryElementSet(elements);
        return;
      }
      for (std::size_t next = from; next + (size - chosen.size()) <= count; ++next) {
        int nextLost = lost;
        int nextDirect = direct;
        for (std::size_t i = 0; i < chosen.size() && nextLost <= spare; ++i) {
          for (std::size_t j = i + 1; j < chosen.size(); ++j) {
            const std::int16_t state = m_stateOf[at(chosen[i], chosen[j], next)];
            nextLost += state < 0 ? 1 : 0;
            nextDirect += state >= 0 && m_states[static_cast<std::size_t>(state)].isDirect ? 1 : 0;
          }
        }
        if (nextLost + std::max(0, nextDirect - 1) > spare) continue;
        chosen.push_back(next);
        self(self, next + 1, nextLost, nextDirect);
        chosen.pop_back();
      }
    };
    add(add, 0, 0, 0);
  }
}

void LayoutSearch::tryElementSet(std::uint64_t elements) {
  if (m_stop.stop_requested()) return;
  if (m_samples.empty()) takeSamples();
  std::array<std::size_t, 12> chosen{};
  std::size_t size = 0;
  for (std::size_t i = 0; i < m_classes.size(); ++i) {
    if ((elements >> i & 1U) != 0) chosen[size++] = i;
  }
  std::array<std::uint16_t, 256> states{};
  std::size_t found = 0;
  const auto count = m_classes.size();
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i + 1; j < size; ++j) {
      for (std::size_t l = j + 1; l < size; ++l) {
        const std::int16_t state = m_stateOf[(chosen[i] * count + chosen[j]) * count + chosen[l]];
        if (state >= 0) states[found++] = static_cast<std::uint16_t>(state);
      }
    }
  }
  const std::uint32_t all = (std::uint32_t{1} << m_wanted) - 1;
  for (std::size_t sample = 0; sample < m_samples.size(); ++sample) {
    std::uint32_t reached = 0;
    for (std::size_t i = 0; i < found; ++i) reached |= m_sampleReach[sample][states[i]];
    if (reached == all) matchAt(sample, std::span(states).first(found));
  }
}

/// Gives the states their gears by the order of their ratios at a sample, and records the tables that come
/// near there.
void LayoutSearch::matchAt(std::size_t sample, std::span<const std::uint16_t> states) {
  const StateValues& values = m_samples[sample];
  std::array<std::uint16_t, 256> forward{};
  std::array<std::uint16_t, 256> backward{};
  std::size_t positive = 0;
  std::size_t negative = 0;
  for (const std::uint16_t state : states) {
    if (std::isnan(values.logs[state])) continue;
    if (values.isNegative[state] != 0) {
      backward[negative++] = state;
    } else {
      forward[positive++] = state;
    }
  }
  const std::size_t gears = m_problem.forward.size();
  if (positive < gears || (m_problem.reverse != ReverseWish::none && negative == 0)) return;
  const auto byRatio = [&](std::uint16_t a, std::uint16_t b) {
    return values.logs[a] != values.logs[b] ? values.logs[a] > values.logs[b] : a < b;
  };
  std::sort(forward.begin(), forward.begin() + static_cast<std::ptrdiff_t>(positive), byRatio);
  m_table.clear();
  const auto choose = [&](const auto& self, std::size_t gear, std::size_t from, double worst) -> void {
    if (gear == gears) {
      if (m_problem.reverse == ReverseWish::none) {
        std::uint64_t all = 0;
        std::uint64_t always = ~std::uint64_t{0};
        for (const std::uint16_t each : m_table) {
          all |= m_states[each].mask;
          always &= m_states[each].mask;
        }
        if (always != 0 || !touchesAll(all)) return;
        const auto [place, isNew] = m_tables.try_emplace(m_table, Start{worst, m_sampleK[sample]});
        if (!isNew && worst < place->second.error) place->second = {worst, m_sampleK[sample]};
        return;
      }
      for (std::size_t i = 0; i < negative; ++i) {
        const std::uint16_t state = backward[i];
        const bool isGiven = m_problem.reverse == ReverseWish::ratio;
        const double off = isGiven ? std::abs(values.logs[state] - m_logs.back()) : 0;
        if (off > kFarthest) continue;
        m_table.push_back(state);
        std::uint64_t all = 0;
        std::uint64_t always = ~std::uint64_t{0};
        for (const std::uint16_t each : m_table) {
          all |= m_states[each].mask;
          always &= m_states[each].mask;
        }
        if (always == 0 && touchesAll(all)) {
          const double error = std::max(worst, off);
          const auto [place, isNew] = m_tables.try_emplace(m_table, Start{error, m_sampleK[sample]});
          if (!isNew && error < place->second.error) place->second = {error, m_sampleK[sample]};
        }
        m_table.pop_back();
      }
      return;
    }
    for (std::size_t i = from; i + (gears - gear) <= positive; ++i) {
      const std::uint16_t state = forward[i];
      const double off = std::abs(values.logs[state] - m_logs[gear]);
      if (off > kFarthest) {
        if (values.logs[state] < m_logs[gear]) return;
        continue;
      }
      if (m_isDirectWanted && m_logs[gear] == 0 && !m_states[state].isDirect) continue;
      if (gear > 0 && m_problem.isSingleShift && changed(m_states[state], m_states[m_table.back()]) != 2)
        continue;
      m_table.push_back(state);
      self(self, gear + 1, i + 1, std::max(worst, off));
      m_table.pop_back();
    }
  };
  choose(choose, 0, 0, 0);
}

GearboxCandidate LayoutSearch::candidateOf(const Table& table) const {
  GearboxCandidate candidate;
  candidate.layout = m_layout;
  std::uint64_t all = 0;
  for (const std::uint16_t state : table) all |= m_states[state].mask;
  std::array<std::uint8_t, 64> places{};
  for (std::size_t i = 0; i < m_classes.size(); ++i) {
    if ((all >> i & 1U) == 0) continue;
    places[i] = static_cast<std::uint8_t>(candidate.elements.size());
    candidate.elements.push_back(m_classes[i]);
  }
  for (const std::uint16_t state : table) {
    auto& gear = candidate.gears.emplace_back();
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(m_freedom); ++i)
      gear.push_back(places[m_states[state].members[i]]);
  }
  return candidate;
}

std::vector<GearboxCandidate> LayoutSearch::refined() {
  std::vector<GearboxCandidate> result;
  double tolerance = 0;
  for (const RatioTarget& each : m_problem.forward) tolerance = std::max(tolerance, each.tolerance);
  if (m_problem.reverse == ReverseWish::ratio)
    tolerance = std::max(tolerance, m_problem.reverseTarget.tolerance);
  for (const auto& [table, start] : m_tables) {
    if (m_stop.stop_requested()) return {};
    ++m_counts.candidates;
    std::array<std::array<ElementLinks, 3>, 24> states{};
    for (std::size_t gear = 0; gear < m_logs.size(); ++gear) {
      for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(m_freedom); ++i)
        states[gear][i] = m_classes[m_states[table[gear]].members[i]].variants.front();
    }
    std::array<double, kMaxSets> k = start.k;
    const auto own = std::span(k).first(m_sets.size());
    const double error =
        refineK(m_ratios, std::span(states).first(m_logs.size()), m_logs,
                m_problem.reverse == ReverseWish::ratio, m_problem.leastK, m_problem.mostK, own);
    if (!(error <= 3 * tolerance + 0.001)) continue;
    GearboxCandidate candidate = candidateOf(table);
    candidate.k.assign(own.begin(), own.end());
    candidate.error = error;
    result.push_back(std::move(candidate));
  }
  return result;
}

}  // namespace

SearchCounts& SearchCounts::operator+=(const SearchCounts& other) {
  states += other.states;
  points += other.points;
  candidates += other.candidates;
  return *this;
}

std::vector<double> gridOf(const SearchProblem& problem) {
  std::vector<double> grid;
  const double span = std::log(problem.mostK / problem.leastK);
  for (int step = 0; step < problem.steps; ++step)
    grid.push_back(problem.leastK * std::exp(span * (step + 0.5) / problem.steps));
  return grid;
}

std::vector<GearboxCandidate> searchLayout(const SearchProblem& problem, const GearLayout& layout,
                                           SearchCounts& counts, const std::stop_token& stop) {
  return LayoutSearch(problem, layout, counts, stop).run();
}

}  // namespace geargraph
