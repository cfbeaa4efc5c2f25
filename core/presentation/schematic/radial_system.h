#pragma once

#include <stop_token>
#include <vector>

namespace geargraph::inline schematic {

/// Parallel axes rolled out into one plane: at which heights they lie, how large wheels are drawn.
struct RadialSystem {
  struct Wheel {
    int axis = 0;
    double radius = 0;
  };
  struct Contact {
    int tail = 0;  ///< wheels
    int head = 0;
    bool internal = false;
    bool kept = true;  ///< the wheels touch in the end
  };
  std::vector<double> heights;  ///< by axis: whence it starts, and the order that stays
  std::vector<Wheel> wheels;
  std::vector<Contact> contacts;
  bool changed = false;  ///< radii differ from what they were

  /// Finds heights and radii for which wheels in mesh touch: the given ones where they fit, else those with
  /// the least squares of relative changes of the radii. Contacts that would shrink a wheel to a quarter are
  /// given up, the last ones first.
  /// Cost: cubic in axes + wheels + contacts if they do not fit; beyond kMostWheels contacts are given up.
  /// Of no use when `stop` was requested meanwhile.
  void settle(const std::stop_token& stop = {});

  static constexpr std::size_t kMostWheels = 150;

 private:
  [[nodiscard]] double error(const Contact& contact) const;
  [[nodiscard]] bool fits(const Contact& contact) const;
  [[nodiscard]] bool trySolve();
};

}  // namespace geargraph::inline schematic
