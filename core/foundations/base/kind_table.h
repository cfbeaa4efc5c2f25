#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/foundations/base/contract.h"

namespace geargraph {

/// How many kinds an enumeration names, counted from 0 without gaps; stated beside each enumeration of kinds.
template <class Kind>
constexpr std::size_t kNamedKinds = 0;

/// Kinds that a table has room for: the named ones and those that are added (AddedFacet).
constexpr std::size_t kMaxKinds = 32;

/// What one layer knows of each kind of a thing (its facet), by the values of the enumeration. A table
/// without an entry for each named kind does not compile. Does not own the entries. Cost of a look-up: one
/// load.
template <class Kind, class Facet>
class KindTable {
 public:
  template <class... Facets>
  constexpr explicit KindTable(const Facets*... named) : m_facets{named...} {
    static_assert(kNamedKinds<Kind> > 0 && sizeof...(Facets) == kNamedKinds<Kind>, "One entry for each kind");
    for (std::size_t i = 0; i < kMaxKinds; ++i) m_kinds[i] = static_cast<Kind>(i);
  }

  /// @pre the table has the kind
  [[nodiscard]] const Facet& operator[](Kind kind) const {
    const Facet* const found = find(kind);
    GEARGRAPH_REQUIRE(found != nullptr);
    return *found;
  }
  /// Null where the table does not have the kind.
  [[nodiscard]] const Facet* find(Kind kind) const {
    const auto at = static_cast<std::size_t>(kind);
    return at < kMaxKinds ? m_facets[at] : nullptr;
  }
  /// The kinds of the table in the order of their values, up to the first that it does not have.
  [[nodiscard]] std::span<const Kind> kinds() const {
    std::size_t count = 0;
    while (count < kMaxKinds && m_facets[count] != nullptr) ++count;
    return std::span(m_kinds).first(count);
  }

 private:
  template <class, class>
  friend class AddedFacet;

  std::array<const Facet*, kMaxKinds> m_facets{};
  std::array<Kind, kMaxKinds> m_kinds{};
};

/// A table's entry for a kind that the enumeration does not name, as long as this lives: for instance for a
/// kind of a test. Not thread-safe: add and drop kinds while no other thread reads tables.
template <class Kind, class Facet>
class AddedFacet {
 public:
  /// The next kind after those of the table, which lists the kinds itself. @pre it has room
  AddedFacet(KindTable<Kind, Facet>& table, const Facet* facet)
      : AddedFacet(table, static_cast<Kind>(table.kinds().size()), facet) {}
  /// @pre the table does not have the kind
  AddedFacet(KindTable<Kind, Facet>& table, Kind kind, const Facet* facet) : m_table(table), m_kind(kind) {
    const auto at = static_cast<std::size_t>(kind);
    GEARGRAPH_REQUIRE(facet != nullptr && at < kMaxKinds && table.m_facets[at] == nullptr);
    m_table.m_facets[at] = facet;
  }
  ~AddedFacet() { m_table.m_facets[static_cast<std::size_t>(m_kind)] = nullptr; }
  AddedFacet(const AddedFacet&) = delete;
  AddedFacet& operator=(const AddedFacet&) = delete;
  AddedFacet(AddedFacet&&) = delete;
  AddedFacet& operator=(AddedFacet&&) = delete;

  [[nodiscard]] Kind kind() const { return m_kind; }

 private:
  KindTable<Kind, Facet>& m_table;
  Kind m_kind;
};

}  // namespace geargraph
