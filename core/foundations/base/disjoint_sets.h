#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace geargraph {

/// The numbers 0, 1, ... in disjoint sets, each named by its smallest number, whatever the order in which
/// they were joined (Boost's names are arbitrary). Joining shortens the ways to the names. Cost: about O(log
/// n) a call.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count = 0) : m_parent(count) {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t{0});
  }

  /// One more number, in a set of its own.
  void add() { m_parent.push_back(m_parent.size()); }

  /// The smallest number of the set. @pre 0 <= of < count
  template <class Number>
  [[nodiscard]] Number root(Number of) const {
    auto at = static_cast<std::size_t>(of);
    while (m_parent[at] != at) at = m_parent[at];
    return static_cast<Number>(at);
  }
  template <class Number>
  void join(Number one, Number other) {
    const std::size_t a = shortened(static_cast<std::size_t>(one));
    const std::size_t b = shortened(static_cast<std::size_t>(other));
    m_parent[a < b ? b : a] = a < b ? a : b;
  }
  template <class Number>
  [[nodiscard]] bool areJoined(Number one, Number other) const {
    return root(one) == root(other);
  }

 private:
  std::size_t shortened(std::size_t at) {
    while (m_parent[at] != at) at = m_parent[at] = m_parent[m_parent[at]];
    return at;
  }

  std::vector<std::size_t> m_parent;
};

}  // namespace geargraph
