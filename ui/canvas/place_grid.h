#pragma once

#include <optional>
#include <vector>

namespace geargraph::inline canvas {

/// Which places of a square grid are free, from -rings to rings either way.
class PlaceGrid {
 public:
  struct Place {
    int across = 0;
    int down = 0;
    friend bool operator==(const Place&, const Place&) = default;
  };
  /// From one place to another, both with it; what is outside the grid does not count.
  struct Span {
    double first = 0;
    double last = 0;
  };

  explicit PlaceGrid(int rings);

  /// Takes all places of a rectangle. Cost: constant.
  void take(Span across, Span down);
  /// The first free place, ring by ring about the middle, each from above. Cost: the places of the grid.
  [[nodiscard]] std::optional<Place> nearestFree() const;

 private:
  int m_rings;
  int m_side;  ///< places in a row, and one for what ends at the border
  std::vector<int>
      m_steps;  ///< by row: how many more rectangles hold a place than the one before it and above
};

}  // namespace geargraph::inline canvas
