#include "core/presentation/drawing/tidy_tree.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace geargraph {
namespace {

/// From where to where a subtree reaches in each of its columns.
class Contour {
 public:
  /// The subtree is moved by as many rows.
  void shift(double rows) { m_shift += rows; }

  /// Adds the column of a root of this size, at row 0.
  void addRoot(double size) { m_bands.push_back({-size / 2 - m_shift, size / 2 - m_shift}); }

  /// How far `below` has to be moved to lie below this one in every column that both have.
  [[nodiscard]] double roomFor(const Contour& below) const {
    double room = std::numeric_limits<double>::lowest();
    for (std::size_t i = 1; i <= std::min(m_bands.size(), below.m_bands.size()); ++i) {
      room = std::max(room, last(i) - below.first(i));
    }
    return room;
  }

  /// Adds what lies below. The longer one is kept and the shorter one written into it, so that all merging of
  /// a tree is linear.
  void append(Contour&& below) {
    const bool mineIsLonger = m_bands.size() >= below.m_bands.size();
    if (!mineIsLonger) std::swap(*this, below);
    for (std::size_t i = 1; i <= below.m_bands.size(); ++i) {
      Band& band = m_bands[m_bands.size() - i];
      if (mineIsLonger) {
        band.last = below.last(i) - m_shift;
      } else {
        band.first = below.first(i) - m_shift;
      }
    }
  }

 private:
  struct Band {
    double first = 0;
    double last = 0;
  };
  /// Of the column number `i` behind the root's, counted from 1.
  [[nodiscard]] double first(std::size_t i) const { return m_bands[m_bands.size() - i].first + m_shift; }
  [[nodiscard]] double last(std::size_t i) const { return m_bands[m_bands.size() - i].last + m_shift; }

  std::vector<Band> m_bands;  ///< the last column first, so that a root is added at the end
  double m_shift = 0;         ///< to be added to all bands
};

/// The children of every node, in one array (counting sort, which keeps their order).
class Children {
 public:
  Children(std::span<const int> parent, std::span<const int> order) : m_start(parent.size() + 1, 0) {
    for (const int up : parent) {
      if (up >= 0) ++m_start[static_cast<std::size_t>(up) + 1];
    }
    for (std::size_t i = 1; i < m_start.size(); ++i) m_start[i] += m_start[i - 1];
    m_nodes.resize(static_cast<std::size_t>(m_start.back()));
    std::vector<int> next = m_start;
    for (const int node : order) {
      const int up = parent[static_cast<std::size_t>(node)];
      if (up >= 0) m_nodes[static_cast<std::size_t>(next[static_cast<std::size_t>(up)]++)] = node;
    }
  }
  [[nodiscard]] std::span<const int> of(int node) const {
    const auto at = static_cast<std::size_t>(node);
    return std::span(m_nodes).subspan(static_cast<std::size_t>(m_start[at]),
                                      static_cast<std::size_t>(m_start[at + 1] - m_start[at]));
  }

 private:
  std::vector<int> m_start;
  std::vector<int> m_nodes;
};

/// Puts subtrees one below the other; the rows of their roots, the first one's 0, go to `rows`.
Contour stacked(std::span<const int> nodes, std::vector<Contour>& contours, std::vector<TidyPlace>& places) {
  Contour all;
  for (const int node : nodes) {
    Contour& one = contours[static_cast<std::size_t>(node)];
    if (node == nodes.front()) {
      all = std::move(one);
      continue;
    }
    const double row = all.roomFor(one);
    one.shift(row);
    places[static_cast<std::size_t>(node)].row = row;
    all.append(std::move(one));
  }
  return all;
}

}  // namespace

// 1. From the leaves to the roots: stack the children's subtrees and put their parent in the middle; rows are
//    relative to the parent's.
// 2. From the roots to the leaves: add up.
std::vector<TidyPlace> tidyForest(std::span<const int> parent, std::span<const int> order,
                                  std::span<const double> sizes) {
  const Children children(parent, order);
  std::vector<TidyPlace> places(parent.size());
  std::vector<Contour> contours(parent.size());
  for (auto node = order.rbegin(); node != order.rend(); ++node) {
    const std::span<const int> below = children.of(*node);
    Contour contour = stacked(below, contours, places);
    if (!below.empty()) {
      const double middle = places[static_cast<std::size_t>(below.back())].row / 2;
      for (const int child : below) places[static_cast<std::size_t>(child)].row -= middle;
      contour.shift(-middle);
    }
    contour.addRoot(sizes.empty() ? 1 : sizes[static_cast<std::size_t>(*node)]);
    contours[static_cast<std::size_t>(*node)] = std::move(contour);
  }
  std::vector<int> roots;
  for (const int node : order) {
    if (parent[static_cast<std::size_t>(node)] < 0) roots.push_back(node);
  }
  (void)stacked(roots, contours, places);
  for (const int node : order) {
    TidyPlace& place = places[static_cast<std::size_t>(node)];
    const int up = parent[static_cast<std::size_t>(node)];
    if (up < 0) continue;
    place.column = places[static_cast<std::size_t>(up)].column + 1;
    place.row += places[static_cast<std::size_t>(up)].row;
  }
  return places;
}

}  // namespace geargraph
