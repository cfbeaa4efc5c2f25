#pragma once

#include <stop_token>
#include <vector>

#include "core/foundations/base/ordinal.h"

namespace geargraph {

/// Parallel axes unrolled into one plane: the heights of the axes and the drawn radii of the wheels.
struct RadialSystem {
  struct Wheel {
    int axis = 0;
    double radius = 0;
  };
  struct Contact {
    int tail = 0;  ///< positions of wheels
    int head = 0;
    bool internal = false;
    bool kept = true;  ///< the wheels touch in the result
  };
  ByClass<double> heights;  ///< of the axes: the initial value, whose order is kept; then the result
  ByGear<Wheel> wheels;
  std::vector<Contact> contacts;
  bool changed = false;  ///< radii differ from the given ones

  /// Finds heights and radii for which wheels in mesh touch: the given ones if they fit, else those with the
  /// least sum of squared relative changes of the radii. Contacts that would shrink a wheel to a quarter are
  /// dropped, the last ones first. Cost: cubic in axes + wheels + contacts if they do not fit; beyond
  /// kMaxWheels contacts are dropped. The result is meaningless if `stop` was requested meanwhile.
  void settle(const std::stop_token& stop = {});

  static constexpr std::size_t kMaxWheels = 150;

 private:
  [[nodiscard]] double error(const Contact& contact) const;
  [[nodiscard]] bool fits(const Contact& contact) const;
  [[nodiscard]] bool trySolve();
};

}  // namespace geargraph
