#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/id.h"

namespace geargraph {

/// Positions in a list by id. Ids that were interned together, as those of a file's list, have numbers close
/// together: then it is a table by number, several times faster than a hash map; else a hash table with open
/// addressing.
template <class Tag>
class PositionIndex {
 public:
  PositionIndex() = default;
  /// The positions of elements with a member `id`. @pre ids are unique in the list
  template <class Element>
  requires requires(const Element& element) { element.id; }
  explicit PositionIndex(const std::vector<Element>& list) {
    std::vector<Id<Tag>> ids;
    ids.reserve(list.size());
    for (const Element& element : list) ids.push_back(element.id);
    fill(ids);
  }
  /// The positions of these ids themselves. @pre they are unique
  explicit PositionIndex(std::span<const Id<Tag>> ids) { fill(ids); }

  /// -1 if the list has no such id.
  [[nodiscard]] int positionOf(Id<Tag> id) const {
    if (!m_places.empty()) return m_places[find(id)].position;
    const std::size_t at =
        numberOf(id) - m_first;  // ids before the first one wrap round, far beyond the last
    return at < m_positions.size() ? m_positions[at] : -1;
  }
  /// @pre the list has this id
  [[nodiscard]] int at(Id<Tag> id) const {
    const int position = positionOf(id);
    GEARGRAPH_REQUIRE(position >= 0);
    return position;
  }

 private:
  struct Place {
    Id<Tag> id;
    int position = -1;
  };

  static std::size_t numberOf(Id<Tag> id) { return id.atom().hash(); }

  void fill(std::span<const Id<Tag>> ids) {
    constexpr std::size_t kMaxPlaces = 8;  // an id
    if (ids.empty()) return;
    std::size_t last = 0;
    m_first = std::numeric_limits<std::size_t>::max();
    for (const Id<Tag> id : ids) {
      m_first = std::min(m_first, numberOf(id));
      last = std::max(last, numberOf(id));
    }
    if (last - m_first >= kMaxPlaces * ids.size()) return fillOpenPlaces(ids);
    m_positions.assign(last - m_first + 1, -1);
    int position = 0;
    for (const Id<Tag> id : ids) m_positions[numberOf(id) - m_first] = position++;
  }

  void fillOpenPlaces(std::span<const Id<Tag>> ids) {
    std::size_t size = 4;
    while (size < 2 * ids.size()) size *= 2;
    m_places.resize(size);
    int position = 0;
    for (const Id<Tag> id : ids) m_places[find(id)] = {id, position++};
  }

  /// The slot of the id, or the free slot for it.
  [[nodiscard]] std::size_t find(Id<Tag> id) const {
    const std::size_t mask = m_places.size() - 1;
    std::size_t at = (static_cast<std::uint64_t>(numberOf(id)) * 0x9e3779b97f4a7c15U) >> 32U;
    for (at &= mask; m_places[at].position >= 0 && m_places[at].id != id;) at = (at + 1) & mask;
    return at;
  }

  std::size_t m_first = 0;       ///< the smallest number of an id
  std::vector<int> m_positions;  ///< by number, from m_first on; -1 where no id of the list has it
  std::vector<Place> m_places;   ///< used instead if the numbers are far apart
};

}  // namespace geargraph
