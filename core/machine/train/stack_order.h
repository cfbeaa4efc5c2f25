#pragma once

#include <stop_token>
#include <vector>

namespace geargraph::inline train {

/// Planes of wheels on parallel axes that have to be stacked, as numbers: which of them, where, is a
/// designer's choice as long as nothing stands in one place.
struct StackPlanes {
  struct Wheel {
    int plane = 0;
    int link = 0;
    int axisClass = 0;
    double offset = 0;  ///< of its middle from its plane's
  };
  /// A wheel that an axis beside its own passes through: no shaft goes there.
  struct Cover {
    int plane = 0;
    int axisClass = 0;  ///< the other axis
    double offset = 0;
  };
  /// A link whose arms hold the axes of wheels: they lie on one side of all of these.
  struct Carrier {
    int link = 0;
    int axisClass = 0;        ///< that it turns about
    std::vector<int> planes;  ///< of the wheels that it carries
  };

  std::vector<double> thickness;         ///< by plane: of its wheels
  double gap = 0;                        ///< between planes that meet
  std::vector<std::vector<bool>> meets;  ///< by pair: in one level, wheels of both would stand in one place
  std::vector<Wheel> wheels;
  std::vector<Cover> covers;
  std::vector<Carrier> carriers;
};

/// How often a link has wheels or arms on both sides of another's on one axis, or of one that its axis passes
/// through: one of them has no way but through the other. `heights`: of the planes' middles.
[[nodiscard]] int enclosedCount(const StackPlanes& planes, const std::vector<double>& heights);

/// Heights of the planes' middles in the order that encloses the fewest, and of those the lowest stack; of
/// equal ones the first, so that equal problems have equal stacks. Every order of up to six planes is looked
/// at; of more, one plane after the other goes where it does best until none does better, or `stop` is
/// requested.
/// Cost: O(p!) or O(rounds * p^2) times O(wheels^2 on an axis).
[[nodiscard]] std::vector<double> stackedHeights(const StackPlanes& planes, const std::stop_token& stop = {});

}  // namespace geargraph::inline train
