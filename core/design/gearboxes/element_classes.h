#pragma once

#include <vector>

#include "core/design/gearboxes/gear_layout.h"
#include "core/design/gearboxes/speed_space.h"

namespace geargraph {

/// A brake or a clutch between two links, by their numbers; `b` 0: a brake of `a`.
struct ElementLinks {
  std::uint8_t a = 0;
  std::uint8_t b = 0;
  [[nodiscard]] bool isBrake() const { return b == 0; }
  friend auto operator<=>(const ElementLinks&, const ElementLinks&) = default;
};

/// Elements that have the same effect on all speeds at general tooth counts, because the differences of
/// speed that they remove are proportional. Torque and slip differ. Brakes first.
struct ElementClass {
  std::vector<ElementLinks> variants;
};

/// Every brake and clutch that has an effect on the ratio: none brakes input or output. Sorted by the first
/// variant. Cost: O(shafts^4). @pre the layout is one of gearLayouts()
[[nodiscard]] std::vector<ElementClass> elementClasses(const BasicSets& sets, const GearLayout& layout,
                                                       int shafts);

/// Which states of a layout are gears at general tooth counts. A state engages freedom - 1 elements of
/// different classes.
struct StateList {
  struct State {
    std::uint64_t mask = 0;                 ///< the classes, a bit each
    std::array<std::uint8_t, 3> members{};  ///< the classes, ascending; the first freedom - 1 count
    bool isDirect = false;                  ///< input and output turn as one
  };
  std::vector<State> states;
};

[[nodiscard]] StateList gearStates(const BasicSets& sets, const GearLayout& layout, int shafts,
                                   const std::vector<ElementClass>& classes);

/// The function of the last element's direction that gives, for `target` a link's row, the determinant of the
/// other directions, the last one and the row: 0 where the link stands still. `before` has freedom - 2
/// directions.
template <class Numbers>
[[nodiscard]] std::array<typename Numbers::Value, kMaxFreedom> lastFactors(
    const std::array<typename Numbers::Value, kMaxFreedom>* first,
    const std::array<typename Numbers::Value, kMaxFreedom>* second,
    const std::array<typename Numbers::Value, kMaxFreedom>& target, int freedom, const Numbers& numbers) {
  using Value = typename Numbers::Value;
  std::array<Value, kMaxFreedom> result{};
  result.fill(numbers.whole(0));
  const auto minor = [&](const Value& a, const Value& b, const Value& c, const Value& d) {
    return numbers.subtract(numbers.multiply(a, d), numbers.multiply(b, c));
  };
  if (freedom == 2) {  // d x t
    result[0] = target[1];
    result[1] = numbers.subtract(numbers.whole(0), target[0]);
  } else if (freedom == 3) {  // d . (t x a)
    const auto& a = *first;
    result[0] = minor(target[1], target[2], a[1], a[2]);
    result[1] = minor(target[2], target[0], a[2], a[0]);
    result[2] = minor(target[0], target[1], a[0], a[1]);
  } else if (freedom == 4) {  // minors of the rows a, b, t, with alternating signs
    const auto& a = *first;
    const auto& b = *second;
    const auto three = [&](std::size_t i, std::size_t j, std::size_t k) {
      return numbers.add(numbers.subtract(numbers.multiply(a[i], minor(b[j], b[k], target[j], target[k])),
                                          numbers.multiply(a[j], minor(b[i], b[k], target[i], target[k]))),
                         numbers.multiply(a[k], minor(b[i], b[j], target[i], target[j])));
    };
    const Value zero = numbers.whole(0);
    result[0] = three(1, 2, 3);
    result[1] = numbers.subtract(zero, three(0, 2, 3));
    result[2] = three(0, 1, 3);
    result[3] = numbers.subtract(zero, three(0, 1, 2));
  }
  return result;
}

template <class Numbers>
[[nodiscard]] typename Numbers::Value rowProduct(const std::array<typename Numbers::Value, kMaxFreedom>& a,
                                                 const std::array<typename Numbers::Value, kMaxFreedom>& b,
                                                 int freedom, const Numbers& numbers) {
  auto sum = numbers.whole(0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(freedom); ++i)
    sum = numbers.add(sum, numbers.multiply(a[i], b[i]));
  return sum;
}

/// What an element makes 0: the speed of a braked link, the difference of speeds of a clutch.
template <class Numbers>
[[nodiscard]] std::array<typename Numbers::Value, kMaxFreedom> directionOf(
    const SpeedSpace<typename Numbers::Value>& space, const ElementLinks& element, const Numbers& numbers) {
  auto direction = space.rows[element.a];
  for (std::size_t i = 0; i < direction.size(); ++i)
    direction[i] = numbers.subtract(direction[i], space.rows[element.b][i]);
  return direction;
}

/// Speeds of a link with all but one freedom taken: the row's determinant, a common factor of all links left
/// in. `engaged` has freedom - 1 directions.
template <class Numbers>
[[nodiscard]] typename Numbers::Value speedWith(
    const std::array<std::array<typename Numbers::Value, kMaxFreedom>, 3>& engaged,
    const std::array<typename Numbers::Value, kMaxFreedom>& row, int freedom, const Numbers& numbers) {
  if (freedom == 1) return row[0];
  const auto last = static_cast<std::size_t>(freedom - 2);
  const auto factors = lastFactors<Numbers>(&engaged[0], &engaged[1], row, freedom, numbers);
  return rowProduct(factors, engaged[last], freedom, numbers);
}

}  // namespace geargraph
