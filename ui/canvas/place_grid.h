#pragma once

#include <optional>
#include <vector>

namespace geargraph {

/// The free places of a square grid, from -rings to rings in both directions.
class PlaceGrid {
 public:
  struct Place {
    int across = 0;
    int down = 0;
    friend bool operator==(const Place&, const Place&) = default;
  };
  /// An interval of places, both ends included; parts outside the grid are ignored.
  struct Span {
    double first = 0;
    double last = 0;
  };

  explicit PlaceGrid(int rings);

  /// Occupies all places of a rectangle. Cost: O(1).
  void take(Span across, Span down);
  /// The first free place, ring by ring around the middle, each from the top. Cost: the places of the grid.
  [[nodiscard]] std::optional<Place> nearestFree() const;

 private:
  int m_rings;
  int m_side;  ///< places in a row, and one for the border
  std::vector<int>
      m_steps;  ///< by row: differences of a two-dimensional prefix sum of the rectangles' counts
};

}  // namespace geargraph
